// What lies around the aircraft and does not depend on its motion: air that moves, air that is warmer or denser than
// the standard one, loads from outside. Held while a step lasts; plain numbers, which carry no partials.
#pragma once

#include "tiltrotor/model/variables/loads.hpp"

namespace tiltrotor {

template <class R>
struct Surroundings {
  // Of the undisturbed air over the ground, north east down, m/s: what carries the aircraft along; 20 ft above the ground
  // where it grows with height (systems/wind_shear.hpp).
  Vec3<R> wind_n;
  // Of the air at a place, relative to the undisturbed air and to Controls::gust, which is felt everywhere: body axes,
  // m/s. Wing: and pylons, fuselage, and wakes of the rotors on it; tail: horizontal tail and fins.
  Vec3<R> rotor_gust_b[2], wing_gust_b, tail_gust_b;
  // Turning of the air around the aircraft, body axes, rad/s: a gust that grows along body and wing.
  Vec3<R> gust_rates_b;
  R warmer;          // than the standard atmosphere at the same altitude, K
  R pressure_above;  // that of the standard atmosphere, as a fraction of it
  // Of everything that pulls and pushes from outside: force, body axes, N, and moment about the origin of the
  // stations, N m.
  Loads<R> outside;
};

}  // namespace tiltrotor
