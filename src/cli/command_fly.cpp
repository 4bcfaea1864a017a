// `tiltrotor fly`: the whole vehicle flown by a script.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "cli/chosen_columns.hpp"
#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/flight_columns.hpp"
#include "cli/flight_figures.hpp"
#include "cli/flight_modes.hpp"
#include "cli/flight_options.hpp"
#include "cli/flight_script.hpp"
#include "cli/flight_script_checks.hpp"
#include "cli/flight_summary.hpp"
#include "cli/linear_options.hpp"
#include "cli/matrix_log.hpp"
#include "cli/output.hpp"
#include "cli/script_flight.hpp"
#include "cli/stamp.hpp"
#include "text/progress.hpp"
#include "text/sink.hpp"

namespace tiltrotor::cli {

namespace {

constexpr Range kSteps{0.002, 0.02, "s"};
constexpr Range kHeights{1, 10000, "m"};
constexpr Range kEvery{0, 3600, "s"};
constexpr Range kModes{0.02, 3600, "s"};
constexpr double kUsualModes = 5;     // s
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
  start.aircraft = &options.aircraft();
  if (!chooses_grid(arguments)) start.setup.options.grid = BladeGrid::realtime;
  start.setup.options.position_states = true;
  start.warmer = options.warmer();
  for (const Side side : {right, left})
    start.engine_failed[side] = options.some_engines_stand() && options.engines() <= side;
  start.speed = arguments.number("--speed", 0, kSpeedRange);
  start.height = arguments.number("--height", kUsualHeight, kHeights);
  start.dt = arguments.number("--dt", 0.01, kSteps);
  if (start.on_ground && arguments.given("--rotor-rpm"))
    throw UsageError(arguments.where("--rotor-rpm") + ": on the ground the script spools the rotors up");
  prepared(options.aircraft(), start.setup, arguments.where("--mast") + ": ");
  return start;
}

// Whether the interconnect twists at any time of the flight.
bool twists(const FlightScript& script, const Options& options) {
  return options.interconnect == Interconnect::twists ||
         std::any_of(script.events.begin(), script.events.end(), [](const ScriptEvent& e) {
           return e.command == ScriptCommand::interconnect && e.word == 1;
         });
}

// What is looked at besides the rows: modes and matrices in files of their own, and figures.
class Companions {
 public:
  Companions(const Arguments& arguments, const Options& options, bool shaft_twists)
      : subject_(arguments.text("--script", "")), finder_(control_set(arguments)) {
    every_ = arguments.number("--modes-every", kUsualModes, kModes);
    const bool asked =
        arguments.given("--modes") || arguments.given("--matrices") || arguments.given("--figures");
    if (arguments.given("--modes-every") && !asked)
      throw UsageError(arguments.where("--modes-every") +
                       ": of --modes, --matrices or --figures, none of which is given");
    if (arguments.given("--control-set") && !arguments.given("--matrices"))
      throw UsageError(arguments.where("--control-set") +
                       ": of the columns of --matrices, which is not given");
    if (arguments.given("--modes")) {
      sink_ = std::make_unique<text::Sink>(arguments.text("--modes", ""), arguments.where("--modes"));
      modes_ = std::make_unique<text::Records>(
          *sink_, text::Format::csv,
          std::vector<std::string>{"time_s", "mode", "real", "imag", "frequency_rad_s", "damping_ratio",
                                   "system_share"},
          Output::to_read, 0);
      modes_->begin_with(stamp_of(arguments));
    }
    if (arguments.given("--matrices")) {
      matrices_ = std::make_unique<MatrixLog>(arguments.text("--matrices", ""), arguments.where("--matrices"),
                                              stamp_of(arguments));
      matrices_->set_columns(finder_.states(options, shaft_twists), finder_.inputs());
    }
    if (!arguments.given("--figures")) return;
    folder_ = arguments.text("--figures", "");
    text::require_writable_folder(folder_, arguments.where("--figures"));
  }

  // At a row, and at every step.
  void add(const FlightMoment& moment) {
    if (!folder_.empty()) figures_.add(moment);
  }
  Status accompany(const ScriptFlight& flight) {
    constexpr double rounding = 1e-9;
    const double time = flight.now().time;
    const bool wants_modes = !folder_.empty() || modes_;
    if ((!wants_modes && !matrices_) || time < next_ - rounding) return Status::ok;
    next_ += every_;
    Status status = finder_.linearize(flight);
    if (status == Status::ok && matrices_) matrices_->add(time, finder_.model(flight));
    if (status == Status::ok && wants_modes) status = finder_.find();
    if (status != Status::ok || !wants_modes) return status;
    if (!folder_.empty()) figures_.add_modes(time, finder_.found());
    for (int i = 0; modes_ && i < finder_.found().count; ++i) {
      const VehicleMode<double>& mode = finder_.found().mode[i];
      modes_->add({time, std::string(mode.name), mode.real, mode.imag, mode.frequency, mode.damping_ratio,
                   mode.system_share});
    }
    return status;
  }
  void finish() {
    if (modes_) modes_->finish();
    if (matrices_) matrices_->finish();
    if (folder_.empty()) return;
    write("flight.svg", study::flight_picture("Flight by " + subject_, figures_.motion()));
    write("flight_modes.svg",
          study::flight_modes_picture("Modes along the flight by " + subject_, figures_.modes()));
  }

 private:
  void write(const char* name, const std::string& svg) const {
    text::Sink sink(folder_ + "/" + name, "fly: --figures");
    sink.write(svg);
    sink.finish();
  }

  std::string subject_, folder_;
  double every_, next_ = 0;
  std::unique_ptr<text::Sink> sink_;
  std::unique_ptr<text::Records> modes_;
  std::unique_ptr<MatrixLog> matrices_;
  FlightModes finder_;
  FlightFigures figures_;
};

int run(const Arguments& arguments) {
  if (!arguments.given("--script"))
    throw UsageError(arguments.where("--script") + ": is missing; give a file");
  const FlightScript script = read_flight_script(arguments.text("--script", ""));
  require_files_apart(arguments, script);
  FlightStart start = read_start(arguments);
  if (start.on_ground) require_governed_ground(script);
  if (start.on_ground && arguments.given("--feedback"))
    throw UsageError(arguments.where("--feedback") +
                     ": counts from the trim a flight begins in; give --mast, --speed or --height");
  const bool shaft_twists = twists(script, start.setup.options);
  const Feedback feedback(arguments, start.setup.options,
                          FlightModes::shape(start.setup.options, shaft_twists));
  const ChosenColumns columns(arguments, flight_columns());
  start.outputs = columns.airframe();
  const double every = arguments.number("--every", 0.1, kEvery);
  const std::size_t thinned =
      std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(every / start.dt)));
  Companions companions(arguments, start.setup.options, shaft_twists);
  Output output(arguments);
  Records records = output.records(columns.names(), Output::to_read);

  ScriptFlight flight(script, start, feedback);
  FlightSummary summary;
  const auto steps = static_cast<std::size_t>(std::ceil(script.duration() / start.dt - 1e-9));
  Progress progress("fly", steps + 1);
  bool goes_on = true;
  int exit_status = exit_success;
  for (std::size_t step = 0; goes_on; ++step) {
    summary.add(flight.now());
    if (step % thinned == 0 || step == steps) {
      records.add(columns.row(flight_row(flight.now()), flight.now().readings, flight.now().airframe));
      companions.add(flight.now());
    }
    const Status modes = companions.accompany(flight);
    if (modes != Status::ok) {
      progress.message("fly: linear model at " + number_text(flight.now().time, 6) +
                       " s: " + status_text(modes));
      exit_status = exit_case_failed;
    }
    progress.advance();
    goes_on = flight.step();
  }
  records.finish();
  companions.finish();
  const bool failed = flight.status() != Status::ok;
  if (failed) progress.message("fly: the flight cannot be continued: " + flight.fault());
  for (const std::string& line : flight.remarks()) summary.add(line);
  std::fputs(summary.text().c_str(), stderr);
  return failed ? exit_case_failed : exit_status;
}

// The aircraft and its air, engines told as a flight has them.
OptionList setup_options() {
  OptionList list = SetupOptions::list();
  for (Option& option : list)
    if (option.name == std::string("--engines"))
      option.help = "that run from the beginning (all); 1: the right one, as after `engine 2 fail`";
  return list;
}

OptionList options() {
  return {
      {"--script", "FILE", "what happens when, see above; - is standard input"},
      {"--mast", "DEG", "begin in trim at this mast angle (0), not on the ground"},
      {"--speed", "MPS", "of the trim (0)"},
      {"--height", "M", "of the trim above the ground, 1..10000 (300)"},
      {"--dt", "S", "time step, 0.002..0.02 (0.01)"},
      {"--modes", "FILE", "modes of the whole vehicle along the flight, as CSV"},
      {"--matrices", "DIR",
       "writes A and B of the whole vehicle to DIR/a.csv and DIR/b.csv;\nwhat is switched off has no rows, and empty cells"},
      {"--modes-every", "S", "of --modes, --matrices and --figures, 0.02..3600 (5)"},
      {"--figures", "DIR", "writes flight.svg (height, speed, masts, power) and flight_modes.svg there"},
      {"--every", "S", "a row every so many seconds (0.1); 0: every step"},
  };
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
  return {
      "fly",
      "the whole vehicle flown by a script, from the ground to the ground",
      description().c_str(),
      "tiltrotor fly --script src/examples/mission.txt --every 1 --columns time_s,height_m,airspeed_mps,mast_deg",
      options() + columns_option() + feedback_option() + control_set_option() + setup_options() +
          Output::list_of_one_piece(),
      run};
}

}  // namespace tiltrotor::cli
