// Results of the model as returned values, each with a workspace of its own: for tests, which have the stack.
#pragma once

#include "tiltrotor/model/derivative.hpp"

namespace tiltrotor {

template <class T>
RotorInput<T> rotor_input(const Configuration<Real<T>>& c, const State<T>& x, const Vec3<T>& velocity,
                          const BladeControls<T>& controls, int side) {
  RotorInput<T> in;
  rotor_input(c, x, velocity, controls, side, in);
  return in;
}

template <class T>
RotorLoads<T> rotor_loads(const Configuration<Real<T>>& c, const RotorInput<T>& in,
                          const AzimuthStations<Real<T>>& azimuth) {
  BladeGroup<T> blades;
  RotorLoads<T> sum;
  rotor_loads(c, in, azimuth, blades, sum);
  return sum;
}

template <class T>
RotorResponse<T> rotor_response(const Configuration<Real<T>>& c, const RotorInput<T>& in,
                                const AzimuthStations<Real<T>>& azimuth) {
  RotorWorkspace<T> work;
  RotorResponse<T> out;
  rotor_response(c, in, azimuth, work, out);
  return out;
}

template <class T>
WingInWake<T> wing_in_wake(const Configuration<Real<T>>& c, const AirframeInput<T>& in,
                           const FreeStream<T>& stream, int side) {
  WingInWake<T> out;
  wing_in_wake(c, in, stream, side, out);
  return out;
}

template <class T>
FreeWing<T> free_wing(const Configuration<Real<T>>& c, const AirframeInput<T>& in,
                      const FreeStream<T>& stream, const WingInWake<T> (&wake)[2]) {
  FreeWing<T> out;
  free_wing(c, in, stream, wake, out);
  return out;
}

}  // namespace tiltrotor
