// Inputs over time from a CSV file.
#pragma once

#include <string>
#include <vector>

#include "tiltrotor/model/variables/controls.hpp"

namespace tiltrotor::cli {

// Inputs of a series: places in kControlVariables, then the throttles.
inline constexpr int kFirstThrottle = control_count;

struct InputSeries {
  std::string name;           // of the file
  std::vector<int> input;     // one a column
  std::vector<double> time;   // s from its beginning, growing
  std::vector<double> value;  // row by row, in the unit of the model; throttle 0..1
  bool is_held = false;       // between rows; else interpolated
};

// Throws UsageError "<file>:<line>: ...": no column time_s, an unknown one, a hole, no number, a number out of the
// range of the input, time that does not grow.
InputSeries read_input_series(const std::string& path, bool is_held);

// Of a column at a time since the beginning; the last row's value after it, the first row's before it.
double value_at(const InputSeries& series, std::size_t column, double time);

}  // namespace tiltrotor::cli
