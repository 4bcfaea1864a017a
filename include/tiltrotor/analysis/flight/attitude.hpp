// Attitude: Euler angles, rotation, quaternion, and the turn since the beginning of a step.
//
// In steep flight, where Euler angles have their singularity, a step integrates that turn in modified Rodrigues
// parameters s = tan(angle/4) axis (Schaub and Junkins, Analytical Mechanics of Space Systems, ch. 3), which have
// none below a whole turn. They stand in the places of bank, pitch and heading while the step lasts.
#pragma once

#include <cmath>

#include "tiltrotor/math/elementary.hpp"
#include "tiltrotor/math/scalar.hpp"
#include "tiltrotor/math/vector.hpp"

namespace tiltrotor {

// From this pitch on, rad: Euler rates are at most twice the body's below.
template <class R>
inline constexpr R kSteepPitch = R(1);

template <class R>
struct EulerAngles {
  R roll, pitch, yaw;  // 3-2-1, rad
};

// Earth axes to body axes.
template <class R>
Rotation<R> earth_to_body(const EulerAngles<R>& a) {
  const SineCosine<R> r = sine_and_cosine(a.roll);
  const SineCosine<R> p = sine_and_cosine(a.pitch);
  const SineCosine<R> y = sine_and_cosine(a.yaw);
  Rotation<R> c;
  c.row_x = {p.cosine * y.cosine, p.cosine * y.sine, -p.sine};
  c.row_y = {r.sine * p.sine * y.cosine - r.cosine * y.sine, r.sine * p.sine * y.sine + r.cosine * y.cosine,
             r.sine * p.cosine};
  c.row_z = {r.cosine * p.sine * y.cosine + r.sine * y.sine, r.cosine * p.sine * y.sine - r.sine * y.cosine,
             r.cosine * p.cosine};
  return c;
}

template <class R>
struct Quaternion {
  R scalar, x, y, z;
};
// Product of the half turns about z, y, x.
template <class R>
Quaternion<R> quaternion(const EulerAngles<R>& a) {
  const SineCosine<R> f = sine_and_cosine(R(R(0.5) * a.roll)), t = sine_and_cosine(R(R(0.5) * a.pitch)),
                      p = sine_and_cosine(R(R(0.5) * a.yaw));
  const R scalar = f.cosine * t.cosine * p.cosine + f.sine * t.sine * p.sine;
  const R sign = scalar < R(0) ? R(-1) : R(1);
  return {sign * scalar, sign * (f.sine * t.cosine * p.cosine - f.cosine * t.sine * p.sine),
          sign * (f.cosine * t.sine * p.cosine + f.sine * t.cosine * p.sine),
          sign * (f.cosine * t.cosine * p.sine - f.sine * t.sine * p.cosine)};
}

// Straight up or down, where only a sum of bank and heading is defined, the bank is `roll`.
template <class R>
EulerAngles<R> euler_angles(const Rotation<R>& c, R roll) {
  const R level = std::sqrt(c.row_x.x * c.row_x.x + c.row_x.y * c.row_x.y);
  const R pitch = atan2(-c.row_x.z, level);
  if (level > R(8) * std::numeric_limits<R>::epsilon())
    return {atan2(c.row_y.z, c.row_z.z), pitch, atan2(c.row_x.y, c.row_x.x)};
  return {roll, pitch,
          pitch > R(0) ? roll - atan2(c.row_y.x, c.row_y.y) : atan2(-c.row_y.x, c.row_y.y) - roll};
}

// Axes turned by s: C(s) c.
template <class R>
Rotation<R> turned_by(const Vec3<R>& s, const Rotation<R>& c) {
  const R s2 = dot(s, s);
  const R scale = R(4) / ((R(1) + s2) * (R(1) + s2));
  // C a = a + scale (2 s x (s x a) - (1 - s2) s x a), for each column of c.
  const auto column = [&](const Vec3<R>& a) {
    const Vec3<R> once = cross(s, a);
    return a + scale * (R(2) * cross(s, once) - (R(1) - s2) * once);
  };
  const Vec3<R> x = column({c.row_x.x, c.row_y.x, c.row_z.x});
  const Vec3<R> y = column({c.row_x.y, c.row_y.y, c.row_z.y});
  const Vec3<R> z = column({c.row_x.z, c.row_y.z, c.row_z.z});
  Rotation<R> t;
  t.row_x = {x.x, y.x, z.x};
  t.row_y = {x.y, y.y, z.y};
  t.row_z = {x.z, y.z, z.z};
  return t;
}

// s' at body rates w: ((1 - s.s) w + 2 s x w + 2 (s.w) s)/4.
template <class R>
Vec3<R> turn_rate(const Vec3<R>& s, const Vec3<R>& w) {
  return R(0.25) * ((R(1) - dot(s, s)) * w + R(2) * cross(s, w) + (R(2) * dot(s, w)) * s);
}

}  // namespace tiltrotor
