// Gusts where the aircraft feels them, and the discrete gust of MIL-F-8785C section 3.7.3 that arrives there one place
// after the other.
#pragma once

#include "tiltrotor/math/scalar.hpp"
#include "tiltrotor/math/vector.hpp"
#include "tiltrotor/model/aircraft/aircraft.hpp"

namespace tiltrotor {

// Velocity of the air at a place relative to the undisturbed air, body axes, m/s: what Surroundings takes. The turning
// of the air is in the differences between the places already.
template <class T>
struct LocalGusts {
  Vec3<T> rotor[2];  // right, left
  Vec3<T> wing, tail;
};

// How far the tail flies behind rotors and wing, which are about at the CG, m.
template <class R>
R tail_distance(const Aircraft<R>& aircraft) {
  return aircraft.htail.surface.sl - aircraft.mass.sl_cg;
}

// (1 - cos(pi x / length)) / 2: from 0 at x = 0 to 1 at x = length > 0, and held before and after. A gust that ends is
// one that begins less one that begins later. The choice is safe: value and slope agree where the pieces meet.
template <class T>
T one_minus_cosine(const T& x, Real<T> length) {
  using R = Real<T>;
  const auto v = value(x);
  if (!(v > R(0))) return T(R(0) * x);
  if (!(v < length)) return T(R(1) + R(0) * x);
  return R(0.5) * (R(1) - cos(T((kPi<R> / length) * x)));
}

// x: flown by the CG since it met the gust, m; amplitude: body axes, m/s.
template <class T>
LocalGusts<T> discrete_gust(const T& x, Real<T> length, const Vec3<Real<T>>& amplitude,
                            const Aircraft<Real<T>>& aircraft) {
  const Vec3<T> here = along(one_minus_cosine(x, length), amplitude);
  return {{here, here}, here, along(one_minus_cosine(T(x - tail_distance(aircraft)), length), amplitude)};
}

}  // namespace tiltrotor
