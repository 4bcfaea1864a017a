// sin, cos and atan2 for double, float and batches of them (batch.hpp): short, branch-free, the same bits on
// every target.
//
// Libraries differ in the last bits of these functions and in the time they take. Here each is one argument
// reduction and one polynomial (Chebyshev-fitted for the reduced interval), evaluated in a fixed order, so
// that a flight computed on a workstation and on a microcontroller agrees bit for bit when the compiler does
// not contract products and sums. Errors against the exact functions stay below 2 units in the last place
// (2.5 for float beyond one turn; tested), at zero crossings too, and for every finite x, y of the angle:
// where the angle itself is subnormal, below 2 units of the smallest number. Angles beyond kLargestAngle have
// lost their meaning to rounding and return NaN.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#include "tiltrotor/math/arithmetic.hpp"
#include "tiltrotor/math/differentiation/lanes.hpp"

namespace tiltrotor {

template <class T>
struct ScalarTraits;  // scalar.hpp

template <class R>
struct Elementary;

template <>
struct Elementary<double> {
  static constexpr double kLargestAngle = 1e8;  // rad
  // Sides of an angle, and sums of their squares, beyond which products overflow or lose digits, and the
  // factors that bring them back.
  static constexpr double kLargestSide = 0x1p1021, kSmallestSide = 0x1p-960;
  static constexpr double kLargestSquare = 0x1p1000, kSmallestSquare = 0x1p-900;
  static constexpr double kShrink = 0x1p-600, kEnlarge = 0x1p600;
  // pi/2 in parts short enough for exact products with the number of quarter turns.
  static constexpr double kHalfPi[3] = {1.5707963109016418, 1.5893254712295857e-08, 6.123233995736766e-17};
  static constexpr double kRoundToInteger = 6755399441055744.0;  // 1.5 * 2^52

  // (sin x / x - 1) / x^2, (cos x - 1 + x^2/2) / x^4 in z = x^2, |x| <= pi/4;
  // (atan x / x - 1) / x^2, |x| <= 0.237.
  template <class V>
  static V sine_tail(const V& z) {
    const V z2 = z * z;
    return (-0.16666666666666666 + z * 0.008333333333330948) +
           z2 * ((-0.00019841269836758574 + z * 2.7557316102552439e-06) +
                 z2 * (-2.5051131845003624e-08 + z * 1.5918129294866608e-10));
  }
  template <class V>
  static V cosine_tail(const V& z) {
    const V z2 = z * z;
    return (0.041666666666666664 + z * -0.0013888888888887398) +
           z2 * ((2.4801587298765689e-05 + z * -2.7557317271729793e-07) +
                 z2 * (2.0876146268403199e-09 + z * -1.1382632425521717e-11));
  }
  template <class V>
  static V arctangent_tail(const V& z) {
    const V z2 = z * z;
    const V low = (-0.3333333333333332 + z * 0.1999999999997088) +
                  z2 * (-0.14285714274772207 + z * 0.11111109541832018);
    const V high = (-0.090907982771159551 + z * 0.076880401178904503) +
                   z2 * (-0.065748615249686435 + z * 0.048329233169324429);
    return low + (z2 * z2) * high;
  }
  static constexpr double kArctangentHalf[2] = {0.46364760900080609, 2.2698777452961687e-17};
  static constexpr double kQuarterPi[2] = {0.78539816339744828, 3.061616997868383e-17};
  static constexpr double kHalf[2] = {1.5707963267948966, 6.123233995736766e-17};
  static constexpr double kWhole[2] = {3.1415926535897931, 1.2246467991473532e-16};

  template <class V>
  static V reduce(const V& x, const V& turns) {
    return ((x - turns * kHalfPi[0]) - turns * kHalfPi[1]) - turns * kHalfPi[2];
  }

  // Next to a zero crossing little is left of the angle, and the rounding of the last product shows: what the
  // reduced angle r is too large, from the third part of pi/2 in two.
  static constexpr double kCrossing = 0x1p-48;  // square of the largest such angle
  static constexpr double kHalfPiRest[2] = {6.123233932053594e-17, 6.36831716351095e-25};
  template <class V>
  static V reduction_excess(const V& x, const V& turns, const V& r) {
    const V exact = ((x - turns * kHalfPi[0]) - turns * kHalfPi[1]) - turns * kHalfPiRest[0];
    return (r - exact) + turns * kHalfPiRest[1];
  }
};

template <>
struct Elementary<float> {
  static constexpr float kLargestAngle = 1e4f;  // rad
  static constexpr float kLargestSide = 0x1p125f, kSmallestSide = 0x1p-100f;
  static constexpr float kLargestSquare = 0x1p120f, kSmallestSquare = 0x1p-100f;
  static constexpr float kShrink = 0x1p-70f, kEnlarge = 0x1p90f;
  static constexpr float kHalfPi[4] = {1.5703125f, 0.000483512878f, 3.13855708e-07f, 6.07710051e-11f};
  static constexpr float kRoundToInteger = 12582912.0f;  // 1.5 * 2^23

  template <class V>
  static V sine_tail(const V& z) {
    return -0.16666664662314379f + z * (0.0083327482706297487f + z * -0.00019587890880412386f);
  }
  template <class V>
  static V cosine_tail(const V& z) {
    return 0.0416666647f + z * (-0.0013888303f + z * 2.45479421e-05f);
  }
  template <class V>
  static V arctangent_tail(const V& z) {
    return -0.33333276333523681f + z * (0.19981632103467778f + z * -0.13398273118857207f);
  }
  static constexpr float kArctangentHalf[2] = {0.463647604f, 5.01215691e-09f};
  static constexpr float kQuarterPi[2] = {0.785398185f, -2.18556941e-08f};
  static constexpr float kHalf[2] = {1.57079637f, -4.37113883e-08f};
  static constexpr float kWhole[2] = {3.14159274f, -8.74227766e-08f};

  template <class V>
  static V reduce(const V& x, const V& turns) {
    return (((x - turns * kHalfPi[0]) - turns * kHalfPi[1]) - turns * kHalfPi[2]) - turns * kHalfPi[3];
  }

  static constexpr float kCrossing = 0;  // four parts are exact enough
  template <class V>
  static V reduction_excess(const V&, const V&, const V&) {
    return V(0.0f);
  }
};

// One of two plain numbers; lane by lane for batches.
template <class T>
T select(bool condition, const T& if_true, const T& if_false) {
  return condition ? if_true : if_false;
}
inline bool any(bool condition) { return condition; }

template <class V>
struct SineCosine {
  V sine, cosine;
};

// Both at once. |x| <= kLargestAngle, otherwise NaN. V: plain number or batch.
template <class V>
SineCosine<V> sine_cosine(const V& x) {
  using R = typename ScalarTraits<V>::Real;
  using E = Elementary<R>;
  const auto rounded = [](const V& a) { return (a + E::kRoundToInteger) - E::kRoundToInteger; };
  const R quarter_turn = R(0.63661977236758134308L);  // 2/pi
  const V turns = rounded(x * quarter_turn);
  const V r = E::reduce(x, turns);
  const V z = r * r;
  V s = r + r * (z * E::sine_tail(z));
  const auto crossing = z < V(E::kCrossing);
  if (any(crossing)) s = select(crossing, s - E::reduction_excess(x, turns, r), s);
  const V c = (R(1) - R(0.5) * z) + (z * z) * E::cosine_tail(z);
  // Quadrants 0, 1, 2 or -2, -1: whole turns taken off, which is exact.
  const V quadrant = turns - R(4) * rounded(turns * R(0.25));
  const V size = select(quadrant < R(0), -quadrant, quadrant);
  const auto odd = size == V(R(1));
  const V sine = select(odd, c, s);
  const V cosine = select(odd, s, c);
  const auto lower = (quadrant < R(0)) | (quadrant > R(1));
  const auto left = (quadrant > R(0)) | (quadrant < R(-1));
  const auto in_range = (x <= V(E::kLargestAngle)) & (x >= V(-E::kLargestAngle));
  const V nan = std::numeric_limits<R>::quiet_NaN();
  return {select(in_range, select(lower, -sine, sine), nan),
          select(in_range, select(left, -cosine, cosine), nan)};
}

// Angle of (x, y), -pi..pi, for finite arguments (0 at the origin); a zero y counts as positive whatever its
// sign. V: plain number or batch; in a batch the larger of |x|, |y| lies between kSmallestSide and kLargestSide
// or is zero, and that of the slopes below likewise by the square. _here: within the caller.
template <class V>
TILTROTOR_INLINE V arctangent2_here(const V& y, const V& x) {
  using R = typename ScalarTraits<V>::Real;
  using E = Elementary<R>;
  const V ax = select(x < R(0), -x, x);
  const V ay = select(y < R(0), -y, y);
  const auto steep = ay > ax;
  V high = select(steep, ay, ax);
  V low = select(steep, ax, ay);
  if constexpr (std::is_same_v<V, R>) {
    if (high == R(0)) return std::atan2(y, x);  // keeps the signs of zero
    if (high > E::kLargestSide || high < E::kSmallestSide) {
      const R unit = high > E::kLargestSide ? E::kShrink : E::kEnlarge;
      high *= unit;
      low *= unit;
    }
  }
  // Reduce by atan(1/2) or pi/4 so that |t| <= 0.237.
  const auto middle = low > R(0.236) * high;
  const auto upper = low > R(0.72) * high;
  const auto reduction = [&](R by_quarter_pi, R by_half) {
    return select(upper, V(by_quarter_pi), select(middle, V(by_half), V(R(0))));
  };
  const V slope = reduction(R(1), R(0.5));
  const V base = reduction(E::kQuarterPi[0], E::kArctangentHalf[0]);
  const V base_rest = reduction(E::kQuarterPi[1], E::kArctangentHalf[1]);
  const V length = high + slope * low;
  const V t = (low - slope * high) / select(length == V(R(0)), V(R(1)), length);
  const V z = t * t;
  V angle = base + (t + (base_rest + t * (z * E::arctangent_tail(z))));
  angle = select(steep, E::kHalf[0] - (angle - E::kHalf[1]), angle);
  angle = select(x < R(0), E::kWhole[0] - (angle - E::kWhole[1]), angle);
  return select(y < R(0), -angle, angle);
}
template <class V>
V arctangent2(const V& y, const V& x) {
  return arctangent2_here(y, x);
}

// Slopes of that angle along y and x: x / (x^2 + y^2) and -y / (x^2 + y^2), for every finite (x, y) but the
// origin, where they are no numbers; infinite when they exceed the largest number.
template <class V>
struct AngleSlopes {
  V along_y, along_x;
};
template <class V>
AngleSlopes<V> arctangent2_slopes(const V& y, const V& x) {
  using R = typename ScalarTraits<V>::Real;
  using E = Elementary<R>;
  const V square = x * x + y * y;
  if constexpr (std::is_same_v<V, R>) {
    const bool huge = square > E::kLargestSquare;
    if (huge || square < E::kSmallestSquare) {
      const R unit = huge ? E::kShrink : E::kEnlarge;
      const R u = x * unit;
      const R v = y * unit;
      const R inverse = R(1) / (std::fabs(u) > std::fabs(v) ? std::fabs(u) : std::fabs(v));
      const R a = u * inverse;  // of unit size: the products below neither vanish nor overflow on the way
      const R b = -v * inverse;
      const R rest = R(1) / (a * a + b * b);
      const R first = huge ? inverse : unit;
      const R last = huge ? unit : inverse;
      return {(a * rest * first) * last, (b * rest * first) * last};
    }
  }
  const V inverse = R(1) / square;
  return {x * inverse, -y * inverse};
}

}  // namespace tiltrotor
