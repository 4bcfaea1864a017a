// Six-degree-of-freedom rigid body in body axes (Etkin, Dynamics of Atmospheric Flight, ch. 5). Symmetric
// aircraft: Ixy = Iyz = 0.
#pragma once

#include "tiltrotor/model/setup/configuration.hpp"
#include "tiltrotor/model/variables/loads.hpp"

namespace tiltrotor {

template <class R>
inline constexpr R kGravity = R(9.80665);  // m/s^2, standard

template <class T>
struct RigidBodyRates {
  Vec3<T> velocity;    // m/s^2
  Vec3<T> rates;       // rad/s^2
  T roll, pitch, yaw;  // rad/s
  Vec3<T> position;    // m/s, north east down
};

// `v`: of the CG. `total`: force and moment about it, those of moving nacelles included; weight is added here. Euler rates are
// singular at 90 deg pitch.
template <class T, class C>
RigidBodyRates<T> rigid_body(const MassProperties<C>& mass, const Vec3<T>& v, const Vec3<T>& w, const T& roll,
                             const T& pitch, const T& yaw, const Loads<T>& total) {
  using R = Real<T>;
  const R g = kGravity<R>;
  const C inverse_mass = R(1) / mass.mass;
  const auto [sr, cr] = sine_and_cosine(roll);
  const auto [sp, cp] = sine_and_cosine(pitch);
  const auto [sy, cy] = sine_and_cosine(yaw);

  RigidBodyRates<T> d;
  d.velocity.x = total.force.x * inverse_mass - g * sp - w.y * v.z + w.z * v.y;
  d.velocity.y = total.force.y * inverse_mass + g * cp * sr - w.z * v.x + w.x * v.z;
  d.velocity.z = total.force.z * inverse_mass + g * cp * cr - w.x * v.y + w.y * v.x;

  const Inertia<C>& i = mass.inertia;
  const C inverse_g = R(1) / (i.xx * i.zz - i.xz * i.xz);
  // Moments about x and z with the gyroscopic terms; solved for p', r' by Ixx Izz - Ixz^2.
  const T tx = total.moment.x + i.xz * w.x * w.y + (i.yy - i.zz) * w.y * w.z;
  const T tz = total.moment.z - i.xz * w.y * w.z + (i.xx - i.yy) * w.x * w.y;
  d.rates.x = inverse_g * (i.zz * tx + i.xz * tz);
  d.rates.z = inverse_g * (i.xz * tx + i.xx * tz);
  d.rates.y = (R(1) / i.yy) * (total.moment.y + (i.zz - i.xx) * w.x * w.z - i.xz * (w.x * w.x - w.z * w.z));

  const T turn = w.y * sr + w.z * cr;
  d.roll = w.x + turn * (sp / cp);
  d.pitch = w.y * cr - w.z * sr;
  d.yaw = turn / cp;

  // R_eb v: 3-2-1 Euler angles.
  const T forward = cp * v.x + sp * (sr * v.y + cr * v.z);
  const T sideways = cr * v.y - sr * v.z;
  d.position = {cy * forward - sy * sideways, sy * forward + cy * sideways,
                cp * (sr * v.y + cr * v.z) - sp * v.x};
  return d;
}

}  // namespace tiltrotor
