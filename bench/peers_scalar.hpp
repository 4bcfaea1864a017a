// A differentiating number type of another library as scalar of the model.
//
// Libraries with expression templates return unevaluated expressions, which a model written for any scalar T
// cannot hold; Foreign evaluates every operation at once. PeerRules says how to read the type and how to
// build the result of a table look-up from its value and slopes: the peers get the same one-pass look-up as
// our own dual numbers.
#pragma once

#include <cmath>

#include "peers_blades.hpp"

namespace bench {

// static double value(const Number&);
// static Number from_slopes(double value, int count, const double* slope, const Foreign<Number>* const* x);
template <class Number>
struct PeerRules;

template <class Number>
struct Foreign {
  Number n;

  Foreign() = default;
  Foreign(double x) : n(x) {}  // NOLINT(google-explicit-constructor): a constant
  static Foreign of(const Number& number) {
    Foreign f;
    f.n = number;
    return f;
  }

  friend Foreign operator-(const Foreign& a) { return of(-a.n); }
  friend Foreign operator+(const Foreign& a, const Foreign& b) { return of(a.n + b.n); }
  friend Foreign operator+(const Foreign& a, double b) { return of(a.n + b); }
  friend Foreign operator+(double a, const Foreign& b) { return of(a + b.n); }
  friend Foreign operator-(const Foreign& a, const Foreign& b) { return of(a.n - b.n); }
  friend Foreign operator-(const Foreign& a, double b) { return of(a.n - b); }
  friend Foreign operator-(double a, const Foreign& b) { return of(a - b.n); }
  friend Foreign operator*(const Foreign& a, const Foreign& b) { return of(a.n * b.n); }
  friend Foreign operator*(const Foreign& a, double b) { return of(a.n * b); }
  friend Foreign operator*(double a, const Foreign& b) { return of(a * b.n); }
  friend Foreign operator/(const Foreign& a, const Foreign& b) { return of(a.n / b.n); }
  friend Foreign operator/(const Foreign& a, double b) { return of(a.n / b); }
  friend Foreign operator/(double a, const Foreign& b) { return of(a / b.n); }
  Foreign& operator+=(const Foreign& b) {
    n += b.n;
    return *this;
  }
  Foreign& operator-=(const Foreign& b) {
    n -= b.n;
    return *this;
  }
  Foreign& operator*=(const Foreign& b) {
    n *= b.n;
    return *this;
  }
};

}  // namespace bench

namespace tiltrotor {

template <class Number>
struct ScalarTraits<bench::Foreign<Number>> {
  using Real = double;
  using T = bench::Foreign<Number>;
  static double value(const T& x) { return bench::PeerRules<Number>::value(x.n); }
  static T sqrt(const T& x) {
    using std::sqrt;
    return T::of(sqrt(x.n));
  }
  static T sin(const T& x) {
    using std::sin;
    return T::of(sin(x.n));
  }
  static T cos(const T& x) {
    using std::cos;
    return T::of(cos(x.n));
  }
  static T atan2(const T& y, const T& x) {
    using std::atan2;
    return T::of(atan2(y.n, x.n));
  }
  static constexpr bool kTakesSlopes = true;
  template <int Arguments>
  static T from_slopes(double value, const double* slope, const T* const* x) {
    return T::of(bench::PeerRules<Number>::from_slopes(value, Arguments, slope, x));
  }
};

template <class Number>
class BladeGroup<bench::Foreign<Number>> : public bench::SingleBlades<bench::Foreign<Number>> {};

}  // namespace tiltrotor
