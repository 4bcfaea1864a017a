// The two vertical fins, with rudder, in the sidewash of body and rotors (NASA CR-166536 pp. B-69 to
// B-81).
#pragma once

#include "tiltrotor/model/airframe/tail_flow.hpp"

namespace tiltrotor {

// 1 - dsigma/dbeta of the body, tables 6-IV to 6-VII. They know no flow from behind: the two ends meet in the
// middle there.
template <class T, class C>
T body_sidewash(const Configuration<C>& c, const FreeStream<T>& stream) {
  using R = Real<T>;
  const auto at = [&](const T& alpha_deg) {
    const T arguments[2] = {alpha_deg, stream.abs_beta_deg};
    return lookup(c.aircraft->fin.sidewash, c.setup.options.tables, c.sidewash_mast_flap, arguments);
  };
  const T ahead = flow_from_ahead(stream.alpha, c.aircraft->smooth);
  if (value(ahead) >= R(1)) return at(stream.alpha_deg);
  const T mean = R(0.5) * (at(stream.alpha_deg) + at(T(-stream.alpha_deg)));
  return mean + ahead * (at(stream.alpha_deg) - mean);
}

// What both fins share.
template <class T>
struct FinFlow {
  T sidewash;       // what rotors and body leave of the sideslip
  T rate_sidewash;  // rad
  T rudder_beta;    // sideslip to which the rudder amounts, rad
};
template <class T, class C>
FinFlow<T> fin_flow(const Configuration<C>& c, const AirframeInput<T>& in, const FreeStream<T>& stream) {
  using R = Real<T>;
  const FinTables<R>& f = c.aircraft->fin;
  const Vec3<T> free = velocity_at_tail(c, in);
  const T body = body_sidewash(c, stream);
  const T rotors =
      lookup(f.rotor_sidewash, c.setup.options.tables, stream.speed_kt, stream.abs_beta_deg);  // 6-VIII
  const T half_span_over_speed =
      (c.aircraft->wing.span / R(2)) / total_speed(free, c.aircraft->smooth.rate_speed);
  const T effectiveness = control_effectiveness(c, f.surface, stream.mach, in.rudder);
  return {rotors * body,
          half_span_over_speed * (f.sidewash_roll * in.rates_b.x + f.sidewash_yaw * in.rates_b.z),
          effectiveness * f.surface.control_tau * in.rudder};
}

template <class T, class C>
Loads<T> fin_loads(const Configuration<C>& c, const AirframeInput<T>& in, const FreeStream<T>& stream,
                   const TailFlow<T>& tail, const FinFlow<T>& fins, int side) {
  using R = Real<T>;
  const FinTables<R>& f = c.aircraft->fin;
  const SmoothingWidths<R>& e = c.aircraft->smooth;
  const Options& o = c.setup.options;
  const Vec3<C> arm = station_arm(c.mass, f.surface.sl, side_sign<R>(side) * f.surface.bl, f.surface.wl);
  const Vec3<T> v = velocity_at_tail(c, in) + rate_cross_arm(in.rates_b, arm) +
                    along(T(tail.wash_ratio * in.mean_wash[side]), c.nacelle_axis_b);
  const T alpha = angle_of_attack(v, e);

  // Local sideslip: geometric, reduced by the rotors' and the body's sidewash, plus the roll-rate sidewash.
  const T geometric = sideslip_angle(v, f.speed_floor) - f.surface.incidence;
  const T beta = fins.sidewash * geometric + fins.rate_sidewash;
  const T beta_deg = beta * kDegPerRad<R>;
  const T slow = lookup(f.side_rudder, o.tables, beta_deg, T(in.rudder * kDegPerRad<R>));  // 6-I
  const T fast =
      lookup(f.side_mach, o.tables, beta_deg, stream.mach) + f.lift_slope * fins.rudder_beta;  // 6-II
  const T side_coefficient = slow + tail.mach_weight * (fast - slow);
  // Table 6-III.
  const T drag_coefficient =
      lookup(f.drag, o.tables, T((beta + fins.rudder_beta) * kDegPerRad<R>), stream.mach);

  const R area = o.fin_area == FinArea::drawings ? f.surface.area : f.area_report;
  const T q = (R(0.5) * c.air.density * f.pressure * f.pressure_ratio) * dot(v, v);
  const T scale = q * area * tail.sideslip_factor;
  return force_at(arm,
                  scale * wind_force(T(R(0)), drag_coefficient, T(-side_coefficient), sine_and_cosine(alpha),
                                     sine_and_cosine(sideslip_angle(v, e.lateral_plane_speed))));
}

}  // namespace tiltrotor
