// What instruments read, load factors at stations and loads of components, of a trimmed flight.
#pragma once

#include <vector>

#include "cli/named_outputs.hpp"
#include "cli/trimmed_flights.hpp"
#include "tiltrotor/analysis/flight/instruments.hpp"

namespace tiltrotor::cli {

// All instruments and the outputs of the airframe asked for. The flight has a trim.
void read_trim(const TrimmedFlight& flight, const std::vector<AirframeOutput>& outputs,
               Instruments<double>& readings, std::vector<double>& airframe);

double reading_of(const TrimmedFlight& flight, const NamedOutput& output);

}  // namespace tiltrotor::cli
