// Lift that rotation keeps on a blade section beyond its two-dimensional stall (switch stall_delay): Snel, Houwink and
// Bosschers, ECN-C--93-052 (1993),
//
//   cl = cl_2D + tanh(3 (c/r)^2) max( a (alpha - alpha_0) - cl_2D, 0 ),   drag unchanged.
//
// Faded in over 4 deg above zero lift, where potential and table agree, and out over 30 to 50 deg, where the data behind
// it end. It over-predicts on many rotors (Breton, Coton and Moe, Wind Energy 11 (2008) 459), hence no default.
#pragma once

#include "tiltrotor/math/smooth.hpp"
#include "tiltrotor/model/setup/configuration.hpp"

namespace tiltrotor {

// To be multiplied by the station's stall_delay. `alpha`: rad, -pi..pi; `lift`: cl of the section tables.
template <class T, class C>
T lift_lost_by_stall(const Configuration<C>& c, int region, const T& alpha, const T& lift) {
  using R = Real<T>;
  const SmoothingWidths<R>& e = c.aircraft->smooth;
  const T alpha_deg = alpha * kDegPerRad<R>;
  const T above = alpha_deg - c.potential_lift[region].zero_deg;
  const T lost = smooth_positive(T(c.potential_lift[region].slope * above - lift), e.stall_delay_lift);
  const T in = smooth_step(T(above * (R(1) / e.stall_delay_start)));
  const T out = smooth_step(T((alpha_deg - e.stall_delay_fade) * (R(1) / e.stall_delay_end)));
  return lost * in * (R(1) - out);
}

}  // namespace tiltrotor
