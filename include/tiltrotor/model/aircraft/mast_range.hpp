// A number that changes with mast angle.
#pragma once

#include "tiltrotor/math/arithmetic.hpp"

namespace tiltrotor {

// Values at mast angle 0 and 90 deg that change linearly between.
template <class R>
struct MastRange {
  R at_0;
  R at_90;
  template <class C>
  C at(const C& mast_deg) const {
    return at_0 + (at_90 - at_0) * (mast_deg / R(90));
  }
};

}  // namespace tiltrotor
