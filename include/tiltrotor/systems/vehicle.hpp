// The whole vehicle: airframe and systems, with everything between them. x' = f(x, u) of all states.
//
// Two halves around the airframe. Upstream, airframe_demand() finds from all states and inputs what the airframe is to
// feel: controls, configuration, loads of the gear. Downstream, drive and governor answer the rotors' torque. Between
// them stands a callable, airframe(demand, answer): the model itself, or, where derivatives are wanted, its exact
// first-order expansion (analysis/linear/vehicle_model.hpp). So one text serves flight and linear model.
#pragma once

#include "tiltrotor/systems/actuators.hpp"
#include "tiltrotor/systems/augmentation.hpp"
#include "tiltrotor/systems/conversion.hpp"
#include "tiltrotor/systems/drive.hpp"
#include "tiltrotor/systems/ground_effect.hpp"
#include "tiltrotor/systems/landing_gear.hpp"
#include "tiltrotor/systems/wind_shear.hpp"

namespace tiltrotor {

struct SystemSwitches {
  Governor governor;
  bool conversion, engines, actuators, augmentation, gear, ground_effect, turbulence;
  bool interconnect = false;  // its shaft twists, where the rotor speed is a state
  WindShear wind_shear = WindShear::none;
};

template <class R>
struct Vehicle {
  SystemSwitches on;
  Commands<R> commands;
  bool engine_failed[2];
  bool disengages;        // the augmentation: its actuators return to neutral
  bool gear_down;         // told to be: SystemState::gear follows
  R brake[2];             // of the main wheels, right and left, 0..1
  GroundPlane<R> ground;  // level and infinitely far below without one
  std::uint64_t turbulence_seed;
  R wind_20_ft;       // strength of the turbulence, m/s
  bool air_follows;   // the altitude: `altitude_origin` less the position down
  R altitude_origin;  // m
  R loaded_mass;      // with no fuel burnt, kg: what the engines' fuel is taken from
};

inline bool any_system(const SystemSwitches& on) {
  return on.governor != Governor::off || on.conversion || on.engines || on.actuators || on.augmentation ||
         on.gear || on.ground_effect || on.turbulence || on.wind_shear != WindShear::none;
}

// Whether the rotors have a speed each.
constexpr bool twists(const SystemSwitches& on) { return on.interconnect && on.governor == Governor::pi; }

template <class R>
inline constexpr R kFarGround = R(1e8);  // m down: none
template <class R>
bool has_ground(const Vehicle<R>& v) {
  return v.ground.down < kFarGround<R>;
}

// Without a ground there is no height for the wind to grow with.
template <class R>
WindShear shear_in_force(const Vehicle<R>& v) {
  return has_ground(v) ? v.on.wind_shear : WindShear::none;
}
template <class R>
MeanWind<R> mean_wind(const Vehicle<R>& v, const GustTables<R>& gust, const Vec3<R>& told_n) {
  return {gust, shear_in_force(v), v.ground.down, told_n};
}

// Whether the gear carries.
template <class R>
bool is_locked_down(const Vehicle<R>& v, R extension) {
  return v.on.gear && v.gear_down && extension >= R(1);
}

// The states of systems that move by themselves, in order: places in kSystemVariables.
struct ActiveSystems {
  int count;
  int index[system_state_count];
};

// Whether a state belongs to a system that is on, and moves by itself.
constexpr bool is_active(int state, const SystemSwitches& on) {
  const SystemState<int>& at = kSystemIndex;
  if (state == at.mast || state == at.mast_rate || state == at.flap) return on.conversion;
  if (state == at.rotor_speed || state == at.governor) return on.governor == Governor::pi;
  if (state == at.shaft_twist || state == at.twist_rate) return twists(on);
  if (state == at.power[right] || state == at.power[left] || state == at.fuel) return on.engines;
  if (is_within(state, at.collective[right], at.rudder)) return on.actuators;
  if (is_within(state, at.series[0], at.washout)) return on.augmentation;
  return false;
}
static_assert(kSystemIndex.rudder - kSystemIndex.collective[right] == 6, "actuators stand together");
static_assert(kSystemIndex.washout - kSystemIndex.series[0] == 3,
              "states of the augmentation stand together");

inline ActiveSystems active_systems(const SystemSwitches& on) {
  ActiveSystems active{0, {}};
  for (int i = 0; i < system_state_count; ++i)
    if (is_active(i, on)) active.index[active.count++] = i;
  return active;
}

// What the airframe is to feel.
template <class T>
struct AirframeDemand {
  Controls<T> controls;
  ConfigurationSetting<T> setting;
  GroundEffect<T> ground;
  GearLoads<T> gear;  // its total, and its drag, are added to the loads around
};

// What the systems need of it.
template <class T>
struct AirframeAnswer {
  State<T> rates;
  T torque[2];  // aerodynamic, of the rotors, N m
};

// Parts of an evaluation that later ones need.
template <class T>
struct VehicleFlows {
  T engine[2];  // power of each at its shaft, W
  T power;      // of both
  T governed;   // collective that an ideal governor has added, rad
  bool held;    // whether it has found one at which the rotors take the power
};

namespace vehicle_parts {

template <class R>
bool is_same(const ConfigurationSetting<R>& a, const ConfigurationSetting<R>& b) {
  bool same = a.mast_deg == b.mast_deg;
  same &= a.mast_rate == b.mast_rate;
  same &= a.mast_acceleration == b.mast_acceleration;
  same &= a.flap_deg == b.flap_deg;
  same &= a.rotor_speed == b.rotor_speed;
  same &= a.rotor_difference == b.rotor_difference;
  same &= a.rotor_acceleration == b.rotor_acceleration;
  same &= a.altitude == b.altitude;
  same &= a.mass == b.mass;
  same &= a.sl_cg == b.sl_cg;
  same &= a.wl_cg == b.wl_cg;
  return same;
}

// The setting alone; what is asked for already is not made again.
template <class T>
void put_setting(const ConfigurationSetting<T>& to, Configuration<T>& c) {
  ConfigurationSetting<T>& now = c.setup;
  if constexpr (kIsNumber<T>) {
    if (is_same(to, now)) return;
  }
  now = to;
  configure(c);
}

inline int engines_running(const bool (&failed)[2]) { return !failed[right] + !failed[left]; }

// What the actuators are asked for.
template <class T>
BladeControls<T> wanted_angles(const Aircraft<Real<T>>& aircraft, const Options& options, const T& mast_deg,
                               const Controls<T>& u, const Vec3<T>& velocity) {
  const Gearing<T> g = gearing(aircraft, options, mast_deg, cos(T(mast_deg * kRadPerDeg<Real<T>>)));
  const GridPoint<T> pedal_mast[1] = {grid_point(aircraft.controls.pedal_cyclic.linear[0], mast_deg)};
  BladeControls<T> wanted = mix_controls(aircraft, options, g, pedal_mast, u, velocity);
  for (const Side side : {right, left}) wanted.long_cyclic[side] = wanted.long_cyclic[side] - g.rigging;
  return wanted;
}

// Gear, `extension` of it out, and ground effect. Without them `at` is left alone.
template <class T>
void meet_ground(const Vehicle<Real<T>>& v, const Configuration<Real<T>>& c, Configuration<T>& at,
                 const State<T>& x, const T& extension, AirframeDemand<T>& demand) {
  using R = Real<T>;
  demand.ground = {{T(R(1)), T(R(1))}, T(R(1))};
  GearLoads<T>::each(demand.gear, [](T& number) { number = T(R(0)); });
  const bool gear = v.on.gear && value(extension) > R(0);
  const bool near = has_ground(v);
  if (!gear && !(v.on.ground_effect && near)) return;
  put_setting(demand.setting, at);
  const Vec3<T> in_air = airframe_velocity(x.velocity - demand.controls.gust, at.mass.nacelles);
  if (near) {
    const AboveGround<T> above = above_ground(v.ground, x.roll, x.pitch, x.yaw, x.position);
    if (v.on.ground_effect)
      demand.ground =
          ground_effect(at, above, in_air, x.rates, {x.rotor[right].lambda_0, x.rotor[left].lambda_0});
    const GearCommand<T> command = {
        is_locked_down(v, value(extension)), false, {T(v.brake[right]), T(v.brake[left])}};
    if (gear)
      landing_gear(at, above, velocity_over_ground(mean_wind(v, c.aircraft->gust, c.around.wind_n), x),
                   x.rates, command, demand.gear);
  }
  if (gear) demand.gear.total = demand.gear.total + gear_drag(at, extension, in_air, x.rates);
}

// Speeds and accelerations of the two halves of the drive, and the rates of its states.
template <class T>
void turn_halves(const Vehicle<Real<T>>& v, const Aircraft<Real<T>>& aircraft, const SystemState<T>& s,
                 const VehicleFlows<T>& flows, const AirframeAnswer<T>& answer, T (&rotor_speed)[2],
                 T (&faster)[2], SystemState<T>& rates) {
  using R = Real<T>;
  for (const Side side : {right, left})
    rotor_speed[side] = s.rotor_speed + (R(0.5) * side_sign<R>(side)) * s.twist_rate;
  half_accelerations(aircraft, v.engine_failed, flows.engine, answer.torque, rotor_speed, s.shaft_twist,
                     faster);
  rates.rotor_speed = R(0.5) * (faster[right] + faster[left]);
  rates.shaft_twist = s.twist_rate;
  rates.twist_rate = faster[right] - faster[left];
}

// Rotors that turn against each other balance what speeds them up but for their difference: derived here,
// M = -I (Omega_R' - Omega_L') n, n along the masts. Their cant counts by its cosine.
template <class T>
Loads<T> twist_reaction(const Configuration<Real<T>>& c, const ConfigurationSetting<T>& setting,
                        const T& acceleration) {
  using R = Real<T>;
  const SineCosine<T> tilt = sine_and_cosine(T(setting.mast_deg * kRadPerDeg<R>));
  T moment = rotor_inertia(*c.aircraft) * acceleration;
  if (c.setup.options.mast_cant) moment = moment * cos(T(c.aircraft->mast.cant * tilt.cosine));
  const T none = T(R(0));
  return {{none, none, none}, {-(moment * tilt.sine), none, moment * tilt.cosine}};
}

}  // namespace vehicle_parts

// `c`: what no system moves, `base`: the setting of what they may, `at`: with the fixed part of `c`, put into the setting
// that is asked for where ground counts. Rates of the systems, but for those that follow the rotors' torque, go to
// `rates`.
template <class T>
void airframe_demand(const Vehicle<Real<T>>& v, const Configuration<Real<T>>& c,
                     const ConfigurationSetting<Real<T>>& base, Configuration<T>& at, const State<T>& x,
                     const SystemState<T>& s, const Commands<T>& commands, const Controls<T>& u,
                     AirframeDemand<T>& demand, VehicleFlows<T>& flows, SystemState<T>& rates) {
  using R = Real<T>;
  const Aircraft<R>& aircraft = *c.aircraft;
  const SystemTables<R>& t = aircraft.systems;
  ConfigurationSetting<T>& setting = demand.setting;
  setting = in_scalar<T>(base);
  SystemState<T>::each(rates, [](T& rate) { rate = T(R(0)); });

  if (v.on.conversion) {
    const MastMotion<T> mast = mast_motion(t, commands.mast, s.mast, s.mast_rate);
    setting.mast_deg = s.mast * kDegPerRad<R>;
    setting.mast_rate = mast.rate;
    setting.mast_acceleration = mast.acceleration;
    setting.flap_deg = s.flap * kDegPerRad<R>;
    rates.mast = mast.rate;
    rates.mast_rate = mast.acceleration;
    rates.flap = flap_rate(t, commands.flap, s.flap);
  }
  if (v.on.governor == Governor::pi) {
    setting.rotor_speed = s.rotor_speed;
    setting.rotor_acceleration = T(R(0));  // see vehicle_rates()
  }
  setting.rotor_difference = twists(v.on) ? s.twist_rate : T(R(0));

  if (v.on.engines) setting.mass = v.loaded_mass - s.fuel;
  if (v.air_follows) setting.altitude = v.altitude_origin - x.position.z;

  out_of_line([&] {
    const auto lapse_at = [&](const auto& altitude) {
      return power_lapse(aircraft.controls,
                         surrounding_air(altitude, c.around.warmer, c.around.pressure_above));
    };
    const T lapse = by_slope(lapse_at, setting.altitude);
    flows.power = T(R(0));
    for (const Side side : {right, left}) {
      const T demanded =
          v.engine_failed[side] ? T(R(0)) : lapsed_power(aircraft, lapse, commands.throttle[side]);
      if (v.on.engines) {
        rates.power[side] = power_rate(t, demanded, s.power[side]);
        rates.fuel = rates.fuel + fuel_flow(t, s.power[side]);
      }
      flows.engine[side] = v.on.engines ? s.power[side] : demanded;
      flows.power = flows.power + flows.engine[side];
    }
  });

  Controls<T>& moved = demand.controls;
  moved = u;
  const Vec3<T> velocity = x.velocity - u.gust;
  out_of_line([&] {
    if (!v.on.augmentation) return;
    const T airspeed = total_speed(velocity, aircraft.smooth.airspeed);
    const T mast = setting.mast_deg * kRadPerDeg<R>;
    const R share = v.disengages ? R(0) : R(1);
    const SeriesCommand<T> wanted = augmentation(t, aircraft.controls, mast, airspeed, x, s);
    for (int k = 0; k < 3; ++k)
      rates.series[k] = t.augmentation.servo * (share * wanted.axis[k] - s.series[k]);
    rates.washout = (wanted.washed_rate - s.washout) * (R(1) / t.augmentation.washout);
    moved.long_stick = moved.long_stick + s.series[0];
    moved.lat_stick = moved.lat_stick + s.series[1];
    moved.pedal = moved.pedal + s.series[2];
  });
  if (v.on.governor == Governor::pi) moved.collective = moved.collective + s.governor;
  out_of_line([&] {
    if (!v.on.actuators) return;
    const BladeControls<T> wanted =
        vehicle_parts::wanted_angles(aircraft, c.setup.options, setting.mast_deg, moved, velocity);
    actuator_rates(aircraft, wanted, s, rates);
    moved = actuated_controls(s, u);
  });
  vehicle_parts::meet_ground(v, c, at, x, s.gear, demand);
}

// The ideal governor: the collective at which the rotors take the power of the engines, by the secant method, its slope
// kept where two points lie too near to give one. Dual numbers, whose value is the solution already, gain the
// derivative of the implicit function. False where there is none: rotors that hover take some power at any
// collective. A search that ends within a thousandth of an engine's power counts, its next one begins there.
template <class T, class Airframe>
bool hold_power(const Configuration<Real<T>>& c, const T& guess, const T& power, Airframe&& airframe,
                AirframeDemand<T>& demand, AirframeAnswer<T>& answer, T& governed) {
  using R = Real<T>;
  constexpr int rounds = 6;
  // Derivatives come by rounds with one slope, each of which leaves the part by which the slope is wrong: P''/P' step/2.
  const R step = kIsNumber<T> ? R(1e-3) : R(1e-5), apart = R(1e-6);  // rad
  const R near = R(1e-12) * c.aircraft->controls.engine_power;
  const R efficiency = c.aircraft->controls.transmission_efficiency;
  const T collective = demand.controls.collective;
  const auto excess = [&](const T& added) {
    demand.controls.collective = collective + added;
    airframe(demand, answer);
    return T((answer.torque[right] + answer.torque[left]) * demand.setting.rotor_speed - efficiency * power);
  };
  governed = guess;
  T left_over = excess(governed);
  R slope = (value(excess(T(governed + step))) - value(left_over)) / step;
  for (int k = 0; k < rounds; ++k) {
    const T by = left_over * (R(-1) / slope);
    const R before = value(left_over), way = value(by);
    governed = governed + by;
    left_over = excess(governed);
    const R rest = value(left_over);
    if (way > apart || way < -apart) slope = (rest - before) / way;
    if (kIsNumber<T> && rest < near && rest > -near) break;
  }
  const R most = R(1e-3) * c.aircraft->controls.engine_power, rest = value(left_over);
  return rest < most && rest > -most;
}

// What follows from the airframe's answer, in it and in `rates`. `airframe.add(loads, rates)`: what a load beside those
// that it knows does to the rates.
template <class T, class Airframe>
void follow_airframe(const Vehicle<Real<T>>& v, const Configuration<Real<T>>& c, const State<T>& x,
                     const SystemState<T>& s, const Commands<T>& commands, Airframe&& airframe,
                     const AirframeDemand<T>& demand, AirframeAnswer<T>& answer, const VehicleFlows<T>& flows,
                     SystemState<T>& rates) {
  using R = Real<T>;
  drift(mean_wind(v, c.aircraft->gust, c.around.wind_n), x, answer.rates);
  if (v.on.governor != Governor::pi) return;
  T rotor_speed[2] = {s.rotor_speed, s.rotor_speed}, faster[2];  // rad/s, rad/s^2
  if (twists(v.on)) {
    vehicle_parts::turn_halves(v, *c.aircraft, s, flows, answer, rotor_speed, faster, rates);
    airframe.add(vehicle_parts::twist_reaction(c, demand.setting, rates.twist_rate), answer.rates);
  } else {
    const T torque = answer.torque[right] + answer.torque[left];
    faster[right] = rotor_acceleration(*c.aircraft, vehicle_parts::engines_running(v.engine_failed),
                                       flows.power, torque, s.rotor_speed);
    faster[left] = rates.rotor_speed = faster[right];
  }
  const T mast = demand.setting.mast_deg * kRadPerDeg<R>;
  rates.governor = governor_rate(c.aircraft->systems, mast, commands.rotor_speed, s.rotor_speed,
                                 rates.rotor_speed, s.governor);
  // Inflow keeps its speed when the rotor's changes: state_rates.hpp.
  for (const Side side : {right, left}) {
    const T slower = faster[side] / rotor_speed[side];
    RotorState<T>& rotor = answer.rates.rotor[side];
    rotor.lambda_0 = rotor.lambda_0 - slower * x.rotor[side].lambda_0;
    rotor.lambda_c = rotor.lambda_c - slower * x.rotor[side].lambda_c;
    rotor.lambda_s = rotor.lambda_s - slower * x.rotor[side].lambda_s;
  }
}

// Rates of all states. `airframe(demand, answer)`: rates of the airframe, and torque of its rotors; `airframe.add` as
// above.
template <class T, class Airframe>
void vehicle_rates(const Vehicle<Real<T>>& v, const Configuration<Real<T>>& c,
                   const ConfigurationSetting<Real<T>>& base, Configuration<T>& at, const State<T>& x,
                   const SystemState<T>& s, const Commands<T>& commands, const Controls<T>& u,
                   Airframe&& airframe, AirframeDemand<T>& demand, AirframeAnswer<T>& answer,
                   VehicleFlows<T>& flows, SystemState<T>& rates) {
  using R = Real<T>;
  airframe_demand(v, c, base, at, x, s, commands, u, demand, flows, rates);
  flows.governed = T(R(0));
  flows.held = true;
  if (v.on.governor == Governor::ideal) {
    flows.held = hold_power(c, s.governor, flows.power, airframe, demand, answer, flows.governed);
  } else {
    airframe(demand, answer);
  }
  follow_airframe(v, c, x, s, commands, airframe, demand, answer, flows, rates);
}

}  // namespace tiltrotor
