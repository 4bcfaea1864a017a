#include "cli/impossible_flight.hpp"

#include <algorithm>
#include <string>

#include "cli/errors.hpp"
#include "tiltrotor/analysis/trim/trim_explanation.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace tiltrotor::cli {

namespace {

std::string sentence(SteadyFlightField invalid) {
  TrimResult<double> refused{};
  refused.status = TrimStatus::out_of_range;
  refused.invalid = invalid;
  char text[256];
  explain(refused, text, sizeof text);
  const std::string beginning = "bad input: ", all = text;
  return all.rfind(beginning, 0) == 0 ? all.substr(beginning.size()) : all;
}

// A search may lead to a flight that can be.
bool lets_go(const FlightCase& one, const char* freed) {
  return std::any_of(one.targets.begin(), one.targets.end(),
                     [&](const TrimTarget& target) { return target.freed == freed; });
}

}  // namespace

bool has_no_azimuth(const SteadyFlight<double>& flight, const std::optional<double>& azimuth_deg) {
  return azimuth_deg && is_vertical(flight);
}

void require_possible(const Arguments& arguments, const FlightCase& only) {
  if (lets_go(only, "speed_mps") || lets_go(only, "climb_deg") || lets_go(only, "sideslip_deg")) return;
  if (has_no_azimuth(only.flight, only.azimuth_deg))
    throw UsageError(arguments.where("--azimuth") + ": " + kNoAzimuth);
  const SteadyFlightField invalid = first_invalid(aircraft_data<double>(), only.flight);
  if (invalid == SteadyFlightField::climb)
    throw UsageError(arguments.where("--climb") + ": " + sentence(invalid));
  if (invalid == SteadyFlightField::sideslip)
    throw UsageError(arguments.where("--sideslip") + ": " + sentence(invalid));
}

}  // namespace tiltrotor::cli
