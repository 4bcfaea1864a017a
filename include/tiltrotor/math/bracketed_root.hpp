// Root of one equation between two ends of different sign.
#pragma once

#include "tiltrotor/math/scalar.hpp"

namespace tiltrotor {

// x in a..b with f(x) = 0, f continuous. Regula falsi that halves the weight of an end kept twice (Illinois
// method: Dowell and Jarratt, BIT 11 (1971) 168). Ends when a step is below `width`, or after 60; ends of one
// sign give the better of them.
template <class R, class F>
R bracketed_root(F&& f, R a, R b, R width) {
  using std::abs;
  constexpr int most = 60;
  R fa = f(a);
  R fb = f(b);
  if ((fa > R(0)) == (fb > R(0))) return abs(fa) < abs(fb) ? a : b;
  R x = a;
  for (int k = 0; k < most; ++k) {
    const R next = (a * fb - b * fa) / (fb - fa);
    const bool is_close = abs(next - x) <= width;
    x = next;
    if (is_close) break;
    const R fx = f(x);
    if ((fx > R(0)) == (fb > R(0))) {
      fa *= R(0.5);
    } else {
      a = b;
      fa = fb;
    }
    b = x;
    fb = fx;
  }
  return x;
}

}  // namespace tiltrotor
