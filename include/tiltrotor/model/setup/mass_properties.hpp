// CG and inertia against mast angle: the nacelles with their rotors swing about the conversion axis.
#pragma once

#include "tiltrotor/model/aircraft/aircraft.hpp"
#include "tiltrotor/model/variables/options.hpp"

namespace tiltrotor {

template <class C>
struct MassProperties {
  C mass;              // kg
  C sl_cg, wl_cg;      // stations of the CG, m
  Inertia<C> inertia;  // kg m^2
};

// The CG is derived here: with k = m_nacelles/m, f = k (SL_pivot - SL_nacelles) and h = k (WL_pivot -
// WL_nacelles), SL = SL_0 + h sin bM + f (1 - cos bM),  WL = WL_0 + h (1 - cos bM) - f sin bM.
// Inertia linear in mast angle: aircraft.csv says its source; design_1975: NASA TM X-62407 p. 12.
// `sl_cg0`, `wl_cg0`: CG at mast 0, m. The inertia belongs to the gross weight of the tables; it is not
// scaled.
template <class C>
MassProperties<C> mass_properties(const Aircraft<Real<C>>& aircraft, const C& mast_deg, const C& mass,
                                  const C& sl_cg0, const C& wl_cg0, const Options& options) {
  using R = Real<C>;
  const MassTables<R>& m = aircraft.mass;
  const C moving = (options.nacelle_mass == NacelleMass::quoted ? m.nacelles_quoted : m.nacelles) / mass;
  const C forward = moving * (aircraft.mast.sl_pivot - m.sl_nacelle);
  const C below = moving * (aircraft.mast.wl_pivot - m.wl_nacelle);
  const C s = sin(C(mast_deg * kRadPerDeg<R>));
  const C c = cos(C(mast_deg * kRadPerDeg<R>));

  MassProperties<C> p;
  p.mass = mass;
  p.sl_cg = sl_cg0 + below * s + forward * (R(1) - c);
  p.wl_cg = wl_cg0 + below * (R(1) - c) - forward * s;
  p.inertia = {m.inertia.xx + m.inertia_slope.xx * mast_deg, m.inertia.yy + m.inertia_slope.yy * mast_deg,
               m.inertia.zz + m.inertia_slope.zz * mast_deg, m.inertia.xz + m.inertia_slope.xz * mast_deg};
  if (options.inertia == InertiaSet::flown) {
    p.inertia.yy = p.inertia.yy * m.flown_pitch;
    p.inertia.zz = p.inertia.zz * m.flown_yaw;
  }
  if (options.inertia == InertiaSet::design_1975) {
    const auto between = [&mast_deg](R at_0, R at_90) { return MastRange<R>{at_0, at_90}.at(mast_deg); };
    p.inertia.xx = between(m.design_0.xx, m.design_90.xx);
    p.inertia.yy = between(m.design_0.yy, m.design_90.yy);
    p.inertia.zz = between(m.design_0.zz, m.design_90.zz);
  }
  return p;
}

}  // namespace tiltrotor
