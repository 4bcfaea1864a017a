// The same tests for an aircraft of another size. They are written with the numbers of the XV-15 at sea level; any
// other aircraft flies the same flights by Froude's number, in the air in which its gross weight asks its rotors for
// the same thrust coefficient, with masses, stations and rotor speeds in proportion. For the XV-15 every number stays
// as it is written.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <sstream>
#include <string>

#include "tiltrotor/math/scalar.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/setup/atmosphere.hpp"

namespace this_aircraft {

inline const tiltrotor::Aircraft<double>& numbers() { return tiltrotor::aircraft_data<double>(); }

// Over those of the XV-15: 12.5 ft, 13000 lb, 589 rpm, CG at 301.2 in.
inline double length() { return numbers().rotor.radius / (12.5 * 0.3048); }
inline double mass() { return numbers().mass.gross / (13000 * 0.45359237); }
inline double rotor_speed() { return numbers().rotor.speed_helicopter / (589 * tiltrotor::kPi<double> / 30); }
inline double station() { return numbers().mass.sl_cg / (301.2 * 0.0254); }
inline double speed() { return std::sqrt(length()); }

// Where the air has the density for it, by the exponent of the standard troposphere; sea level for one that would
// need more. To the metre, m.
inline double altitude() {
  const double density = mass() / std::pow(length(), 4) / std::pow(rotor_speed(), 2);
  const double temperature = std::pow(density, 1 / 4.2559);
  return std::clamp(std::round((1 - temperature) * 288.15 / 0.0065), 0.0, numbers().limits.altitude.high);
}

// What stands after an option of the command line for what a test wrote there: to 0.01 of its unit.
inline double given(const std::string& option, double written) {
  const std::map<std::string, double> factors = {
      {"--speed", speed()},         {"--speed-axial", speed()},
      {"--speed-inplane", speed()}, {"--turn-rate", 1 / speed()},
      {"--mass", mass()},           {"--cg-sl", station()},
      {"--rpm", rotor_speed()},     {"--rotor-rpm", rotor_speed()}};
  if (option == "--altitude" && altitude() > 0)
    return std::min(std::round(altitude() + length() * written), numbers().limits.altitude.high);
  const auto factor = factors.find(option);
  if (factor == factors.end() || std::fabs(factor->second - 1) < 1e-6) return written;
  return std::round(100 * factor->second * written) / 100;
}

/// The shortest decimals that read back as the number, without a power of ten.
inline std::string shortest(double value) {
  char text[40];
  for (int digits = 1; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value && std::strchr(text, 'e') == nullptr) break;
  }
  return text;
}

// A value, a list, or a range of what is no altitude.
inline std::string given_list(const std::string& option, const std::string& list) {
  std::string all;
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find_first_of(",:", at), list.size());
    const std::string item = list.substr(at, end - at);
    const double written = std::strtod(item.c_str(), nullptr);
    const double value = given(option, written);
    all += value == written ? item : shortest(value);
    if (end < list.size()) all += list[end];
    at = end + 1;
  }
  return all;
}

/// Arguments of the program as this aircraft flies them: its altitude is given where the command has none.
inline std::string flown(const std::string& arguments) {
  std::istringstream words(arguments);
  std::string all, word, option;
  bool has_altitude = altitude() == 0;
  while (words >> word) {
    all += (all.empty() ? "" : " ") + (option.empty() ? word : given_list(option, word));
    has_altitude = has_altitude || word == "--altitude";
    option = word.compare(0, 2, "--") == 0 ? word : "";
  }
  return has_altitude ? all : all + " --altitude " + shortest(altitude());
}

}  // namespace this_aircraft
