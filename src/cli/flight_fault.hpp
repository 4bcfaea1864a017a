// Why a flight of the whole vehicle cannot go on.
#pragma once

#include <string>

#include "tiltrotor/analysis/flight/response.hpp"

namespace tiltrotor::cli {

// ", rotor_speed: leaves 20..80 rad/s (20.3 rad/s in the last good step)": the quantity and its range.
std::string flight_fault_text(const Configuration<double>& c, const SystemFlight<double>& flight,
                              const Simulation<double>& simulation);

}  // namespace tiltrotor::cli
