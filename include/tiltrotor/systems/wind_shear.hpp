// Wind that grows with the height above the ground: MIL-F-8785C section 3.7, mean wind.
//   W(h) = W20 ln(h/z0) / ln(20 ft/z0)      3 to 1000 ft, constant beyond; W20: Surroundings::wind_n, its level part
// Velocities of the state are relative to the air at the CG, which moves faster the higher the aircraft climbs:
// (R v + W)' = forces, so that v' loses R^T W'(h) h'. The growth across the aircraft itself is left out.
#pragma once

#include "tiltrotor/math/logarithm.hpp"
#include "tiltrotor/math/smooth.hpp"
#include "tiltrotor/math/vector.hpp"
#include "tiltrotor/model/aircraft/aircraft.hpp"

namespace tiltrotor {

// Of the ground: smooth, as the standard has it in terminal flight phases (category C), or as in all others.
enum class WindShear : unsigned char { none, terminal, other };

// Of the wind at 20 ft.
template <class T>
struct WindProfile {
  T share, slope;  // -, 1/m
};

// `height`: above the ground, m, any. Not of WindShear::none.
template <class T>
WindProfile<T> wind_profile(const GustTables<Real<T>>& g, WindShear shear, const T& height) {
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

}  // namespace tiltrotor
