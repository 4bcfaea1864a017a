#include "cli/sweep.hpp"

#include <cmath>

#include "cli/errors.hpp"

namespace tiltrotor::cli {

namespace {

constexpr int max_points = 100000;
constexpr std::size_t max_combinations = 1000000;

// A range ends at `to` also when rounding carries the last step a little past it.
constexpr double step_tolerance = 1e-9;

void append_range(const std::vector<std::string>& parts, const std::string& text, const std::string& where,
                  const Range& range, std::vector<double>& values) {
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
  for (double i = 0; i <= steps; ++i) {
    const double value = from + i * step;
    const bool last = std::abs(value - to) <= step_tolerance * std::abs(step);
    values.push_back(last ? to : value);
  }
}

}  // namespace

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::vector<double> parse_sweep(std::string_view text, const std::string& where, const Range& range) {
  std::vector<double> values;
  for (const std::string& item : split(text, ',')) {
    const std::vector<std::string> parts = split(item, ':');
    if (parts.size() == 1) {
      values.push_back(parse_number(item, where, range));
    } else if (parts.size() == 3) {
      append_range(parts, item, where, range, values);
    } else {
      throw UsageError(where + ": '" + item + "' is not a range; write from:step:to, for example 0:5:50");
    }
    if (values.size() > max_points)
      throw UsageError(where + ": the list has more than " + std::to_string(max_points) + " values");
  }
  return values;
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
