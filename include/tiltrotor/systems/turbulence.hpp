// Turbulence felt at right rotor, left rotor, wing and tail: Dryden's spectra from filters of white noise.
//
//   TurbulenceState<double> t{};                                        // calm; the gusts grow over L/V
//   const LocalGusts<double> gusts = gusts_at(t, air, aircraft);        // held while the step lasts
//   t = turbulence_step(t, air, dt, gust_noise<double>(seed, step), aircraft);
//
// The field is frozen: it is a series along the path flown, and speed says only how fast the aircraft reads it. Two
// independent series, s1 and s2, each with the spectrum of a point, give the rotors c1 s1 +- c2 s2: their own spectrum
// is that of a point, their correlation the law's. The wing feels their mean; the tail s1, later.
//
// The filters are stepped by the midpoint rule. That rule keeps the stationary covariance of a linear filter of white
// noise exactly (it is Cayley's map of the rates: A P + P A' + B B' = 0 becomes F P F' + G G' = P), whatever the step,
// also while the speed changes. So variances and correlations at the ends of steps are the law's at any dt; a
// frequency w appears at (2/dt) atan(w dt/2), 1 % low at w dt = 0.35. Beyond + - * / only sqrt: the same bits
// everywhere. The arithmetic is in TURBULENCE.md.
#pragma once

#include <cstdint>

#include "tiltrotor/systems/dryden.hpp"
#include "tiltrotor/systems/local_gusts.hpp"
#include "tiltrotor/systems/random.hpp"

namespace tiltrotor {

// Filters of one series. Scaled: stationary variance 1/2 behind the first lag, 1/4 behind the second.
template <class T>
struct GustSeries {
  T u;
  T v[2], w[2];  // two lags in a row
};

// A series on its way to the tail: the all-pass of second order (12 - 6 s + s^2) / (12 + 6 s + s^2) for the delay
// e^-s, Pade's approximation, with the distance to the tail as unit. Its phase is right to 0.1 deg at 1 rad of delay,
// 2 at 2 and 11 at 3; the variance is kept. Behind it comes series - slope.
template <class T>
struct GustDelay {
  T followed, slope;  // slope = d followed / d distance
};

template <class T>
struct TurbulenceState {
  GustSeries<T> series[2];  // s1, in which the rotors are alike; s2, in which they are opposite
  GustDelay<T> tail[3];     // u, v, w of s1
  static constexpr int kCount = 16;

  // Every state once, with its name.
  template <class Self, class Visit>
  static constexpr void describe(Self& s, Visit&& visit) {
    visit(s.series[0].u, "gust_alike_u");
    visit(s.series[0].v[0], "gust_alike_v1");
    visit(s.series[0].v[1], "gust_alike_v2");
    visit(s.series[0].w[0], "gust_alike_w1");
    visit(s.series[0].w[1], "gust_alike_w2");
    visit(s.series[1].u, "gust_opposite_u");
    visit(s.series[1].v[0], "gust_opposite_v1");
    visit(s.series[1].v[1], "gust_opposite_v2");
    visit(s.series[1].w[0], "gust_opposite_w1");
    visit(s.series[1].w[1], "gust_opposite_w2");
    visit(s.tail[0].followed, "gust_tail_u");
    visit(s.tail[0].slope, "gust_tail_u_slope");
    visit(s.tail[1].followed, "gust_tail_v");
    visit(s.tail[1].slope, "gust_tail_v_slope");
    visit(s.tail[2].followed, "gust_tail_w");
    visit(s.tail[2].slope, "gust_tail_w_slope");
  }
  template <class Self, class Visit>
  static constexpr void each(Self& s, Visit&& visit) {
    describe(s, [&visit](auto& x, const char*) { visit(x); });
  }
};
static_assert(lists_its_members<TurbulenceState>());

// One number for each filter and step, mean 0, variance 1, independent.
template <class R>
struct GustNoise {
  Vec3<R> series[2];
};
// Of a step: streams 0 to 5 of the seed.
template <class R>
GustNoise<R> gust_noise(std::uint64_t seed, std::uint64_t step) {
  GustNoise<R> noise;
  std::uint64_t stream = 0;
  for (Vec3<R>& series : noise.series)
    Vec3<R>::each(series, [&](R& n) { n = normal_number<R>(seed, stream++, step); });
  return noise;
}

namespace turbulence_detail {

template <class R>
inline constexpr R kSqrt2 = static_cast<R>(1.41421356237309504880168872420969808L);
template <class R>
inline constexpr R kSqrt3 = static_cast<R>(1.73205080756887729352744634150587237L);

// Over z of its own length the lag x' = input - x; `fed` is z times the mean of the input.
template <class T>
T lagged(const T& x, const T& fed, const T& z) {
  using R = Real<T>;
  return ((R(1) - R(0.5) * z) * x + fed) / (R(1) + R(0.5) * z);
}
template <class T>
T mean(const T& a, const T& b) {
  return Real<T>(0.5) * (a + b);
}

// sqrt(2) / (1 + s): variance 1.
template <class T>
T along_path(const T& lag) {
  return kSqrt2<Real<T>> * lag;
}
// (1 + sqrt(3) s) / (1 + s)^2: variance 1.
template <class T>
T across_path(const T (&lags)[2]) {
  using R = Real<T>;
  return lags[1] + kSqrt3<R> * (lags[0] - lags[1]);
}
// A series at a point, for unit intensity.
template <class T>
Vec3<T> at_point(const GustSeries<T>& s) {
  return {along_path(s.u), across_path(s.v), across_path(s.w)};
}

// Over z lengths of its scale; root_z its square root.
template <class T>
void advance_across(T (&lags)[2], const T& z, const T& root_z, Real<T> noise) {
  const T before = lags[0];
  lags[0] = lagged(before, T(root_z * noise), z);
  lags[1] = lagged(lags[1], T(z * mean(before, lags[0])), z);
}

// Over z distances to the tail, `mean_series` meanwhile: followed'' = 12 (series - followed) - 6 followed'.
template <class T>
void advance_delay(GustDelay<T>& d, const T& mean_series, const T& z) {
  using R = Real<T>;
  const T middle = (d.slope + R(6) * z * (mean_series - d.followed)) / (R(1) + R(3) * z * (R(1) + z));
  d.followed = d.followed + z * middle;
  d.slope = R(2) * middle - d.slope;
}

}  // namespace turbulence_detail

// The state dt later, dt >= 0 in s, any length; `noise` belongs to this step alone. Air and aircraft as they are
// during the step. Finite for finite arguments. About 200 operations.
template <class T>
TurbulenceState<T> turbulence_step(TurbulenceState<T> state, const TurbulentAir<T>& air, Real<T> dt,
                                   const GustNoise<Real<T>>& noise, const Aircraft<Real<T>>& aircraft) {
  using namespace turbulence_detail;
  using R = Real<T>;
  const GustTables<R>& g = aircraft.gust;
  const DrydenLaw<T> law = dryden_law(air, g);
  const T speed = smooth_max(air.airspeed, g.convection_speed, g.speed_width);
  const T level = speed / law.scale.x;
  const T vertical = speed / law.scale.z;
  const T z_level = level * dt;
  const T z_vertical = vertical * dt;
  const R root_dt = sqrt(dt);
  const T root_level = sqrt(level) * root_dt;
  const T root_vertical = sqrt(vertical) * root_dt;

  const Vec3<T> before = at_point(state.series[0]);
  for (int i = 0; i < 2; ++i) {
    GustSeries<T>& s = state.series[i];
    const Vec3<R>& n = noise.series[i];
    s.u = lagged(s.u, T(root_level * n.x), z_level);
    advance_across(s.v, z_level, root_level, n.y);
    advance_across(s.w, z_vertical, root_vertical, n.z);
  }
  const Vec3<T> after = at_point(state.series[0]);

  const T z_tail = speed * (dt / tail_distance(aircraft));
  advance_delay(state.tail[0], mean(before.x, after.x), z_tail);
  advance_delay(state.tail[1], mean(before.y, after.y), z_tail);
  advance_delay(state.tail[2], mean(before.z, after.z), z_tail);
  return state;
}

// Gusts of a state, m/s, body axes; zero without wind. About 300 operations.
template <class T>
LocalGusts<T> gusts_at(const TurbulenceState<T>& state, const TurbulentAir<T>& air,
                       const Aircraft<Real<T>>& aircraft) {
  using namespace turbulence_detail;
  using R = Real<T>;
  const DrydenLaw<T> law = dryden_law(air, aircraft.gust);
  const Vec3<T> correlation = rotor_correlation(law, aircraft.mast);
  const auto scaled = [](const Vec3<T>& a, const Vec3<T>& b) {
    return Vec3<T>{a.x * b.x, a.y * b.y, a.z * b.z};
  };
  const auto share = [&](R sign) {  // c1, c2
    const auto of = [sign](const T& r) { return sqrt(R(0.5) * (R(1) + sign * r)); };
    return Vec3<T>{of(correlation.x), of(correlation.y), of(correlation.z)};
  };
  const Vec3<T> point = at_point(state.series[0]);
  const Vec3<T> alike = scaled(law.intensity, scaled(share(R(1)), point));
  const Vec3<T> opposite = scaled(law.intensity, scaled(share(R(-1)), at_point(state.series[1])));
  const Vec3<T> slope = {state.tail[0].slope, state.tail[1].slope, state.tail[2].slope};
  const Vec3<T> tail = scaled(law.intensity, point - slope);
  return {{alike + opposite, alike - opposite}, alike, tail};
}

}  // namespace tiltrotor
