#include "cli/sweep.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "cli/errors.hpp"
#include "text/nearest.hpp"

namespace tiltrotor::cli {

namespace {

constexpr int max_points = 100000;
constexpr std::size_t max_combinations = 1000000;
constexpr int max_decimals = 15;

// A range ends at `to` also when rounding carries the last step a little past it.
constexpr double step_tolerance = 1e-9;

// Digits behind the point; too many to matter where a power of ten follows.
int decimals_of(const std::string& number) {
  if (number.find_first_of("eE") != std::string::npos) return max_decimals + 1;
  const std::size_t point = number.find('.');
  return point == std::string::npos ? 0
                                    : static_cast<int>(std::min<std::size_t>(number.size() - point - 1, 99));
}

// 0:0.1:1 holds 0.3 as a list of decimal numbers does, not 3 * 0.1 = 0.30000000000000004.
double to_decimals(double value, int decimals) {
  if (decimals > max_decimals) return value;
  char text[400];
  const std::to_chars_result end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals);
  std::from_chars(text, end.ptr, value);
  return value;
}

void append_range(const std::vector<std::string>& parts, const std::string& text, const std::string& where,
                  const Range& range, std::vector<double>& values) {
  for (const std::string& part : parts)
    if (part.empty())
      throw UsageError(where + ": '' is not a number; a part of " + quoted(text) + " is empty");
  const double from = parse_number(parts[0], where, range);
  const double step = parse_number(parts[1], where);
  const double to = parse_number(parts[2], where, range);
  if (step == 0) throw UsageError(where + ": the step of range '" + text + "' is zero");
  const double steps = std::floor((to - from) / step + step_tolerance);
  if (steps < 0) {
    throw UsageError(where + ": range '" + text + "' is empty: its step leads away from " + parts[2]);
  }
  if (steps >= max_points) {
    throw UsageError(where + ": range '" + text + "' has more than " + std::to_string(max_points) +
                     " values");
  }
  const int decimals = std::max(decimals_of(parts[0]), decimals_of(parts[1]));
  for (double i = 0; i <= steps; ++i) {
    const double value = to_decimals(from + i * step, decimals);
    const bool last = std::abs(value - to) <= step_tolerance * std::abs(step);
    values.push_back(last ? to : value);
  }
}

}  // namespace

std::vector<double> parse_sweep(std::string_view text, const std::string& where, const Range& range) {
  std::vector<double> values;
  for (const std::string& item : split(text, ',')) {
    if (item.empty() && !text.empty())
      throw UsageError(where + ": '' is not a number; an item of " + quoted(text) + " is empty");
    const std::vector<std::string> parts = split(item, ':');
    if (parts.size() == 1) {
      values.push_back(parse_number(item, where, range));
    } else if (parts.size() == 3) {
      append_range(parts, item, where, range, values);
    } else {
      throw UsageError(where + ": '" + item + "' is not a range; write from:step:to, for example 0:5:50");
    }
    require_few_values(values.size(), where);
  }
  return values;
}

void require_few_values(std::size_t count, const std::string& where) {
  if (count > max_points)
    throw UsageError(where + ": the list has more than " + std::to_string(max_points) + " values");
}

void require_few(const std::string& command, const std::vector<std::size_t>& sizes) {
  std::size_t combinations = 1;
  for (const std::size_t size : sizes) {
    if (size == 0) return;
    if (size > max_combinations / combinations) {
      throw UsageError(command + ": more than " + std::to_string(max_combinations) +
                       " combinations; divide the ranges among several runs");
    }
    combinations *= size;
  }
}

}  // namespace tiltrotor::cli
