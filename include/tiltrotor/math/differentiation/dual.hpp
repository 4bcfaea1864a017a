// Forward-mode dual number: a value and its N partial derivatives, carried exactly through every operation.
//
// The value part is computed by the same operations as a plain number, so it equals the plain evaluation
// bit for bit. Points where a function has no derivative are left to IEEE arithmetic on purpose: sqrt at 0
// and atan2 at (0, 0) return infinite or NaN partials, which the library's boundary reports, instead of a
// silently lost derivative. Nothing here branches on a derivative.
//
// Range: partials are as exact as their rule where its factors are normal numbers, in a quotient 1/b, a/b and
// a/b^2; atan2 scales by itself. With values between 1e-150 and 1e150 (1e-18 and 1e18 in float) all are.
#pragma once

#include "tiltrotor/math/differentiation/lanes.hpp"
#include "tiltrotor/math/scalar.hpp"

namespace tiltrotor {

template <class R, int N>
struct Dual {
  static constexpr int kPartials = N;
  R v;               // value
  Partials<R, N> d;  // partial derivatives

  Dual() = default;
  Dual(R x) : v(x), d(Partials<R, N>::zero()) {}  // NOLINT(google-explicit-constructor): a constant
  Dual(R x, const Partials<R, N>& dx) : v(x), d(dx) {}
  Dual& operator=(R x) {
    v = x;
    d = Partials<R, N>::zero();
    return *this;
  }
  template <class Group>
  Dual(R x, const PartialsRule<R, N, Group>& dx) : v(x), d(dx) {}

  // The independent variable number `direction`.
  static Dual variable(R x, int direction) {
    Dual r(x);
    r.d.set(direction, R(1));
    return r;
  }

  friend Dual operator-(const Dual& a) { return {-a.v, scaled(R(-1), a.d)}; }

  friend Dual operator+(const Dual& a, const Dual& b) { return {a.v + b.v, a.d + b.d}; }
  friend Dual operator+(const Dual& a, R b) { return {a.v + b, a.d}; }
  friend Dual operator+(R a, const Dual& b) { return {a + b.v, b.d}; }

  friend Dual operator-(const Dual& a, const Dual& b) { return {a.v - b.v, a.d - b.d}; }
  friend Dual operator-(const Dual& a, R b) { return {a.v - b, a.d}; }
  friend Dual operator-(R a, const Dual& b) { return {a - b.v, scaled(R(-1), b.d)}; }

  // (a b)' = b a' + a b'
  friend Dual operator*(const Dual& a, const Dual& b) { return {a.v * b.v, combined(b.v, a.d, a.v, b.d)}; }
  friend Dual operator*(const Dual& a, R b) { return {a.v * b, scaled(b, a.d)}; }
  friend Dual operator*(R a, const Dual& b) { return {a * b.v, scaled(a, b.d)}; }

  // (a / b)' = a' / b - (a / b) b' / b
  friend Dual operator/(const Dual& a, const Dual& b) {
    const R inverse = R(1) / b.v;
    const R quotient = a.v / b.v;
    return {quotient, combined(inverse, a.d, -quotient * inverse, b.d)};
  }
  friend Dual operator/(const Dual& a, R b) { return {a.v / b, scaled(R(1) / b, a.d)}; }
  friend Dual operator/(R a, const Dual& b) {
    const R quotient = a / b.v;
    return {quotient, scaled(-quotient / b.v, b.d)};
  }

  Dual& operator+=(const Dual& b) {
    d = d + b.d;
    v = v + b.v;
    return *this;
  }
  Dual& operator-=(const Dual& b) {
    d = d - b.d;
    v = v - b.v;
    return *this;
  }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator*=(R b) { return *this = *this * b; }
};

template <class R, int N>
SineCosine<Dual<R, N>> sine_and_cosine(const Dual<R, N>& x) {
  const SineCosine<R> f = sine_cosine(x.v);
  return {{f.sine, scaled(f.cosine, x.d)}, {f.cosine, scaled(-f.sine, x.d)}};
}

template <class R, int N>
struct ScalarTraits<Dual<R, N>> {
  using Real = typename ScalarTraits<R>::Real;
  using T = Dual<R, N>;

  static R value(const T& x) { return x.v; }
  // sqrt' = 1 / (2 sqrt)
  static T sqrt(const T& x) {
    const R root = ScalarTraits<R>::sqrt(x.v);
    return {root, scaled(R(0.5) / root, x.d)};
  }
  // sin' = cos
  static T sin(const T& x) {
    const SineCosine<R> f = sine_cosine(x.v);
    return {f.sine, scaled(f.cosine, x.d)};
  }
  // cos' = -sin
  static T cos(const T& x) {
    const SineCosine<R> f = sine_cosine(x.v);
    return {f.cosine, scaled(-f.sine, x.d)};
  }
  // atan2(y, x)' = (x y' - y x') / (x^2 + y^2)
  static T atan2(const T& y, const T& x) {
    const AngleSlopes<R> slope = arctangent2_slopes(y.v, x.v);
    return {ScalarTraits<R>::atan2(y.v, x.v), combined(slope.along_y, y.d, slope.along_x, x.d)};
  }

  // Result of a function whose value and slopes are known: touches the partials once.
  static constexpr bool kTakesSlopes = true;
  template <int Arguments>
  static T from_slopes(R value, const R* slope, const T* const* x) {
    if constexpr (Arguments == 1) {
      return {value, scaled(slope[0], x[0]->d)};
    } else {
      T result(value, combined(slope[0], x[0]->d, slope[1], x[1]->d));
      for (int a = 2; a < Arguments; ++a) result.d = combined(R(1), result.d, slope[a], x[a]->d);
      return result;
    }
  }
};

}  // namespace tiltrotor
