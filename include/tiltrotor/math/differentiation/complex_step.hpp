// std::complex as a scalar of the model: with an imaginary step of 1e-30 the imaginary part of the result
// over the step is the derivative to rounding, by arithmetic that shares nothing with the dual numbers.
#pragma once

#include <complex>

#include "tiltrotor/math/scalar.hpp"

namespace tiltrotor {

template <class R>
struct ScalarTraits<std::complex<R>> {
  using Real = R;
  using T = std::complex<R>;
  static constexpr bool kTakesSlopes = false;

  static R value(const T& x) { return x.real(); }
  static T sqrt(const T& x) { return std::sqrt(x); }
  static T sin(const T& x) { return std::sin(x); }
  static T cos(const T& x) { return std::cos(x); }
  // First-order extension of the real function: exact for the infinitesimal steps this scalar is used with.
  static T atan2(const T& y, const T& x) {
    const AngleSlopes<R> slope = arctangent2_slopes(y.real(), x.real());
    return {std::atan2(y.real(), x.real()), slope.along_y * y.imag() + slope.along_x * x.imag()};
  }
};

}  // namespace tiltrotor
