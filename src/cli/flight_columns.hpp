// Columns of a flight of the whole vehicle.
#pragma once

#include <string>
#include <vector>

#include "cli/script_flight.hpp"
#include "text/records.hpp"

namespace tiltrotor::cli {

// Every column, in the order of the files.
const std::vector<std::string>& flight_columns();

text::Row flight_row(const FlightMoment& moment);

}  // namespace tiltrotor::cli
