// A function of one number by its value and slope.
#pragma once

#include "tiltrotor/math/differentiation/dual.hpp"

namespace tiltrotor {

// function(x): of a dual number one direction is carried through it, and all follow from that.
template <class T, class Function>
T by_slope(Function&& function, const T& x) {
  if constexpr (ScalarTraits<T>::kTakesSlopes) {
    const Dual<Real<T>, 1> local = function(Dual<Real<T>, 1>::variable(value(x), 0));
    const Real<T> slope = local.d.get(0);
    const T* const argument = &x;
    return ScalarTraits<T>::template from_slopes<1>(local.v, &slope, &argument);
  } else {
    return function(x);
  }
}

}  // namespace tiltrotor
