// Memory of the rotors' expansion, and what it holds.
#pragma once

#include "tiltrotor/model/control_mixing.hpp"
#include "tiltrotor/model/rotor/rotor.hpp"

namespace tiltrotor {

template <class R>
using PlacedDual = Dual<R, PlacedRotorInput<R>::kCount>;

template <class R>
struct RotorExpansion {
  RotorResponse<PlacedDual<R>> rotor[2];
};

template <class R>
struct RotorExpansionWorkspace {
  BladeControls<R> controls;
  PlacedRotorInput<R> point;
  PlacedRotorInput<PlacedDual<R>> seeded;
  RotorConditions<PlacedDual<R>> conditions;
  RotorWorkspace<PlacedDual<R>> inner;
};

}  // namespace tiltrotor
