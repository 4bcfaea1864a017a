#include "cli/trimmed_flights.hpp"

#include <algorithm>
#include <cmath>

#include "cli/errors.hpp"
#include "cli/impossible_flight.hpp"
#include "cli/state_columns.hpp"
#include "cli/targeted_trim.hpp"
#include "cli/wind_trim.hpp"
#include "text/progress.hpp"

namespace tiltrotor::cli {

std::string trim_explanation(const TrimResult<double>& trim) {
  char text[256];
  explain(trim, text, sizeof text);
  return text;
}

double TrimmedFlight::setting(const std::string& column) const {
  const bool found = std::any_of(targets.begin(), targets.end(),
                                 [&](const TrimTarget& target) { return target.freed == column; });
  const double now = setting_value(column, configuration.setup);
  return found ? now : setup->given(column).value_or(now);
}

void trim_flight(TrimmedFlight& f, Analyses& work) {
  if (f.azimuth_deg) {
    trim_in_wind(f.configuration, f.flight, *f.azimuth_deg * kRadPerDeg<double>, work, f.trim);
    f.sideslip_deg = f.trim.sideslip / kRadPerDeg<double>;
    return;
  }
  (void)trim(f.configuration, f.flight, work, f.trim);
}

std::string flight_text(const std::string& command, double mast_deg, double speed) {
  return command + ": mast " + number_text(mast_deg, 6) + " deg, " + number_text(speed, 6) + " m/s";
}

int for_each_trim(const Arguments& arguments, const std::vector<SetupOptions>& setups, const Shard& shard,
                  Analyses& work, const std::function<int(const TrimmedFlight&)>& visit,
                  const Connected& connected) {
  const std::vector<FlightCase> cases = flight_cases(arguments, setups.size());
  const std::size_t begin = shard.begin(cases.size());
  const std::size_t end = shard.end(cases.size());
  std::size_t first = begin;
  while (first < end && first > 0 && connected && connected(cases[first - 1], cases[first])) --first;
  Progress progress(arguments.command(), end - first);
  int exit_status = exit_success;
  TrimmedFlight trimmed{};
  for (std::size_t i = first; i < end; ++i) {
    trimmed.number = i;
    trimmed.is_preliminary = i < begin;
    trimmed.connects = i > first && connected && connected(cases[i - 1], cases[i]);
    trimmed.mast_deg = cases[i].mast_deg;
    trimmed.flight = cases[i].flight;
    trimmed.climb_deg = cases[i].climb_deg;
    trimmed.sideslip_deg = cases[i].sideslip_deg;
    trimmed.turn_rate_degps = cases[i].turn_rate_degps;
    trimmed.azimuth_deg = cases[i].azimuth_deg;
    trimmed.targets = cases[i].targets;
    const SetupOptions& setup = setups[cases[i].setup];
    trimmed.setup = &setup;
    trimmed.configuration = setup.configuration(trimmed.mast_deg);
    trimmed.where = flight_text(arguments.command(), trimmed.mast_deg, trimmed.flight.speed) + setup.text();
    const std::string unreached = trim_to_targets(trimmed.targets, work, trimmed);
    const TrimStatus status = trimmed.trim.status;
    if (status != TrimStatus::ok && !trimmed.is_preliminary) {
      progress.message(trimmed.where + ": " + trim_status_word(status) + ": " +
                       (has_no_azimuth(trimmed.flight, trimmed.azimuth_deg) ? kNoAzimuth
                        : unreached.empty()                                 ? trim_explanation(trimmed.trim)
                                                                            : unreached));
      exit_status = exit_case_failed;
    }
    const int visited = visit(trimmed);
    if (visited != exit_success && !trimmed.is_preliminary) exit_status = visited;
    progress.advance();
  }
  return exit_status;
}

}  // namespace tiltrotor::cli
