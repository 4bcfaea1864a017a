// How the configuration moves while a step lasts: masts and rotors as their rates and accelerations carry them,
// the masts to their stops; air as the altitude says.
#pragma once

#include <cmath>

#include "tiltrotor/model/setup/configuration.hpp"

namespace tiltrotor {

// Whether anything of a setting moves by itself.
template <class R>
bool is_moving(const ConfigurationSetting<R>& s) {
  return s.mast_rate != R(0) || s.mast_acceleration != R(0) || s.rotor_acceleration != R(0);
}

// Time until the mast meets a stop, s: `none` when it does not within that time.
template <class R>
R time_to_stop(const ConfigurationSetting<R>& s, const Bounds<R>& stops, R none) {
  const R rate = s.mast_rate * kDegPerRad<R>, acceleration = s.mast_acceleration * kDegPerRad<R>;
  R first = none;
  for (const bool upper : {true, false}) {
    // way = rate t + acceleration t^2 / 2, with all signs those of the way to this stop.
    const R sign = upper ? R(1) : R(-1);
    const R way = sign * ((upper ? stops.high : stops.low) - s.mast_deg);
    const R v = sign * rate, a = sign * acceleration;
    if (!(way > R(0))) {  // it stands there: does it move into the stop, or come back to it?
      const R t = v > R(0) || (v == R(0) && a > R(0)) ? R(0) : a > R(0) ? R(-2) * v / a : none;
      if (t < first) first = t;
      continue;
    }
    const R under = v * v + R(2) * a * way;
    if (!(under >= R(0))) continue;  // turns back before
    // The first root, written without cancellation.
    const R sum = v + std::sqrt(under);
    if (sum > R(0) && R(2) * way < first * sum) first = R(2) * way / sum;
  }
  return first;
}

// The setting `since` seconds later, without stops.
template <class R>
ConfigurationSetting<R> carried(ConfigurationSetting<R> s, R since) {
  s.mast_deg += (s.mast_rate + R(0.5) * s.mast_acceleration * since) * since * kDegPerRad<R>;
  s.mast_rate += s.mast_acceleration * since;
  s.rotor_speed += s.rotor_acceleration * since;
  return s;
}

// Turned by the right rotor's first blade in the same time, rad.
template <class R>
R turned(const ConfigurationSetting<R>& s, R since) {
  return (s.rotor_speed + R(0.5) * s.rotor_acceleration * since) * since;
}

// At a stop a mast stays: rate and acceleration are gone.
template <class R>
void stop_mast(ConfigurationSetting<R>& s, const Bounds<R>& stops) {
  s.mast_deg = s.mast_deg < R(0.5) * (stops.low + stops.high) ? stops.low : stops.high;
  s.mast_rate = s.mast_acceleration = R(0);
}

// A configuration on its way. Air follows the altitude, `altitude_origin` less the state's position down, when
// asked to; else it stays as the setting says.
template <class R>
struct MovingConfiguration {
  Configuration<R>* configuration;
  bool air_follows_altitude;
  R altitude_origin;  // m

  // Set by a step:
  ConfigurationSetting<R> from;  // at `begin`
  R begin;                       // s
};

// Air of another altitude, nothing else being changed.
template <class R>
void set_altitude(Configuration<R>& c, R altitude) {
  c.setup.altitude = altitude;
  c.air = surrounding_air(altitude, c.around.warmer, c.around.pressure_above);
}

// The configuration at a time of the step and a position.
template <class R>
void place(const MovingConfiguration<R>& moving, R time, R down) {
  Configuration<R>& c = *moving.configuration;
  ConfigurationSetting<R>& setting = c.setup;
  setting = carried(moving.from, time - moving.begin);
  if (moving.air_follows_altitude) set_altitude(c, moving.altitude_origin - down);
  if (is_moving(moving.from)) configure(c);
}

}  // namespace tiltrotor
