// `tiltrotor modes`: eigenvalues with names.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/governed.hpp"
#include "cli/linear_options.hpp"
#include "cli/output.hpp"
#include "cli/trimmed_flights.hpp"
#include "tiltrotor/analysis/linear/mode_tracker.hpp"

namespace tiltrotor::cli {

namespace {

const std::vector<std::string> columns = {
    "mast_deg",   "speed_mps",       "axis",          "mode",           "real",
    "imag",       "frequency_rad_s", "damping_ratio", "time_to_half_s", "status",
    "altitude_m", "mass_kg",         "cg_sl_in",      "branch",         "flap_deg"};

// Branches are followed along a sweep of speed, or of mast angle at one speed, and numbered through it. A
// shard begins with the sweep, to find the same numbers.
bool same_sweep(const FlightCase& a, const FlightCase& b) {
  return a.setup == b.setup && (a.mast_deg == b.mast_deg || a.flight.speed == b.flight.speed);
}

// Steps of a sweep beyond these connect nothing.
constexpr double longest_speed_step = 10;  // m/s
constexpr double longest_mast_step = 10;   // deg

bool neighbours(const TrimmedFlight& flight, double mast_deg, double speed) {
  return std::abs(flight.flight.speed - speed) <= longest_speed_step &&
         std::abs(flight.mast_deg - mast_deg) <= longest_mast_step;
}

void add_row(Records& records, const TrimmedFlight& flight, const char* status,
             const Mode<double>* mode = nullptr, const char* axis = nullptr) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  Row row = {as_given(flight.mast_deg), as_given(flight.flight.speed)};
  const Row numbers = mode != nullptr ? Row{axis != nullptr ? axis : axis_word(mode->axis),
                                            mode->name,
                                            mode->real,
                                            mode->imag,
                                            mode->frequency,
                                            mode->damping_ratio,
                                            mode->time_to_half}
                                      : Row{"", "", nothing, nothing, nothing, nothing, nothing};
  row.insert(row.end(), numbers.begin(), numbers.end());
  const double branch = mode != nullptr && mode->branch > 0 ? mode->branch : nothing;
  for (const Cell& cell :
       Row{status, as_given(flight.setting("altitude_m")), as_given(flight.setting("mass_kg")),
           as_given(flight.setting("cg_sl_in")), branch, as_given(flight.setting("flap_deg"))})
    row.push_back(cell);
  records.add(row);
}

void add_rows(Records& records, const TrimmedFlight& flight, const ModeSet<double>& set) {
  for (int i = 0; i < set.count; ++i)
    add_row(records, flight, trim_status_word(flight.trim.status), &set.mode[i]);
}

// Rows of a model with a governor: modes of the systems besides, on an axis of their own; no branches.
class GovernedModes {
 public:
  Status find(const TrimmedFlight& flight, Analyses& work) {
    const Status status = linearize_governed(flight.configuration, flight.trim.state, flight.trim.controls,
                                             ControlSet{}, work, *matrices_);
    return status == Status::ok ? vehicle_modes(*matrices_, work, *modes_) : status;
  }
  void add_rows(Records& records, const TrimmedFlight& flight) const {
    for (int i = 0; i < modes_->count; ++i) {
      const VehicleMode<double>& m = modes_->mode[i];
      Mode<double> shown{};
      shown.real = m.real;
      shown.imag = m.imag;
      shown.frequency = m.frequency;
      shown.damping_ratio = m.damping_ratio;
      shown.time_to_half = m.time_to_half;
      shown.axis = m.axis;
      std::copy(std::begin(m.name), std::end(m.name), std::begin(shown.name));
      add_row(records, flight, trim_status_word(flight.trim.status), &shown,
              m.is_system ? "system" : nullptr);
    }
  }

 private:
  std::unique_ptr<VehicleMatrices> matrices_ = std::make_unique<VehicleMatrices>();
  std::unique_ptr<VehicleModes<double>> modes_ = std::make_unique<VehicleModes<double>>();
};

int run(const Arguments& arguments) {
  const std::vector<SetupOptions> setups = SetupOptions::every_combination(arguments);
  const bool rigid = wants_rigid(arguments);
  const Options& options = setups.front().switches();
  require_no_governor(options, arguments, "--reduce");
  flight_cases(arguments, setups.size());
  Output output(arguments);
  Records records = output.records(columns, Output::to_read);
  const AnalysesWorkspace work;
  const auto model = std::make_unique<LinearModel<double>>();
  GovernedModes with_governor;
  ModeTracker<double> tracker;
  double mast_before = 0;
  double speed_before = 0;
  const auto visit = [&](const TrimmedFlight& flight) -> int {
    const TrimResult<double>& trim = flight.trim;
    const bool connects = flight.connects && neighbours(flight, mast_before, speed_before);
    mast_before = flight.mast_deg;
    speed_before = flight.flight.speed;
    if (!flight.connects) tracker.begin_sweep();
    if (!is_trimmed(trim.status)) {
      tracker.lose_track();
      if (!flight.is_preliminary) add_row(records, flight, trim_status_word(trim.status));
      return exit_case_failed;
    }
    if (options.governor != Governor::off && flight.is_preliminary) return exit_success;
    if (options.governor != Governor::off) {
      const Status found = with_governor.find(flight, *work);
      if (found == Status::ok) {
        with_governor.add_rows(records, flight);
        return exit_success;
      }
      add_row(records, flight, status_word(found));
      std::fprintf(stderr, "tiltrotor: %s: %s\n", flight.where.c_str(), status_text(found));
      return exit_case_failed;
    }
    Status status = linearize(flight.configuration, trim.state, trim.controls, ControlSet{}, *work, *model);
    if (status == Status::ok && rigid) status = reduce_to_rigid(*model);
    if (status == Status::ok) status = tracker.find(*model, connects);
    if (flight.is_preliminary) return exit_success;
    if (status == Status::ok) {
      add_rows(records, flight, tracker.found());
      return exit_success;
    }
    add_row(records, flight, status_word(status));
    std::fprintf(stderr, "tiltrotor: %s: %s\n", flight.where.c_str(), status_text(status));
    return exit_case_failed;
  };
  const int exit_status = for_each_trim(arguments, setups, output.shard(), *work, visit, same_sweep);
  records.finish();
  return exit_status;
}

}  // namespace

Command modes_command() {
  return {
      "modes",
      "eigenvalues of A with names, frequency and damping",
      "One row for every real root or conjugate pair, longitudinal, lateral, then rotor, slow modes\n"
      "first. A negative time_to_half_s is the time to double. The name of a mode comes from its matrix\n"
      "alone, from the states that take part. Which mode of one row continues which of another is the\n"
      "number `branch`: followed along a sweep of speed at one mast angle (of mast angle at one speed) in\n"
      "steps of at most 10 m/s (10 deg). Where a pair falls apart into two real roots, and at a flight\n"
      "without a trim, branches end. A shard follows them from the beginning of its sweep.\n"
      "--mast, --speed, --altitude, --mass, --cg-sl and --flap take a value, a list or a range.\n",
      "tiltrotor modes --mast 30,60,90 --speed 60",
      reduce_option() + flight_list() + SetupOptions::list() + Output::list(),
      run};
}

}  // namespace tiltrotor::cli
