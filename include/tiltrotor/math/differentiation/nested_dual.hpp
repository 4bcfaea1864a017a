// Second derivatives along one direction: a dual number of one direction over dual numbers.
//
//   using D = Dual<double, 2>;
//   Nested<D> x = {D::variable(3, 0), D(1)}, y = {D::variable(2, 1), D(0)};   // x moves along the direction
//   (x * x * y).along.v          // 2 x y: slope along the direction
//   (x * x * y).along.d.get(1)   // 2 x:   the slope's own partial by y
//
// `v` carries value and partials as a Dual does, `along` the slope of each of these along the direction. Every rule
// is that of a dual number written in D, hence exact to rounding; as with Dual nothing branches on a derivative.
// Tables give their second derivative: on the knots of a C1 table it jumps, and is that of the interval above.
#pragma once

#include "tiltrotor/math/differentiation/dual.hpp"

namespace tiltrotor {

template <class D>
struct Nested {
  using R = Real<D>;
  D v, along;

  Nested() = default;
  Nested(R x) : v(x), along(R(0)) {}  // NOLINT(google-explicit-constructor): a constant
  Nested(const D& x, const D& slope) : v(x), along(slope) {}

  friend Nested operator-(const Nested& a) { return {-a.v, -a.along}; }

  friend Nested operator+(const Nested& a, const Nested& b) { return {a.v + b.v, a.along + b.along}; }
  friend Nested operator+(const Nested& a, R b) { return {a.v + b, a.along}; }
  friend Nested operator+(R a, const Nested& b) { return {a + b.v, b.along}; }

  friend Nested operator-(const Nested& a, const Nested& b) { return {a.v - b.v, a.along - b.along}; }
  friend Nested operator-(const Nested& a, R b) { return {a.v - b, a.along}; }
  friend Nested operator-(R a, const Nested& b) { return {a - b.v, -b.along}; }

  friend Nested operator*(const Nested& a, const Nested& b) {
    return {a.v * b.v, a.along * b.v + a.v * b.along};
  }
  friend Nested operator*(const Nested& a, R b) { return {a.v * b, a.along * b}; }
  friend Nested operator*(R a, const Nested& b) { return {a * b.v, a * b.along}; }

  // (a / b)' = (a' - (a / b) b') / b
  friend Nested operator/(const Nested& a, const Nested& b) {
    const D quotient = a.v / b.v;
    return {quotient, (a.along - quotient * b.along) / b.v};
  }
  friend Nested operator/(const Nested& a, R b) { return {a.v / b, a.along / b}; }
  friend Nested operator/(R a, const Nested& b) {
    const D quotient = a / b.v;
    return {quotient, -(quotient * b.along) / b.v};
  }

  Nested& operator+=(const Nested& b) { return *this = *this + b; }
  Nested& operator-=(const Nested& b) { return *this = *this - b; }
  Nested& operator*=(const Nested& b) { return *this = *this * b; }
  Nested& operator*=(R b) { return *this = *this * b; }
};

template <class D>
struct ScalarTraits<Nested<D>> {
  using Real = typename ScalarTraits<D>::Real;
  using T = Nested<D>;
  static constexpr bool kTakesSlopes = false;  // tables and blades run on the scalar itself

  static Real value(const T& x) { return ScalarTraits<D>::value(x.v); }
  static T sqrt(const T& x) {
    const D root = tiltrotor::sqrt(x.v);
    return {root, x.along * (Real(0.5) / root)};
  }
  static T sin(const T& x) { return {tiltrotor::sin(x.v), tiltrotor::cos(x.v) * x.along}; }
  static T cos(const T& x) { return {tiltrotor::cos(x.v), -(tiltrotor::sin(x.v) * x.along)}; }
  static T atan2(const T& y, const T& x) {
    const D slope = Real(1) / (x.v * x.v + y.v * y.v);
    return {tiltrotor::atan2(y.v, x.v), (x.v * y.along - y.v * x.along) * slope};
  }
};

// One pass of a function that sees few numbers: its local result, of In partials, chained to the N of its inputs.
template <class R, int In, int N>
Nested<Dual<R, N>> chain(const Nested<Dual<R, In>>& local, const Nested<Dual<R, N>>* input) {
  using D = Dual<R, N>;
  D v(local.v.v), along(local.along.v);
  for (int j = 0; j < In; ++j) {
    v.d = combined(R(1), v.d, local.v.d.get(j), input[j].v.d);
    along.d = combined(R(1), along.d, local.along.d.get(j), input[j].v.d);
    along.d = combined(R(1), along.d, local.v.d.get(j), input[j].along.d);
  }
  return {v, along};
}

}  // namespace tiltrotor
