// Steady flight: what a trim holds, and the velocity and rates that follow from the attitude.
#pragma once

#include "tiltrotor/math/algebra/matrix.hpp"
#include "tiltrotor/model/rigid_body.hpp"
#include "tiltrotor/model/setup/configuration.hpp"
#include "tiltrotor/model/variables/state.hpp"

namespace tiltrotor {

// Straight or turning, level or climbing, with or without sideslip. Relative to the air at the aircraft.
template <class R>
struct SteadyFlight {
  R speed;      // m/s, 0 up to LimitTables::speed; 0 below kLeastSpeed
  R climb;      // angle of the flight path, rad, + up, within 90 deg; 0 at speed 0
  R turn_rate;  // of the heading, rad/s, + right, within 60 deg/s
  R sideslip;   // beta: v = speed sin beta, rad, + wind from the right, within 60 deg; 0 at speed 0 and in
                // vertical flight, where it follows from the attitude
  // Held velocity of the air, Controls::gust, each within LimitTables::gust. In a turn it turns with the
  // aircraft.
  Vec3<R> gust = {};
};

// Fields of SteadyFlight, for a message about a bad one.
enum class SteadyFlightField : unsigned char { none, speed, climb, turn_rate, sideslip, gust };

// Straight up or down: the flight path has no direction over ground.
template <class R>
bool is_vertical(const SteadyFlight<R>& flight) {
  return std::fabs(cos(flight.climb)) < R(64) * std::numeric_limits<R>::epsilon();
}

template <class R>
SteadyFlightField first_invalid(const Aircraft<R>& aircraft, const SteadyFlight<R>& flight) {
  const R angle = R(60) * kRadPerDeg<R>;
  const R vertical = R(0.5) * kPi<R> * (R(1) + R(2) * std::numeric_limits<R>::epsilon());
  if (!is_within(flight.speed, R(0), aircraft.limits.speed)) return SteadyFlightField::speed;
  if (!is_within(flight.climb, -vertical, vertical)) return SteadyFlightField::climb;
  if (!is_within(flight.turn_rate, -angle, angle)) return SteadyFlightField::turn_rate;
  if (!is_within(flight.sideslip, -angle, angle)) return SteadyFlightField::sideslip;
  const R gust = aircraft.limits.gust;
  const Vec3<R>& g = flight.gust;
  const bool held = is_within(g.x, -gust, gust) && is_within(g.y, -gust, gust) && is_within(g.z, -gust, gust);
  if (!held) return SteadyFlightField::gust;
  const bool at_rest = flight.speed < kLeastSpeed<R>;
  if (at_rest && flight.climb != R(0)) return SteadyFlightField::climb;
  if (flight.sideslip != R(0) && (at_rest || is_vertical(flight))) return SteadyFlightField::sideslip;
  return SteadyFlightField::none;
}

template <class R>
bool all_finite(const SteadyFlight<R>& flight) {
  return is_finite(flight.speed) && is_finite(flight.climb) && is_finite(flight.turn_rate) &&
         is_finite(flight.sideslip) && is_finite(flight.gust.x) && is_finite(flight.gust.y) &&
         is_finite(flight.gust.z);
}

// Body velocity of steady flight relative to the air at a roll and pitch angle.
//
// In axes level with the ground and turned with the heading the velocity is V (cos g cos k, cos g sin k, -sin
// g), with g the climb angle and k the track minus the heading. Its component along the body's y axis shall
// be V sin beta:
//
//   A cos k + B sin k = C,   A = sin(roll) sin(pitch),  B = cos(roll),
//                            C = (sin beta + sin g sin(roll) cos(pitch)) / cos g
//
// With D^2 = A^2 + B^2 and A = D sin d, B = D cos d this is sin(k + d) = C / D; the flight forward has
// cos(k + d) = Q / D, Q = sqrt(D^2 - C^2), hence
//
//   sin k = (B C - A Q) / D^2,   cos k = (B Q + A C) / D^2.
//
// Nothing is divided by V: in hover the formulas hold and the velocity is zero. No attitude beyond Q = 0 has
// that sideslip: not to be asked for, see has_attitude. In vertical flight the velocity is that of the
// attitude alone.
template <class T>
TILTROTOR_NOINLINE Vec3<T> steady_velocity(const SteadyFlight<Real<T>>& flight, const T& roll,
                                           const T& pitch) {
  using R = Real<T>;
  if (is_vertical(flight)) {
    const R up = flight.climb > R(0) ? flight.speed : -flight.speed;
    return {up * sin(pitch), -(up * sin(roll) * cos(pitch)), -(up * cos(roll) * cos(pitch))};
  }
  const T sr = sin(roll);
  const T cr = cos(roll);
  const T sp = sin(pitch);
  const T cp = cos(pitch);
  const R sg = sin(flight.climb);
  const R cg = cos(flight.climb);
  const R sb = sin(flight.sideslip);
  const T a = sr * sp;
  const T c = (sb + sg * sr * cp) * (R(1) / cg);
  const T square_d = a * a + cr * cr;
  const T q = sqrt(square_d - c * c);
  const T sk = (cr * c - a * q) / square_d;
  const T ck = (cr * q + a * c) / square_d;
  return {flight.speed * (cp * cg * ck + sg * sp), T(flight.speed * sb),
          flight.speed * (cg * (cr * sp * ck - sr * sk) - sg * cr * cp)};
}

// cos(k + d)^2 = (Q / D)^2 above: 1 where the aircraft flies straight ahead, 0 where its path is square to
// its nose. Negative where no heading has that path and sideslip at that attitude.
template <class R>
R attitude_margin(const SteadyFlight<R>& flight, R roll, R pitch) {
  if (is_vertical(flight)) return R(1);
  const R a = sin(roll) * sin(pitch);
  const R b = cos(roll);
  const R c =
      (sin(flight.sideslip) + sin(flight.climb) * sin(roll) * cos(pitch)) * (R(1) / cos(flight.climb));
  const R square_d = a * a + b * b;
  return square_d > R(0) ? R(1) - c * c / square_d : R(-1);
}

// Whether the steady flight is possible at that attitude, rounding apart.
template <class R>
bool has_attitude(const SteadyFlight<R>& flight, R roll, R pitch) {
  return attitude_margin(flight, roll, pitch) > R(64) * std::numeric_limits<R>::epsilon();
}

// The attitude nearest to the one given at which the flight is possible: first roll in steps of 3 deg, then
// pitch nearer to level. Level pitch has one for every flight: the wing turned against the sideslip, by no
// more than the climb. Angles finite.
template <class R>
void find_attitude(const SteadyFlight<R>& flight, R& roll, R& pitch) {
  const R step = R(3) * kRadPerDeg<R>;
  const int pitch_steps = 8;
  for (int down = 0; down < pitch_steps; ++down) {
    const R trial_pitch = pitch * static_cast<R>(pitch_steps - down) / R(pitch_steps);
    for (int k = 0; k <= 60; ++k) {
      const R trial_roll = roll + static_cast<R>(k % 2 == 0 ? k / 2 : -(k + 1) / 2) * step;
      if (!has_attitude(flight, trial_roll, trial_pitch)) continue;
      roll = trial_roll;
      pitch = trial_pitch;
      return;
    }
  }
  const R sideslip = std::fabs(flight.sideslip);
  const R climb = std::fabs(flight.climb);
  const bool same_sign = (flight.sideslip < R(0)) == (flight.climb < R(0));
  roll = (same_sign ? R(-1) : R(1)) * (sideslip < climb ? sideslip : climb);
  pitch = R(0);
}

template <class R>
R steady_sideslip(const SteadyFlight<R>& flight, const Vec3<R>& velocity) {
  return is_vertical(flight) ? atan2(velocity.y, std::sqrt(square(velocity.x) + square(velocity.z)))
                             : flight.sideslip;
}

// Body rates that turn the heading alone.
template <class T>
TILTROTOR_NOINLINE Vec3<T> steady_rates(const SteadyFlight<Real<T>>& flight, const T& roll, const T& pitch) {
  const T level = flight.turn_rate * cos(pitch);
  return {-(flight.turn_rate * sin(pitch)), level * sin(roll), level * cos(roll)};
}

// Load factor: the force of air and rotors normal to the motion through the air, over the weight; negative where
// it pushes the aircraft down. At rest all of the force. `specific_force`: over the mass, m/s^2; `velocity`:
// relative to the air, m/s; both in body axes.
template <class T>
T load_factor(const Vec3<T>& specific_force, const Vec3<T>& velocity) {
  using R = Real<T>;
  const T speed = length(velocity);
  Vec3<T> lift = specific_force;
  if (value(speed) >= kLeastSpeed<R>) {
    const Vec3<T> path = (R(1) / speed) * velocity;
    lift = specific_force - dot(specific_force, path) * path;
  }
  const T size = length(lift) / kGravity<R>;
  return value(lift.z) > R(0) ? T(-size) : size;
}

}  // namespace tiltrotor
