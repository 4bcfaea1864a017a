// Wind that grows with the height above the ground: MIL-F-8785C section 3.7, mean wind.
//   W(h) = W20 ln(h/z0) / ln(20 ft/z0)      3 to 1000 ft, constant beyond; W20: Surroundings::wind_n, its level part
// Velocities of the state are relative to the air at the CG, which moves faster the higher the aircraft climbs:
// (R v + W)' = forces, so that v' loses R^T W'(h) h'. The growth across the aircraft itself is left out.
#pragma once

#include "tiltrotor/math/differentiation/preaccumulate.hpp"
#include "tiltrotor/math/logarithm.hpp"
#include "tiltrotor/math/smooth.hpp"
#include "tiltrotor/math/vector.hpp"
#include "tiltrotor/model/aircraft/aircraft.hpp"
#include "tiltrotor/model/variables/state.hpp"

namespace tiltrotor {

// Of the ground: smooth, as the standard has it in terminal flight phases (category C), or as in all others.
enum class WindShear : unsigned char { none, terminal, other };

// Of the wind at 20 ft.
template <class T>
struct WindProfile {
  T share, slope;  // -, 1/m
};

namespace wind_shear_detail {

template <class T>
WindProfile<T> profile(const GustTables<Real<T>>& g, WindShear shear, const T& height) {
  using R = Real<T>;
  const R roughness = shear == WindShear::terminal ? g.roughness_terminal : g.roughness_other;
  const R per_log = R(1) / logarithm(R(g.shear_height / roughness)), per_width = R(1) / g.shear_width;
  // Beyond its ends, where nothing changes, no large numbers.
  const R low = g.shear_lowest - g.shear_width, high = g.shear_highest + g.shear_width;
  const T h = value(height) < low ? T(low) : value(height) > high ? T(high) : height;
  const T above = h - g.shear_lowest, beyond = h - g.shear_highest;
  const T held = g.shear_lowest + smooth_ramp(above, g.shear_width) - smooth_ramp(beyond, g.shear_width);
  const T rises = smooth_step(T(per_width * above + R(0.5))) - smooth_step(T(per_width * beyond + R(0.5)));
  return {per_log * logarithm(T(held * (R(1) / roughness))), per_log * rises / held};
}

// With its derivative along the height: code once, whatever the directions behind.
template <class R>
TILTROTOR_NOINLINE WindProfile<Dual<R, 1>> profile_along(const GustTables<R>& g, WindShear shear, R height) {
  return profile(g, shear, Dual<R, 1>::variable(height, 0));
}

}  // namespace wind_shear_detail

// `height`: above the ground, m, any. Not of WindShear::none.
template <class T>
WindProfile<T> wind_profile(const GustTables<Real<T>>& g, WindShear shear, const T& height) {
  using R = Real<T>;
  if constexpr (OuterPartials<T>::count > 0) {
    const WindProfile<Dual<R, 1>> along = wind_shear_detail::profile_along(g, shear, R(value(height)));
    return {chain(along.share, &height), chain(along.slope, &height)};
  } else if constexpr (kIsPlain<T>) {
    const WindProfile<Dual<R, 1>> along = wind_shear_detail::profile_along(g, shear, height);
    return {along.share.v, along.slope.v};
  } else {
    return wind_shear_detail::profile(g, shear, height);
  }
}

// The wind around an aircraft.
template <class R>
struct MeanWind {
  const GustTables<R>& gust;
  WindShear shear;
  R ground_down;   // m
  Vec3<R> told_n;  // Surroundings::wind_n, north east down, m/s
};

// From the earth's axes to the body's.
template <class T>
Vec3<T> wind_in_body(const Vec3<Real<T>>& wind_n, const State<T>& x) {
  const SineCosine<T> r = sine_and_cosine(x.roll), p = sine_and_cosine(x.pitch), y = sine_and_cosine(x.yaw);
  const T ahead = wind_n.x * y.cosine + wind_n.y * y.sine;
  const T aside = wind_n.y * y.cosine - wind_n.x * y.sine;
  const T below = ahead * p.sine + wind_n.z * p.cosine;
  return {ahead * p.cosine - wind_n.z * p.sine, aside * r.cosine + below * r.sine,
          below * r.cosine - aside * r.sine};
}

// At a position down, north east down, m/s.
template <class T, class R>
Vec3<T> wind_at(const MeanWind<R>& wind, const T& down) {
  T share = T(R(1));
  if (wind.shear != WindShear::none)
    share = wind_profile(wind.gust, wind.shear, T(wind.ground_down - down)).share;
  return {share * wind.told_n.x, share * wind.told_n.y, T(wind.told_n.z)};
}

// Of the airframe, body axes, m/s.
template <class T>
Vec3<T> velocity_over_ground(const MeanWind<Real<T>>& wind, const State<T>& x) {
  using R = Real<T>;
  Vec3<T> even = x.velocity + wind_in_body(wind.told_n, x);
  if (wind.shear == WindShear::none) return even;
  const T share = wind_profile(wind.gust, wind.shear, T(wind.ground_down - x.position.z)).share;
  return even + (share - R(1)) * wind_in_body(Vec3<R>{wind.told_n.x, wind.told_n.y, R(0)}, x);
}

// What the growth adds to the rates of a state in even wind.
template <class T>
TILTROTOR_NOINLINE void drift(const MeanWind<Real<T>>& wind, const State<T>& x, State<T>& rates) {
  using R = Real<T>;
  if (wind.shear == WindShear::none) return;
  const WindProfile<T> profile = wind_profile(wind.gust, wind.shear, T(wind.ground_down - x.position.z));
  const Vec3<R> level = {wind.told_n.x, wind.told_n.y, R(0)};
  const T more = profile.share - R(1);
  rates.position.x = rates.position.x + more * level.x;
  rates.position.y = rates.position.y + more * level.y;
  rates.velocity = rates.velocity + (profile.slope * rates.position.z) * wind_in_body(level, x);
}

}  // namespace tiltrotor
