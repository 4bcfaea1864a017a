// The one door to elementary functions, for every scalar the model runs on: double, float, Dual, and
// std::complex (complex-step differentiation, an independent check of the dual numbers).
// A target that brings its own mathematics library changes ScalarTraits here and nothing else.
#pragma once

#include <cmath>
#include <type_traits>

#include "tiltrotor/math/elementary.hpp"

namespace tiltrotor {

// Plain numbers. Other scalars specialise this: dual.hpp, complex_step.hpp.
template <class T>
struct ScalarTraits {
  using Real = T;
  static T value(T x) { return x; }
  static T sqrt(T x) {
    using std::sqrt;
    return sqrt(x);
  }
  static T sin(T x) { return sine_cosine(x).sine; }
  static T cos(T x) { return sine_cosine(x).cosine; }
  static T atan2(T y, T x) { return arctangent2(y, x); }
  static constexpr bool kTakesSlopes = false;  // see Dual
};

template <class T>
using Real = typename ScalarTraits<T>::Real;

// What aircraft and tables are made of.
template <class T>
inline constexpr bool kIsPlain = std::is_same_v<T, Real<T>>;

// A number and nothing else. Only of such a one may zero mean "leave it out", or an end value "take the end
// alone": the partials of another scalar would be lost, and the slope of along.hpp.
template <class T>
inline constexpr bool kIsNumber = kIsPlain<T>;

// Of a value that has a slope itself (along.hpp), the number.
template <class R>
R without_slope(const R& x) {
  return x;
}

// Plain value of any scalar: the only part a comparison or an index may look at. Of a batch (batch.hpp), the
// batch.
template <class T>
auto value(const T& x) {
  return ScalarTraits<T>::value(x);
}
template <class T>
T sqrt(const T& x) {
  return ScalarTraits<T>::sqrt(x);
}
template <class T>
T sin(const T& x) {
  return ScalarTraits<T>::sin(x);
}
template <class T>
T cos(const T& x) {
  return ScalarTraits<T>::cos(x);
}
// Both, where both are needed: one reduction of the angle for plain numbers, and for duals and batches of them.
template <class T>
SineCosine<T> sine_and_cosine(const T& x) {
  if constexpr (kIsPlain<T>) {
    return sine_cosine(x);
  } else {
    return {sin(x), cos(x)};
  }
}
template <class T>
T tan(const T& x) {
  return sin(x) / cos(x);
}
// Angle of the point (x, y), -pi..pi.
template <class T>
TILTROTOR_INLINE T atan2(const T& y, const T& x) {
  return ScalarTraits<T>::atan2(y, x);
}
template <class T>
T square(const T& x) {
  return x * x;
}

// sqrt(x^2 + y^2) of plain numbers, also where the squares overflow or vanish; infinite beyond the range.
template <class R>
R length_of(R x, R y) {
  const R square = x * x + y * y;
  const bool huge = !(square <= Elementary<R>::kLargestSquare);
  if (!huge && square >= Elementary<R>::kSmallestSquare) return std::sqrt(square);
  const R unit = huge ? Elementary<R>::kShrink : Elementary<R>::kEnlarge;
  return std::sqrt((x * unit) * (x * unit) + (y * unit) * (y * unit)) / unit;
}

// Ends included; false for NaN.
template <class R>
constexpr bool is_within(R x, R low, R high) {
  return x >= low && x <= high;
}

template <class R>
inline constexpr R kPi = static_cast<R>(3.14159265358979323846264338327950288L);
template <class R>
inline constexpr R kRadPerDeg = kPi<R> / R(180);  // one degree in radians
template <class R>
inline constexpr R kDegPerRad = R(180) / kPi<R>;  // one radian in degrees

}  // namespace tiltrotor
