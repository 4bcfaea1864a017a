// CG and inertia against mast angle: the nacelles with their rotors swing about the conversion axis.
#pragma once

#include "tiltrotor/model/aircraft.hpp"
#include "tiltrotor/model/options.hpp"

namespace tiltrotor {

template <class R>
struct MassProperties {
  R mass;              // kg
  R sl_cg, wl_cg;      // stations of the CG, m
  Inertia<R> inertia;  // kg m^2
};

// `sl_cg0`, `wl_cg0`: CG at mast 0, m. The inertia belongs to the gross weight of the tables; it is not
// scaled.
template <class R>
MassProperties<R> mass_properties(const Aircraft<R>& aircraft, R mast_deg, R mass, R sl_cg0, R wl_cg0,
                                  InertiaSet set) {
  const MassTables<R>& m = aircraft.mass;
  const R moving = m.nacelles / mass;
  const R forward = moving * (aircraft.mast.sl_pivot - m.sl_nacelle);
  const R below = moving * (aircraft.mast.wl_pivot - m.wl_nacelle);
  const R s = sin(mast_deg * kRadPerDeg<R>);
  const R c = cos(mast_deg * kRadPerDeg<R>);

  MassProperties<R> p;
  p.mass = mass;
  p.sl_cg = sl_cg0 + below * s + forward * (R(1) - c);
  p.wl_cg = wl_cg0 + below * (R(1) - c) - forward * s;
  p.inertia = {m.inertia.xx + m.inertia_slope.xx * mast_deg, m.inertia.yy + m.inertia_slope.yy * mast_deg,
               m.inertia.zz + m.inertia_slope.zz * mast_deg, m.inertia.xz + m.inertia_slope.xz * mast_deg};
  if (set == InertiaSet::design_1975) {
    const auto between = [&](R at_0, R at_90) { return MastRange<R>{at_0, at_90}.at(mast_deg); };
    p.inertia.xx = between(m.design_0.xx, m.design_90.xx);
    p.inertia.yy = between(m.design_0.yy, m.design_90.yy);
    p.inertia.zz = between(m.design_0.zz, m.design_90.zz);
  }
  return p;
}

}  // namespace tiltrotor
