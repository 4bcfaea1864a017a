// A mission of the whole vehicle in the report: drawn and judged here, flown by the program, which knows the pilot.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/section.hpp"

namespace tiltrotor::study {

// time_s, height_m, airspeed_mps, mast_deg, flap_deg, power_kw (both engines), takeoff_power_kw, load_factor
Table motion_along_flight();
// time_s, mode, real, imag
Table modes_along_flight();

struct FlownMission {
  std::string name;  // of its script
  Table motion = motion_along_flight();
  Table modes = modes_along_flight();
  int models = 0, models_without_modes = 0;
  double height_error, power_part, touch_down;  // m while a height is held, of take-off power, m/s
  std::string summary;                          // lines "name: value"
};
using FlyMission = std::function<FlownMission()>;

// Figures of any flight, one below the other: `note` below the last.
std::string flight_picture(const std::string& title, const Table& motion, const std::string& note = "");
std::string flight_modes_picture(const std::string& title, const Table& modes, const std::string& note = "");

Section mission(const FlownMission& flown);

}  // namespace tiltrotor::study
