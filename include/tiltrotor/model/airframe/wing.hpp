// The part of wing and pylons in the free stream, with flap, aileron and rate terms, and the wing's downwash:
// NASA CR-166536 pp.; constants pp. B-31 to B-33, tables pp. B-34 to B-54.
#pragma once

#include "tiltrotor/model/airframe/wing_coefficients.hpp"
#include "tiltrotor/model/airframe/wing_in_wake.hpp"

namespace tiltrotor {

template <class T>
struct LateralCoefficients {
  T roll, yaw;
};

// The loads, and what leads to them.
template <class T>
struct FreeWing {
  T alpha;       // alpha_WFS: free-stream angle less the deflection by the rotors' wakes, rad, -pi..pi
  T beta;        // sideslip at the wing, rad
  T pressure;    // dynamic pressure in the plane of symmetry, Pa
  T rotor_wash;  // rotor force over the square of the advance ratio, with the table's factor
  WingCoefficients<T> coefficients;
  LateralCoefficients<T> lateral;
  T downwash;  // at the tail, not yet lagged, rad
  Loads<T> loads;
};

// Roll and yaw coefficients due to sideslip and rates (pp. A-71, B-31 to B-33).
template <class T, class C>
LateralCoefficients<T> wing_lateral_coefficients(const Configuration<C>& c, const AirframeInput<T>& in,
                                                 const FreeStream<T>& stream, const T& beta,
                                                 const WingCoefficients<T>& k) {
  using R = Real<T>;
  const WingTables<R>& w = c.aircraft->wing;
  const R aspect = c.wing.aspect_ratio;
  const R cos_sweep = cos(w.sweep);
  const T bc = sqrt(R(1) - square(cos_sweep) * stream.mach * stream.mach);  // compressibility, DATCOM
  const T cb = (aspect + R(4) * cos_sweep) / (aspect * bc + R(4) * cos_sweep);

  const T roll_beta = c.wing.roll_beta * cb + c.wing.roll_beta_per_lift * k.lift;  // 4-VI, 4-VII
  const T roll_p = w.roll_rate * cb - R(0.125) * (k.drag - k.lift * k.lift * (R(1) / (kPi<R> * aspect)));
  const T bc2 = bc * bc;
  const T compressed = R(1) + aspect * (R(1) - bc2) / (R(2) * bc * (aspect * bc + R(2)));
  const T roll_r =
      w.roll_yaw_rate_per_lift * k.lift * compressed + w.roll_yaw_rate_flap * w.flap_alpha * c.setup.flap_deg;
  const T yaw_beta = w.yaw_beta_0 * cb + w.yaw_beta_per_lift2 * k.lift * k.lift;
  const T yaw_p = w.yaw_roll_rate_per_lift * k.lift * cb * bc;
  const T yaw_r = w.yaw_rate_per_lift2 * k.lift * k.lift + w.yaw_rate_per_drag * c.wing.zero_lift_drag;

  const auto& [sa, ca] = stream.attack;
  const auto [sb, cbeta] = sine_and_cosine(beta);
  const T p_wind = in.rates_b.x * ca * cbeta + in.rates_b.y * sb + in.rates_b.z * sa * cbeta;
  const T r_wind = in.rates_b.z * ca - in.rates_b.x * sa;
  const T half_span_over_speed = (w.span / R(2)) / total_speed(in.velocity_b, c.aircraft->smooth.rate_speed);
  return {roll_beta * beta + half_span_over_speed * (roll_p * p_wind + roll_r * r_wind),
          yaw_beta * beta + half_span_over_speed * (yaw_p * p_wind + yaw_r * r_wind)};
}

// Aileron effectiveness fade: 1 up to 8 deg of wing angle, 0 beyond 25 deg (with table 4-XI). The plain
// |alpha| is safe because the fade is constant around zero.
template <class T, class C>
T aileron_fade(const Configuration<C>& c, const T& alpha) {
  using R = Real<T>;
  const WingTables<R>& w = c.aircraft->wing;
  const T alpha_deg = alpha * kDegPerRad<R>;
  const T size = value(alpha_deg) < R(0) ? T(-alpha_deg) : alpha_deg;
  const T t = (size - w.aileron_full_alpha) * (R(1) / (w.aileron_zero_alpha - w.aileron_full_alpha));
  if (c.setup.options.tables == Interpolation::c1) return R(1) - smooth_step(t);
  return value(t) <= R(0) ? T(R(1)) : value(t) >= R(1) ? T(R(0)) : T(R(1) - t);
}

// Loads of the free part of one half wing, at the centroid of what the wake leaves free.
template <class T, class C>
Loads<T> free_half_wing(const Configuration<C>& c, const ImmersedWing<T>& immersed, const Vec3<T>& per_area,
                        const Vec3<T>& aileron_loss, int side) {
  using R = Real<T>;
  const WingTables<R>& w = c.aircraft->wing;
  const Vec3<C> line = station_arm(c.mass, w.sl, R(0), w.wl);
  const R half_area = R(0.5) * w.area;
  const T area = half_area - immersed.area;
  const T lateral = (half_area * w.bl - immersed.area * immersed.lateral) / area;
  const Vec3<T> force = area * per_area - aileron_loss;
  return {force, cross(Vec3<T>{T(line.x), side_sign<R>(side) * lateral, T(line.z)}, force)};
}

namespace wing_detail {

// Angles and pressure, with the deflection of the free stream by the rotors: alpha_WFS = alpha - K_XRW X_RW
// C_RF / mu^2 (p. A-70; C_RF p. A-38, X_RW p. B-33).
template <class T, class C>
void free_wing_flow(const Configuration<C>& c, const AirframeInput<T>& in, FreeWing<T>& out) {
  using R = Real<T>;
  const WingTables<R>& w = c.aircraft->wing;
  const SmoothingWidths<R>& e = c.aircraft->smooth;
  const Vec3<C> arm = station_arm(c.mass, w.sl, R(0), w.wl);
  const Vec3<T> v =
      c.setup.options.wing_rate_velocity ? in.velocity_b + rate_cross_arm(in.rates_b, arm) : in.velocity_b;
  const T advance = smooth_max(in.advance_ratio, w.advance_floor, e.advance_floor);
  out.rotor_wash = c.wing.rotor_wash * in.rotor_force / (advance * advance);
  out.alpha = wrapped(T(angle_of_attack(v, e) - w.rotor_wash_angle * out.rotor_wash));
  out.beta = sideslip_angle(v, e.lateral_plane_speed);
  out.pressure = R(0.5) * c.air.density * (v.x * v.x + v.z * v.z);
}

// Lift, drag and the loss by the ailerons, on both halves.
template <class T, class C>
void free_wing_forces(const Configuration<C>& c, const AirframeInput<T>& in, const WingInWake<T> (&wake)[2],
                      FreeWing<T>& out) {
  using R = Real<T>;
  const WingTables<R>& w = c.aircraft->wing;
  const T lift_per_area = out.pressure * out.coefficients.lift;
  const T drag_per_area = out.pressure * out.coefficients.drag;
  const T half_aileron_loss = out.pressure * (R(0.5) * w.area * c.wing.aileron_lift_loss) *
                              smooth_abs_zero(in.aileron, c.aircraft->smooth.angle);  // 4-XII
  const SineCosine<T> attack = sine_and_cosine(out.alpha);
  const Vec3<T> per_area = wind_force(lift_per_area, drag_per_area, attack);
  const Vec3<T> half_loss = wind_force(half_aileron_loss, T(R(0)), attack);
  out.loads = free_half_wing(c, wake[right].immersed, per_area, half_loss, right) +
              free_half_wing(c, wake[left].immersed, per_area, half_loss, left);
}

// Moments by sideslip, rates, ailerons and camber (p. A-71).
template <class T, class C>
void add_free_wing_moments(const Configuration<C>& c, const AirframeInput<T>& in, const FreeStream<T>& stream,
                           const WingInWake<T> (&wake)[2], FreeWing<T>& out) {
  using R = Real<T>;
  const WingTables<R>& w = c.aircraft->wing;
  const T wake_pressure = R(0.5) * (wake[right].pressure + wake[left].pressure);
  const R area_span = w.area * w.span;
  const T aileron_slope = (w.aileron_roll_slope * c.wing.aileron_roll) * aileron_fade(c, out.alpha);  // 4-XI
  const T aileron_yaw =
      c.wing.aileron_yaw_0 + c.wing.aileron_yaw * out.coefficients.lift * aileron_slope;  // 4-XIII, 4-XIV
  const T roll = area_span * (out.pressure * out.lateral.roll + wake_pressure * aileron_slope * in.aileron);
  const T yaw = area_span * (out.pressure * out.lateral.yaw + wake_pressure * aileron_yaw * in.aileron);
  const auto& [sa, ca] = stream.attack;
  out.loads.moment.x += roll * ca - yaw * sa;
  out.loads.moment.y += out.pressure * (w.area * w.chord * c.wing.moment);  // 4-VIII
  out.loads.moment.z += roll * sa + yaw * ca;
}

// Downwash at the tail, table 4-V, compressibility-corrected (p. A-74).
template <class T, class C>
T wing_downwash(const Configuration<C>& c, const FreeStream<T>& stream, const T& alpha) {
  using R = Real<T>;
  const T alpha_deg[1] = {alpha * kDegPerRad<R>};
  return lookup(c.aircraft->wing.downwash, c.setup.options.tables, c.downwash_mast_flap, alpha_deg) /
         sqrt(R(1) - stream.mach * stream.mach);
}

}  // namespace wing_detail

// Part of the rotor-induced lift: printed loads show it with flap 40 deg, not with 20 deg or none.
template <class C>
C rotor_lift_by_flap(const Configuration<C>& c) {
  using R = Real<C>;
  if (c.setup.options.rotor_lift_flaps == RotorLiftFlaps::any) return C(R(1));
  const WingTables<R>& w = c.aircraft->wing;
  const R range = w.rotor_lift_flap_full - w.rotor_lift_flap_none;
  return smooth_step(C((c.setup.flap_deg - w.rotor_lift_flap_none) * (R(1) / range)));
}

template <class T, class C>
void free_wing(const Configuration<C>& c, const AirframeInput<T>& in, const FreeStream<T>& stream,
               const WingInWake<T> (&wake)[2], FreeWing<T>& out) {
  using R = Real<T>;
  wing_detail::free_wing_flow(c, in, out);
  out.coefficients = wing_coefficients(c, out.alpha, stream.mach);
  const C rotor_lift =
      c.setup.options.rotor_lift_on_wing
          ? C(R(2) * c.aircraft->wing.rotor_wash_lift * square(c.nacelle_axis_b.z)) * rotor_lift_by_flap(c)
          : C(R(0));  // rotor-induced lift: K_RW of p. B-33, cos^2 and flap a choice
  out.coefficients.lift = out.coefficients.lift * (R(1) + rotor_lift * out.rotor_wash);
  wing_detail::free_wing_forces(c, in, wake, out);
  out.lateral = wing_lateral_coefficients(c, in, stream, out.beta, out.coefficients);
  wing_detail::add_free_wing_moments(c, in, stream, wake, out);
  out.downwash = wing_detail::wing_downwash(c, stream, out.alpha);
}

}  // namespace tiltrotor
