// First-order lag of a sensor that is read at intervals, y' = (u - y)/T, exactly for an input that goes from one reading
// to the next in a straight line. With h = dt/T, E = exp(-h) and F = (1 - E)/h:
//   y1 = E y0 + (F - E) u0 + (1 - F) u1
// The weights are never negative and add up to 1. E and F by t = tanh(h/2): E = (1 - t)/(1 + t), F = (2 t/h)/(1 + t),
// which needs no difference of almost equal numbers.
#pragma once

#include "tiltrotor/math/hyperbolic_tangent.hpp"

namespace tiltrotor {

// Of time constants shorter than this part of the step nothing is left at its end.
template <class R>
inline constexpr R kShortestLag = R(1e-6);

// `before`, `reading`: u0 and y0; `now`: u1, after `dt` > 0.
template <class R>
R lagged(R time_constant, R before, R reading, R now, R dt) {
  if (!(time_constant > kShortestLag<R> * dt)) return now;
  const R half = R(0.5) * (dt / time_constant);
  const R ratio = hyperbolic_tangent_over(square(half));  // t over h/2
  const R t = half * ratio;
  const R stays = (R(1) - t) / (R(1) + t);
  const R mean = ratio / (R(1) + t);
  return stays * reading + (mean - stays) * before + (R(1) - mean) * now;
}

}  // namespace tiltrotor
