// Smooth stand-ins for |x|, max, min, clip and switches: C1 or better, exact derivatives.
// Every width e is an absolute physical scale with a name in tables/<aircraft>/choices.csv.
// Range: |x| up to 1e150 (1e18 in float), e from 1e-150 (1e-18); beyond, the square under the root overflows
// or vanishes. Errors are a few units in the last place of the larger of |x| and e: where smooth_positive is
// nearly zero it keeps no digits of its own.
#pragma once

#include "tiltrotor/math/scalar.hpp"

namespace tiltrotor {

// sqrt(x^2 + e^2): |x| for |x| >> e, e at 0.
template <class T>
T smooth_abs(const T& x, Real<T> e) {
  return sqrt(x * x + e * e);
}
// sqrt(x^2 + e^2) - e: |x| with zero at 0.
template <class T>
T smooth_abs_zero(const T& x, Real<T> e) {
  return smooth_abs(x, e) - e;
}
// max(x, 0).
template <class T>
T smooth_positive(const T& x, Real<T> e) {
  return Real<T>(0.5) * (x + sqrt(x * x + e * e));
}
// max(x, bound).
template <class T>
T smooth_max(const T& x, Real<T> bound, Real<T> e) {
  return bound + smooth_positive(x - bound, e);
}
// min(x, bound).
template <class T>
T smooth_min(const T& x, Real<T> bound, Real<T> e) {
  return x - smooth_positive(x - bound, e);
}
// x clipped to low..high.
template <class T>
T smooth_clip(const T& x, Real<T> low, Real<T> high, Real<T> e) {
  return low + smooth_positive(x - low, e) - smooth_positive(x - high, e);
}
// 0 for t <= 0, 1 for t >= 1, the quintic t^3 (10 - 15 t + 6 t^2) between: C2.
// The choice is safe: value, slope and curvature agree where the pieces meet.
template <class T>
T smooth_step(const T& t) {
  using R = Real<T>;
  const auto v = value(t);
  const T quintic = t * t * t * (R(10) + t * (R(-15) + R(6) * t));
  return select(v > R(0), select(v < R(1), quintic, T(R(1))), T(R(0) * t));
}
// max(x, 0), exactly so outside |x| < e/2: C3. Its slope is smooth_step(x/e + 1/2).
template <class T>
T smooth_ramp(const T& x, Real<T> e) {
  using R = Real<T>;
  const T t = x * (R(1) / e) + R(0.5);
  const auto v = value(t);
  const T between = (e * t * t) * (t * t) * (R(2.5) + t * (t - R(3)));
  return select(v > R(0), select(v < R(1), between, x), T(R(0) * x));
}

// x brought to -pi..pi by any number of whole turns: the derivative is that of x.
template <class T>
T wrapped(const T& x) {
  using R = Real<T>;
  using std::floor;
  const R turn = R(2) * kPi<R>;
  return x - turn * floor(value(x) / turn + R(0.5));
}
// a - b brought to -pi..pi by whole turns: the derivative is that of the plain difference.
template <class T>
T wrapped_difference(const T& a, const T& b) {
  using R = Real<T>;
  const T difference = a - b;
  const auto v = value(difference);
  const R turn = R(2) * kPi<R>;
  return select(v > kPi<R>, T(difference - turn), select(v < -kPi<R>, T(difference + turn), difference));
}

}  // namespace tiltrotor
