// Memory of a rotor's evaluation.
#pragma once

#include "tiltrotor/model/rotor/rotor_loads.hpp"

namespace tiltrotor {

template <class T>
struct RotorWorkspace {
  BladeGroup<T> blades;
  AzimuthStations<Real<T>> stations;  // of individual blades
  RotorInput<T> input_at_rest;        // of a rotor whose gimbal does not move: first-order flapping alone
  RotorLoads<T> loads, loads_at_rest;
};

}  // namespace tiltrotor
