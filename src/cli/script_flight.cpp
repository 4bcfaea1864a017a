#include "cli/script_flight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "cli/analyses_workspace.hpp"
#include "cli/errors.hpp"
#include "cli/flight_options.hpp"
#include "cli/script_commander.hpp"
#include "text/number.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace tiltrotor::cli {

namespace {

using pilot::Lateral;
using pilot::Vertical;

constexpr double kRotorRate = 1;      // rad/s^2, of the governor's reference
constexpr double kLanded = 0.3;       // from here on the pilot takes the thrust off
constexpr double kForceTrim = 2;      // dead bands of the attitude hold
constexpr double kLiftOffRate = 0.3;  // of the usual rates of the levers, while wheels carry
constexpr double kQuickened = 0.15;   // s, left of the lag of the engines where the throttle leads them
constexpr double kSettling = 10;      // s on the wheels before the time begins

}  // namespace

struct ScriptFlight::Parts : ScriptCommander {
  using ScriptCommander::ScriptCommander;

  // ---- begin ----

  void prepare_vehicle(const FlightSetup<double>& setup) {
    c = prepared(aircraft, setup);
    c.around.warmer = start.warmer;
    configure(c);
    Vehicle<double>& v = flight.vehicle;
    for (const Side side : {right, left}) v.engine_failed[side] = start.engine_failed[side];
    v.on = {Governor::pi, true, true, true, true, true, true, false};
    v.on.interconnect = setup.options.interconnect == Interconnect::twists;
    v.ground = {0, 0, 0};
    v.air_follows = true;
    v.altitude_origin = start.setup.altitude;
  }

  void begin_in_trim() {
    FlightSetup<double> setup = start.setup;
    const double cg_height = start.height + setup.wl_cg - aircraft.gear.ground_wl;
    setup.altitude += cg_height;
    prepare_vehicle(setup);
    const AnalysesWorkspace analyses;
    TrimResult<double> trimmed;
    SteadyFlight<double> steady{};
    steady.speed = start.speed;
    const TrimStatus status = trim(c, steady, *analyses, trimmed);
    if (!is_trimmed(status))
      throw std::runtime_error(std::string("fly: cannot begin in this flight: ") + trim_status_word(status));
    State<double> x = trimmed.state;
    Controls<double> u = trimmed.controls;
    x.position = {0, 0, -cg_height};
    evaluate_aircraft(c, x, u, evaluation);
    settle(c, x, {evaluation.rotor[right].loads.torque, evaluation.rotor[left].loads.torque}, flight.vehicle,
           flight.state, u);
    rotor_target = c.setup.rotor_speed;
    followed = throttle_of_both();
    begin(x, u);
    if (closed.begin(c, simulation) != Status::ok)
      throw std::runtime_error("fly: cannot begin with this law");
    aims.holds_speed = true;
    aims.speed = levelled(x).x;
    aims.vertical = Vertical::height;
    aims.height = start.height;
    aims.lateral = Lateral::heading;
  }

  void begin_on_ground() {
    FlightSetup<double> setup = start.setup;
    setup.rotor_speed = setup_range(aircraft, SetupField::rotor_speed).low + 1;
    prepare_vehicle(setup);
    flight.vehicle.gear_down = true;
    flight.vehicle.brake[right] = flight.vehicle.brake[left] = 1;
    State<double> x{};
    x.position.z = -rest_height();
    constexpr double calm = 0.01;  // inflow over tip speed
    for (RotorState<double>& rotor : x.rotor) rotor.lambda_0 = calm;
    Controls<double> u{};
    u.collective = GroundHandling::kFlatPitch;
    evaluate_aircraft(c, x, u, evaluation);
    settle(c, x, {evaluation.rotor[right].loads.torque, evaluation.rotor[left].loads.torque}, flight.vehicle,
           flight.state, u);
    rotor_target = c.setup.rotor_speed;
    parked = true;
    ground.hands = {u.collective, u.long_stick, u.lat_stick, u.pedal, throttle_of_both()};
    begin(x, u);
    const int settling = static_cast<int>(std::ceil(kSettling / start.dt));
    for (int k = 0; k < settling; ++k) {
      observe();
      act();
      if (closed.advance(c, simulation) != Status::ok)
        throw std::runtime_error("fly: the aircraft does not come to rest on its wheels: " + fault());
    }
    State<double> rested = current_state(simulation);
    rested.position.x = rested.position.y = rested.yaw = 0;
    flight.steps = 0;
    flight.state.fuel = 0;
    begin(rested, simulation.controls);
  }

  // What each engine would have if all ran: the pilot's throttle.
  double throttle_of_both() const { return flight.vehicle.commands.throttle[right] / throttle_share(); }

  void begin(const State<double>& x, const Controls<double>& u) {
    const Status status = tiltrotor::start(c, x, u, start.dt, Integrator::rk3, simulation);
    if (status != Status::ok)
      throw std::runtime_error(std::string("fly: cannot begin: ") + status_text(status));
  }

  // ---- a step ----

  // Hands and throttles for the next step.
  pilot::PilotOutput hands() {
    if (parked) {
      const double torque = answer.torque[right] + answer.torque[left];
      return ground.hold(
          {c.setup.rotor_speed, flight.vehicle.commands.rotor_speed, torque, full_power(),
           flight.vehicle.on.governor == Governor::ideal, ground.hands.collective + moment.systems.governor},
          reach, start.dt);
    }
    pilot::PilotReach now = reach;
    const pilot::PilotSees sees = look();
    if (sees.is_on_ground && !lands) {
      now.rate.collective *= kLiftOffRate;
      now.rate.throttle *= kLiftOffRate;
    }
    return reference_pilot(aims, sees, gains(), PilotTraining::thrust(flight.vehicle.on.governor), now,
                           start.dt, memory);
  }

  void move_references() {
    Commands<double>& commands = flight.vehicle.commands;
    const double rate = parked ? GroundHandling::kSpoolRate : kRotorRate;
    const double way = rate * start.dt;
    commands.rotor_speed += std::clamp(rotor_target - commands.rotor_speed, -way, way);
    if (parked)
      flight.state.governor -= std::clamp(flight.state.governor, -reach.rate.collective * start.dt,
                                          reach.rate.collective * start.dt);
    if (flight.vehicle.on.governor == Governor::off || flight.vehicle.on.governor == Governor::ideal)
      c.setup.rotor_speed = commands.rotor_speed;
  }

  // The throttle ahead of the engines' lag, of which kQuickened is left.
  double lead(double throttle) {
    if (parked) return followed = throttle;
    followed += start.dt / kQuickened * (throttle - followed);
    return throttle + (aircraft.systems.drive.power_lag / kQuickened - 1) * (throttle - followed);
  }

  void act() {
    if (lands && moment.weight_on_wheels > kLanded) {
      lands = false;
      parked = true;
      ground.hands = memory.last;
      release(4);
    }
    move_references();
    const pilot::PilotOutput out = hands();
    const double leading = lead(out.throttle);
    double u[control_count + 2] = {};
    u[kControlIndex.collective] = out.collective;
    u[kControlIndex.long_stick] = out.long_stick;
    u[kControlIndex.lat_stick] = out.lat_stick;
    u[kControlIndex.pedal] = out.pedal;
    u[kFirstThrottle] = u[kFirstThrottle + 1] = std::clamp(leading * throttle_share(), 0.0, 1.0);
    inputs.apply(time(), u);
    for (const Side side : {right, left}) flight.vehicle.commands.throttle[side] = u[kFirstThrottle + side];
    unflatten(u, simulation.controls);
    rest_sticks();
  }

  void rest_sticks() {
    const double away = kForceTrim * aircraft.systems.augmentation.dead_band;
    SystemState<double>& s = flight.state;
    const bool flies_pitch =
        !parked && (aims.holds_speed || aims.holds_position || aims.vertical != Vertical::released);
    const bool flies_bank = !parked && (aims.holds_position || aims.lateral != Lateral::released);
    if (flies_pitch || parked) s.rest_long = simulation.controls.long_stick - away;
    if (flies_bank || parked) s.rest_lat = simulation.controls.lat_stick - away;
  }

  // Nothing but wheels carries: without them the flight ends where they would stand, else where the CG would.
  bool has_struck() {
    struck = height() < (is_locked_down(flight.vehicle, flight.state.gear) ? -rest_height() : 0.0);
    if (!struck) return false;
    simulation.status = Status::out_of_range;
    simulation.fault_state = kStateIndex.position.z;
    simulation.fault_time = time();
    return true;
  }

  void observe() {
    const State<double> x = current_state(simulation);
    const Status acts = closed.act(c, simulation);
    if (acts != Status::ok) simulation.status = acts;
    const Controls<double> u = closed.acting();
    Configuration<double> here = c;
    here.around = with_turbulence(c, x, u, flight.vehicle, flight.state);
    VehicleFlows<double> flows;
    SystemState<double> found;
    vehicle_rates(flight.vehicle, here, c.setup, here, x, flight.state, flight.vehicle.commands, u,
                  VehicleAirframe<double>{here, x, steps, current_azimuth(c, simulation)}, demand, answer,
                  flows, found);
    flatten(answer.rates, rates);
    flatten(found, rates + state_count);
    FlightMoment& m = moment;
    m.time = time();
    m.state = x;
    m.controls = u;
    m.systems = flight.state;
    if (flight.vehicle.on.governor == Governor::ideal) m.systems.governor = flows.governed;
    m.commands = flight.vehicle.commands;
    m.rates = answer.rates;
    read_vehicle(flight.vehicle, here, x, steps, answer.rates, found, m.readings);
    m.airframe = airframe_readings(here, x, steps, answer.rates, start.outputs);
    m.velocity_n = over_ground(x, wind());
    m.height = height();
    m.airspeed = length(x.velocity - u.gust);
    m.load_factor = -steps.total.force.z / (here.mass.mass * kGravity<double>);
    m.mast_deg = c.setup.mast_deg;
    m.rotor_speed = c.setup.rotor_speed;
    m.flap_deg = c.setup.flap_deg;
    for (const Side side : {right, left}) m.power[side] = flight.state.power[side];
    m.rotor_power = (answer.torque[right] + answer.torque[left]) * c.setup.rotor_speed +
                    0.5 * (answer.torque[right] - answer.torque[left]) * c.setup.rotor_difference;
    m.is_governed = flight.vehicle.on.governor != Governor::off;
    m.engines_running = vehicle_parts::engines_running(flight.vehicle.engine_failed);
    m.power_allowed = full_power();
    m.weight_on_wheels = demand.gear.weight_on_wheels;
    const bool holds = !parked && aims.vertical == Vertical::height;
    m.wanted_height = holds ? aims.height : std::numeric_limits<double>::quiet_NaN();
    m.height_settles = has_settled();
  }

  // A height counts as held from when the aircraft was there, until another is wanted.
  bool has_settled() {
    constexpr double near = 0.5;  // m
    if (moment.wanted_height != settled_at) is_there = false;
    settled_at = moment.wanted_height;
    is_there |= moment.weight_on_wheels == 0 && std::fabs(height() - moment.wanted_height) < near;
    return is_there;
  }

  // A shaft that twists begins at the twist with which neither rotor gains on the other, with their torques as they are now.
  // Rotors that turn alike again keep the speed of their inflow.
  void balance_shaft() {
    SystemState<double>& s = flight.state;
    for (const Side side : {right, left}) {
      const double faster = 1 + 0.5 * side_sign<double>(side) * s.twist_rate / c.setup.rotor_speed;
      RotorState<double>& rotor = simulation.state.rotor[side];
      for (double* const inflow : {&rotor.lambda_0, &rotor.lambda_c, &rotor.lambda_s}) *inflow *= faster;
    }
    s.shaft_twist = s.twist_rate = 0;
    if (!twists(flight.vehicle.on)) return;
    observe();
    s.shaft_twist =
        balanced_twist(aircraft, flight.vehicle.engine_failed, s.power, answer.torque, c.setup.rotor_speed);
  }

  void meet() {
    constexpr double rounding = 1e-9;
    const auto is_due = [&] {
      return next < script.events.size() && script.events[next].time <= time() + rounding;
    };
    for (; is_due(); ++next) {
      if (script.events[next].command == ScriptCommand::gear) observe();  // weight on wheels, now
      const bool twisted = twists(flight.vehicle.on);
      obey(script.events[next]);
      if (twists(flight.vehicle.on) != twisted) balance_shaft();
    }
    remarks.effects(flight.vehicle, time());
    act();
    observe();
  }
};

ScriptFlight::ScriptFlight(const FlightScript& script, const FlightStart& start, const Feedback& feedback)
    : parts_(std::make_unique<Parts>(script, start, feedback)) {
  if (start.on_ground) {
    parts_->begin_on_ground();
  } else {
    parts_->begin_in_trim();
  }
  parts_->observe();
  parts_->meet();
}
ScriptFlight::~ScriptFlight() = default;

const FlightMoment& ScriptFlight::now() const { return parts_->moment; }

bool ScriptFlight::step() {
  Parts& p = *parts_;
  constexpr double rounding = 1e-9;
  if (p.time() >= p.script.duration() - rounding) return false;
  if (p.closed.advance(p.c, p.simulation, p.rates) != Status::ok) return false;
  for (int control = 0; control < control_count; ++control)
    if (p.inputs.is_stopped(control)) p.remarks.stopped(control, p.start.dt);
  if (p.has_struck()) return false;
  p.meet();
  return true;
}

Status ScriptFlight::status() const { return parts_->simulation.status; }
std::string ScriptFlight::fault() const { return parts_->fault(); }
const Configuration<double>& ScriptFlight::configuration() const { return parts_->c; }
const SystemFlight<double>& ScriptFlight::systems() const { return parts_->flight; }
const FeedbackFlight& ScriptFlight::loop() const { return parts_->closed; }
double ScriptFlight::azimuth() const { return current_azimuth(parts_->c, parts_->simulation); }
std::vector<std::string> ScriptFlight::remarks() const { return parts_->remarks.text(); }

}  // namespace tiltrotor::cli
