// Numbers of trim and respond that follow from state and controls alone.
#pragma once

#include <string>

#include "cli/state_file.hpp"
#include "tiltrotor/model/setup/configuration.hpp"

namespace tiltrotor::cli {

// Relative to the air, gust included, m/s.
double airspeed(const State<double>& x, const Controls<double>& u);
// Along the heading, level with the ground, and up, relative to the undisturbed air, m/s.
double forward_speed(const State<double>& x);
double climb_rate(const State<double>& x);

// What a row of the file says of itself that its states do not: "column speed_mps: 45, but the states and
// controls of the row give 40; ...". Empty where they agree to the digits that the row is printed with.
std::string contradiction(const StateRow& row, const StateFile& file, const Configuration<double>& c);

}  // namespace tiltrotor::cli
