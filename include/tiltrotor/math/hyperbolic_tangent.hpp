// Hyperbolic tangent, with the same bits on every machine: of a plain number, and of any scalar over its argument.
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

// tanh(x)/x from x^2, for every x within 1e-15 of the ratio: exact derivatives, also at rest. The same fraction at x/16,
// then tanh(2 y) = 2 tanh(y)/(1 + tanh(y)^2). From |x| = 20 on tanh is 1 to rounding.
template <class T>
T hyperbolic_tangent_over(const T& x2) {
  using R = Real<T>;
  if (value(x2) >= R(400)) return R(1) / sqrt(x2);
  T y2 = x2 * (R(1) / R(256));
  constexpr int levels = 8;
  T fraction = T(R(2 * levels + 1));
  for (int k = levels - 1; k >= 0; --k) fraction = static_cast<R>(2 * k + 1) + y2 / fraction;
  T ratio = R(1) / fraction;
  for (int doubled = 0; doubled < 4; ++doubled) {
    ratio = ratio / (R(1) + y2 * square(ratio));
    y2 = R(4) * y2;
  }
  return ratio;
}

}  // namespace tiltrotor
