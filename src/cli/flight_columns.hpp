// Columns of a flight of the whole vehicle.
#pragma once

#include <string>
#include <vector>

#include "cli/script_flight.hpp"
#include "text/records.hpp"

namespace tiltrotor::cli {

// Every column, in the order of the files.
const std::vector<std::string>& flight_columns();

// Places in flight_columns() of a list "time_s,height_m". Throws UsageError "<where>: ...".
std::vector<std::size_t> chosen_columns(const std::string& list, const std::string& where);

text::Row flight_row(const FlightMoment& moment, const std::vector<std::size_t>& columns);

}  // namespace tiltrotor::cli
