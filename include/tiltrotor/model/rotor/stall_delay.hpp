// Lift that rotation keeps on a blade section beyond its two-dimensional stall (switch stall_delay): Snel, Houwink and
// Bosschers, ECN-C--93-052 (1993),
//
//   cl = cl_2D + tanh(3 (c/r)^2) max( a (alpha - alpha_0) - cl_2D, 0 ),   drag unchanged.
//
// Faded in over 4 deg above zero lift, where potential and table agree, and out over 30 to 50 deg, where the data behind
// it end. It over-predicts on many rotors (Breton, Coton and Moe, Wind Energy 11 (2008) 459), hence no default.
#pragma once

#include "tiltrotor/math/hyperbolic_tangent.hpp"
#include "tiltrotor/math/smooth.hpp"
#include "tiltrotor/model/setup/configuration.hpp"

namespace tiltrotor {

// tanh(3 (c/r)^2) of a station: the share of the lost lift that rotation keeps. Computed at every element, since
// every aircraft would carry a stored one and few fly with the switch.
template <class C>
Real<C> kept_by_rotation(const Configuration<C>& c, const BladeStation<Real<C>>& s) {
  using R = Real<C>;
  const RotorTables<R>& rotor = c.aircraft->rotor;
  const R chord = blade_chord(rotor, c.setup.options.chord, s.radius / rotor.radius);
  return hyperbolic_tangent(R(3) * square(chord / s.radius));
}

// Lift lost by stall. `alpha`: rad, -pi..pi; `lift`: cl of the section tables. Zero lift and slope are looked for at
// every element as well: a derivative takes three times as long with the switch.
template <class T, class C>
T lift_lost_by_stall(const Configuration<C>& c, int region, const T& alpha, const T& lift) {
  using R = Real<T>;
  const SmoothingWidths<R>& e = c.aircraft->smooth;
  const T alpha_deg = alpha * kDegPerRad<R>;
  const PotentialLift<R> potential = potential_lift(c.aircraft->rotor, region);
  const T above = alpha_deg - potential.zero_deg;
  const T lost = smooth_positive(T(potential.slope * above - lift), e.stall_delay_lift);
  const T in = smooth_step(T(above * (R(1) / e.stall_delay_start)));
  const T out = smooth_step(T((alpha_deg - e.stall_delay_fade) * (R(1) / e.stall_delay_end)));
  return lost * in * (R(1) - out);
}

}  // namespace tiltrotor
