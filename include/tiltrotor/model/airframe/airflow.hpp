// Angles, pressures and axes of the flow at an airframe component.
#pragma once

#include "tiltrotor/math/smooth.hpp"
#include "tiltrotor/math/vector.hpp"
#include "tiltrotor/model/setup/configuration.hpp"
#include "tiltrotor/model/variables/loads.hpp"

namespace tiltrotor {

// What the airframe components see of the aircraft: 14 numbers.
template <class T>
struct AirframeInput {
  Vec3<T> velocity_b;           // airframe at the CG relative to the air at the wing, m/s
  Vec3<T> rates_b;              // relative to the air, rad/s
  T mean_wash[2];               // v0 = lambda_0 Omega R of each rotor, m/s
  T rotor_force;                // C_RF: resultant forces of both rotors over rho pi Omega^2 R^4
  T advance_ratio;              // mean in-plane advance ratio of the rotors
  T downwash;                   // lagged wing downwash at the tail, rad
  T elevator, aileron, rudder;  // rad

  static constexpr int kCount = 14;
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    Vec3<T>::each(s.velocity_b, visit);
    Vec3<T>::each(s.rates_b, visit);
    visit(s.mean_wash[right]);
    visit(s.mean_wash[left]);
    visit(s.rotor_force);
    visit(s.advance_ratio);
    visit(s.downwash);
    visit(s.elevator);
    visit(s.aileron);
    visit(s.rudder);
  }
};
static_assert(lists_its_members<AirframeInput>(), "each member of AirframeInput is listed and counted");

// atan2(w, u + e): e keeps exact hover regular; its bias is below 0.1 deg at 30 m/s. The angle of air at rest
// stands at u = -e, w = 0 instead: there it has no derivative, and next to it loads of some hundredths of a
// newton change their direction. In flow from behind it jumps from 180 to -180 deg, as w passes zero;
// whatever depends on it has one value and one slope there.
template <class T>
T angle_of_attack(const Vec3<T>& v, const SmoothingWidths<Real<T>>& e) {
  return atan2(v.z, v.x + e.forward_speed);
}
// atan2(v, sqrt(u^2 + w^2 + e^2))
template <class T>
T sideslip_angle(const Vec3<T>& v, Real<T> e) {
  return atan2(v.y, sqrt(v.x * v.x + v.z * v.z + e * e));
}
template <class T>
T total_speed(const Vec3<T>& v, Real<T> e) {
  return sqrt(dot(v, v) + e * e);
}

// The same relative to the air at the tail.
template <class T, class C>
Vec3<T> velocity_at_tail(const Configuration<C>& c, const AirframeInput<T>& in) {
  return minus_fixed(in.velocity_b, c.around.tail_gust_b - c.around.wing_gust_b);
}

// Free-stream quantities shared by the components, from the CG's velocity.
template <class T>
struct FreeStream {
  T speed;        // m/s, smoothed at rest
  T speed_kt;     // the same, kt
  T mach;         // held below the limit of the tables
  T alpha, beta;  // rad
  T alpha_deg;
  SineCosine<T> attack;  // of alpha
  T abs_beta_deg;        // smoothed |beta|, zero at zero
};

// m/s: the rounded factor of the tables' speed axes, 9e-8 below 1852/3600.
template <class R>
inline constexpr R kKnot = R(0.5144444);

template <class T, class C>
FreeStream<T> free_stream(const Configuration<C>& c, const Vec3<T>& velocity_b) {
  using R = Real<T>;
  const SmoothingWidths<R>& e = c.aircraft->smooth;
  FreeStream<T> f;
  f.speed = total_speed(velocity_b, e.airspeed);
  f.speed_kt = f.speed * (R(1) / kKnot<R>);
  f.mach = smooth_min(T(f.speed * (R(1) / c.air.speed_of_sound)), e.mach_limit, e.mach);
  f.alpha = angle_of_attack(velocity_b, e);
  f.beta = sideslip_angle(velocity_b, e.lateral_plane_speed);
  f.alpha_deg = f.alpha * kDegPerRad<R>;
  f.attack = sine_and_cosine(f.alpha);
  f.abs_beta_deg = smooth_abs_zero(f.beta, e.angle) * kDegPerRad<R>;
  return f;
}

// 1 in flow from ahead, |alpha| up to 90 deg, falling to 0 in flow from straight behind: C2, also where alpha
// jumps from 180 to -180 deg. For laws that end somewhere before. The plain |alpha| is safe because the
// weight is constant around zero.
template <class T>
T flow_from_ahead(const T& alpha, const SmoothingWidths<Real<T>>& e) {
  using R = Real<T>;
  const T size = value(alpha) < R(0) ? T(-alpha) : alpha;
  return R(1) - smooth_step(T((size - e.rear_flow_start) * (R(1) / (kPi<R> - e.rear_flow_start))));
}

// Force of lift L, drag D and side force Y' (wind axes at alpha, beta) in body axes, derived here from the
// two rotations, with the signs of NASA CR-166536.
// X = L sa - (D cb + Y' sb) ca,  Y = Y' cb - D sb,  Z = -L ca - (D cb + Y' sb) sa.
template <class T>
Vec3<T> wind_force(const T& lift, const T& drag, const T& side, const SineCosine<T>& alpha,
                   const SineCosine<T>& beta) {
  const T forward = drag * beta.cosine + side * beta.sine;
  return {lift * alpha.sine - forward * alpha.cosine, side * beta.cosine - drag * beta.sine,
          -(lift * alpha.cosine) - forward * alpha.sine};
}
// The same without side force,
template <class T>
Vec3<T> wind_force(const T& lift, const T& drag, const SineCosine<T>& alpha, const SineCosine<T>& beta) {
  const T forward = drag * beta.cosine;
  return {lift * alpha.sine - forward * alpha.cosine, T(Real<T>(0)) - drag * beta.sine,
          -(lift * alpha.cosine) - forward * alpha.sine};
}
// and without sideslip.
template <class T>
Vec3<T> wind_force(const T& lift, const T& drag, const SineCosine<T>& alpha) {
  return {lift * alpha.sine - drag * alpha.cosine, T(Real<T>(0)), -(lift * alpha.cosine) - drag * alpha.sine};
}

}  // namespace tiltrotor
