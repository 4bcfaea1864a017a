// `--states FILE`: given states instead of trimmed ones.
#pragma once

#include "cli/flight_options.hpp"
#include "cli/state_file.hpp"

namespace tiltrotor::cli {

OptionList states_option();

// The file of --states and the aircraft of its rows.
class GivenStates {
 public:
  GivenStates(const Arguments& arguments, const SetupOptions& setup);
  StateFile& file() { return file_; }
  // What the row's own columns set, and the options the rest.
  Configuration<double> configuration(const StateRow& row) const;

 private:
  const SetupOptions& setup_;
  double mast_deg_;
  StateFile file_;
};

}  // namespace tiltrotor::cli
