// International Standard Atmosphere, troposphere: ISO 2533.
#pragma once

#include <cmath>

#include "tiltrotor/math/arithmetic.hpp"

namespace tiltrotor {

template <class R>
struct Air {
  R density;         // kg/m^3
  R speed_of_sound;  // m/s
};

namespace atmosphere_detail {

// (1 + x)^exponent by the binomial series, |x| <= 0.25: the same bits on every machine, which pow() does not
// promise.
template <class R>
R binomial_power(R x, R exponent) {
  const int terms = 28;  // the next is below 1e-18
  R term = R(1);
  R sum = R(1);
  for (int k = 0; k < terms; ++k) {
    term *= (exponent - static_cast<R>(k)) / static_cast<R>(k + 1) * x;
    sum += term;
  }
  return sum;
}

}  // namespace atmosphere_detail

// Valid for altitudes -500 m to 11000 m above sea level.
template <class R>
Air<R> standard_air(R altitude_m) {
  const R sea_level_temperature = R(288.15);  // K
  const R lapse_rate = R(0.0065);             // K/m
  const R sea_level_density = R(1.225);       // kg/m^3
  const R density_exponent = R(4.2559);       // g / (R_air lapse) - 1
  const R heat_ratio = R(1.4);
  const R gas_constant = R(287.053);  // J/(kg K)
  const R temperature = sea_level_temperature - lapse_rate * altitude_m;
  const R lapse = -lapse_rate * altitude_m / sea_level_temperature;
  return {sea_level_density * atmosphere_detail::binomial_power(lapse, density_exponent),
          std::sqrt(heat_ratio * gas_constant * temperature)};
}

}  // namespace tiltrotor
