// Natural logarithm, with the same bits on every machine.
#pragma once

#include "tiltrotor/math/scalar.hpp"

namespace tiltrotor {

// ln(x) for 1e-30 < x < 1e30 within 4e-16 of max(1, |ln x|) in double precision: powers of two taken out until x lies
// within sqrt(2) of 1, then 2 artanh((x - 1)/(x + 1)) by its series, NIST Digital Library 4.6.4 and 4.37.24.
template <class T>
T logarithm(const T& x) {
  using R = Real<T>;
  constexpr R ln_2 = R(0.693147180559945309417232121458), root_2 = R(1.41421356237309504880168872421);
  constexpr int most_halvings = 100, terms = 12;
  R by = R(1), halved = R(0);
  for (int k = 0; k < most_halvings && value(x) * by > root_2; ++k, halved += R(1)) by *= R(0.5);
  for (int k = 0; k < most_halvings && value(x) * by < R(1) / root_2; ++k, halved -= R(1)) by *= R(2);
  const T near = by * x;
  const T t = (near - R(1)) / (near + R(1)), t2 = square(t);
  T sum = T(R(1) / R(2 * terms - 1));
  for (int k = terms - 2; k >= 0; --k) sum = R(1) / static_cast<R>(2 * k + 1) + t2 * sum;
  return halved * ln_2 + R(2) * t * sum;
}

}  // namespace tiltrotor
