// `tiltrotor qualities`: levels of handling qualities, with the source of each limit.

#include <cmath>
#include <cstdio>

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/feedback.hpp"
#include "cli/figure.hpp"
#include "cli/flight_records.hpp"
#include "cli/governed.hpp"
#include "cli/handling_figure.hpp"
#include "cli/linear_options.hpp"
#include "cli/output.hpp"
#include "cli/trimmed_flights.hpp"

namespace tiltrotor::cli {

namespace {

const std::vector<std::string> columns = {"mast_deg",   "speed_mps", "criterion", "quantity",   "value",
                                          "unit",       "level",     "low_1",     "high_1",     "low_2",
                                          "high_2",     "low_3",     "high_3",    "confidence", "status",
                                          "altitude_m", "mass_kg",   "cg_sl_in",  "flap_deg",   "source"};

class Qualities {
 public:
  Qualities(const Arguments& arguments, const std::vector<SetupOptions>& setups)
      : criteria_(handling_criteria("ABC"[arguments.choice("--category", "B", {"A", "B", "C"})],
                                    arguments.command())),
        scas_(wants_scas(arguments)),
        feedback_(arguments, setups.front().switches(), scas_),
        output_(arguments),
        figure_(arguments),
        records_(arguments, setups, output_, columns, Output::to_read) {}

  const Shard& shard() const { return output_.shard(); }

  int add(const TrimmedFlight& flight, Analyses& work) {
    const char* const trim_status = trim_status_word(flight.trim.status);
    if (!is_trimmed(flight.trim.status)) return add_failed(flight, trim_status);
    const auto& [state, controls] = std::tie(flight.trim.state, flight.trim.controls);
    Status status = feedback_.linearize_governed(flight.configuration, state, controls, kInceptors, work,
                                                 *matrices_, scas_);
    JudgedFlight judged{flight.mast_deg, flight.flight.speed, {}};
    if (status == Status::ok)
      status =
          handling_quantities(flight.configuration, state, controls, *matrices_, work, judged.quantities);
    if (status != Status::ok) {
      std::fprintf(stderr, "tiltrotor: %s: %s\n", flight.where.c_str(), status_text(status));
      return add_failed(flight, status_word(status));
    }
    for (const Criterion& criterion : criteria_) {
      if (criterion.in_hover != (flight.flight.speed <= kLowSpeed) || !is_of(criterion, flight)) continue;
      const auto found = judged.quantities.find(criterion.quantity);
      const bool has = found != judged.quantities.end();
      add_row(flight, criterion, has ? found->second : std::nan(""),
              has ? level_of(criterion, found->second) : "not defined", trim_status);
    }
    if (figure_.wanted()) flights_.push_back(judged);
    return exit_success;
  }

  void finish() {
    records_.finish();
    figure_.draw("Handling qualities against published boundaries", handling_plots(criteria_, flights_));
  }

 private:
  // Of two that differ by the flaps the one that is meant.
  static bool is_of(const Criterion& criterion, const TrimmedFlight& flight) {
    const bool down = flight.configuration.setup.flap_deg > 0;
    const auto names = [&](const char* words) { return criterion.name.find(words) != std::string::npos; };
    return !(names("flaps up") && down) && !(names("flaps down") && !down);
  }

  int add_failed(const TrimmedFlight& flight, const char* status) {
    add_row(flight, {}, std::nan(""), "", status);
    return exit_case_failed;
  }

  void add_row(const TrimmedFlight& flight, const Criterion& c, double value, const std::string& level,
               const char* status) {
    Row row = {
        as_given(flight.mast_deg), as_given(flight.flight.speed), c.name, c.quantity, value, c.unit, level};
    for (const Limit& limit : c.level) {
      row.emplace_back(limit.low);
      row.emplace_back(limit.high);
    }
    row.emplace_back(c.confidence);
    row.emplace_back(std::string(status));
    for (const char* setting : {"altitude_m", "mass_kg", "cg_sl_in", "flap_deg"})
      row.emplace_back(as_given(flight.setting(setting)));
    row.emplace_back(c.source);
    records_.add(flight, row);
  }

  std::vector<Criterion> criteria_;
  bool scas_;
  Feedback feedback_;
  Output output_;  // last of what arguments can refuse
  Figure figure_;
  FlightRecords records_;
  std::vector<JudgedFlight> flights_;
  std::unique_ptr<VehicleMatrices> matrices_ = std::make_unique<VehicleMatrices>();
};

int run(const Arguments& arguments) {
  const std::vector<SetupOptions> setups = SetupOptions::every_combination(arguments);
  require_no_positions(setups.front().switches(), arguments);
  flight_cases(arguments, setups.size());
  Qualities qualities(arguments, setups);
  const AnalysesWorkspace work;
  const int exit_status =
      for_each_trim(arguments, setups, qualities.shard(), *work,
                    [&](const TrimmedFlight& flight) -> int { return qualities.add(flight, *work); });
  qualities.finish();
  return exit_status;
}

}  // namespace

Command qualities_command() {
  return {
      "qualities",
      "levels of handling qualities, each with its source",
      "One row for every criterion that is written for the flight: up to 45 kt those of hover and low speed (MIL-H-8501A,\n"
      "MIL-F-83300, AGARD R-577, parts of ADS-33), beyond those of forward flight (MIL-F-8785C and MIL-STD-1797A, classes II\n"
      "and III, whatever the mast angle). Limits are those of tables/xv15/published/handling_qualities.csv that were read\n"
      "from a source (confidence high or medium), in the unit they have there. Level 1, 2 or 3; `below 2`: worse than the\n"
      "last limit there is; `met` or `not met` where a requirement has no levels; `not defined`: the flight has no such mode.\n"
      "From the linear model: sensitivity and damping with rotors, wash and series actuators in their balance; attitudes\n"
      "after an inch of stick or pedal; control power from trim to the nearer stop; bank with all the stick there is to it.\n"
      "Everything that describes the flight takes a value, a list or a range; so do --altitude, --mass, --cg-sl,\n"
      "--flap, --rotor-rpm and --isa-offset.\n",
      "tiltrotor qualities --mast 90 --speed 80:20:120 --scas on --option governor=pi",
      OptionList{
          {"--category", "A|B|C", "flight phase of forward flight: A precise, B cruise, C landing (B)"}} +
          scas_option() + feedback_option() + figure_option("flights against the boundaries as SVG") +
          flight_list() + SetupOptions::list() + Output::list(),
      run};
}

}  // namespace tiltrotor::cli
