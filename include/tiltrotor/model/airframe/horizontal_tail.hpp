// Horizontal tail with elevator, in the wing's downwash and the rotors' wash (NASA CR-166536 pp. A-85 to
// A-88, tables 5-I to 5-VI, pp. B-56 to B-68).
#pragma once

#include "tiltrotor/model/airframe/tail_flow.hpp"

namespace tiltrotor {

// Velocity of the tail relative to the air there, m/s, with the rotors' wash; the wing's downwash turns it afterwards.
template <class T, class C>
Vec3<T> horizontal_tail_velocity(const Configuration<C>& c, const AirframeInput<T>& in, const T& wash_ratio) {
  const TailSurface<Real<T>>& s = c.aircraft->htail.surface;
  const T wash = wash_ratio * (Real<T>(0.5) * (in.mean_wash[right] + in.mean_wash[left]));
  return velocity_at_tail(c, in) + rate_cross_arm(in.rates_b, station_arm(c.mass, s.sl, Real<T>(0), s.wl)) +
         along(wash, c.nacelle_axis_b);
}

template <class T, class C>
Loads<T> horizontal_tail_loads(const Configuration<C>& c, const AirframeInput<T>& in,
                               const FreeStream<T>& stream, const TailFlow<T>& tail, const T& downwash) {
  using R = Real<T>;
  const HorizontalTailTables<R>& h = c.aircraft->htail;
  const SmoothingWidths<R>& e = c.aircraft->smooth;
  const Options& o = c.setup.options;
  const Vec3<C> arm = station_arm(c.mass, h.surface.sl, R(0), h.surface.wl);
  const Vec3<T> free = velocity_at_tail(c, in);
  const Vec3<T> v = horizontal_tail_velocity(c, in, tail.wash_ratio);
  const T alpha = angle_of_attack(v, e);
  const T beta = sideslip_angle(v, e.lateral_plane_speed);

  // Angles for lift and, with the elevator's share, for drag and the Mach tables.
  const T lift_alpha = alpha + h.surface.incidence - downwash;
  const T effectiveness = control_effectiveness(c, h.surface, stream.mach, in.elevator);
  const T drag_alpha = lift_alpha + effectiveness * h.surface.control_tau * in.elevator;
  const T lift_alpha_deg = wrapped(lift_alpha) * kDegPerRad<R>;
  const T drag_alpha_deg = wrapped(drag_alpha) * kDegPerRad<R>;
  const T slow = lookup(h.lift_elevator, o.tables, lift_alpha_deg, T(in.elevator * kDegPerRad<R>));  // 5-I
  const T fast = lookup(h.lift_mach, o.tables, drag_alpha_deg, stream.mach);                         // 5-II

  const T abs_beta = smooth_min(smooth_abs_zero(beta, e.angle), h.beta_limit * kRadPerDeg<R>, e.angle);
  const T lift =
      slow + tail.mach_weight * (fast - slow) + (h.lift_beta * c.nacelle_axis_b.z * R(-1)) * abs_beta;
  const T drag = lookup(h.drag, o.tables, drag_alpha_deg, stream.mach);  // 5-III

  const T arguments[2] = {stream.alpha_deg, stream.speed_kt};
  const T ratio = lookup(h.pressure_ratio, o.tables, c.tail_pressure_mast, arguments);  // 5-V
  const C loss = o.tail_pressure == TailPressure::by_mast    ? h.pressure.at(c.setup.mast_deg)
                 : o.tail_pressure == TailPressure::constant ? C(h.pressure.at_90)
                                                             : C(R(1));
  // Body velocity, not the local one: the pressure ratio holds the rest (p. A-87).
  const T q = (R(0.5) * c.air.density * loss) * ratio * (free.x * free.x + free.z * free.z);
  const T scale = q * h.surface.area * tail.sideslip_factor;
  // Turned by the angle of the flow, without the incidence (p. A-88).
  return force_at(
      arm, scale * wind_force(lift, drag, sine_and_cosine(T(alpha - downwash)), sine_and_cosine(beta)));
}

}  // namespace tiltrotor
