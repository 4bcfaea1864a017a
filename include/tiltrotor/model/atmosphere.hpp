// International Standard Atmosphere, troposphere: ISO 2533.
#pragma once

#include <cmath>

namespace tiltrotor {

template <class R>
struct Air {
  R density;         // kg/m^3
  R speed_of_sound;  // m/s
};

// Valid for altitudes -500 m to 11000 m above sea level.
template <class R>
Air<R> standard_air(R altitude_m) {
  const R sea_level_temperature = R(288.15);  // K
  const R lapse_rate = R(0.0065);             // K/m
  const R sea_level_density = R(1.225);       // kg/m^3
  const R density_exponent = R(4.2559);       // g / (R_air lapse) - 1
  const R heat_ratio = R(1.4);
  const R gas_constant = R(287.053);          // J/(kg K)
  const R temperature = sea_level_temperature - lapse_rate * altitude_m;
  return {sea_level_density * std::pow(temperature / sea_level_temperature, density_exponent),
          std::sqrt(heat_ratio * gas_constant * temperature)};
}

}  // namespace tiltrotor
