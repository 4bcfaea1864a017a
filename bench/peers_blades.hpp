// Blades for the scalars of other libraries: one after the other, every operation on the library's own
// numbers.
//
// Our own scalars compute several blades at once on plain numbers and chain their slopes
// (model/rotor/blade_group.hpp). With that the peers would differentiate next to nothing themselves.
#pragma once

#include "tiltrotor/model/rotor/single_blades.hpp"

namespace bench {

template <class T>
using SingleBlades = tiltrotor::SingleBlades<T, tiltrotor::PlainBladeLoads>;

}  // namespace bench
