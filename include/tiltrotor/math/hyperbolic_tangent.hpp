// Hyperbolic tangent, with the same bits on every machine.
#pragma once

#include "tiltrotor/math/scalar.hpp"

namespace tiltrotor {

// tanh(x) for |x| <= 5 within 4e-16 in double precision: Lambert's continued fraction x/(1 + x^2/(3 + x^2/(5 + ..))),
// NIST Digital Library 4.39.1.
template <class T>
T hyperbolic_tangent(const T& x) {
  using R = Real<T>;
  constexpr int levels = 20;
  T fraction = R(2 * levels + 1);
  for (int k = levels - 1; k >= 0; --k) fraction = static_cast<R>(2 * k + 1) + x * x / fraction;
  return x / fraction;
}

}  // namespace tiltrotor
