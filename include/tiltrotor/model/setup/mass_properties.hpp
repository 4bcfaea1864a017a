// CG and inertia against mast angle: the nacelles with their rotors swing about the conversion axis.
#pragma once

#include "tiltrotor/model/aircraft/aircraft.hpp"
#include "tiltrotor/model/variables/options.hpp"

namespace tiltrotor {

// Of moving nacelles, all zero at rest: nacelle_motion().
template <class C>
struct NacelleMotion {
  C cg_rate_x, cg_rate_z;                  // of the CG in the airframe, body axes, m/s
  C cg_acceleration_x, cg_acceleration_z;  // m/s^2
  Inertia<C> inertia_rate;                 // kg m^2/s
  C momentum;                              // angular, about y, relative to the airframe, N m s
  C momentum_rate;                         // N m
};

template <class C>
struct MassProperties {
  C mass;              // kg
  C sl_cg, wl_cg;      // stations of the CG, m
  Inertia<C> inertia;  // kg m^2
  NacelleMotion<C> nacelles;
};

// Linear in mast angle: aircraft.csv says its source; design_1975: NASA TM X-62407 p. 12. It belongs to the
// gross weight of the tables; it is not scaled.
template <class C>
Inertia<C> inertia_at(const MassTables<Real<C>>& m, const C& mast_deg, const Options& options) {
  using R = Real<C>;
  Inertia<C> i = {m.inertia.xx + m.inertia_slope.xx * mast_deg, m.inertia.yy + m.inertia_slope.yy * mast_deg,
                  m.inertia.zz + m.inertia_slope.zz * mast_deg, m.inertia.xz + m.inertia_slope.xz * mast_deg};
  if (options.inertia == InertiaSet::flown) {
    i.yy = i.yy * m.flown_pitch;
    i.zz = i.zz * m.flown_yaw;
  }
  if (options.inertia == InertiaSet::design_1975) {
    const auto between = [&mast_deg](R at_0, R at_90) { return MastRange<R>{at_0, at_90}.at(mast_deg); };
    i.xx = between(m.design_0.xx, m.design_90.xx);
    i.yy = between(m.design_0.yy, m.design_90.yy);
    i.zz = between(m.design_0.zz, m.design_90.zz);
  }
  return i;
}

// Its slope per degree of mast angle.
template <class R>
Inertia<R> inertia_slope(const MassTables<R>& m, const Options& options) {
  Inertia<R> slope = m.inertia_slope;
  if (options.inertia == InertiaSet::flown) {
    slope.yy = slope.yy * m.flown_pitch;
    slope.zz = slope.zz * m.flown_yaw;
  }
  if (options.inertia == InertiaSet::design_1975) {
    slope.xx = (m.design_90.xx - m.design_0.xx) / R(90);
    slope.yy = (m.design_90.yy - m.design_0.yy) / R(90);
    slope.zz = (m.design_90.zz - m.design_0.zz) / R(90);
  }
  return slope;
}

// Mass of what tilts, kg.
template <class R>
R nacelle_mass(const MassTables<R>& m, const Options& options) {
  return options.nacelle_mass == NacelleMass::quoted ? m.nacelles_quoted : m.nacelles;
}

// The CG is derived here: with k = m_nacelles/m, f = k (SL_pivot - SL_nacelles) and h = k (WL_pivot -
// WL_nacelles), SL = SL_0 + h sin bM + f (1 - cos bM),  WL = WL_0 + h (1 - cos bM) - f sin bM.
// `tilt`: sine and cosine of the mast angle. `sl_cg0`, `wl_cg0`: CG at mast 0, m. The nacelles at rest.
template <class C>
MassProperties<C> mass_properties(const Aircraft<Real<C>>& aircraft, const C& mast_deg,
                                  const SineCosine<C>& tilt, const C& mass, const C& sl_cg0, const C& wl_cg0,
                                  const Options& options) {
  using R = Real<C>;
  const MassTables<R>& m = aircraft.mass;
  const C moving = nacelle_mass(m, options) / mass;
  const C forward = moving * (aircraft.mast.sl_pivot - m.sl_nacelle);
  const C below = moving * (aircraft.mast.wl_pivot - m.wl_nacelle);

  MassProperties<C> p{};
  p.mass = mass;
  p.sl_cg = sl_cg0 + below * tilt.sine + forward * (R(1) - tilt.cosine);
  p.wl_cg = wl_cg0 + below * (R(1) - tilt.cosine) - forward * tilt.sine;
  p.inertia = inertia_at(m, mast_deg, options);
  return p;
}

}  // namespace tiltrotor
