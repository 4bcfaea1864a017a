// Lift and drag coefficients of wing and pylons against angle of attack, mast angle, flap and Mach (NASA
// CR-166536 tables 4-I to 4-IV).
#pragma once

#include "tiltrotor/model/airframe/airflow.hpp"

namespace tiltrotor {

template <class T>
struct WingCoefficients {
  T lift, drag;
};

// Value of one flap setting or the blend of two.
template <class T, class C, class At>
T blend_flaps(const WingConstants<C>& w, At&& at) {
  using R = Real<T>;
  if constexpr (kIsNumber<C>) {
    if (w.flap_fraction == R(0)) return at(w.flap_below);
    if (w.flap_fraction == R(1)) return at(w.flap_above);
  }
  return (R(1) - w.flap_fraction) * at(w.flap_below) + w.flap_fraction * at(w.flap_above);
}

// Weight of the mast-0 drag table: cos^3 of the mast angle, with which the eight printed wing loads at mast 15,
// 30 and 60 (NASA CR-166537) agree to 0.001. The difference of the tables is the drag of the upright pylons.
// mast_drag=cross_flow takes it for sin^3 of the angle between mast and flow, the law of the spinners (pp. A-75,
// A-76; choices.csv: crossflow_*, smooth_crossflow*), 1 at mast 0, 0 at mast 90, exact there:
// k0 = [ s3(90 deg - bM + a) - (bM/90) s3(a) ] / cos^3 a,  s3 = sin^3 |.|,  a = alpha within 25 deg.
template <class T, class C>
T upright_pylon_weight(const Configuration<C>& c, const T& alpha) {
  using R = Real<T>;
  const C& mast_deg = c.setup.mast_deg;
  const C linear = R(1) - mast_deg / R(90);
  const bool at_end = value(mast_deg) <= R(0) || value(mast_deg) >= R(90);
  if (c.setup.options.mast_drag == MastDrag::linear || (kIsNumber<C> && at_end)) return T(linear);
  if (c.setup.options.mast_drag == MastDrag::cosine)
    return T(R(-1) * c.nacelle_axis_b.z * square(c.nacelle_axis_b.z));
  const SmoothingWidths<R>& e = c.aircraft->smooth;
  const R limit_deg = c.aircraft->wing.crossflow_alpha_limit;
  const T clipped =
      smooth_clip(T(alpha * kDegPerRad<R>), -limit_deg, limit_deg, e.crossflow_clip) * kRadPerDeg<R>;
  const T a = clipped * flow_from_ahead(alpha, e);
  const auto sine_cubed = [](const T& y) {
    const T s = sin(y);
    return s * s * s;
  };
  const T ca = cos(a);
  const T across = smooth_abs(T((kPi<R> / R(2) - c.mast) + a), e.crossflow);
  const T along = smooth_abs(a, e.crossflow);
  T weight = (sine_cubed(across) - (mast_deg / R(90)) * sine_cubed(along)) / (ca * ca * ca);
  if constexpr (!kIsNumber<C>)  // the end's value, the law's slope
    if (at_end) return without_slope(value(linear)) + (weight - without_slope(value(weight)));
  return weight;
}

template <class T, class C>
WingCoefficients<T> wing_coefficients(const Configuration<C>& c, const T& alpha, const T& mach) {
  using R = Real<T>;
  const WingTables<R>& w = c.aircraft->wing;
  const Interpolation mode = c.setup.options.tables;
  const T alpha_deg = alpha * kDegPerRad<R>;
  const C airplane = c.setup.mast_deg / R(90);  // 0 helicopter, 1 airplane
  const auto lift_0 = [&](int k) { return lookup(w.lift_0[k], mode, alpha_deg); };
  const auto drag_0 = [&](int k) { return lookup(w.drag_0[k], mode, alpha_deg); };
  const auto lift_90 = [&](int k) { return lookup(w.lift_90[k], mode, alpha_deg, mach); };
  const auto drag_90 = [&](int k) { return lookup(w.drag_90[k], mode, alpha_deg, mach); };
  const auto blended = [&](const auto& at) { return blend_flaps<T>(c.wing, at); };
  if (kIsNumber<C> && value(airplane) <= R(0)) return {blended(lift_0), blended(drag_0)};
  if (kIsNumber<C> && value(airplane) >= R(1)) return {blended(lift_90), blended(drag_90)};
  const T k0 = upright_pylon_weight(c, alpha);
  return {(R(1) - airplane) * blended(lift_0) + airplane * blended(lift_90),
          k0 * blended(drag_0) + (R(1) - k0) * blended(drag_90)};
}

}  // namespace tiltrotor
