// `--states FILE`: given states instead of trimmed ones.
#pragma once

#include "cli/flight_options.hpp"
#include "cli/shard.hpp"
#include "cli/state_file.hpp"

namespace tiltrotor::cli {

OptionList states_option();

// The file of --states and the aircraft of its rows.
class GivenStates {
 public:
  GivenStates(const Arguments& arguments, const SetupOptions& setup);
  const StateFile& file() const { return file_; }

  // Every row of the shard, in order, with what its own columns set and the options the rest. A row that is
  // no flight (StateRow::fault) is explained on stderr before. Returns exit_case_failed when there was one or
  // `visit` returned it.
  using Visit = std::function<int(const StateRow&, const Configuration<double>&)>;
  int each(const Shard& shard, const Visit& visit);

 private:
  Configuration<double> configuration(const StateRow& row) const;
  void compare_models(const StateRow& row);

  const SetupOptions& setup_;
  double mast_deg_;
  StateFile file_;
  std::string model_;  // that the options choose
  std::string told_;   // another, of rows before
};

}  // namespace tiltrotor::cli
