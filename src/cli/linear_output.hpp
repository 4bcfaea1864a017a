// Linear models as CSV, JSON, a MATLAB script or a table.
#pragma once

#include <string>

#include "cli/arguments.hpp"
#include "cli/linear_settings.hpp"
#include "cli/shard.hpp"
#include "cli/shown_model.hpp"
#include "text/sink.hpp"

namespace tiltrotor::cli {

struct LinearCase {
  std::string name;
  double mast_deg;
  double speed;  // m/s
  std::string status;
  bool valid;  // there is a model
  LinearSettings settings;
  std::vector<double> swept = {};  // of the columns behind the others
};

class LinearOutput {
 public:
  static OptionList list();
  // `single`: one case in all, which JSON then writes as an object instead of an array. `swept`: columns of CSV behind
  // the others, and in the headings of a table.
  LinearOutput(const Arguments& arguments, bool single, const std::vector<std::string>& swept);

  const Shard& shard() const { return shard_; }
  // Whether the file has outputs, C and D: json and matlab.
  bool wants_outputs() const { return kind_ == Kind::json || kind_ == Kind::matlab; }
  void add(const LinearCase& which, const ShownModel& model);
  void finish();

 private:
  enum class Kind : unsigned char { table, csv, json, matlab };
  void add_csv(const LinearCase& which, const ShownModel& model);
  void add_json(const LinearCase& which, const ShownModel& model);
  void add_matlab(const LinearCase& which, const ShownModel& model);
  void add_table(const LinearCase& which, const ShownModel& model);

  Sink sink_;
  Shard shard_;
  Kind kind_;
  bool single_;
  std::string stamp_;
  std::vector<std::string> swept_;
  std::size_t count_ = 0;
};

}  // namespace tiltrotor::cli
