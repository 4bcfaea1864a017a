// Hyperbolic tangent of a plain number, with the same bits on every machine.
#pragma once

#include "tiltrotor/math/arithmetic.hpp"

namespace tiltrotor {

// tanh(x) for |x| <= 5 within 4e-16 in double precision: Lambert's continued fraction x/(1 + x^2/(3 + x^2/(5 + ..))),
// NIST Digital Library 4.39.1.
template <class R>
R hyperbolic_tangent(R x) {
  constexpr int levels = 20;
  R fraction = R(2 * levels + 1);
  for (int k = levels - 1; k >= 0; --k) fraction = static_cast<R>(2 * k + 1) + x * x / fraction;
  return x / fraction;
}

}  // namespace tiltrotor
