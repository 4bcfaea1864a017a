// Memory of the components while each is evaluated on the scalar of its own few directions (local_response.hpp).
#pragma once

#include <type_traits>

#include "tiltrotor/math/differentiation/preaccumulate.hpp"
#include "tiltrotor/model/airframe/airframe.hpp"
#include "tiltrotor/model/rotor/rotor.hpp"

namespace tiltrotor {

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

}  // namespace tiltrotor
