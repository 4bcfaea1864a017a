// What one evaluation of the model finds on its way from state and inputs to rates, in the order in which it is
// found. Placed by the caller, or on the stack by the functions without it (with many partials some 60 kB).
#pragma once

#include "tiltrotor/model/local_response.hpp"
#include "tiltrotor/model/variables/controls.hpp"

namespace tiltrotor {

template <class T>
struct DerivativeSteps {
  Vec3<T> velocity_b;  // of the CG relative to the air, m/s
  BladeControls<T> controls;
  RotorInput<T> rotor_input;  // of one rotor
  Real<T> seen_by_rotor[RotorInput<T>::kCount];
  RotorResponse<T> rotor[2];
  Loads<T> hub_loads[2];
  T advance_ratio[2];
  Loads<T> total;
  AirframeInput<T> airframe_input;
  AirframeResponse<T> airframe;
  TakingTurns<LocalRotor<T>, LocalAirframe<T>, T> local;  // rotors, then the airframe
};

}  // namespace tiltrotor
