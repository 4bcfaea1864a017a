// Gusts of the air the aircraft flies through: numbers of the laws of turbulence and of the mean wind.
#pragma once

#include "tiltrotor/math/arithmetic.hpp"

namespace tiltrotor {

// Dryden turbulence of MIL-F-8785C. Heights are those above the ground.
template <class R>
struct GustTables {
  R wind_light, wind_moderate, wind_severe;  // gust_W20_light .. gust_W20_severe: wind at 20 ft, m/s
  R vertical_intensity;                      // gust_sigma_w_over_W20, near the ground
  R ground_shape;             // gust_ground_shape: longer and stronger along than up near the ground
  R low_height, high_height;  // gust_low_height, gust_high_height: ends of the two laws, m
  R high_length;              // gust_high_length: scale above, m
  R high_intensity;           // choices: gust_high_intensity, over the wind at 20 ft
  R lowest_height;            // choices: gust_lowest_height, m
  R convection_speed;         // choices: gust_convection_speed: lowest airspeed of the filters, m/s
  R height_width;             // choices: gust_height_width, m
  R speed_width;              // choices: gust_speed_width, m/s
  // Mean wind: where it is told, between which heights it grows, and roughness of the ground, m.
  R shear_height, shear_lowest, shear_highest;  // wind_shear_*
  R roughness_terminal, roughness_other;        // wind_roughness_*: category C, other flight phases
  R shear_width;                                // choices: wind_shear_width, m
};

}  // namespace tiltrotor
