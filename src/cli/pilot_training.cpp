#include "cli/pilot_training.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "cli/analyses_workspace.hpp"
#include "tiltrotor/analysis/linear/vehicle_model.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/systems/vehicle_events.hpp"

namespace tiltrotor::cli {

namespace {

// Speeds at a mast angle: along the corridor, a little beyond it.
struct Lesson {
  double mast_deg, slowest, fastest, every;
};
constexpr Lesson kLessons[] = {{0, 0, 60, 5},   {15, 10, 70, 5},  {30, 20, 80, 5},   {45, 30, 85, 5},
                               {60, 40, 90, 5}, {75, 45, 100, 5}, {90, 55, 130, 7.5}};
constexpr double kAirplaneMast = 75;  // from here on gains are sought at the rotor speed of airplane mode too

pilot::RateFeedback feedback(const Aircraft<double>& aircraft, double mast_deg) {
  const AugmentationTables<double>& t = aircraft.systems.augmentation;
  const auto gain = [&](const Table<double, 1>& table) { return lookup(table, Interpolation::c1, mast_deg); };
  return {gain(t.pitch), -gain(t.roll), -gain(t.yaw)};
}

struct Trained {
  AnalysesWorkspace analyses;
  TrimResult<double> trim;
  Evaluation<double> evaluation;
  VehicleModelWorkspace<double> vehicle;
  LinearModel<double> model;
};

// The airframe with sticks, pedal and the lever that leads.
Status lead(const Configuration<double>& c, Governor governor, double throttle, Trained& at) {
  Vehicle<double> v{};
  v.on.governor = governor;
  v.commands.rotor_speed = c.setup.rotor_speed;
  for (double& t : v.commands.throttle) t = throttle;
  SystemState<double> s{};
  VehicleShape shape;
  vehicle_states(v, c.setup.options, shape);
  const int throttles = governor == Governor::off ? 0 : 2;
  const Controls<int>& u = kControlIndex;
  const Commands<int>& command = kCommandIndex;
  shape.inputs = 0;
  if (throttles == 0) shape.input[shape.inputs++] = u.collective;
  for (int side = 0; side < throttles; ++side)
    shape.input[shape.inputs++] = control_count + command.throttle[side];
  for (const int stick : {u.long_stick, u.lat_stick, u.pedal}) shape.input[shape.inputs++] = stick;

  LinearModel<double>& m = at.model;
  clear(m);
  linear_states(c.setup.options, m);
  if (m.states != shape.states) return Status::bad_argument;
  m.controls = kInceptors.count;
  double flat[state_count], inputs[control_count];
  flatten(at.trim.state, flat);
  flatten(at.trim.controls, inputs);
  for (int i = 0; i < m.states; ++i) m.x[i] = flat[m.state[i]];
  for (int j = 0; j < m.controls; ++j) m.u[j] = inputs[m.control[j] = kInceptors.index[j]];
  set_zero(m.b);
  Configuration<double> put = c;
  State<double> rates;
  SystemState<double> system_rates;
  return linearize_vehicle(
      v, put, at.trim.state, s, at.trim.controls, shape, at.vehicle, rates, system_rates,
      [&m](int i, int j, int count, const double* slope) { copy_row(slope, count, m.a.row(i) + j); },
      [&m, throttles](int i, int first, int count, const double* slope) {
        for (int j = first; j < first + count; ++j)
          m.b(i, j < throttles ? 0 : j + (throttles == 0 ? 0 : 1 - throttles)) += *slope++;
      });
}

}  // namespace

PilotTraining::PilotTraining(const FlightSetup<double>& setup, double warmer) {
  const Aircraft<double>& aircraft = aircraft_data<double>();
  helicopter_speed_ = aircraft.rotor.speed_helicopter;
  airplane_speed_ = aircraft.rotor.speed_airplane;
  const auto at = std::make_unique<Trained>();
  const auto learn = [&](double mast_deg, double speed, double rotor_speed, Lessons& lessons) {
    FlightSetup<double> here = flight_setup(aircraft, mast_deg);
    here.altitude = setup.altitude;
    here.mass = setup.mass;
    here.sl_cg = setup.sl_cg;
    here.wl_cg = setup.wl_cg;
    here.options = setup.options;
    here.rotor_speed = rotor_speed;
    Configuration<double> c;
    if (prepare(aircraft, here, c) != Status::ok) return;
    c.around.warmer = warmer;
    configure(c);
    SteadyFlight<double> flight{};
    flight.speed = speed;
    if (!is_trimmed(trim(c, flight, *at->analyses, at->trim))) return;
    evaluate_aircraft(c, at->trim.state, at->trim.controls, at->evaluation);
    const double torque = at->evaluation.rotor[right].loads.torque + at->evaluation.rotor[left].loads.torque;
    const double full = 2 * demanded_power(aircraft, c.air, 1.0) * aircraft.controls.transmission_efficiency;
    const double throttle = torque * rotor_speed / full;
    if (!(throttle > 0)) return;
    // dQ/dcollective, from what the governor's gains were made of: governor_gains().
    const GovernorTables<double>& g = aircraft.systems.governor;
    const double integral = lookup(g.integral, Interpolation::c1, mast_deg);
    const double q_theta = square(g.frequency) * drive_inertia(aircraft, 2) * rotor_speed / integral;
    for (const Governor governor : {Governor::off, Governor::ideal}) {
      if (lead(c, governor, throttle, *at) != Status::ok) continue;
      for (const bool augmented : {false, true}) {
        pilot::PilotGains gains{};
        const pilot::RateFeedback help = augmented ? feedback(aircraft, mast_deg) : pilot::RateFeedback{};
        if (pilot_gains(at->model, help, pilot::PilotRule{}, gains) != Status::ok) continue;
        gains.mast_deg = mast_deg;
        gains.throttle = throttle;
        const double power_per_collective = q_theta * rotor_speed / full;
        gains.following = governor == Governor::off ? power_per_collective : 1 / power_per_collective;
        lessons.schedule[governor != Governor::off][augmented].add(gains);
      }
    }
  };
  for (const Lesson& lesson : kLessons)
    for (double speed = lesson.slowest; speed <= lesson.fastest; speed += lesson.every) {
      learn(lesson.mast_deg, speed, helicopter_speed_, helicopter_);
      if (lesson.mast_deg >= kAirplaneMast) learn(lesson.mast_deg, speed, airplane_speed_, airplane_);
    }
  if (helicopter_.schedule[1][1].is_empty() || airplane_.schedule[1][1].is_empty())
    throw std::runtime_error("no level flight of this aircraft can be trimmed, so that nobody can fly it");
}

pilot::PilotGains PilotTraining::at(double mast_deg, double speed, double rotor_speed,
                                    const SystemSwitches& on) const {
  const int governed = on.governor != Governor::off;
  const pilot::PilotGains fast = helicopter_.schedule[governed][on.augmentation].at(mast_deg, speed);
  const double part =
      std::clamp((helicopter_speed_ - rotor_speed) / (helicopter_speed_ - airplane_speed_), 0.0, 1.0);
  if (part == 0 || mast_deg < kAirplaneMast) return fast;
  return between(fast, airplane_.schedule[governed][on.augmentation].at(mast_deg, speed), part);
}

}  // namespace tiltrotor::cli
