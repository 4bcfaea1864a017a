// `tiltrotor respond`: the nonlinear model flown from trim.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/input_text.hpp"
#include "cli/linear_options.hpp"
#include "cli/matrix_log.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/trimmed_flights.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double radian = kRadian<double>;

// Modes shown in a row: those of the 8 rigid-body states and the downwash; the rotors' are left out.
constexpr int shown_modes = kRigidStates + 1;

constexpr Range duration_range{0, 3600, "s"};
constexpr Range step_range{1e-4, 0.1, "s"};
constexpr double max_steps = 1e6;

struct Moment {
  const Simulation<double>& simulation;
  const State<double>& x;
  Controls<double> u;  // what acts from here on
};
using Now = const Moment&;

struct Column {
  const char* name;
  double (*value)(Now);
};

double speed(Now m) { return std::sqrt(dot(m.x.velocity, m.x.velocity)); }

// Along the heading, level with the ground.
double forward_speed(Now m) {
  const Vec3<double>& v = m.x.velocity;
  const double lateral_plane = v.y * std::sin(m.x.roll) + v.z * std::cos(m.x.roll);
  return v.x * std::cos(m.x.pitch) + lateral_plane * std::sin(m.x.pitch);
}
double climb_rate(Now m) {
  const Vec3<double>& v = m.x.velocity;
  const double lateral_plane = v.y * std::sin(m.x.roll) + v.z * std::cos(m.x.roll);
  return v.x * std::sin(m.x.pitch) - lateral_plane * std::cos(m.x.pitch);
}

const Column columns[] = {
    {"time_s", [](Now m) { return current_time(m.simulation); }},
    {"u_mps", [](Now m) { return m.x.velocity.x; }},
    {"v_mps", [](Now m) { return m.x.velocity.y; }},
    {"w_mps", [](Now m) { return m.x.velocity.z; }},
    {"p_degps", [](Now m) { return m.x.rates.x / radian; }},
    {"q_degps", [](Now m) { return m.x.rates.y / radian; }},
    {"r_degps", [](Now m) { return m.x.rates.z / radian; }},
    {"roll_deg", [](Now m) { return m.x.roll / radian; }},
    {"pitch_deg", [](Now m) { return m.x.pitch / radian; }},
    {"yaw_deg", [](Now m) { return m.x.yaw / radian; }},
    {"speed_mps", speed},
    {"forward_speed_mps", forward_speed},
    {"climb_rate_mps", climb_rate},
    {"collective75_deg", [](Now m) { return m.u.collective / radian; }},
    // Inches from neutral.
    {"long_stick_from_neutral_in", [](Now m) { return m.u.long_stick; }},
    {"lat_stick_in", [](Now m) { return m.u.lat_stick; }},
    {"pedal_in", [](Now m) { return m.u.pedal; }},
    {"b1c_right_deg", [](Now m) { return m.x.rotor[right].b1c / radian; }},
    {"b1s_right_deg", [](Now m) { return m.x.rotor[right].b1s / radian; }},
    {"n0_right", [](Now m) { return m.x.rotor[right].n0; }},
    {"b1c_left_deg", [](Now m) { return m.x.rotor[left].b1c / radian; }},
    {"b1s_left_deg", [](Now m) { return m.x.rotor[left].b1s / radian; }},
    {"n0_left", [](Now m) { return m.x.rotor[left].n0; }},
    {"downwash_deg", [](Now m) { return m.x.downwash / radian; }},
};

struct Plan {
  std::size_t steps;
  double dt;
  Integrator integrator;
  std::vector<InputSignal<double>> inputs;
  std::size_t modes_every;  // steps; 0: never
};

Plan read_plan(const Arguments& arguments) {
  Plan plan{};
  const double duration = arguments.number("--duration", 3, duration_range);
  plan.dt = arguments.number("--dt", 0.005, step_range);
  const double steps = std::round(duration / plan.dt);
  if (steps > max_steps) {
    throw UsageError(arguments.where("--duration") + ": more than " + number_text(max_steps) + " steps of " +
                     number_text(plan.dt) + " s");
  }
  plan.steps = static_cast<std::size_t>(steps);
  plan.integrator = static_cast<Integrator>(arguments.choice("--method", "rk4", {"rk4", "rodas3"}));
  for (const std::string& text : arguments.texts("--input")) {
    plan.inputs.push_back(parse_input(text, arguments.where("--input")));
  }
  if (plan.inputs.size() > kMaxInputs) {
    throw UsageError(arguments.where("--input") + ": at most " + std::to_string(kMaxInputs) + " inputs");
  }
  if (arguments.given("--modes-every")) {
    const double every = arguments.number("--modes-every", 0, {plan.dt, duration_range.high, "s"});
    plan.modes_every = static_cast<std::size_t>(std::round(every / plan.dt));
  }
  return plan;
}

FlightCase single_flight(const Arguments& arguments) {
  const std::vector<FlightCase> cases = flight_cases(arguments);
  if (cases.size() != 1) throw UsageError("respond: --mast and --speed take one value each");
  return cases.front();
}

std::vector<std::string> column_names(bool with_modes) {
  std::vector<std::string> names;
  for (const Column& column : columns) names.emplace_back(column.name);
  for (int i = 1; with_modes && i <= shown_modes; ++i) {
    const std::string name = "mode" + std::to_string(i);
    names.insert(names.end(), {name, name + "_real", name + "_imag"});
  }
  return names;
}

// Linear models and modes along the flight.
class Surroundings {
 public:
  explicit Surroundings(const ControlSet& controls) : controls_(controls), room_(std::make_unique<Room>()) {}

  Status linearize_here(const Configuration<double>& c, const Simulation<double>& s, Analyses& analyses) {
    return linearize(c, s.state, current_controls(s), controls_, analyses, room_->model,
                     current_azimuth(c, s));
  }
  Status find_modes() {
    const Status status = modes(room_->model, room_->work, room_->current);
    if (status != Status::ok) return status;
    if (has_previous_ && follow(room_->previous, room_->current) != Status::ok) has_previous_ = false;
    room_->previous = room_->current;
    has_previous_ = true;
    return Status::ok;
  }
  const LinearModel<double>& model() const { return room_->model; }
  const ModeSet<double>& mode_set() const { return room_->current; }

 private:
  struct Room {
    LinearModel<double> model;
    ModesWorkspace<double> work;
    ModeSet<double> previous, current;
  };
  ControlSet controls_;
  bool has_previous_ = false;
  std::unique_ptr<Room> room_;
};

// Cells of one row's modes; empty ones when `set` is none.
void append_modes(Row& row, const ModeSet<double>* set) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  int shown = 0;
  for (int i = 0; set != nullptr && i < set->count && shown < shown_modes; ++i) {
    const Mode<double>& mode = set->mode[i];
    if (mode.axis == ModeAxis::rotor) continue;
    row.insert(row.end(), {mode.name, mode.real, mode.imag});
    ++shown;
  }
  for (; shown < shown_modes; ++shown) row.insert(row.end(), {"", nothing, nothing});
}

int fly(const Configuration<double>& c, const Plan& plan, Simulation<double>& simulation, Analyses& analyses,
        Surroundings& surroundings, Records& records, MatrixLog* matrices) {
  Progress progress("respond", plan.steps);
  int exit_status = exit_success;
  for (std::size_t step = 0;; ++step) {
    const Moment moment{simulation, simulation.state, current_controls(simulation)};
    Row row;
    for (const Column& column : columns) row.emplace_back(column.value(moment));
    const bool wants_modes = plan.modes_every > 0 && step % plan.modes_every == 0;
    if (wants_modes || matrices != nullptr) {
      Status status = surroundings.linearize_here(c, simulation, analyses);
      if (status == Status::ok && matrices != nullptr)
        matrices->add(current_time(simulation), surroundings.model());
      if (status == Status::ok && wants_modes) status = surroundings.find_modes();
      if (status != Status::ok) {
        progress.message("respond: linear model at " + number_text(current_time(simulation), 6) +
                         " s: " + status_text(status));
        exit_status = exit_case_failed;
      }
      if (plan.modes_every > 0) {
        append_modes(row, wants_modes && status == Status::ok ? &surroundings.mode_set() : nullptr);
      }
    } else if (plan.modes_every > 0) {
      append_modes(row, nullptr);
    }
    records.add(row);
    if (step == plan.steps) return exit_status;
    const Status status = advance(c, analyses, simulation);
    if (status != Status::ok) {
      const bool named = simulation.fault_state >= 0;
      progress.message("respond: the flight cannot be continued beyond " +
                       number_text(current_time(simulation), 6) + " s" +
                       (named ? std::string(", state ") + kStateNames[simulation.fault_state].name : "") +
                       ": " + status_text(status));
      return exit_case_failed;
    }
    progress.advance();
  }
}

int run(const Arguments& arguments) {
  const SetupOptions setup(arguments);
  single_flight(arguments);
  const Plan plan = read_plan(arguments);
  Output output(arguments);
  std::optional<MatrixLog> matrices;
  if (arguments.given("--matrices")) {
    matrices.emplace(arguments.text("--matrices", ""), arguments.where("--matrices"));
  }
  Records records = output.records(column_names(plan.modes_every > 0), Output::to_read);
  Surroundings surroundings(control_set(arguments));
  const AnalysesRoom room;
  const auto visit = [&](const TrimmedFlight& flight) -> int {
    if (!is_trimmed(flight.trim.status)) return exit_case_failed;
    const auto simulation = std::make_unique<Simulation<double>>();
    Status status = start(flight.configuration, flight.trim.state, flight.trim.controls, plan.dt,
                          plan.integrator, *simulation);
    for (const InputSignal<double>& input : plan.inputs) {
      if (status == Status::ok) status = add_input(*simulation, input);
    }
    if (status == Status::ok) {
      return fly(flight.configuration, plan, *simulation, *room, surroundings, records,
                 matrices ? &*matrices : nullptr);
    }
    std::fprintf(stderr, "tiltrotor: respond: cannot start: %s\n", status_text(status));
    return exit_case_failed;
  };
  const int exit_status = for_each_trim(arguments, setup, Shard{}, *room, visit);
  if (matrices && !matrices->is_empty()) matrices->finish();
  records.finish();
  return exit_status;
}

OptionList options() {
  return {
      {"--input", "INPUT", "a test input, see above; repeatable", true},
      {"--duration", "S", "0..3600 (3)"},
      {"--dt", "S", "time step, 1e-4..0.1 (0.005)"},
      {"--method", "NAME", "rk4, stable to about 0.02 s, or rodas3, for long steps (rk4)"},
      {"--modes-every", "S",
       "adds name, real and imaginary part of the body's modes to a row\nevery S seconds"},
      {"--matrices", "DIR", "writes A and B at every step to DIR/a.csv and DIR/b.csv"},
  };
}

// Everything about the output but shards: a flight is one piece.
OptionList output_list() {
  OptionList list = Output::list();
  list.erase(std::remove_if(list.begin(), list.end(),
                            [](const Option& option) { return option.name == std::string("--shard"); }),
             list.end());
  return list;
}

const std::string& description() {
  static const std::string text = std::string(
                                      "Flies the nonlinear model from trim. One row a step: the state, and "
                                      "the controls that act from then on.\n\n") +
                                  kInputGrammar;
  return text;
}

}  // namespace

Command respond_command() {
  return {"respond",
          "time response to control inputs, with linear models along the way",
          description().c_str(),
          "tiltrotor respond --mast 0 --speed 40 --input collective=1deg@0 --duration 3 --modes-every 1",
          options() + control_set_option() + flight_list() + SetupOptions::list() + output_list(),
          run};
}

}  // namespace tiltrotor::cli
