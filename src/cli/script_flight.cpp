#include "cli/script_flight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "cli/analyses_workspace.hpp"
#include "cli/errors.hpp"
#include "cli/flight_options.hpp"
#include "cli/ground_handling.hpp"
#include "cli/script_inputs.hpp"
#include "text/number.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace tiltrotor::cli {

namespace {

using pilot::Lateral;
using pilot::Vertical;

constexpr double kRotorRate = 1;      // rad/s^2, of the governor's reference
constexpr double kTouched = 0.02;     // weight on wheels, of the weight
constexpr double kLanded = 0.3;       // from here on the pilot takes the thrust off
constexpr double kForceTrim = 2;      // dead bands of the attitude hold
constexpr double kLiftOffRate = 0.3;  // of the usual rates of the levers, while wheels carry
constexpr double kQuickened = 0.15;   // s, left of the lag of the engines where the throttle leads them
// How far ahead the pilot looks where masts move: further forward, where thrust for the acceleration must build up.
constexpr double kAheadForward = 2.2, kAheadBack = 0.2;  // s
constexpr double kSettling = 10;                         // s on the wheels before the time begins

// Velocity relative to the air in axes along the heading: forward, to the right, down.
Vec3<double> levelled(const State<double>& x) {
  const Vec3<double>& v = x.velocity;
  const double across = v.y * std::cos(x.roll) - v.z * std::sin(x.roll);
  const double below = v.y * std::sin(x.roll) + v.z * std::cos(x.roll);
  return {v.x * std::cos(x.pitch) + below * std::sin(x.pitch), across,
          -v.x * std::sin(x.pitch) + below * std::cos(x.pitch)};
}

Vec3<double> over_ground(const State<double>& x, const Vec3<double>& wind_n) {
  const Vec3<double> v = levelled(x);
  const double cosine = std::cos(x.yaw), sine = std::sin(x.yaw);
  return wind_n + Vec3<double>{v.x * cosine - v.y * sine, v.x * sine + v.y * cosine, v.z};
}

// Along the body's axes.
Vec3<double> in_body(const State<double>& x, const Vec3<double>& n) {
  return vehicle_detail::wind_in_body(n, x);
}

}  // namespace

struct ScriptFlight::Parts {
  const FlightScript& script;
  const FlightStart start;
  const Aircraft<double>& aircraft = aircraft_data<double>();
  PilotTraining training;
  Configuration<double> c{};
  SystemFlight<double> flight{};
  Simulation<double> simulation{};
  SimulationWorkspace<double> work{};
  pilot::PilotAims aims{};
  pilot::PilotMemory memory{};
  pilot::PilotReach reach = pilot::pilot_reach(aircraft);
  GroundHandling ground{};
  ScriptInputs inputs;
  bool parked = false, lands = false;
  double followed = 0;      // by the engines, of the throttle
  double rotor_target = 0;  // rad/s
  std::size_t next = 0;     // event
  FlightMoment moment{};
  double rates[vehicle_state_count] = {};
  Evaluation<double> evaluation{};
  DerivativeSteps<double> steps{};
  AirframeDemand<double> demand{};
  AirframeAnswer<double> answer{};

  Parts(const FlightScript& s, const FlightStart& at) : script(s), start(at), training(at.setup), inputs(s) {}

  double time() const { return current_time(simulation); }
  double rest_height() const { return c.setup.wl_cg - aircraft.gear.ground_wl; }
  double full_power() const { return demanded_power(aircraft, c.air, 1.0); }
  double throttle_share() const {
    const int running = vehicle_detail::engines_running(flight.vehicle.engine_failed);
    return running == 0 ? 0 : 2.0 / running;
  }

  // ---- begin ----

  void prepare_vehicle(const FlightSetup<double>& setup) {
    c = prepared(setup);
    Vehicle<double>& v = flight.vehicle;
    v.on = {Governor::pi, true, true, true, true, true, true, false};
    v.ground = {0, 0, 0};
    v.air_follows = true;
    v.altitude_origin = start.setup.altitude;
  }

  void begin_in_trim() {
    FlightSetup<double> setup = start.setup;
    setup.altitude += start.height;
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
    x.position = {0, 0, -(start.height + rest_height())};
    evaluate_aircraft(c, x, u, evaluation);
    settle(c, x, evaluation.rotor[right].loads.torque + evaluation.rotor[left].loads.torque, flight.vehicle,
           flight.state, u);
    rotor_target = c.setup.rotor_speed;
    followed = flight.vehicle.commands.throttle[right];
    begin(x, u);
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
    settle(c, x, evaluation.rotor[right].loads.torque + evaluation.rotor[left].loads.torque, flight.vehicle,
           flight.state, u);
    rotor_target = c.setup.rotor_speed;
    parked = true;
    ground.hands = {u.collective, u.long_stick, u.lat_stick, u.pedal, flight.vehicle.commands.throttle[0]};
    begin(x, u);
    const int settling = static_cast<int>(std::ceil(kSettling / start.dt));
    for (int k = 0; k < settling; ++k) {
      observe();
      act();
      if (advance_vehicle(c, flight, work, simulation) != Status::ok)
        throw std::runtime_error("fly: the aircraft does not come to rest on its wheels: " + fault());
    }
    State<double> rested = current_state(simulation);
    rested.position.x = rested.position.y = rested.yaw = 0;
    flight.steps = 0;
    flight.state.fuel = 0;
    begin(rested, simulation.controls);
  }

  void begin(const State<double>& x, const Controls<double>& u) {
    const Status status = tiltrotor::start(c, x, u, start.dt, Integrator::rk3, simulation);
    if (status != Status::ok)
      throw std::runtime_error(std::string("fly: cannot begin: ") + status_text(status));
  }

  // ---- commands ----

  void take_off() {
    if (!parked) return;
    parked = false;
    memory = {};
    const pilot::PilotSees sees = look();
    const SystemSwitches& on = flight.vehicle.on;
    reference_pilot(aims, sees, gains(), PilotTraining::thrust(on.governor), reach, 0, memory);
    memory.last = ground.hands;
  }

  void hold_thrust() {
    aims.taken.thrust = false;
    inputs.release({kControlIndex.collective, kFirstThrottle, kFirstThrottle + 1});
  }
  void hold_long_stick() {
    aims.taken.long_stick = false;
    inputs.release({kControlIndex.long_stick});
  }
  void hold_lateral() {
    aims.taken.lat_stick = aims.taken.pedal = false;
    inputs.release({kControlIndex.lat_stick, kControlIndex.pedal});
  }
  void aim_lateral(Lateral how) {
    aims.lateral = how;
    hold_lateral();
  }

  void engine(const ScriptEvent& e) {
    const int side = e.number[0] == 1 ? right : left;
    flight.vehicle.engine_failed[side] = e.word == 0;
  }

  void change_governor(Governor to) {
    Vehicle<double>& v = flight.vehicle;
    SystemState<double>& s = flight.state;
    if (v.on.governor == to) return;
    // The lever takes over what the governor had added, and the rotors turn as they do.
    if (v.on.governor != Governor::off && to == Governor::off) {
      memory.last.collective += s.governor;
      s.governor = 0;
    }
    s.rotor_speed = c.setup.rotor_speed;
    c.setup.rotor_acceleration = 0;
    v.on.governor = to;
  }

  void change_wind(const Vec3<double>& wind_n) {
    const Vec3<double> change = wind_n - c.around.wind_n;
    simulation.state.velocity = simulation.state.velocity - in_body(simulation.state, change);
    c.around.wind_n = wind_n;
  }

  void release(std::size_t loop) {
    const bool all = loop == 4;
    if (all || loop == 0) aims.holds_speed = false;
    if (all || loop == 1) aims.vertical = Vertical::released;
    if (all || loop == 2) aims.lateral = Lateral::released;
    if (all || loop == 3) aims.holds_position = false;
    lands = lands && !(all || loop == 1);
  }

  void obey(const ScriptEvent& e) {
    using C = ScriptCommand;
    Vehicle<double>& v = flight.vehicle;
    const double first = e.number[0];
    switch (e.command) {
      case C::mast:
        v.commands.mast = first * kRadPerDeg<double>;
        return;
      case C::flap:
        v.commands.flap = first * kRadPerDeg<double>;
        return;
      case C::rotor_speed:
        rotor_target = first;
        return;
      case C::spool:
        rotor_target = aircraft.rotor.speed_helicopter;
        return;
      case C::throttle:
        aims.taken.thrust = true;
        inputs.take(kFirstThrottle, first);
        inputs.take(kFirstThrottle + 1, e.count > 1 ? e.number[1] : first);
        return;
      case C::hold_speed:
        aims.holds_speed = true;
        aims.holds_position = false;
        aims.speed = first;
        aims.acceleration = e.count > 1 ? e.number[1] : pilot::PilotAims{}.acceleration;
        hold_thrust();
        hold_long_stick();
        return;
      case C::hold_height:
        aims.vertical = Vertical::height;
        aims.height = first;
        aims.most_climb = e.count > 1 ? e.number[1] : pilot::PilotAims{}.most_climb;
        lands = false;
        hold_thrust();
        hold_long_stick();
        take_off();
        return;
      case C::hold_climb:
        aims.vertical = Vertical::climb;
        aims.climb = first;
        lands = false;
        hold_thrust();
        hold_long_stick();
        if (first > 0) take_off();
        return;
      case C::hold_heading:
        aims.heading = first;
        aim_lateral(Lateral::heading);
        return;
      case C::hold_track:
        aims.track = first;
        aims.north = simulation.state.position.x;
        aims.east = simulation.state.position.y;
        aim_lateral(Lateral::track);
        return;
      case C::hold_position:
        aims.holds_position = true;
        aims.holds_speed = false;
        aims.north = simulation.state.position.x;
        aims.east = simulation.state.position.y;
        hold_thrust();
        hold_long_stick();
        hold_lateral();
        return;
      case C::turn:
        aims.turn_rate = first;
        aim_lateral(Lateral::turn);
        return;
      case C::release:
        release(e.word);
        return;
      case C::inceptor:
        inputs.take(e.control, first);
        note_taken(e.control);
        return;
      case C::step:
      case C::doublet:
        inputs.add(e);
        return;
      case C::series:
        for (const int input : script.series[e.series].input) note_taken(input);
        inputs.play(e);
        return;
      case C::scas:
        if (e.word == 0) {
          v.on.augmentation = true;
          v.disengages = false;
        } else {
          v.disengages = v.on.augmentation;
        }
        return;
      case C::governor:
        change_governor(static_cast<Governor>(e.word));
        return;
      case C::gear:
        v.gear_down = e.word == 1;
        return;
      case C::brakes:
        v.brake[right] = v.brake[left] = first;
        return;
      case C::engine:
        engine(e);
        return;
      case C::gust:
        inputs.blow(e);
        return;
      case C::wind:
        change_wind({e.number[0], e.number[1], e.number[2]});
        return;
      case C::turbulence:
        v.on.turbulence = first > 0;
        v.wind_20_ft = first;
        v.turbulence_seed = e.count > 1 ? static_cast<std::uint64_t>(e.number[1]) : 1;
        return;
      case C::land:
        lands = !parked;
        if (parked) return;
        aims.vertical = Vertical::climb;
        aims.climb = -first;
        hold_thrust();
        hold_long_stick();
        return;
      case C::end:
        return;
    }
  }

  void note_taken(int input) {
    const Controls<int>& u = kControlIndex;
    aims.taken.thrust |= input == u.collective || input >= kFirstThrottle;
    aims.taken.long_stick |= input == u.long_stick;
    aims.taken.lat_stick |= input == u.lat_stick;
    aims.taken.pedal |= input == u.pedal;
  }

  // ---- a step ----

  pilot::PilotSees look() const {
    const State<double> x = current_state(simulation);
    const Vec3<double> air = levelled(x);
    pilot::PilotSees sees{};
    sees.mast_deg = c.setup.mast_deg;
    sees.airspeed = air.x;
    sees.side_airspeed = air.y;
    sees.north = x.position.x;
    sees.east = x.position.y;
    sees.height = -x.position.z - rest_height();
    sees.ground_velocity = over_ground(x, c.around.wind_n);
    sees.roll = x.roll;
    sees.pitch = x.pitch;
    sees.yaw = x.yaw;
    sees.rates = x.rates;
    sees.is_on_ground = moment.weight_on_wheels > kTouched;
    return sees;
  }

  pilot::PilotGains gains() const {
    const bool holds = memory.has_begun && (aims.holds_speed || aims.holds_position);
    const double speed = holds ? memory.speed : levelled(simulation.state).x;
    const double turning = flight.vehicle.commands.rotor_speed, mast_deg = c.setup.mast_deg;
    const SystemSwitches& on = flight.vehicle.on;
    const double rate = c.setup.mast_rate * kDegPerRad<double>;
    const double ahead = rate > 0 ? kAheadForward : kAheadBack;
    return training.at(mast_deg + ahead * rate, speed + ahead * memory.acceleration, turning, on);
  }

  // Hands and throttles for the next step.
  pilot::PilotOutput hands() {
    if (parked) {
      const double torque = answer.torque[right] + answer.torque[left];
      return ground.hold({c.setup.rotor_speed, flight.vehicle.commands.rotor_speed, torque, full_power()},
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

  void observe() {
    const State<double> x = current_state(simulation);
    const Controls<double> u = simulation.controls;
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
    m.commands = flight.vehicle.commands;
    m.rates = answer.rates;
    m.velocity_n = over_ground(x, c.around.wind_n);
    m.height = -x.position.z - rest_height();
    m.airspeed = length(x.velocity - u.gust);
    const Vec3<double> turning = cross(x.rates, x.velocity);
    m.load_factor =
        std::cos(x.pitch) * std::cos(x.roll) - (answer.rates.velocity.z + turning.z) / kGravity<double>;
    m.mast_deg = c.setup.mast_deg;
    m.rotor_speed = c.setup.rotor_speed;
    m.flap_deg = c.setup.flap_deg;
    for (const Side side : {right, left}) m.power[side] = flight.state.power[side];
    m.rotor_power = (answer.torque[right] + answer.torque[left]) * c.setup.rotor_speed;
    m.power_allowed = full_power();
    m.weight_on_wheels = flight.vehicle.gear_down ? demand.gear.weight_on_wheels : 0;
    const bool holds = !parked && aims.vertical == Vertical::height;
    constexpr double arrived = 0.5;  // m
    m.wanted_height = holds ? aims.height : std::numeric_limits<double>::quiet_NaN();
    m.height_settles = holds && std::fabs(memory.height - aims.height) < arrived;
  }

  void meet() {
    constexpr double rounding = 1e-9;
    for (; next < script.events.size() && script.events[next].time <= time() + rounding; ++next)
      obey(script.events[next]);
    act();
    observe();
  }

  std::string fault() const {
    const std::string what = simulation.fault_state < 0
                                 ? std::string()
                                 : std::string(", ") + vehicle_variable(simulation.fault_state).name;
    return "at " + number_text(simulation.fault_time, 6) + " s" + what + ": " +
           status_text(simulation.status);
  }
};

ScriptFlight::ScriptFlight(const FlightScript& script, const FlightStart& start)
    : parts_(std::make_unique<Parts>(script, start)) {
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
  if (advance_vehicle(p.c, p.flight, p.work, p.simulation, p.rates) != Status::ok) return false;
  p.meet();
  return true;
}

Status ScriptFlight::status() const { return parts_->simulation.status; }
std::string ScriptFlight::fault() const { return parts_->fault(); }
const Configuration<double>& ScriptFlight::configuration() const { return parts_->c; }
const SystemFlight<double>& ScriptFlight::systems() const { return parts_->flight; }

}  // namespace tiltrotor::cli
