// What an aircraft can do at one mast angle and setting, searched among its trims.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "library/analyses.hpp"

namespace tiltrotor::cli {

enum class Figure : unsigned char {
  least_power,
  best_range,
  top_speed,
  top_speed_power,
  top_speed_torque,
  best_climb,
  hover_ceiling,
  hover_ceiling_in_ground,
  one_engine_least_speed,
  one_engine_top_speed,
  one_engine_ceiling,
  one_engine_hover_ceiling,
  count
};
inline constexpr int kFigures = static_cast<int>(Figure::count);
const char* figure_name(Figure figure);
const char* figure_unit(Figure figure);

// A figure and the flight that has it. Without a value: `limit` says what ends the search before it.
struct Performance {
  Figure figure;
  std::optional<double> value;         // in its unit
  double speed, power_kw, altitude_m;  // of the flight
  std::string limit;  // that the next flight exceeds: power, torque, another of trim's; "" where none does
};

// Every figure, in order. `c`: prepared. Take-off power of the engines that run, contingency power of one with the
// others out, largest steady torque of the masts. Ceilings look at all altitudes, everything else at that of `c`.
// `wheel_height`: in ground effect, m. Cost: some 700 trims.
std::vector<Performance> performance(const Configuration<double>& c, double wheel_height, Analyses& work);

}  // namespace tiltrotor::cli
