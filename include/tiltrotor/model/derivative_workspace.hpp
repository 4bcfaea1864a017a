// Memory of one evaluation of the model: placed by the caller, or on the stack by the functions without it
// (with many partials it takes some 60 kB).
#pragma once

#include <type_traits>

#include "tiltrotor/math/differentiation/preaccumulate.hpp"
#include "tiltrotor/model/airframe/airframe.hpp"
#include "tiltrotor/model/rotor/rotor.hpp"
#include "tiltrotor/model/variables/controls.hpp"

namespace tiltrotor {

// A component on the scalar of its own few directions, and the chain to those of the aircraft.
template <class T>
struct LocalRotorWorkspace {
  AzimuthStations<Real<T>> blades;  // of individual blades
  PreaccumulationWorkspace<RotorInput, RotorResponse, T> chain;
  RotorWorkspace<LocalDual<RotorInput, T>> rotor;
};
template <class T>
struct LocalAirframeWorkspace {
  PreaccumulationWorkspace<AirframeInput, AirframeResponse, T> chain;
  AirframeWorkspace<LocalDual<AirframeInput, T>> airframe;
};

// Rotors and airframe come one after the other: they share one place where the scalar allows it.
template <class T, bool = std::is_trivially_default_constructible_v<T>>
struct LocalWorkspace {
  union {
    LocalRotorWorkspace<T> rotor;
    LocalAirframeWorkspace<T> airframe;
  };
};
template <class T>
struct LocalWorkspace<T, false> {
  LocalRotorWorkspace<T> rotor;
  LocalAirframeWorkspace<T> airframe;
};

template <class T>
struct DerivativeWorkspace {
  Vec3<T> velocity_b;  // of the CG relative to the air, m/s
  BladeControls<T> controls;
  RotorInput<T> rotor_input;  // of one rotor
  RotorResponse<T> rotor[2];
  Loads<T> hub_loads[2];
  T advance_ratio[2];
  Loads<T> total;
  AirframeInput<T> airframe_input;
  AirframeResponse<T> airframe;
  LocalWorkspace<T> local;
};

}  // namespace tiltrotor
