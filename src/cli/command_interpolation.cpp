// `tiltrotor interpolation`: how much of each stability derivative is data, rounding of the print, or interpolation.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "cli/changed_aircraft.hpp"
#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/flight_records.hpp"
#include "cli/governed.hpp"
#include "cli/linear_options.hpp"
#include "cli/print_rounding.hpp"
#include "text/rounding.hpp"
#include "tiltrotor/model/aircraft/c2_aircraft.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

const std::vector<std::string> columns = {"mast_deg",
                                          "speed_mps",
                                          "derivative",
                                          "unit",
                                          "c1",
                                          "linear",
                                          "c2",
                                          "interpolation_band",
                                          "rounding",
                                          "data_percent",
                                          "interpolation_percent",
                                          "rounding_percent",
                                          "status",
                                          "altitude_m",
                                          "mass_kg",
                                          "cg_sl_in",
                                          "flap_deg"};

// Rows and columns of the rigid body that make stability derivatives: u v w p q r.
constexpr const char* kForces[] = {"X", "Y", "Z", "L", "M", "N"};
constexpr int kMotions = 6;

// Place of a motion, or -1.
int motion_of(int state) {
  const State<int>& at = kStateIndex;
  const int places[kMotions] = {at.velocity.x, at.velocity.y, at.velocity.z,
                                at.rates.x,    at.rates.y,    at.rates.z};
  const int* const found = std::find(places, places + kMotions, state);
  return found == places + kMotions ? -1 : static_cast<int>(found - places);
}

class Interpolations {
 public:
  Interpolations(const Arguments& arguments, const std::vector<SetupOptions>& setups)
      : draws_(parse_integer(arguments.text("--draws", "64"), arguments.where("--draws"), 2, 10000)),
        output_(arguments),
        records_(arguments, setups, output_, columns, Output::to_read) {}

  const Shard& shard() const { return output_.shard(); }
  Analyses& work() const { return *work_; }
  void finish() { records_.finish(); }

  int add(const TrimmedFlight& flight) {
    if (!is_trimmed(flight.trim.status)) return add_failed(flight, trim_status_word(flight.trim.status));
    Configuration<double> straight = flight.configuration;
    straight.setup.options.tables = Interpolation::linear;
    const auto keep = [](ChangedAircraft&) {};
    const auto smooth = [&](ChangedAircraft& changed) {
      const int engines = changed.aircraft.controls.engines;
      changed.aircraft = c2_aircraft_data();
      changed.aircraft.controls.engines = engines;
    };
    const Model c1 = model_of(flight, flight.configuration, keep);
    const Model linear = model_of(flight, straight, keep);
    const Model c2 = model_of(flight, flight.configuration, smooth);
    if (!c1 || !linear || !c2) return fail(flight, !c1 ? "c1" : !linear ? "linear" : "c2");
    std::vector<Model> drawn;
    PrintRounding rounding;
    for (long k = 0; k < draws_; ++k) {
      drawn.push_back(model_of(flight, flight.configuration, [&](ChangedAircraft& changed) {
        rounding.draw(static_cast<std::uint64_t>(k), changed.aircraft);
      }));
      if (!drawn.back()) return fail(flight, "a draw of the print");
    }
    for (int i = 0; i < c1->states; ++i)
      for (int j = 0; j < c1->states; ++j) add_derivative(flight, {&*c1, &*linear, &*c2}, drawn, i, j);
    return exit_success;
  }

 private:
  using Model = std::unique_ptr<LinearModel<double>>;
  struct Three {
    const LinearModel<double>*c1, *linear, *c2;
  };

  // Of the same flight of another aircraft, which has a trim of its own; none where it has not.
  template <class Change>
  Model model_of(const TrimmedFlight& flight, const Configuration<double>& base, Change&& change) {
    const ChangedAircraft changed(base, change);
    TrimmedFlight other = flight;
    other.configuration = changed.configuration();
    trim_flight(other, *work_);
    if (!is_trimmed(other.trim.status)) return nullptr;
    auto model = std::make_unique<LinearModel<double>>();
    Status status =
        linearize(other.configuration, other.trim.state, other.trim.controls, kInceptors, *work_, *model);
    if (status == Status::ok) status = reduce_to_rigid(*model, Reduction::first_order);
    if (status != Status::ok) return nullptr;
    *model = text::without_rounding(*model);
    return model;
  }

  void add_derivative(const TrimmedFlight& flight, const Three& by, const std::vector<Model>& drawn, int i,
                      int j) {
    const int row = motion_of(by.c1->state[i]);
    const int column = motion_of(by.c1->state[j]);
    if (row < 0 || column < 0) return;
    const double c1 = by.c1->a(i, j);
    const double linear = by.linear->a(i, j);
    const double c2 = by.c2->a(i, j);
    if (c1 == 0 && linear == 0 && c2 == 0) return;
    const auto [low, high] = std::minmax({c1, linear, c2});
    double squares = 0;
    for (const Model& model : drawn) squares += (model->a(i, j) - c1) * (model->a(i, j) - c1);
    const double rounding = std::sqrt(squares / static_cast<double>(drawn.size()));
    constexpr double percent = 100;
    const double whole = std::abs(c1) + (high - low) + rounding;
    const std::string force = kForces[row];
    const std::string unit =
        row < 3 ? (column < 3 ? "1/s" : "m/(rad s)") : (column < 3 ? "rad/(m s)" : "1/s");
    records_.add(flight, {as_given(flight.mast_deg), as_given(flight.flight.speed),
                          force + "_" + "uvwpqr"[column], unit, c1, linear, c2, high - low, rounding,
                          percent * std::abs(c1) / whole, percent * (high - low) / whole,
                          percent * rounding / whole, std::string(trim_status_word(flight.trim.status)),
                          as_given(flight.setting("altitude_m")), as_given(flight.setting("mass_kg")),
                          as_given(flight.setting("cg_sl_in")), as_given(flight.setting("flap_deg"))});
  }

  int add_failed(const TrimmedFlight& flight, const char* status) {
    Row row = {as_given(flight.mast_deg), as_given(flight.flight.speed), "", ""};
    row.insert(row.end(), 8, kNothing);
    row.emplace_back(std::string(status));
    for (const char* setting : {"altitude_m", "mass_kg", "cg_sl_in", "flap_deg"})
      row.emplace_back(as_given(flight.setting(setting)));
    records_.add(flight, row);
    return exit_case_failed;
  }
  int fail(const TrimmedFlight& flight, const char* tables) {
    std::fprintf(stderr, "tiltrotor: %s: no trim or no linear model with tables %s\n", flight.where.c_str(),
                 tables);
    return add_failed(flight, "no_model");
  }

  long draws_;
  Output output_;  // last of what arguments can refuse
  FlightRecords records_;
  AnalysesWorkspace work_;
};

int run(const Arguments& arguments) {
  const std::vector<SetupOptions> setups = SetupOptions::every_combination(arguments);
  const SetupOptions& setup = setups.front();
  require_no_governor(setup.switches(), arguments, "--option");
  require_no_positions(setup.switches(), arguments);
  if (setup.switches().tables != Interpolation::c1 || has_c2_tables(setup.aircraft()))
    throw UsageError("interpolation: compares all kinds of tables: leave --tables and --option tables out");
  flight_cases(arguments, setups.size());
  Interpolations rows(arguments, setups);
  const int exit_status = for_each_trim(arguments, setups, rows.shard(), rows.work(),
                                        [&](const TrimmedFlight& flight) -> int { return rows.add(flight); });
  rows.finish();
  return exit_status;
}

}  // namespace

Command interpolation_command() {
  return {
      "interpolation",
      "how much of each stability derivative is data, rounding of the print, or interpolation",
      "Each derivative of the rigid body, rotors and wash following (--reduce rigid of linearize), at the trim of its own\n"
      "tables: c1, linear and c2. interpolation_band: largest less smallest of the three. rounding: root mean square of\n"
      "what changes when every printed number of the tables of loads moves within half a unit of its last digit, by chance,\n"
      "over --draws draws, always the same. The three percentages are shares of |c1| + interpolation_band + rounding.\n",
      "tiltrotor interpolation --mast 30 --speed 46 --grid realtime --draws 8",
      OptionList{{"--draws", "N", "of the print, 2..10000 (64)"}} + flight_list() + SetupOptions::list() +
          Output::list(),
      run};
}

}  // namespace tiltrotor::cli
