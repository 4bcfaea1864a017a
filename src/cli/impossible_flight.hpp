// Flights that contradict themselves, whatever the aircraft.
#pragma once

#include "cli/flight_options.hpp"

namespace tiltrotor::cli {

// The only flight that is asked for: throws UsageError "<command>: <option>: ..." where no trim can have it. Among several
// it is a row whose status is out_of_range.
void require_possible(const Arguments& arguments, const FlightCase& only);

// Straight up or down there is no side for the wind to come from.
bool has_no_azimuth(const SteadyFlight<double>& flight, const std::optional<double>& azimuth_deg);
inline constexpr const char* kNoAzimuth =
    "the wind has no azimuth in vertical flight: leave it out, or climb by less than 90 deg";

}  // namespace tiltrotor::cli
