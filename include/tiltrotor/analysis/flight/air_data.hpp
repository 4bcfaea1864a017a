// Pressures and speeds as air data instruments count them, of compressible flow without shock: ICAO Doc 7488.
// They are found without powers of a fraction and without differences of almost equal numbers: the same bits on
// every machine, and exact at walking speed.
#pragma once

#include "tiltrotor/analysis/flight/instruments.hpp"
#include "tiltrotor/model/setup/atmosphere.hpp"

namespace tiltrotor {

template <class R>
struct AirData {
  R static_pressure;  // Pa
  R impact_pressure;  // total less static, Pa
  R true_airspeed;    // m/s
  R calibrated;       // m/s: airspeed at sea level, ISA, of the same impact pressure
  R mach;
  R angle_of_attack, sideslip;  // rad
};

namespace air_data_detail {

template <class R>
inline constexpr R kHeatRatio = R(1.4);

// rho R T, by the speed of sound: a^2 = 1.4 R T.
template <class R>
R static_pressure(const Air<R>& air) {
  return air.density * square(air.speed_of_sound) / kHeatRatio<R>;
}

// (1 + t)^7 - 1 and its slope.
template <class R>
R seventh_power(R t) {
  return t * (R(7) + t * (R(21) + t * (R(35) + t * (R(35) + t * (R(21) + t * (R(7) + t))))));
}
template <class R>
R seventh_power_slope(R t) {
  const R square_of = square(R(1) + t);
  return R(7) * square_of * square_of * square_of;
}

// q_c / p = (1 + M^2/5)^(7/2) - 1, with 1 + t = sqrt(1 + M^2/5).
template <class R>
R impact_ratio(R mach) {
  const R m = R(0.2) * square(mach);
  return seventh_power(m / (R(1) + std::sqrt(R(1) + m)));
}
// The inverse. Newton's method from t = ratio / 7 falls to the root; to ratio 4 (Mach 1.7) 10 steps are enough.
template <class R>
R mach_of(R ratio) {
  R t = ratio / R(7);
  for (int k = 0; k < 10; ++k) t -= (seventh_power(t) - ratio) / seventh_power_slope(t);
  return std::sqrt(R(5) * t * (R(2) + t));
}

}  // namespace air_data_detail

// `v`: relative to the air, body axes, m/s.
template <class R>
AirData<R> air_data(const Air<R>& air, const Vec3<R>& v) {
  using namespace air_data_detail;
  const Air<R> sea_level = standard_air(R(0));
  const Airspeed<R> motion = airspeed(v);
  AirData<R> d;
  d.static_pressure = static_pressure(air);
  d.true_airspeed = motion.speed;
  d.mach = motion.speed / air.speed_of_sound;
  d.impact_pressure = d.static_pressure * impact_ratio(d.mach);
  d.calibrated = sea_level.speed_of_sound * mach_of(d.impact_pressure / static_pressure(sea_level));
  d.angle_of_attack = motion.angle_of_attack;
  d.sideslip = motion.sideslip;
  return d;
}

// What instruments make of two pressures, Pa: `impact` >= 0, up to 4 of the static one; airspeed in the temperature of
// `air`. Angles are 0.
template <class R>
AirData<R> indicated_air_data(const Air<R>& air, R static_pressure, R impact) {
  using namespace air_data_detail;
  const Air<R> sea_level = standard_air(R(0));
  AirData<R> d{};
  d.static_pressure = static_pressure;
  d.impact_pressure = impact;
  d.mach = mach_of(impact / static_pressure);
  d.true_airspeed = d.mach * air.speed_of_sound;
  d.calibrated = sea_level.speed_of_sound * mach_of(impact / air_data_detail::static_pressure(sea_level));
  return d;
}

}  // namespace tiltrotor
