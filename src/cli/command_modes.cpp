// `tiltrotor modes`: eigenvalues with names.

#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/linear_options.hpp"
#include "cli/mode_tracker.hpp"
#include "cli/output.hpp"
#include "cli/trimmed_flights.hpp"

namespace tiltrotor::cli {

namespace {

const std::vector<std::string> columns = {
    "mast_deg",      "speed_mps",      "axis",   "mode",       "real",    "imag",    "frequency_rad_s",
    "damping_ratio", "time_to_half_s", "status", "altitude_m", "mass_kg", "cg_sl_in"};

// Neighbours in a sweep of speed, or of the mast angle at one speed, closer than these.
constexpr double speed_neighbour = 10;  // m/s
constexpr double mast_neighbour = 10;   // deg

bool neighbours(const FlightCase& a, const FlightCase& b) {
  const double speed_step = std::abs(a.flight.speed - b.flight.speed);
  const double mast_step = std::abs(a.mast_deg - b.mast_deg);
  return a.setup == b.setup && ((mast_step == 0 && speed_step <= speed_neighbour) ||
                                (speed_step == 0 && mast_step <= mast_neighbour));
}

void add_row(Records& records, const TrimmedFlight& flight, const char* status,
             const Mode<double>* mode = nullptr) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  const FlightSetup<double>& setup = flight.configuration.setup;
  Row row = {flight.mast_deg, flight.flight.speed};
  const Row numbers = mode != nullptr
                          ? Row{axis_word(mode->axis), mode->name,          mode->real,        mode->imag,
                                mode->frequency,       mode->damping_ratio, mode->time_to_half}
                          : Row{"", "", nothing, nothing, nothing, nothing, nothing};
  row.insert(row.end(), numbers.begin(), numbers.end());
  for (const Cell& cell : Row{status, setup.altitude, setup.mass, given_as(setup.sl_cg, kInch)})
    row.push_back(cell);
  records.add(row);
}

void add_rows(Records& records, const TrimmedFlight& flight, const ModeSet<double>& set) {
  for (int i = 0; i < set.count; ++i)
    add_row(records, flight, trim_status_word(flight.trim.status), &set.mode[i]);
}

int run(const Arguments& arguments) {
  const std::vector<SetupOptions> setups = SetupOptions::every_combination(arguments);
  const bool rigid = wants_rigid(arguments);
  flight_cases(arguments, setups.size());
  Output output(arguments);
  Records records = output.records(columns, Output::to_read);
  const AnalysesRoom room;
  const auto model = std::make_unique<LinearModel<double>>();
  ModeTracker tracker;
  const auto visit = [&](const TrimmedFlight& flight) -> int {
    const TrimResult<double>& trim = flight.trim;
    if (!is_trimmed(trim.status)) {
      tracker.lose_track();
      if (!flight.is_preliminary) add_row(records, flight, trim_status_word(trim.status));
      return exit_case_failed;
    }
    Status status = linearize(flight.configuration, trim.state, trim.controls, ControlSet{}, *room, *model);
    if (status == Status::ok && rigid) status = reduce_to_rigid(*model);
    if (status == Status::ok) status = tracker.find(*model, flight.connects);
    if (flight.is_preliminary) return exit_success;
    if (status == Status::ok) {
      add_rows(records, flight, tracker.found());
      return exit_success;
    }
    add_row(records, flight, status_word(status));
    std::fprintf(stderr, "tiltrotor: %s: %s\n", flight.where.c_str(), status_text(status));
    return exit_case_failed;
  };
  const int exit_status = for_each_trim(arguments, setups, output.shard(), *room, visit, neighbours);
  records.finish();
  return exit_status;
}

}  // namespace

Command modes_command() {
  return {"modes",
          "eigenvalues of A with names, frequency and damping",
          "One row for every real root or conjugate pair, longitudinal, lateral, then rotor, slow modes "
          "first. A\n"
          "negative time_to_half_s is the time to double. Names come from the states that take part; along a "
          "sweep in\n"
          "steps of at most 10 m/s, or 10 deg of mast angle at one speed, they follow the mode.\n"
          "--mast, --speed, --altitude, --mass and --cg-sl take a value, a list or a range.\n",
          "tiltrotor modes --mast 30,60,90 --speed 60",
          reduce_option() + flight_list() + SetupOptions::list() + Output::list(),
          run};
}

}  // namespace tiltrotor::cli
