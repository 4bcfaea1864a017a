// The C interface: systems around the airframe.
#include "library/c_systems.hpp"

#include <utility>

#include "library/c_fault.hpp"
#include "library/c_ranges.hpp"
#include "library/c_state.hpp"
#include "library/c_words.hpp"
#include "tiltrotor/analysis/flight/attitude.hpp"
#include "tiltrotor/systems/system_behind.hpp"

namespace tiltrotor::c_interface {

namespace {

static_assert(TR_STATES == vehicle_state_count && TR_INPUTS == vehicle_input_count);
static_assert(TR_MAST == state_count + kSystemIndex.mast && TR_FUEL == state_count + kSystemIndex.fuel);
static_assert(TR_GEAR == state_count + kSystemIndex.gear);
static_assert(TR_ACTUATORS == state_count + kSystemIndex.collective[right]);
static_assert(TR_WASHOUT == state_count + kSystemIndex.washout && TR_GEAR + 17 == TR_STATES);
static_assert(TR_GOVERNOR_PI == static_cast<int>(Governor::pi));
static_assert(TR_SHEAR_OTHER == static_cast<int>(WindShear::other));

// The twist of the shaft with which neither rotor gains on the other, of the aircraft with its systems as it flies.
TILTROTOR_NOINLINE void balance_shaft(Sim& s) {
  Configuration<R> c;
  Found found;
  evaluate(s, c, found);
  const Vehicle<R>& v = s.systems.vehicle;
  R power[2];
  for (const Side side : {right, left})
    power[side] = v.on.engines            ? s.systems.state.power[side]
                  : v.engine_failed[side] ? R(0)
                                          : demanded_power(*c.aircraft, c.air, v.commands.throttle[side]);
  s.systems.state.shaft_twist = balanced_twist(
      *c.aircraft, v.engine_failed, power,
      {found.steps.rotor[right].loads.torque, found.steps.rotor[left].loads.torque}, c.setup.rotor_speed);
}

// States of the systems that are on, from the aircraft as it is: the others are zero.
TILTROTOR_NOINLINE void begin_systems(const SystemSwitches& before, Sim& s) {
  Configuration<R> c;
  equipped(s, c);
  Vehicle<R>& v = s.systems.vehicle;
  SystemState<R>& x = s.systems.state;
  const SystemSwitches on = v.on;
  const FlightSetup<R>& setup = c.setup;
  if (on.conversion && !before.conversion) {
    x.mast = c.mast;
    x.mast_rate = setup.mast_rate;
    x.flap = setup.flap_deg * kRadPerDeg<R>;
  }
  if (on.governor == Governor::pi && before.governor != Governor::pi) x.rotor_speed = setup.rotor_speed;
  if (on.engines && !before.engines) {
    v.loaded_mass = setup.mass;
    for (const Side side : {right, left})
      x.power[side] =
          v.engine_failed[side] ? R(0) : demanded_power(*c.aircraft, c.air, v.commands.throttle[side]);
  }
  if (on.gear && !before.gear) x.gear = v.gear_down ? R(1) : R(0);
  if (on.augmentation && !before.augmentation) {
    const State<R> now = evaluated_state(s);
    const R airspeed = total_speed(now.velocity - s.u.gust, c.aircraft->smooth.airspeed);
    x.washout = now.rates.z - turn_rate_wanted(c.aircraft->systems.augmentation, airspeed, now.roll);
    x.rest_long = s.u.long_stick;
    x.rest_lat = s.u.lat_stick;
  }
  if (on.actuators && !before.actuators) {
    Controls<R> asked = s.u;
    asked.long_stick += x.series[0];
    asked.lat_stick += x.series[1];
    asked.pedal += x.series[2];
    asked.collective += on.governor == Governor::pi ? x.governor : R(0);
    const Vec3<R> velocity = evaluated_state(s).velocity - s.u.gust;
    put_actuators(vehicle_parts::wanted_angles(*c.aircraft, setup.options, setup.mast_deg, asked, velocity),
                  x);
  }
}

TILTROTOR_NOINLINE void leave_ground(Sim& s) {
  Configuration<R> c;
  equipped(s, c);
  set_outside(c);
  c.rotor[right].ground_wash = c.rotor[left].ground_wash = c.download = R(1);
  keep(c, s);
}

// Apart from those that evaluate, so that a stack holds one configuration at a time.
TILTROTOR_NOINLINE void hold_masts(Sim& s) {
  Configuration<R> c;
  equipped(s, c);
  c.setup.mast_rate = c.setup.mast_acceleration = R(0);
  configure(c);
  keep(c, s);
}

// Nothing of a system that is off is left.
void clear_unused(Sim& s) {
  const SystemSwitches& on = s.systems.vehicle.on;
  SystemState<R>& x = s.systems.state;
  if (!on.conversion) x.mast = x.mast_rate = x.flap = R(0);
  if (on.governor != Governor::pi) x.rotor_speed = R(0);
  if (!twists(on)) x.shaft_twist = x.twist_rate = R(0);
  if (on.governor == Governor::off) x.governor = R(0);
  if (!on.engines) x.power[right] = x.power[left] = x.fuel = R(0);
  if (!on.actuators) put_actuators(BladeControls<R>{}, x);
  if (!on.gear) x.gear = R(0);
  if (!on.turbulence) x.gusts = TurbulenceState<R>{};
  if (!on.augmentation) {
    for (R& way : x.series) way = R(0);
    x.washout = x.held_pitch = x.held_roll = x.holds_pitch = x.holds_roll = x.rest_long = x.rest_lat = R(0);
  }
}

}  // namespace

void evaluate(const Sim& s, Configuration<R>& c, Found& found) {
  equipped(s, c);
  const State<R> x = evaluated_state(s);
  found.system_rates = SystemState<R>{};
  found.weight_on_wheels = R(0);
  if (!has_systems(s)) return derivative(c, x, s.u, found.steps, found.rates);
  AirframeDemand<R> demand;
  AirframeAnswer<R> answer;
  VehicleFlows<R> flows;
  const ConfigurationSetting<R> base = c.setup;
  const Vehicle<R>& v = s.systems.vehicle;
  c.around = with_turbulence(c, x, s.u, v, s.systems.state);
  vehicle_rates(v, c, base, c, x, s.systems.state, v.commands, s.u,
                VehicleAirframe<R>{c, x, found.steps, R(0)}, demand, answer, flows, found.system_rates);
  found.rates = answer.rates;
  found.weight_on_wheels = demand.gear.weight_on_wheels;
  put_spin_up(v, found.system_rates, c);
}

void flatten_rates(const Found& found, R* rates) {
  flatten(found.rates, rates);
  flatten(found.system_rates, rates + state_count);
}

void follow_configuration(Sim& s) {
  const SystemSwitches& on = s.systems.vehicle.on;
  const FlightSetup<R>& setup = s.configuration.setup;
  SystemState<R>& x = s.systems.state;
  if (on.conversion) {
    // What reads the same in degrees was not set: it keeps its bits.
    if (x.mast * kDegPerRad<R> != setup.mast_deg) x.mast = s.configuration.mast;
    x.mast_rate = setup.mast_rate;
    if (x.flap * kDegPerRad<R> != setup.flap_deg) x.flap = setup.flap_deg * kRadPerDeg<R>;
  }
  if (on.governor == Governor::pi) x.rotor_speed = setup.rotor_speed;
  if (on.engines) s.systems.vehicle.loaded_mass = setup.mass + x.fuel;
}

tr_status follow_systems(Sim& s, int* blamed) {
  const SystemSwitches& on = s.systems.vehicle.on;
  const bool apart = s.configuration.setup.rotor_difference != s.systems.state.twist_rate;
  if (!on.conversion && on.governor != Governor::pi && !on.engines && !apart) return TR_OK;
  Configuration<R> c;
  equipped(s, c);
  ConfigurationSetting<R> setting = c.setup;
  const SystemState<R>& x = s.systems.state;
  if (on.conversion) {
    if (x.mast != c.mast) setting.mast_deg = x.mast * kDegPerRad<R>;
    setting.mast_rate = x.mast_rate;
    setting.mast_acceleration =
        mast_motion(c.aircraft->systems, s.systems.vehicle.commands.mast, x.mast, x.mast_rate).acceleration;
    if (x.flap != setting.flap_deg * kRadPerDeg<R>) setting.flap_deg = x.flap * kDegPerRad<R>;
  }
  if (on.engines) setting.mass = s.systems.vehicle.loaded_mass - x.fuel;
  if (on.governor == Governor::pi) {
    setting.rotor_speed = x.rotor_speed;
    setting.rotor_acceleration = R(0);
  }
  setting.rotor_difference = x.twist_rate;
  FlightSetup<R> wanted = c.setup;
  static_cast<ConfigurationSetting<R>&>(wanted) = setting;
  const Status status = reconfigure(setting, c);
  if (status == Status::ok) {
    keep(c, s);
  } else if (blamed != nullptr) {
    const int system = system_behind(*c.aircraft, wanted);
    *blamed = system < 0 ? kNone : state_count + system;
  }
  return translated(status);
}

void put_system_states(const R* states, Sim& s) {
  unflatten(states, s.systems.state);
  clear_unused(s);
}

void reset_systems(Sim& s) {
  s.systems = SystemFlight<R>{};
  const FlightSetup<R>& setup = s.configuration.setup;
  Vehicle<R>& v = s.systems.vehicle;
  v.commands = {s.configuration.mast, setup.flap_deg * kRadPerDeg<R>, setup.rotor_speed, {R(0), R(0)}};
  v.gear_down = true;
  v.ground = {s.air.ground_down, R(0), R(0)};
}

bool meet_ground_in_flight(const Sim& s, State<R> x, const Controls<R>& u, Configuration<R>& c) {
  const Vehicle<R>& v = s.systems.vehicle;
  const bool gear = v.on.gear && v.gear_down;
  if (!gear && !v.on.ground_effect) return false;
  x.position = s.x.position;
  AirframeDemand<R> demand;
  demand.controls = u;
  demand.setting = c.setup;
  vehicle_parts::meet_ground(v, c, c, x, gear ? R(1) : R(0), demand);
  demand.gear.total = Loads<R>{};
  if (gear)
    demand.gear.total = gear_drag(c, R(1), airframe_velocity(x.velocity - u.gust, c.mass.nacelles), x.rates);
  put_into(demand, c);
  return true;
}

void settle_systems(Sim& s) {
  if (!has_systems(s)) return;
  Configuration<R> c;
  equipped(s, c);
  const State<R> x = evaluated_state(s);
  DerivativeSteps<R> steps;
  State<R> rates;
  derivative(c, x, s.u, steps, rates);
  settle(c, x, {steps.rotor[right].loads.torque, steps.rotor[left].loads.torque}, s.systems.vehicle,
         s.systems.state, s.u);
  clear_unused(s);
}

Vec3<R> gust_at(const Sim& s, const Vec3<R>& arm) {
  Configuration<R> c;
  equipped(s, c);
  const Surroundings<R> around =
      with_turbulence(c, evaluated_state(s), s.u, s.systems.vehicle, s.systems.state);
  return around.wing_gust_b + cross(around.gust_rates_b, arm);
}

int engines_that_run(const Sim& s) {
  const bool(&failed)[2] = s.systems.vehicle.engine_failed;
  return failed[right] || failed[left] ? vehicle_parts::engines_running(failed) : kAllEngines;
}

void get_systems(const Sim& s, tr_systems& systems) {
  const Vehicle<R>& v = s.systems.vehicle;
  systems = tr_systems{};
  systems.governor = static_cast<std::int32_t>(v.on.governor);
  systems.conversion = v.on.conversion;
  systems.engines = v.on.engines;
  systems.actuators = v.on.actuators;
  systems.scas = v.on.augmentation && !v.disengages;
  systems.gear = v.on.gear;
  systems.ground_effect = v.on.ground_effect;
  systems.turbulence = v.on.turbulence;
  systems.interconnect = v.on.interconnect;
  systems.wind_shear = static_cast<std::int32_t>(v.on.wind_shear);
  systems.mast_command_deg = v.commands.mast * kDegPerRad<R>;
  systems.flap_command_deg = v.commands.flap * kDegPerRad<R>;
  systems.rotor_command_radps = v.commands.rotor_speed;
  systems.gear_down = v.gear_down;
  for (const Side side : {right, left}) {
    systems.throttle[side] = v.commands.throttle[side];
    systems.brake[side] = v.brake[side];
    systems.engine_failed[side] = v.engine_failed[side];
  }
  systems.turbulence_seed = v.turbulence_seed;
  systems.turbulence_w20_mps = v.wind_20_ft;
}

Vec3<R> wind_there(const Sim& s, const Vehicle<R>& v, const Vec3<R>& told_n) {
  return wind_at(mean_wind(v, aircraft_data<R>().gust, told_n), s.x.position.z);
}

bool keep_over_ground(const Sim& s, const Vec3<R>& change_n, Vec3<R>& velocity) {
  const State<R> x = evaluated_state(s);
  velocity = s.x.velocity - earth_to_body(EulerAngles<R>{x.roll, x.pitch, x.yaw}).apply(change_n);
  bool possible = true;
  Vec3<R>::each(velocity, [&possible](R part) {
    possible = possible && std::fabs(part) <= state_bound<R>(kStateIndex.velocity.x);
  });
  return possible;
}

void put_switches(const tr_systems& systems, Sim& s) {
  Vehicle<R>& v = s.systems.vehicle;
  hand_over(v, s.systems.state, static_cast<Governor>(systems.governor));
  v.on.conversion = systems.conversion == 1;
  v.on.engines = systems.engines == 1;
  v.on.actuators = systems.actuators == 1;
  v.on.gear = systems.gear == 1;
  v.on.ground_effect = systems.ground_effect == 1;
  v.on.turbulence = systems.turbulence == 1;
  v.on.interconnect = systems.interconnect == 1;
  v.on.wind_shear = static_cast<WindShear>(systems.wind_shear);
  // Switched off it stays until its actuators have returned.
  v.disengages = v.on.augmentation && systems.scas == 0 && !has_returned(s.systems.state);
  v.on.augmentation = v.disengages || systems.scas == 1;
  v.commands.mast = systems.mast_command_deg * kRadPerDeg<R>;
  v.commands.flap = systems.flap_command_deg * kRadPerDeg<R>;
  v.commands.rotor_speed = systems.rotor_command_radps;
  v.gear_down = systems.gear_down == 1;
  for (const Side side : {right, left}) {
    v.commands.throttle[side] = systems.throttle[side];
    v.brake[side] = systems.brake[side];
    v.engine_failed[side] = systems.engine_failed[side] == 1;
  }
  v.turbulence_seed = systems.turbulence_seed;
  v.wind_20_ft = systems.turbulence_w20_mps;
}

}  // namespace tiltrotor::c_interface

namespace tiltrotor::c_interface::checked {

tr_status tr_default_systems(tr_systems* systems) {
  if (systems == nullptr) return TR_BAD_ARGUMENT;
  *systems = tr_systems{};
  systems->rotor_command_radps = aircraft_data<R>().rotor.speed_helicopter;
  systems->flap_command_deg = aircraft_data<R>().defaults.flap_helicopter;
  systems->gear_down = 1;
  return TR_OK;
}

tr_status tr_get_systems(const tr_sim* sim, tr_systems* systems) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (systems == nullptr) return TR_BAD_ARGUMENT;
  get_systems(*opened(sim), *systems);
  return TR_OK;
}

tr_status tr_set_systems(tr_sim* sim, const tr_systems* systems) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (systems == nullptr) return TR_BAD_ARGUMENT;
  const tr_status possible = check_systems(*systems);
  if (possible != TR_OK) return possible;
  Sim& s = *opened(sim);
  const SystemFlight<R> all_before = s.systems;
  put_switches(*systems, s);
  const Vec3<R>& told = s.configuration.around.wind_n;
  Vec3<R> velocity;
  if (!keep_over_ground(s, wind_there(s, s.systems.vehicle, told) - wind_there(s, all_before.vehicle, told),
                        velocity)) {
    s.systems = all_before;
    return TR_OUT_OF_RANGE;
  }
  std::swap(s.x.velocity, velocity);  // the systems begin in the new wind; on failure it is put back
  begin_systems(all_before.vehicle.on, s);
  if (twists(s.systems.vehicle.on) && !twists(all_before.vehicle.on)) balance_shaft(s);
  clear_unused(s);
  // A drive that is switched off holds the masts.
  if (all_before.vehicle.on.conversion && !s.systems.vehicle.on.conversion) hold_masts(s);
  const tr_status status = follow_systems(s);
  // Rotors that turn alike again keep the speed of their inflow.
  const R apart = all_before.state.twist_rate - s.systems.state.twist_rate;
  const R mean = s.configuration.setup.rotor_speed;
  for (const Side side : {right, left}) {
    if (status != TR_OK || apart == R(0)) break;
    const R faster = R(1) + R(0.5) * side_sign<R>(side) * apart / mean;
    RotorState<R>& rotor = s.x.rotor[side];
    for (R* inflow : {&rotor.lambda_0, &rotor.lambda_c, &rotor.lambda_s}) *inflow *= faster;
  }
  // Loads of a gear belong to the moment.
  if (status == TR_OK) leave_ground(s);
  if (status != TR_OK) {
    s.systems = all_before;
    s.x.velocity = velocity;
  }
  return status;
}

}  // namespace tiltrotor::c_interface::checked
