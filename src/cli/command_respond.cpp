// `tiltrotor respond`: the nonlinear model flown from trim.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "cli/chosen_columns.hpp"
#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/feedback_flight.hpp"
#include "cli/flight_range.hpp"
#include "cli/governed.hpp"
#include "cli/input_text.hpp"
#include "cli/linear_options.hpp"
#include "cli/mast_moves.hpp"
#include "cli/matrix_log.hpp"
#include "cli/output.hpp"
#include "cli/response_columns.hpp"
#include "cli/stamp.hpp"
#include "cli/trimmed_flights.hpp"
#include "text/progress.hpp"
#include "tiltrotor/analysis/linear/mode_tracker.hpp"

namespace tiltrotor::cli {

namespace {

constexpr Range duration_range{0, 3600, "s"};
constexpr Range step_range{1e-4, 0.1, "s"};
constexpr double max_steps = 1e6;

struct Plan {
  std::size_t steps;  // whole ones
  double dt;
  double rest;  // s, of a shorter last step; 0: there is none
  Integrator integrator;
  std::vector<InputSignal<double>> inputs;
  MastMoves masts;
  std::size_t modes_every;  // steps; 0: never
};

// Whole steps in a time, but for the rounding of decimals.
bool is_whole(double steps) { return std::fabs(steps - std::round(steps)) <= 1e-12 * steps; }

Plan read_plan(const Arguments& arguments) {
  Plan plan{};
  const double duration = arguments.number("--duration", 3, duration_range);
  plan.dt = arguments.number("--dt", 0.005, step_range);
  const double steps = duration / plan.dt;
  if (std::round(steps) > max_steps) {
    throw UsageError(arguments.where("--duration") + ": more than " + number_text(max_steps) + " steps of " +
                     number_text(plan.dt) + " s");
  }
  plan.steps = static_cast<std::size_t>(is_whole(steps) ? std::round(steps) : steps);
  plan.rest = is_whole(steps) ? 0 : duration - static_cast<double>(plan.steps) * plan.dt;
  plan.integrator =
      static_cast<Integrator>(arguments.choice("--method", "rk4", {"rk3", "rk4", "rodas3", "exponential"}));
  for (const std::string& text : arguments.texts("--input")) {
    double begins = 0;
    if (is_mast_move(text)) {
      const MastMove move = parse_mast_move(text, arguments.where("--input"));
      plan.masts.add(move, arguments.where("--input") + " " + text);
      begins = move.start;
    } else {
      plan.inputs.push_back(parse_input(text, arguments.where("--input")));
      begins = plan.inputs.back().start;
    }
    if (begins > duration) {
      throw UsageError(arguments.where("--input") + " " + text + ": starts after the end of the flight, " +
                       number_text(duration) + " s");
    }
  }
  if (plan.inputs.size() > kMaxInputs) {
    throw UsageError(arguments.where("--input") + ": at most " + std::to_string(kMaxInputs) + " inputs");
  }
  if (arguments.given("--modes-every")) {
    const double every = arguments.number("--modes-every", 0, {plan.dt, duration_range.high, "s"});
    if (!is_whole(every / plan.dt)) {
      const double below = std::floor(every / plan.dt);
      throw UsageError(arguments.where("--modes-every") + ": " + number_text(every) +
                       " is no multiple of the time step; the nearest are " +
                       number_text(below * plan.dt, 12) + " and " + number_text((below + 1) * plan.dt, 12) +
                       " s");
    }
    plan.modes_every = static_cast<std::size_t>(std::round(every / plan.dt));
  }
  return plan;
}

FlightCase single_flight(const Arguments& arguments) {
  const std::vector<FlightCase> cases = flight_cases(arguments);
  if (cases.size() != 1)
    throw UsageError("respond: --mast, --speed and what else describes the flight take one value each");
  return cases.front();
}

// A flight as it stands, and what carries it on.
struct Flown {
  Flown(const Configuration<double>& at, const Feedback& law, Simulation<double>& s, Analyses& analyses)
      : c(at),
        simulation(s),
        systems(governed(c, s.state, s.controls)),
        feedback(law, is_governed() ? &systems : nullptr, analyses) {}
  Flown(const Flown&) = delete;
  Configuration<double> c;
  Simulation<double>& simulation;
  SystemFlight<double> systems;  // where the rotors have a governor
  FeedbackFlight feedback;
  bool is_governed() const { return c.setup.options.governor != Governor::off; }
};

// Linear models along the flight, where somebody wants them.
class Companions {
 public:
  Companions(const Arguments& arguments, const Feedback& feedback, const Plan& plan)
      : feedback_(feedback),
        controls_(control_set(arguments)),
        whole_steps_(plan.steps),
        modes_every_(plan.modes_every) {}

  // Throws UsageError when the folder cannot be written.
  void open_matrices(const Arguments& arguments) {
    matrices_.emplace(arguments.text("--matrices", ""), arguments.where("--matrices"), stamp_of(arguments));
  }

  // Appends the cells of the modes, if there are such columns.
  Status accompany(std::size_t step, const Flown& flown, Analyses& analyses, Row& row) {
    const bool wants_modes = modes_every_ > 0 && step <= whole_steps_ && step % modes_every_ == 0;
    if (!wants_modes && !matrices_) {
      if (modes_every_ > 0) append(flown, false, row);
      return Status::ok;
    }
    Status status = flown.is_governed() ? look_at_vehicle(flown, wants_modes, analyses)
                                        : look_at_airframe(flown, wants_modes, analyses);
    if (modes_every_ > 0) append(flown, wants_modes && status == Status::ok, row);
    return status;
  }
  void finish() {
    if (matrices_ && !matrices_->is_empty()) matrices_->finish();
  }

 private:
  Status look_at_airframe(const Flown& flown, bool wants_modes, Analyses& analyses) {
    const Simulation<double>& s = flown.simulation;
    const State<double> x = current_state(s);
    const Controls<double>& u = flown.feedback.acting();
    const double azimuth = current_azimuth(flown.c, s);
    const Status status = feedback_.is_given()
                              ? feedback_.linearize(flown.c, x, u, controls_, analyses, *model_, nullptr,
                                                    flown.feedback.point(), azimuth)
                              : linearize(flown.c, x, u, controls_, analyses, *model_, azimuth);
    if (status != Status::ok) return status;
    if (matrices_) matrices_->add(current_time(s), ShownModel(*model_));
    return wants_modes ? modes_.find(*model_, true) : status;
  }
  Status look_at_vehicle(const Flown& flown, bool wants_modes, Analyses& analyses) {
    const Simulation<double>& s = flown.simulation;
    const State<double> x = current_state(s);
    const Controls<double>& u = flown.feedback.acting();
    const Status status = feedback_.linearize_flight(flown.c, flown.systems, x, u, controls_,
                                                     CommandColumns::throttles, analyses, *vehicle_, nullptr,
                                                     flown.feedback.point(), current_azimuth(flown.c, s));
    if (status != Status::ok) return status;
    if (matrices_) {
      const ShownModel shown(*vehicle_, x, flown.systems.state, u, flown.systems.vehicle.commands);
      matrices_->add(current_time(s), shown);
    }
    return wants_modes ? vehicle_modes(*vehicle_, analyses, *vehicle_modes_) : status;
  }
  void append(const Flown& flown, bool found, Row& row) const {
    if (flown.is_governed()) {
      append_modes(row, found ? vehicle_modes_.get() : nullptr, flown.c.setup.options);
    } else {
      append_modes(row, found ? &modes_.found() : nullptr);
    }
  }

  const Feedback& feedback_;
  ControlSet controls_;
  std::size_t whole_steps_;
  std::size_t modes_every_;
  std::optional<MatrixLog> matrices_;
  std::unique_ptr<LinearModel<double>> model_ = std::make_unique<LinearModel<double>>();
  ModeTracker<double> modes_;
  std::unique_ptr<VehicleMatrices> vehicle_ = std::make_unique<VehicleMatrices>();
  std::unique_ptr<VehicleModes<double>> vehicle_modes_ = std::make_unique<VehicleModes<double>>();
};

// With what is read beside the row.
Row chosen_row(const ChosenColumns& columns, const Row& own, const Flown& flown,
               const Controls<double>& acting) {
  if (!columns.have_readings() && columns.airframe().empty()) return columns.row(own, no_readings(), {});
  const State<double> x = current_state(flown.simulation);
  VehicleMoment now;
  read_vehicle_moment(flown.systems, flown.c, x, acting, current_azimuth(flown.c, flown.simulation), now);
  return columns.row(
      own, now.found.readings,
      airframe_readings(now.put, x, now.found.steps, now.found.answer.rates, columns.airframe()));
}

int fly(const TrimmedFlight& flight, const Plan& plan, const Feedback& feedback,
        Simulation<double>& simulation, Analyses& analyses, Companions& companions,
        const ChosenColumns& columns, Records& records) {
  Flown flown(flight.configuration, feedback, simulation, analyses);
  Configuration<double>& c = flown.c;
  const std::size_t steps = plan.steps + (plan.rest > 0 ? 1 : 0);
  Progress progress("respond", steps);
  int exit_status = exit_success;
  Status status = flown.feedback.begin(c, simulation);
  for (std::size_t step = 0;; ++step) {
    const std::string now = number_text(current_time(simulation), 6) + " s";
    if (status == Status::ok) status = flown.feedback.act(c, simulation);
    if (status != Status::ok) {
      progress.message("respond: the flight cannot be continued beyond " + now + fault_text(simulation) +
                       ": " + status_text(status));
      return exit_case_failed;
    }
    const Controls<double>& acting = flown.feedback.acting();
    const double added = governed_collective(c, flown.systems, current_state(simulation), acting,
                                             current_azimuth(c, simulation));
    Row row = response_row(flight, c, simulation, acting, added);
    const Status linear = companions.accompany(step, flown, analyses, row);
    records.add(chosen_row(columns, row, flown, acting));
    if (linear != Status::ok) {
      progress.message("respond: linear model at " + now + ": " + status_text(linear));
      exit_status = exit_case_failed;
    }
    if (step == steps) return exit_status;
    if (step == plan.steps) status = change_step(simulation, plan.rest);
    if (status == Status::ok) status = plan.masts.advance(c, flown.feedback, simulation);
    if (status == Status::ok) progress.advance();
  }
}

int run(const Arguments& arguments) {
  const SetupOptions setup(arguments);
  single_flight(arguments);
  if (wants_scas(arguments))
    throw UsageError(
        arguments.where("--scas") +
        ": respond flies the bare airframe, with a governor or a law of --feedback; `tiltrotor fly "
        "--mast .. --speed .. --script FILE` flies with the augmentation");
  const Plan plan = read_plan(arguments);
  if (plan.integrator >= Integrator::rodas3) require_no_governor(setup.switches(), arguments, "--method");
  const Feedback feedback(arguments, setup.switches(), false);
  Companions companions(arguments, feedback, plan);
  if (arguments.given("--control-set") && !arguments.given("--matrices"))
    throw UsageError(arguments.where("--control-set") + ": of the columns of --matrices, which is not given");
  const ChosenColumns columns(arguments, response_columns(plan.modes_every > 0, setup.switches()));
  Output output(arguments);
  if (arguments.given("--matrices")) {
    companions.open_matrices(arguments);
  }
  Records records = output.records(columns.names(), Output::to_read);
  const AnalysesWorkspace work;
  const auto visit = [&](const TrimmedFlight& flight) -> int {
    if (!is_trimmed(flight.trim.status)) return exit_case_failed;
    const auto simulation = std::make_unique<Simulation<double>>();
    Status status = start(flight.configuration, flight.trim.state, flight.trim.controls, plan.dt,
                          plan.integrator, *simulation);
    for (const InputSignal<double>& input : plan.inputs) {
      if (status == Status::ok) status = add_input(*simulation, input);
    }
    if (status == Status::ok) {
      require_inputs(*simulation, arguments.where("--input"));
      plan.masts.require_range(flight.configuration.setup.mast_deg, arguments.where("--input"));
      return fly(flight, plan, feedback, *simulation, *work, companions, columns, records);
    }
    std::fprintf(stderr, "tiltrotor: respond: cannot start: %s\n", status_text(status));
    return exit_case_failed;
  };
  const int exit_status = for_each_trim(arguments, {setup}, Shard{}, *work, visit);
  companions.finish();
  records.finish();
  return exit_status;
}

OptionList options() {
  return {
      {"--scas", "STATE", "off alone: with the augmentation flies `fly`"},
      {"--input", "INPUT", "a test input, see above; repeatable", true},
      {"--duration", "S", "0..3600 (3); the last step is shorter where --dt does not divide it"},
      {"--dt", "S", "time step, 1e-4..0.1 (0.005); inputs act at their times, whatever the step"},
      {"--method", "NAME",
       "rk3, rk4, rodas3 or exponential (rk4); the first two take a step that\n"
       "is too long for them in equal parts, the others are for long steps,\nexponential of order 2"},
      {"--modes-every", "S",
       "adds name, real and imaginary part and branch of the body's modes\nto a row every S seconds, a "
       "multiple of --dt"},
      {"--matrices", "DIR", "writes A and B at every step to DIR/a.csv and DIR/b.csv"},
  };
}

const std::string& description() {
  static const std::string text = std::string(
                                      "Flies the nonlinear model from trim. One row a step: the state, and "
                                      "the controls that act from then on; `limits` names those beyond their "
                                      "stops. With a governor the collective holds\n"
                                      "what it adds, governor_deg; its modes have no branch, and columns of "
                                      "the throttles stand in b.csv.\n\n") +
                                  kInputGrammar;
  return text;
}

}  // namespace

Command respond_command() {
  return {"respond",
          "time response to control inputs, with linear models along the way",
          description().c_str(),
          "tiltrotor respond --mast 0 --speed 40 --input collective=1deg@0 --duration 3 --modes-every 1",
          options() + columns_option() + feedback_option() + control_set_option() + flight_list() +
              SetupOptions::list() + Output::list_of_one_piece(),
          run};
}

}  // namespace tiltrotor::cli
