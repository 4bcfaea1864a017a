// Small drag items of the pylons (NASA CR-166536 pp. ): spinners, pylon-wing interference, side
// plates.
#pragma once

#include "tiltrotor/model/airframe/wing_in_wake.hpp"

namespace tiltrotor {

// Both spinners at hub height: drag area grows with sin^3 of the angle between mast and flow (pp. A-75,
// A-76; areas p. B-33).
template <class T, class C>
Loads<T> spinner_loads(const Configuration<C>& c, const AirframeInput<T>& in) {
  using R = Real<T>;
  const SmoothingWidths<R>& e = c.aircraft->smooth;
  const PylonTables<R>& p = c.aircraft->pylon;
  const T wash = R(0.5) * (in.mean_wash[right] + in.mean_wash[left]);
  const Vec3<T> v = in.velocity_b + along(wash, c.nacelle_axis_b);
  const T axial = component(v, c.nacelle_axis_b);
  const T speed2 = dot(v, v);
  const T sine2 = (speed2 - axial * axial) / (speed2 + square(e.airspeed));
  const T sine3 = sine2 * sqrt(sine2 + square(e.spinner_sine));
  const T area = R(2) * (p.spinner_base + p.spinner_cross * sine3);
  const T scale = -(R(0.5) * c.air.density * area * speed2 / sqrt(speed2 + square(e.drag_speed)));
  const Vec3<C> arm = R(0.5) * (c.hub[right].arm_b + c.hub[left].arm_b);
  return force_at(arm, scale * v);
}

// Interference drag of both pylons along the mean flow of the immersed wing parts, at the conversion axis
// (p. A-75).
template <class T, class C>
Loads<T> pylon_interference_loads(const Configuration<C>& c, const WingInWake<T> (&wake)[2]) {
  using R = Real<T>;
  const C area = lookup(c.aircraft->pylon.interference, Interpolation::linear, c.setup.mast_deg);  // 4-XV
  const T pressure = R(0.5) * (wake[right].pressure + wake[left].pressure);
  const Vec3<T> v = T(R(0.5)) * (wake[right].velocity + wake[left].velocity);
  const T scale = -(area * pressure / total_speed(v, c.aircraft->smooth.drag_speed));
  return force_at(c.pivot_arm_b, scale * v);
}

// Side force of the pylons as lateral flat plates (p. A-77).
template <class T, class C>
Loads<T> pylon_side_loads(const Configuration<C>& c, const AirframeInput<T>& in) {
  using R = Real<T>;
  const SmoothingWidths<R>& e = c.aircraft->smooth;
  const PylonTables<R>& p = c.aircraft->pylon;
  const T& v = in.velocity_b.y;
  const T incidence = atan2(smooth_abs(v, e.side_plate_speed),
                            smooth_abs(component(in.velocity_b, c.nacelle_axis_b), e.side_plate_axial));
  const T factor = lookup(p.side_plate, c.setup.options.tables, T(incidence * kDegPerRad<R>));  // 4-XVI
  const T y = -(c.air.density * p.side_area) * v * smooth_abs(v, e.airspeed) * factor;
  return force_at(c.pivot_arm_b, Vec3<T>{T(R(0)), y, T(R(0))});
}

}  // namespace tiltrotor
