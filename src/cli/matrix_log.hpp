// A and B along a flight, in two CSV files of a folder, a.csv and b.csv, with the columns of the first model or those
// given. A model that has no such column leaves it empty.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/errors.hpp"
#include "cli/shown_model.hpp"
#include "text/sink.hpp"

namespace tiltrotor::cli {

class MatrixLog {
 public:
  // Throws UsageError "<where>: ..." when the folder cannot be written.
  // `beginning`: lines before the header of each.
  MatrixLog(const std::string& folder, const std::string& where, const std::string& beginning);

  // Before the first model.
  void set_columns(const std::vector<std::string>& states, const std::vector<std::string>& controls);
  void add(double time, const ShownModel& model);
  bool is_empty() const { return !has_header_; }
  void finish();

 private:
  std::vector<std::string> states_, controls_;
  std::unique_ptr<Sink> a_, b_;
  bool has_header_ = false;
};

}  // namespace tiltrotor::cli
