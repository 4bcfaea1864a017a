// What happens to the systems between steps, and where they stand in a steady flight.
#pragma once

#include "tiltrotor/systems/vehicle.hpp"

namespace tiltrotor {

// Series actuators that have come this near to neutral, in, have returned.
template <class R>
inline constexpr R kReturned = R(1e-6);

// Events of a step, at its beginning: an attitude is held or given up, an augmentation that was switched off is gone
// when its actuators have returned, engines stop without fuel; masts are sent no further than their stops, where else
// their drive would push on.
template <class R>
void begin_step(const Aircraft<R>& aircraft, const State<R>& x, const Controls<R>& u, Vehicle<R>& v,
                SystemState<R>& s) {
  const AugmentationTables<R>& t = aircraft.systems.augmentation;
  if (v.on.augmentation) {
    latch(t, u.long_stick - s.rest_long, x.rates.y, x.pitch, s.holds_pitch, s.held_pitch);
    latch(t, u.lat_stick - s.rest_lat, x.rates.x, x.roll, s.holds_roll, s.held_roll);
  }
  const Bounds<R>& stops = aircraft.limits.mast_deg;
  if (v.on.conversion)
    v.commands.mast =
        smaller_of(larger_of(v.commands.mast, stops.low * kRadPerDeg<R>), stops.high * kRadPerDeg<R>);
  if (v.on.augmentation && v.disengages) {
    bool returned = true;
    for (const R& way : s.series) returned = returned && way < kReturned<R> && way > -kReturned<R>;
    if (returned) {
      v.on.augmentation = v.disengages = false;
      for (R& way : s.series) way = R(0);
      s.washout = s.holds_pitch = s.holds_roll = R(0);
    }
  }
  if (v.on.engines && s.fuel >= aircraft.systems.drive.fuel)
    for (bool& failed : v.engine_failed) failed = true;
}

// The systems in a steady flight at (x, u) of the airframe, `torque` of both rotors (N m): every rate that the flight
// leaves zero is zero. Commands become what is; stick and pedals are relieved of what the augmentation holds, and
// rest there. Engines that run share the power, which is none where the rotors drive them.
template <class R>
void settle(const Configuration<R>& c, const State<R>& x, R torque, Vehicle<R>& v, SystemState<R>& s,
            Controls<R>& u) {
  const Aircraft<R>& aircraft = *c.aircraft;
  s.mast = v.commands.mast = c.mast;
  s.mast_rate = R(0);
  s.flap = v.commands.flap = c.setup.flap_deg * kRadPerDeg<R>;
  s.rotor_speed = v.commands.rotor_speed = c.setup.rotor_speed;
  s.governor = R(0);

  const R needed = torque * c.setup.rotor_speed / aircraft.controls.transmission_efficiency;
  const int running = vehicle_detail::engines_running(v.engine_failed);
  const R full = demanded_power(aircraft, c.air, R(1));
  for (const Side side : {right, left}) {
    const bool works = !v.engine_failed[side] && needed > R(0);
    s.power[side] = works ? needed / static_cast<R>(running) : R(0);
    v.commands.throttle[side] = s.power[side] / full;
  }

  const Vec3<R> velocity = x.velocity - u.gust;
  const BladeControls<R> angles =
      vehicle_detail::wanted_angles(aircraft, c.setup.options, c.setup.mast_deg, u, velocity);
  for (const Side side : {right, left}) {
    s.collective[side] = angles.collective[side];
    s.long_cyclic[side] = angles.long_cyclic[side];
  }
  s.elevator = angles.elevator;
  s.aileron = angles.aileron;
  s.rudder = angles.rudder;

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

}  // namespace tiltrotor
