// What horizontal tail and fins share: rotor wash at the tail, control effectiveness, Mach blend (NASA
// CR-166536 tables 2-I, 2-II, 5-IV, 5-VI).
#pragma once

#include "tiltrotor/model/airframe/airflow.hpp"

namespace tiltrotor {

// Ratio of the wash at the tail to the mean wash at the disk, tables 2-I and 2-II (pp. B-22 to B-25);
// negative means upwash between the wakes.
template <class T, class C>
T tail_wash_ratio(const Configuration<C>& c, const FreeStream<T>& stream) {
  using R = Real<T>;
  const HorizontalTailTables<R>& h = c.aircraft->htail;
  const Interpolation mode = c.setup.options.tables;
  T ratio;
  if (c.setup.options.tail_wash == TailWash::tables) {
    const T arguments[2] = {stream.alpha_deg, stream.speed_kt};
    ratio = lookup(h.rotor_wash, mode, c.tail_wash_mast, arguments);
  } else {
    // Fit along alpha near 0, an older form of table 2-I at second hand (choices.csv: htail_wash_fit_*):
    // K = h0 + h1 bM + (h2 + h3 bM) r^2,  r = (V - u0 + h4 bM)/u0, bM in degrees, V and u0 in ft/s.
    const C& mast_deg = c.setup.mast_deg;
    const R foot = R(0.3048);
    const T r = (stream.speed * (R(1) / foot) - h.wash_fit_speed + h.wash_fit[4] * mast_deg) *
                (R(1) / h.wash_fit_speed);
    ratio = h.wash_fit[0] + h.wash_fit[1] * mast_deg + (h.wash_fit[2] + h.wash_fit[3] * mast_deg) * r * r;
  }
  const T abs_beta_deg[1] = {stream.abs_beta_deg};
  return ratio * lookup(h.rotor_wash_beta, mode, c.tail_wash_beta_mast, abs_beta_deg);
}

// Effectiveness of elevator or rudder: K = X_K(M) - D_K max(|delta| - 15 deg, 0)/15 deg (X_K: table 5-IV;
// equation pp., D_K pp. B-56, B-69).
template <class T, class C>
T control_effectiveness(const Configuration<C>& c, const TailSurface<Real<T>>& surface, const T& mach,
                        const T& deflection) {
  using R = Real<T>;
  const TailSharedTables<R>& t = c.aircraft->tail;
  const R width = c.aircraft->smooth.angle;
  const R start = t.control_loss_start * kRadPerDeg<R>;
  const T beyond = smooth_positive(T(smooth_abs_zero(deflection, width) - start), width);
  return lookup(t.control_mach, c.setup.options.tables, mach) -
         surface.control_loss * beyond * (R(1) / start);
}

// 0 where the low-speed coefficient tables hold, 1 where the Mach tables do.
template <class T, class C>
T tail_mach_weight(const Configuration<C>& c, const T& mach) {
  using R = Real<T>;
  const TailSharedTables<R>& t = c.aircraft->tail;
  return smooth_step(T((mach - t.mach_blend_start) * (R(1) / (t.mach_blend_end - t.mach_blend_start))));
}

// Table 5-VI.
template <class T, class C>
T tail_sideslip_factor(const Configuration<C>& c, const FreeStream<T>& stream) {
  using R = Real<T>;
  if (!c.setup.options.tail_sideslip_loss) return T(R(1));
  return lookup(c.aircraft->tail.sideslip_loss, c.setup.options.tables, stream.abs_beta_deg);
}

template <class T>
struct TailFlow {
  T wash_ratio, mach_weight, sideslip_factor;
};
template <class T, class C>
TailFlow<T> tail_flow(const Configuration<C>& c, const FreeStream<T>& stream) {
  return {tail_wash_ratio(c, stream), tail_mach_weight(c, stream.mach), tail_sideslip_factor(c, stream)};
}

}  // namespace tiltrotor
