// What is wrong with a script for the flight that is asked for.
#pragma once

#include "cli/arguments.hpp"
#include "cli/flight_script.hpp"

namespace tiltrotor::cli {

// Throws UsageError when a file that `fly` writes is one that it reads, or another that it writes.
void require_files_apart(const Arguments& arguments, const FlightScript& script);

// Of a flight that begins on the wheels. Throws UsageError when its governor is ideal before it takes off: rotors that turn
// slowly with flat blades have no collective at which they take the power that speeds them up.
void require_governed_ground(const FlightScript& script);

}  // namespace tiltrotor::cli
