// What a drive, an actuator or an engine can give of what is asked of it.
#pragma once

#include "tiltrotor/math/differentiation/by_slope.hpp"
#include "tiltrotor/math/smooth.hpp"

namespace tiltrotor {

// x clipped to low..high, rounded by e.
template <class T>
T limited(const T& x, Real<T> low, Real<T> high, Real<T> e) {
  return by_slope([=](const auto& number) { return smooth_clip(number, low, high, e); }, x);
}

}  // namespace tiltrotor
