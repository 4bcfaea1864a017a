// Columns that `trim` prints.
#pragma once

#include <string>
#include <vector>

#include "cli/trimmed_flights.hpp"

namespace tiltrotor::cli {

// Without those that complete the state (state_columns.hpp).
std::vector<std::string> trim_columns();

// Those that follow from the trim, and the number of one of them.
std::vector<std::string> trim_quantities();
double (*trim_quantity(const std::string& column))(const TrimmedFlight&);

}  // namespace tiltrotor::cli
