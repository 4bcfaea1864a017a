// What happens to the systems between steps, and where they stand in a steady flight.
#pragma once

#include "tiltrotor/systems/vehicle.hpp"

namespace tiltrotor {

// Series actuators that have come this near to neutral, in, have returned.
template <class R>
inline constexpr R kReturned = R(1e-6);

template <class R>
bool has_returned(const SystemState<R>& s) {
  for (const R& way : s.series)
    if (!(way < kReturned<R> && way > -kReturned<R>)) return false;
  return true;
}

// Events of a step, at its beginning: an attitude is held or given up, an augmentation that was switched off is gone
// when its actuators have returned, engines stop without fuel; masts are sent no further than their stops, where else
// their drive would push on. Whether anything happened.
template <class R>
bool begin_step(const Aircraft<R>& aircraft, const State<R>& x, const Controls<R>& u, Vehicle<R>& v,
                SystemState<R>& s) {
  const AugmentationTables<R>& t = aircraft.systems.augmentation;
  const R before[] = {s.holds_pitch, s.holds_roll};
  bool happened = false;
  if (v.on.augmentation) {
    latch(t, u.long_stick - s.rest_long, x.rates.y, x.pitch, s.holds_pitch, s.held_pitch);
    latch(t, u.lat_stick - s.rest_lat, x.rates.x, x.roll, s.holds_roll, s.held_roll);
  }
  const Bounds<R>& stops = aircraft.limits.mast_deg;
  if (v.on.conversion) {
    const R told = v.commands.mast;
    v.commands.mast = smaller_of(larger_of(told, stops.low * kRadPerDeg<R>), stops.high * kRadPerDeg<R>);
    happened = v.commands.mast != told;
  }
  if (v.on.augmentation && v.disengages) {
    if (has_returned(s)) {
      v.on.augmentation = v.disengages = false;
      for (R& way : s.series) way = R(0);
      s.washout = s.held_pitch = s.held_roll = s.holds_pitch = s.holds_roll = s.rest_long = s.rest_lat = R(0);
      happened = true;
    }
  }
  if (v.on.engines && s.fuel >= aircraft.systems.drive.fuel) {
    for (bool& failed : v.engine_failed) {
      happened = happened || !failed;
      failed = true;
    }
  }
  return happened || s.holds_pitch != before[0] || s.holds_roll != before[1];
}

// Another governor takes over in flight, with the blades where they are. One that leads goes on from the collective that
// the other had added; switched off, it leaves that to the lever: the answer, rad. An ideal governor adds it behind the
// actuators, one of kind pi before them.
template <class R>
R hand_over(Vehicle<R>& v, SystemState<R>& s, Governor to) {
  const Governor from = v.on.governor;
  const R added = s.governor;
  if (v.on.actuators && from != to)
    for (R& blades : s.collective)
      blades += from == Governor::ideal ? added : to == Governor::ideal ? -added : R(0);
  v.on.governor = to;
  if (to != Governor::off) return R(0);
  s.governor = R(0);
  return added;
}

// Extension of the gear `dt` later: unlocked at once when it is told to go up, locked where it arrives.
template <class R>
R moved_gear(const GearTables<R>& gear, const Vehicle<R>& v, R extension, R dt) {
  const R way = dt / gear.transit;
  const R moved = v.gear_down ? extension + way : extension - way;
  return larger_of(smaller_of(moved, R(1)), R(0));
}

// The systems in a steady flight at (x, u) of the airframe, `torque` of each rotor (N m): every rate that the flight
// leaves zero is zero. Commands become what is; stick and pedals are relieved of what the augmentation holds, and
// rest there. Engines that run share the power, which is none where the rotors drive them, and no more than they have: then
// the rotors slow down (TrimStatus::power_limit).
template <class R>
void settle(const Configuration<R>& c, const State<R>& x, const R (&torque)[2], Vehicle<R>& v,
            SystemState<R>& s, Controls<R>& u) {
  const Aircraft<R>& aircraft = *c.aircraft;
  s.mast = v.commands.mast = c.mast;
  s.mast_rate = R(0);
  s.flap = v.commands.flap = c.setup.flap_deg * kRadPerDeg<R>;
  s.rotor_speed = v.commands.rotor_speed = c.setup.rotor_speed;
  s.governor = R(0);
  v.loaded_mass = c.setup.mass + s.fuel;

  const R needed =
      (torque[right] + torque[left]) * c.setup.rotor_speed / aircraft.controls.transmission_efficiency;
  const int running = vehicle_parts::engines_running(v.engine_failed);
  const R full = demanded_power(aircraft, c.air, R(1));
  const R most = demanded_power(aircraft, c.air, kMostThrottle<R>);
  for (const Side side : {right, left}) {
    const bool works = !v.engine_failed[side] && needed > R(0);
    s.power[side] = works ? smaller_of(needed / static_cast<R>(running), most) : R(0);
    v.commands.throttle[side] = smaller_of(s.power[side] / full, kMostThrottle<R>);
  }
  s.shaft_twist =
      twists(v.on) ? balanced_twist(aircraft, v.engine_failed, s.power, torque, c.setup.rotor_speed) : R(0);
  s.twist_rate = R(0);
  s.gear = v.on.gear && v.gear_down ? R(1) : R(0);

  const Vec3<R> velocity = x.velocity - u.gust;
  put_actuators(vehicle_parts::wanted_angles(aircraft, c.setup.options, c.setup.mast_deg, u, velocity), s);

  const AugmentationTables<R>& t = aircraft.systems.augmentation;
  for (R& way : s.series) way = R(0);
  s.washout = s.holds_pitch = s.holds_roll = R(0);
  s.held_pitch = x.pitch;
  s.held_roll = x.roll;
  if (v.on.augmentation && !v.disengages) {
    const R airspeed = total_speed(velocity, aircraft.smooth.airspeed);
    s.washout = x.rates.z - turn_rate_wanted(t, airspeed, x.roll);
    const SeriesCommand<R> wanted = augmentation(aircraft.systems, aircraft.controls, c.mast, airspeed, x, s);
    for (int k = 0; k < 3; ++k) s.series[k] = wanted.axis[k];
    u.long_stick -= s.series[0];
    u.lat_stick -= s.series[1];
    u.pedal -= s.series[2];
  }
  s.rest_long = u.long_stick;
  s.rest_lat = u.lat_stick;
}

// The air of the turbulence about an aircraft.
template <class R>
TurbulentAir<R> turbulent_air(const Configuration<R>& c, const State<R>& x, const Controls<R>& u,
                              const Vehicle<R>& v) {
  const R height = has_ground(v) ? v.ground.down - x.position.z : c.setup.altitude;
  return {height, length(x.velocity - u.gust), v.wind_20_ft};
}

// The surroundings with the gusts of the turbulence, which add to those that are there.
template <class R>
Surroundings<R> with_turbulence(const Configuration<R>& c, const State<R>& x, const Controls<R>& u,
                                const Vehicle<R>& v, const SystemState<R>& s) {
  Surroundings<R> around = c.around;
  if (!v.on.turbulence) return around;
  const LocalGusts<R> gusts = gusts_at(s.gusts, turbulent_air(c, x, u, v), *c.aircraft);
  for (const Side side : {right, left})
    around.rotor_gust_b[side] = around.rotor_gust_b[side] + gusts.rotor[side];
  around.wing_gust_b = around.wing_gust_b + gusts.wing;
  around.tail_gust_b = around.tail_gust_b + gusts.tail;
  return around;
}

}  // namespace tiltrotor
