// Motion of a point fixed to the airframe, as an inertial unit there measures it.
#pragma once

#include "tiltrotor/model/rigid_body.hpp"
#include "tiltrotor/model/variables/controls.hpp"
#include "tiltrotor/model/variables/state.hpp"

namespace tiltrotor {

// Body axes in the axes of the earth, by 3-2-1 Euler angles: rows forward, right, down.
template <class R>
Rotation<R> earth_to_body(R roll, R pitch, R yaw) {
  const SineCosine<R> f = sine_and_cosine(roll), t = sine_and_cosine(pitch), p = sine_and_cosine(yaw);
  return {{t.cosine * p.cosine, t.cosine * p.sine, -t.sine},
          {f.sine * t.sine * p.cosine - f.cosine * p.sine, f.sine * t.sine * p.sine + f.cosine * p.cosine,
           f.sine * t.cosine},
          {f.cosine * t.sine * p.cosine + f.sine * p.sine, f.cosine * t.sine * p.sine - f.sine * p.cosine,
           f.cosine * t.cosine}};
}

template <class R>
struct Quaternion {
  R scalar, x, y, z;
};
// Of the same rotation, scalar >= 0: product of the half turns about z, y, x.
template <class R>
Quaternion<R> quaternion(R roll, R pitch, R yaw) {
  const SineCosine<R> f = sine_and_cosine(R(R(0.5) * roll)), t = sine_and_cosine(R(R(0.5) * pitch)),
                      p = sine_and_cosine(R(R(0.5) * yaw));
  const R scalar = f.cosine * t.cosine * p.cosine + f.sine * t.sine * p.sine;
  const R sign = scalar < R(0) ? R(-1) : R(1);
  return {sign * scalar, sign * (f.sine * t.cosine * p.cosine - f.cosine * t.sine * p.sine),
          sign * (f.cosine * t.sine * p.cosine + f.sine * t.cosine * p.sine),
          sign * (f.cosine * t.cosine * p.sine - f.sine * t.sine * p.cosine)};
}

// Velocity of a point at an arm from the CG, body axes, where the CG has the velocity v.
template <class R>
Vec3<R> velocity_at(const Vec3<R>& v, const Vec3<R>& rates, const Vec3<R>& arm) {
  return v + rate_cross_arm(rates, arm);
}

// Specific force of a point at an arm from the CG: F/m + omega' x r + omega x (omega x r).
template <class R>
Vec3<R> specific_force_at(const Vec3<R>& of_cg, const Vec3<R>& rates, const Vec3<R>& acceleration,
                          const Vec3<R>& arm) {
  return of_cg + rate_cross_arm(acceleration, arm) + cross(rates, rate_cross_arm(rates, arm));
}

}  // namespace tiltrotor
