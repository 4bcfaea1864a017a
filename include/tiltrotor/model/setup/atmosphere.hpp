// International Standard Atmosphere, troposphere: ISO 2533.
#pragma once

#include "tiltrotor/math/scalar.hpp"

namespace tiltrotor {

template <class C>
struct Air {
  C density;         // kg/m^3
  C speed_of_sound;  // m/s
  C temperature;     // K
};

namespace atmosphere_detail {

// (1 + x)^exponent by the binomial series, |x| <= 0.25: the same bits on every machine, which pow() does not
// promise.
template <class C>
C binomial_power(const C& x, Real<C> exponent) {
  using R = Real<C>;
  const int terms = 28;  // the next is below 1e-18
  C term = R(1);
  C sum = R(1);
  for (int k = 0; k < terms; ++k) {
    term *= (exponent - static_cast<R>(k)) / static_cast<R>(k + 1) * x;
    sum += term;
  }
  return sum;
}

}  // namespace atmosphere_detail

// Valid for altitudes -500 m to 11000 m above sea level.
template <class C>
Air<C> standard_air(const C& altitude_m) {
  using R = Real<C>;
  const R sea_level_temperature = R(288.15);  // K
  const R lapse_rate = R(0.0065);             // K/m
  const R sea_level_density = R(1.225);       // kg/m^3
  const R density_exponent = R(4.2559);       // g / (R_air lapse) - 1
  const R heat_ratio = R(1.4);
  const R gas_constant = R(287.053);  // J/(kg K)
  const C temperature = sea_level_temperature - lapse_rate * altitude_m;
  const C lapse = -lapse_rate * altitude_m / sea_level_temperature;
  return {sea_level_density * atmosphere_detail::binomial_power(lapse, density_exponent),
          sqrt(C(heat_ratio * gas_constant * temperature)), temperature};
}

// Warmer by so many kelvin than the standard atmosphere at that altitude, under (1 + `pressure_above`) times its
// pressure: density goes with pressure over temperature, the speed of sound with the root of temperature.
template <class C>
Air<C> surrounding_air(const C& altitude_m, Real<C> warmer, Real<C> pressure_above) {
  using R = Real<C>;
  const Air<C> standard = standard_air(altitude_m);
  const C temperature = standard.temperature + warmer;
  const C ratio = temperature / standard.temperature;
  return {standard.density * (R(1) + pressure_above) / ratio, standard.speed_of_sound * sqrt(ratio),
          temperature};
}

}  // namespace tiltrotor
