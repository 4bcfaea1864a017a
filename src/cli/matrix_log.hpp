// A and B along a flight, in two CSV files of a folder: a.csv and b.csv.
#pragma once

#include <memory>
#include <string>

#include "cli/errors.hpp"
#include "text/sink.hpp"
#include "tiltrotor/analysis/linear/linear_model.hpp"

namespace tiltrotor::cli {

class MatrixLog {
 public:
  // Throws UsageError "<where>: ..." when the folder cannot be written.
  MatrixLog(const std::string& folder, const std::string& where);

  void add(double time, const LinearModel<double>& model);
  bool is_empty() const { return !has_header_; }
  void finish();

 private:
  void write_header(const LinearModel<double>& model);

  std::unique_ptr<Sink> a_, b_;
  bool has_header_ = false;
};

}  // namespace tiltrotor::cli
