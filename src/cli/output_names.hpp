// Names and units of what instruments read, as rows of C and D: the members of tr_outputs, in the order of Instruments.
#pragma once

#include "tiltrotor/analysis/flight/instruments.hpp"

namespace tiltrotor::cli {

struct OutputName {
  const char *name, *unit;
};
inline constexpr OutputName kOutputNames[] = {
    {"airspeed", "m/s"},
    {"angle_of_attack", "rad"},
    {"sideslip", "rad"},
    {"specific_force_x", "m/s^2"},
    {"specific_force_y", "m/s^2"},
    {"specific_force_z", "m/s^2"},
    {"load_factor", "-"},
    {"climb_rate", "m/s"},
    {"thrust_right", "N"},
    {"thrust_left", "N"},
    {"torque_right", "N m"},
    {"torque_left", "N m"},
    {"power_right", "W"},
    {"power_left", "W"},
    {"collective_right", "rad"},
    {"collective_left", "rad"},
    {"long_cyclic_right", "rad"},
    {"long_cyclic_left", "rad"},
    {"gimbal_tilt_right", "rad"},
    {"gimbal_tilt_left", "rad"},
    {"elevator", "rad"},
    {"aileron", "rad"},
    {"rudder", "rad"},
};
static_assert(sizeof kOutputNames / sizeof kOutputNames[0] == Instruments<double>::kCount,
              "one for each reading");

}  // namespace tiltrotor::cli
