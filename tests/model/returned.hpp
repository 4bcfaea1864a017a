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
  rotor_loads(c, rotor_conditions(c, right), in, azimuth, blades, sum);
  return sum;
}

template <class T>
RotorResponse<T> rotor_response(const Configuration<Real<T>>& c, const RotorInput<T>& in,
                                const AzimuthStations<Real<T>>& azimuth) {
  RotorWorkspace<T> work;
  RotorResponse<T> out;
  rotor_response(c, rotor_conditions(c, right), in, azimuth, work, out);
  return out;
}

// Of the right rotor; both turn alike.
template <class T>
FlapRates<T> flap_rates(const Configuration<Real<T>>& c, const RotorState<T>& x, const Vec3<T>& hub_rates,
                        const T& mc, const T& ms) {
  return flap_rates(c, rotor_conditions(c, right), x, hub_rates, mc, ms);
}
template <class T>
FlapRates<T> quasi_static_flap_rates(const Configuration<Real<T>>& c, const RotorState<T>& x,
                                     const Vec3<T>& hub_rates, const T& mc, const T& ms) {
  return quasi_static_flap_rates(c, rotor_conditions(c, right), x, hub_rates, mc, ms);
}
template <class T>
T coning_acceleration(const Configuration<Real<T>>& c, const ConingState<T>& x, const T& m0) {
  return coning_acceleration(c, rotor_conditions(c, right), x, m0);
}
template <class T>
InflowRates<T> inflow_rates(const Configuration<Real<T>>& c, const RotorState<T>& x,
                            const InflowForcing<T>& f) {
  return inflow_rates(c, rotor_conditions(c, right), x, f);
}
template <class T>
InflowForcing<T> inflow_forcing(const Configuration<Real<T>>& c, const RotorInput<T>& in,
                                const RotorLoads<T>& loads) {
  return inflow_forcing(c, rotor_conditions(c, right), in, loads);
}
template <class T>
FeltInflow<T> felt_inflow(const Configuration<Real<T>>& c, const RotorInput<T>& in) {
  return felt_inflow(c, rotor_conditions(c, right), in);
}

// Of the blade at one azimuth of the right rotor.
template <class T>
BladeView<T> blade_view(const Configuration<Real<T>>& c, const RotorInput<T>& in, Real<T> cosine,
                        Real<T> sine) {
  BladeHarmonics<T> hub;
  blade_harmonics(rotor_conditions(c, right).speed, c.pitch_flap, in, felt_inflow(c, in), hub);
  return blade_view(hub, cosine, sine);
}
template <class T>
BladeFlow<T> blade_flow(const Configuration<Real<T>>& c, const RotorInput<T>& in, Real<T> cosine,
                        Real<T> sine) {
  const BladeView<T> view = blade_view(c, in, cosine, sine);
  return blade_flow(view, sine_and_cosine(view.flap));
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
