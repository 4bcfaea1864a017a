// `tiltrotor fly`: the whole vehicle flown by a script.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/flight_columns.hpp"
#include "cli/flight_options.hpp"
#include "cli/flight_script.hpp"
#include "cli/flight_summary.hpp"
#include "cli/output.hpp"
#include "cli/script_flight.hpp"
#include "text/progress.hpp"

namespace tiltrotor::cli {

namespace {

constexpr Range kSteps{0.002, 0.02, "s"};
constexpr Range kHeights{1, 10000, "m"};
constexpr Range kEvery{0, 3600, "s"};
constexpr double kUsualHeight = 300;  // m

bool chooses_grid(const Arguments& arguments) {
  const std::vector<std::string> options = arguments.texts("--option");
  return arguments.given("--grid") || arguments.given("--preset") ||
         std::any_of(options.begin(), options.end(),
                     [](const std::string& option) { return option.rfind("grid=", 0) == 0; });
}

FlightStart read_start(const Arguments& arguments) {
  const SetupOptions options(arguments);
  FlightStart start{};
  start.on_ground = !arguments.given("--speed") && !arguments.given("--mast") && !arguments.given("--height");
  const double mast_deg = arguments.number("--mast", 0, kMastRange);
  start.setup = options.flight_setup(mast_deg);
  if (!chooses_grid(arguments)) start.setup.options.grid = BladeGrid::realtime;
  start.setup.options.position_states = true;
  start.speed = arguments.number("--speed", 0, kSpeedRange);
  start.height = arguments.number("--height", kUsualHeight, kHeights);
  start.dt = arguments.number("--dt", 0.01, kSteps);
  if (start.on_ground && arguments.given("--rotor-rpm"))
    throw UsageError(arguments.where("--rotor-rpm") + ": on the ground the script spools the rotors up");
  prepared(start.setup, arguments.where("--mast") + ": ");
  return start;
}

int run(const Arguments& arguments) {
  if (!arguments.given("--script")) throw UsageError(arguments.where("--script") + ": is missing; give a file");
  const FlightScript script = read_flight_script(arguments.text("--script", ""));
  const FlightStart start = read_start(arguments);
  std::string all;
  for (const std::string& name : flight_columns()) all += (all.empty() ? "" : ",") + name;
  const std::vector<std::size_t> columns =
      chosen_columns(arguments.text("--columns", all), arguments.where("--columns"));
  const double every = arguments.number("--every", 0.1, kEvery);
  const std::size_t thinned = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(every / start.dt)));
  Output output(arguments);
  std::vector<std::string> names;
  for (const std::size_t place : columns) names.push_back(flight_columns()[place]);
  Records records = output.records(names, Output::to_read);

  ScriptFlight flight(script, start);
  FlightSummary summary;
  const auto steps = static_cast<std::size_t>(std::ceil(script.duration() / start.dt - 1e-9));
  Progress progress("fly", steps + 1);
  bool goes_on = true;
  for (std::size_t step = 0; goes_on; ++step) {
    summary.add(flight.now());
    if (step % thinned == 0 || step == steps) records.add(flight_row(flight.now(), columns));
    progress.advance();
    goes_on = flight.step();
  }
  records.finish();
  const bool failed = flight.status() != Status::ok;
  if (failed) progress.message("fly: the flight cannot be continued: " + flight.fault());
  std::fputs(summary.text().c_str(), stderr);
  return failed ? exit_case_failed : exit_success;
}

OptionList options() {
  return {
      {"--script", "FILE", "what happens when, see above; - is standard input"},
      {"--mast", "DEG", "begin in trim at this mast angle (0), not on the ground"},
      {"--speed", "MPS", "of the trim (0)"},
      {"--height", "M", "of the trim above the ground, 1..10000 (300)"},
      {"--dt", "S", "time step, 0.002..0.02 (0.01)"},
      {"--columns", "A,B,..", "only these, in this order"},
      {"--every", "S", "a row every so many seconds (0.1); 0: every step"},
  };
}

OptionList output_list() {
  OptionList list = Output::list();
  list.erase(std::remove_if(list.begin(), list.end(),
                            [](const Option& option) { return option.name == std::string("--shard"); }),
             list.end());
  return list;
}

const std::string& description() {
  static const std::string text =
      "Flies the aircraft with all its systems as a script says, with a reference pilot at the controls: from the ground,\n"
      "or from a trim with the gear up. One row every 0.1 s; a summary goes to standard error.\n\n" +
      script_help();
  return text;
}

}  // namespace

Command fly_command() {
  return {"fly",
          "the whole vehicle flown by a script, from the ground to the ground",
          description().c_str(),
          "tiltrotor fly --script src/examples/mission.txt --every 1 --columns time_s,height_m,airspeed_mps,mast_deg",
          options() + SetupOptions::list() + output_list(),
          run};
}

}  // namespace tiltrotor::cli
