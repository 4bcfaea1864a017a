// `tiltrotor performance`: best speeds, climb and ceilings at every combination of mast angle and setting.

#include <limits>

#include "cli/analyses_workspace.hpp"
#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/flight_options.hpp"
#include "cli/output.hpp"
#include "cli/performance.hpp"
#include "cli/state_columns.hpp"
#include "text/progress.hpp"

namespace tiltrotor::cli {

namespace {

constexpr Range height_range{0, 100, "m"};

const std::vector<std::string> columns = {
    "mast_deg",          "figure",     "value",   "unit",     "speed_mps", "power_kw",  "limit",
    "flight_altitude_m", "altitude_m", "mass_kg", "cg_sl_in", "flap_deg",  "rotor_rpm", "model"};

Row row(const Performance& p, double mast_deg, const SetupOptions& setup, const FlightSetup<double>& flown,
        const Units& units) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  const InUnit unit = units.sign(figure_unit(p.figure));
  Row cells = {as_given(mast_deg),
               figure_name(p.figure),
               p.value.value_or(nothing) / unit.size,
               unit.name,
               p.speed,
               p.power_kw,
               p.limit,
               p.altitude_m};
  for (const char* setting : {"altitude_m", "mass_kg", "cg_sl_in", "flap_deg", "rotor_rpm"})
    cells.emplace_back(as_given(setup.given(setting).value_or(setting_value(setting, flown))));
  cells.emplace_back(setup.model());
  return cells;
}

int run(const Arguments& arguments) {
  const std::vector<SetupOptions> setups = SetupOptions::every_combination(arguments);
  const std::vector<double> masts = arguments.sweep("--mast", "0", kMastRange);
  const double height = arguments.number("--wheel-height", 0, height_range);
  require_few(arguments.command(), {setups.size(), masts.size()});
  Output output(arguments);
  Records records = output.records(columns, Output::to_read);
  const AnalysesWorkspace work;
  const std::size_t count = setups.size() * masts.size();
  const std::size_t end = output.shard().end(count);
  Progress progress(arguments.command(), end - output.shard().begin(count));
  for (std::size_t i = output.shard().begin(count); i < end; ++i) {
    const SetupOptions& setup = setups[i / masts.size()];
    const double mast_deg = masts[i % masts.size()];
    const Configuration<double> c = setup.configuration(mast_deg);
    for (const Performance& p : performance(c, height, *work))
      records.add(row(p, mast_deg, setup, c.setup, arguments.units()));
    progress.advance();
  }
  records.finish();
  return exit_success;
}

}  // namespace

Command performance_command() {
  return {
      "performance",
      "speeds of least power and best range, top speeds, climb, ceilings, one engine out",
      "One row for every figure, searched among the trims at each combination of mast angle and setting:\n"
      "  least_power, best_range (least power over speed)          level flight\n"
      "  top_speed                                                 inside every limit\n"
      "  top_speed_power, top_speed_torque                         take-off power; steady torque of a mast\n"
      "  best_climb                                                rate of climb with all of both\n"
      "  hover_ceiling, hover_ceiling_in_ground                    the same, wheels at --wheel-height in the latter\n"
      "  one_engine_least_speed, _top_speed, _ceiling, _hover_ceiling   contingency power of one engine\n"
      "`limit` is what the next flight would exceed (power, torque, or another word of trim); where a figure\n"
      "has no value, what ends the flights before it.\n"
      "Ceilings are of all altitudes, whatever --altitude. Flights are inside every other limit of `trim`. Speed\n"
      "and power are those of the flight, which is at flight_altitude_m.\n",
      "tiltrotor performance --mast 0,90 --format csv",
      mast_option() + OptionList{{"--wheel-height", "M", "over the ground in ground effect, 0..100 (0)"}} +
          SetupOptions::list() + Output::list(),
      run};
}

}  // namespace tiltrotor::cli
