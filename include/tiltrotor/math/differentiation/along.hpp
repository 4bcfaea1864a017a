// A number with its slope along one direction, in the place of the plain numbers of the model: aircraft and tables of
// such numbers give A and B of duals of them, and with them d A / d p, exact as A is.
//
//   Aircraft<Along> aircraft = ..;  aircraft.htail.surface.area *= Along(1, 0.01);  // per cent
//
// Order and indices look at the value, equality at both. What works on such numbers includes this.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

namespace tiltrotor {

struct Along {
  double v;  // value
  double d;  // slope

  Along() = default;
  template <class X, class = std::enable_if_t<std::is_arithmetic_v<X>>>
  constexpr Along(X x)
      : v(static_cast<double>(x)), d(0) {}  // NOLINT(google-explicit-constructor): a constant
  constexpr Along(double x, double slope) : v(x), d(slope) {}
  constexpr explicit operator double() const { return v; }
  constexpr explicit operator float() const { return static_cast<float>(v); }
  constexpr explicit operator int() const { return static_cast<int>(v); }
  constexpr explicit operator long() const { return static_cast<long>(v); }

  friend constexpr Along operator-(Along a) { return {-a.v, -a.d}; }
  friend constexpr Along operator+(Along a, Along b) { return {a.v + b.v, a.d + b.d}; }
  friend constexpr Along operator-(Along a, Along b) { return {a.v - b.v, a.d - b.d}; }
  // (a b)' = b a' + a b'
  friend constexpr Along operator*(Along a, Along b) { return {a.v * b.v, b.v * a.d + a.v * b.d}; }
  // (a / b)' = (a' - (a / b) b') / b
  friend constexpr Along operator/(Along a, Along b) { return {a.v / b.v, (a.d - a.v / b.v * b.d) / b.v}; }
  constexpr Along& operator+=(Along b) { return *this = *this + b; }
  constexpr Along& operator-=(Along b) { return *this = *this - b; }
  constexpr Along& operator*=(Along b) { return *this = *this * b; }
  constexpr Along& operator/=(Along b) { return *this = *this / b; }
  friend constexpr bool operator<(Along a, Along b) { return a.v < b.v; }
  friend constexpr bool operator>(Along a, Along b) { return a.v > b.v; }
  friend constexpr bool operator<=(Along a, Along b) { return a.v <= b.v; }
  friend constexpr bool operator>=(Along a, Along b) { return a.v >= b.v; }
  // The same number with the same slope: where one of them stands for the other, or is left out for a zero.
  friend constexpr bool operator==(Along a, Along b) { return a.v == b.v && a.d == b.d; }
  friend constexpr bool operator!=(Along a, Along b) { return !(a == b); }

  friend Along fabs(Along a) { return a.v < 0 ? -a : a; }
  friend Along abs(Along a) { return fabs(a); }
  friend Along floor(Along a) { return {std::floor(a.v)}; }
  friend Along sqrt(Along a) {
    const double root = std::sqrt(a.v);
    return {root, 0.5 / root * a.d};
  }
};

}  // namespace tiltrotor

template <>
struct std::numeric_limits<tiltrotor::Along> : std::numeric_limits<double> {};

#include "tiltrotor/math/differentiation/lanes.hpp"

namespace tiltrotor {

template <>
inline constexpr int kWidestLanes<Along> = 1;

}  // namespace tiltrotor

#include "tiltrotor/math/differentiation/batch.hpp"
#include "tiltrotor/math/tables/table.hpp"

namespace tiltrotor {

template <>
struct StoredSlope<Along> {
  using type = Along;
};

template <>
inline constexpr int kWidestLanes<Batch<Along>> = 1;

// A zero of it may have a slope.
template <>
inline constexpr bool kIsNumber<Along> = false;
template <>
inline Along without_slope(const Along& x) {
  return {x.v};
}

template <>
struct Elementary<Along> : Elementary<double> {};

template <>
inline bool is_ieee_arithmetic<Along>() {
  return is_ieee_arithmetic<double>();
}

template <>
inline SineCosine<Along> sine_cosine(const Along& x) {
  const SineCosine<double> f = sine_cosine(x.v);
  return {{f.sine, f.cosine * x.d}, {f.cosine, -f.sine * x.d}};
}
template <>
inline Along arctangent2(const Along& y, const Along& x) {
  const AngleSlopes<double> slope = arctangent2_slopes(y.v, x.v);
  return {arctangent2(y.v, x.v), slope.along_y * y.d + slope.along_x * x.d};
}
template <>
inline Along arctangent2_here(const Along& y, const Along& x) {
  return arctangent2(y, x);
}
template <>
inline AngleSlopes<Along> arctangent2_slopes(const Along& y, const Along& x) {
  const Along inverse = Along(1) / (x * x + y * y);
  return {x * inverse, -y * inverse};
}

template <>
inline SineCosine<Batch<Along>> sine_cosine(const Batch<Along>& x) {
  const SineCosine<Along> f = sine_cosine(x.get(0));
  return {Batch<Along>(f.sine), Batch<Along>(f.cosine)};
}
template <>
inline Batch<Along> arctangent2(const Batch<Along>& y, const Batch<Along>& x) {
  return Batch<Along>(arctangent2(y.get(0), x.get(0)));
}
template <>
inline Batch<Along> arctangent2_here(const Batch<Along>& y, const Batch<Along>& x) {
  return arctangent2(y, x);
}
template <>
inline AngleSlopes<Batch<Along>> arctangent2_slopes(const Batch<Along>& y, const Batch<Along>& x) {
  const AngleSlopes<Along> slope = arctangent2_slopes(y.get(0), x.get(0));
  return {Batch<Along>(slope.along_y), Batch<Along>(slope.along_x)};
}

}  // namespace tiltrotor
