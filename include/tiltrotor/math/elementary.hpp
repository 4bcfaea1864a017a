// sin, cos and atan2 for double and float: short, branch-free, the same bits on every target.
//
// Libraries differ in the last bits of these functions and in the time they take. Here each is one argument
// reduction and one polynomial (Chebyshev-fitted for the reduced interval), evaluated in a fixed order, so that a
// flight computed on a workstation and on a microcontroller agrees bit for bit when the compiler does not contract
// products and sums. Errors against the exact functions stay below 2 units in the last place (2.5 for
// float beyond one turn; tested).
// Angles beyond kLargestAngle have lost their meaning to rounding and return NaN.
#pragma once

#include <cmath>
#include <limits>

namespace tiltrotor {

template <class R>
struct Elementary;

template <>
struct Elementary<double> {
  static constexpr double kLargestAngle = 1e8;  // rad
  // pi/2 in parts short enough for exact products with the number of quarter turns.
  static constexpr double kHalfPi[3] = {1.5707963109016418, 1.5893254712295857e-08, 6.123233995736766e-17};
  static constexpr double kRoundToInteger = 6755399441055744.0;  // 1.5 * 2^52

  // (sin x / x - 1) / x^2, (cos x - 1 + x^2/2) / x^4 in z = x^2, |x| <= pi/4;  (atan x / x - 1) / x^2, |x| <= 0.237.
  static double sine_tail(double z) {
    const double z2 = z * z;
    return (-0.16666666666666666 + z * 0.008333333333330948) +
           z2 * ((-0.00019841269836758574 + z * 2.7557316102552439e-06) +
                 z2 * (-2.5051131845003624e-08 + z * 1.5918129294866608e-10));
  }
  static double cosine_tail(double z) {
    const double z2 = z * z;
    return (0.041666666666666664 + z * -0.0013888888888887398) +
           z2 * ((2.4801587298765689e-05 + z * -2.7557317271729793e-07) +
                 z2 * (2.0876146268403199e-09 + z * -1.1382632425521717e-11));
  }
  static double arctangent_tail(double z) {
    const double z2 = z * z;
    const double low = (-0.3333333333333332 + z * 0.1999999999997088) +
                       z2 * (-0.14285714274772207 + z * 0.11111109541832018);
    const double high = (-0.090907982771159551 + z * 0.076880401178904503) +
                        z2 * (-0.065748615249686435 + z * 0.048329233169324429);
    return low + (z2 * z2) * high;
  }
  static constexpr double kArctangentHalf[2] = {0.46364760900080609, 2.2698777452961687e-17};
  static constexpr double kQuarterPi[2] = {0.78539816339744828, 3.061616997868383e-17};
  static constexpr double kHalf[2] = {1.5707963267948966, 6.123233995736766e-17};
  static constexpr double kWhole[2] = {3.1415926535897931, 1.2246467991473532e-16};

  static double reduce(double x, double turns) {
    return ((x - turns * kHalfPi[0]) - turns * kHalfPi[1]) - turns * kHalfPi[2];
  }
};

template <>
struct Elementary<float> {
  static constexpr float kLargestAngle = 1e4f;  // rad
  static constexpr float kHalfPi[4] = {1.5703125f, 0.000483512878f, 3.13855708e-07f, 6.07710051e-11f};
  static constexpr float kRoundToInteger = 12582912.0f;  // 1.5 * 2^23

  static float sine_tail(float z) {
    return -0.16666664662314379f + z * (0.0083327482706297487f + z * -0.00019587890880412386f);
  }
  static float cosine_tail(float z) {
    return 0.0416666647f + z * (-0.0013888303f + z * 2.45479421e-05f);
  }
  static float arctangent_tail(float z) {
    return -0.33333276333523681f + z * (0.19981632103467778f + z * -0.13398273118857207f);
  }
  static constexpr float kArctangentHalf[2] = {0.463647604f, 5.01215691e-09f};
  static constexpr float kQuarterPi[2] = {0.785398185f, -2.18556941e-08f};
  static constexpr float kHalf[2] = {1.57079637f, -4.37113883e-08f};
  static constexpr float kWhole[2] = {3.14159274f, -8.74227766e-08f};

  static float reduce(float x, float turns) {
    return (((x - turns * kHalfPi[0]) - turns * kHalfPi[1]) - turns * kHalfPi[2]) - turns * kHalfPi[3];
  }
};

template <class R>
struct SineCosine {
  R sine, cosine;
};

// Both at once. |x| <= kLargestAngle, otherwise NaN.
template <class R>
SineCosine<R> sine_cosine(R x) {
  using E = Elementary<R>;
  if (!(x <= E::kLargestAngle && x >= -E::kLargestAngle)) {
    return {std::numeric_limits<R>::quiet_NaN(), std::numeric_limits<R>::quiet_NaN()};
  }
  const R quarter_turn = R(0.63661977236758134308L);  // 2/pi
  const R turns = (x * quarter_turn + E::kRoundToInteger) - E::kRoundToInteger;
  const R r = E::reduce(x, turns);
  const R z = r * r;
  const R s = r + r * (z * E::sine_tail(z));
  const R c = (R(1) - R(0.5) * z) + (z * z) * E::cosine_tail(z);
  const int quadrant = static_cast<int>(turns) & 3;
  const bool swap = (quadrant & 1) != 0;
  const R sine = swap ? c : s;
  const R cosine = swap ? s : c;
  return {(quadrant & 2) != 0 ? -sine : sine, ((quadrant + 1) & 2) != 0 ? -cosine : cosine};
}

// Angle of (x, y), -pi..pi, as std::atan2 for finite arguments (0 at the origin).
template <class R>
R arctangent2(R y, R x) {
  using E = Elementary<R>;
  const R ax = x < R(0) ? -x : x;
  const R ay = y < R(0) ? -y : y;
  const bool steep = ay > ax;
  const R high = steep ? ay : ax;
  const R low = steep ? ax : ay;
  if (high == R(0)) return std::atan2(y, x);  // keeps the signs of zero
  // Reduce by atan(1/2) or pi/4 so that |t| <= 0.237.
  const bool middle = low > R(0.236) * high;
  const bool upper = low > R(0.72) * high;
  const R slope = upper ? R(1) : (middle ? R(0.5) : R(0));
  const R base = upper ? E::kQuarterPi[0] : (middle ? E::kArctangentHalf[0] : R(0));
  const R base_rest = upper ? E::kQuarterPi[1] : (middle ? E::kArctangentHalf[1] : R(0));
  const R t = (low - slope * high) / (high + slope * low);
  const R z = t * t;
  R angle = base + (t + (base_rest + t * (z * E::arctangent_tail(z))));
  if (steep) angle = E::kHalf[0] - (angle - E::kHalf[1]);
  if (x < R(0)) angle = E::kWhole[0] - (angle - E::kWhole[1]);
  return y < R(0) ? -angle : angle;
}

}  // namespace tiltrotor
