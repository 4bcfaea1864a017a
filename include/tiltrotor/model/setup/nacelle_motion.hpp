// What moving nacelles do to the rigid body: the CG travels in the airframe, the inertia changes, and the
// nacelles carry angular momentum of their own.
#pragma once

#include "tiltrotor/math/vector.hpp"
#include "tiltrotor/model/setup/mass_properties.hpp"

namespace tiltrotor {

// Two rigid bodies, the nacelles and the rest, with mast angle bM and its derivatives prescribed; derived here.
// Nacelles turn nose down, at -bM' about y. r, from the conversion axis to their CG, turns with them: r' = dr/dbM
// = (-rz, rx). a: from the CG of the aircraft to theirs; m_n, I_n: their mass and own inertia.
//   travel of the CG in the airframe        c' = (m_n/m) r' bM',  c'' = (m_n/m) (r' bM'' - r bM'^2)
//   angular momentum about the CG           H = I w + h e_y,  h = k bM',  k = -(I_n + m_n (a . r))
//   its rate                                h' = k bM'' + m_n (ax rz - az rx) bM'^2
// `rate` rad/s and `acceleration` rad/s^2 of the mast; `pivot_arm_b`: CG to conversion axis, m.
template <class C>
NacelleMotion<C> nacelle_motion(const Aircraft<Real<C>>& aircraft, const Options& options, const C& mass,
                                const SineCosine<C>& tilt, const Vec3<C>& pivot_arm_b, const C& rate,
                                const C& acceleration) {
  using R = Real<C>;
  const MassTables<R>& m = aircraft.mass;
  const R moving = nacelle_mass(m, options);
  const R forward = aircraft.mast.sl_pivot - m.sl_nacelle;  // of the axis, with the mast up
  const R below = aircraft.mast.wl_pivot - m.wl_nacelle;
  const C rx = forward * tilt.cosine - below * tilt.sine;
  const C rz = below * tilt.cosine + forward * tilt.sine;
  const C ax = pivot_arm_b.x + rx;
  const C az = pivot_arm_b.z + rz;
  const C k = -(moving * (square(m.nacelle_gyration) + ax * rx + az * rz));
  const Inertia<R> slope = inertia_slope(m, options);
  const C rate_deg = rate * kDegPerRad<R>;

  NacelleMotion<C> n;
  const C share = moving / mass;
  n.cg_rate_x = -(share * rz * rate);
  n.cg_rate_z = share * rx * rate;
  n.cg_acceleration_x = -(share * (rx * square(rate) + rz * acceleration));
  n.cg_acceleration_z = share * (rx * acceleration - rz * square(rate));
  n.inertia_rate = {slope.xx * rate_deg, slope.yy * rate_deg, slope.zz * rate_deg, slope.xz * rate_deg};
  n.momentum = k * rate;
  n.momentum_rate = k * acceleration + moving * (ax * rz - az * rx) * square(rate);
  return n;
}

// Velocity of the airframe at the CG, from that of the CG.
template <class T, class C>
Vec3<T> airframe_velocity(const Vec3<T>& cg_velocity_b, const NacelleMotion<C>& nacelles) {
  return {cg_velocity_b.x - nacelles.cg_rate_x, cg_velocity_b.y, cg_velocity_b.z - nacelles.cg_rate_z};
}

// Moment of moving nacelles on the aircraft turning at w: -(I' w + h' e_y + w x h e_y).
template <class T, class C>
Vec3<T> nacelle_moment(const NacelleMotion<C>& n, const Vec3<T>& w) {
  const Inertia<C>& i = n.inertia_rate;
  return {n.momentum * w.z - (i.xx * w.x - i.xz * w.z), -(n.momentum_rate + i.yy * w.y),
          -(n.momentum * w.x + (i.zz * w.z - i.xz * w.x))};
}

}  // namespace tiltrotor
