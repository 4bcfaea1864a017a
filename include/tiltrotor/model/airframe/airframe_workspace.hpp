// Memory of an evaluation of the airframe.
#pragma once

#include "tiltrotor/model/airframe/fin.hpp"
#include "tiltrotor/model/airframe/wing.hpp"

namespace tiltrotor {

template <class T>
struct AirframeWorkspace {
  FreeStream<T> stream;
  WingInWake<T> wake[2];
  FreeWing<T> wing;
  Loads<T> loads;  // of one component
  TailFlow<T> tail;
  FinFlow<T> fins;
  T downwash;
};

}  // namespace tiltrotor
