// What each component sees of the aircraft: motion, state and controls, a rotor's in its own frame A.
#pragma once

#include "tiltrotor/model/airframe/airflow.hpp"
#include "tiltrotor/model/control_mixing.hpp"
#include "tiltrotor/model/rotor/rotor.hpp"

namespace tiltrotor {

// `velocity`: of the CG relative to the air, B. A moving mast carries the hub along an arc about the conversion
// axis and pitches the hub frame nose down.
template <class T, class C>
void rotor_input(const Configuration<C>& c, const State<T>& x, const Vec3<T>& velocity,
                 const BladeControls<T>& controls, int side, RotorInput<T>& in) {
  using R = Real<T>;
  const HubFrame<C>& hub = c.hub[side];
  const Vec3<C> swing = {c.setup.mast_rate * c.aircraft->mast.length * cos(c.mast), C(R(0)),
                         c.setup.mast_rate * c.aircraft->mast.length * sin(c.mast)};
  Vec3<T> hub_velocity = velocity + rate_cross_arm(x.rates, hub.arm);
  hub_velocity = {hub_velocity.x + swing.x, hub_velocity.y, hub_velocity.z + swing.z};
  Vec3<T> hub_rates = hub.from_body.apply(x.rates);
  hub_rates.y = hub_rates.y - c.setup.mast_rate;

  in.velocity = mirror_polar(hub.from_body.apply(hub_velocity), side);
  in.rates = mirror_axial(hub_rates, side);
  in.state = x.rotor[side];
  in.coning.angle = c.setup.options.coning_states ? x.coning[side].angle : T(c.coning);
  in.coning.rate = c.setup.options.coning_states ? x.coning[side].rate : T(R(0));
  in.collective = controls.collective[side];
  in.lateral_cyclic = controls.lateral_cyclic[side];
  in.long_cyclic = controls.long_cyclic[side];
}

// In-plane advance ratio of a hub velocity in the frame A.
template <class T, class C>
T advance_ratio(const Configuration<C>& c, const Vec3<T>& hub_velocity) {
  using R = Real<T>;
  const C inverse_tip = R(1) / c.tip_speed;
  const T mx = hub_velocity.x * inverse_tip;
  const T my = hub_velocity.y * inverse_tip;
  return sqrt(mx * mx + my * my + square(c.aircraft->smooth.advance_ratio));
}

// `advance`: advance ratio of each rotor.
template <class T, class C>
void airframe_input(const Configuration<C>& c, const State<T>& x, const Vec3<T>& velocity,
                    const BladeControls<T>& controls, const RotorResponse<T> (&rotor)[2],
                    const T (&advance)[2], AirframeInput<T>& in) {
  using R = Real<T>;
  const C unit_force = c.air.density * kPi<R> * square(c.tip_speed * c.aircraft->rotor.radius);
  const auto size = [](const Vec3<T>& force) { return sqrt(dot(force, force)); };
  in.velocity = velocity;
  in.rates = x.rates;
  for (const Side side : {right, left}) in.mean_wash[side] = c.tip_speed * x.rotor[side].lambda_0;
  in.rotor_force = (size(rotor[right].loads.force) + size(rotor[left].loads.force)) * (R(1) / unit_force);
  in.advance_ratio = R(0.5) * (advance[right] + advance[left]);
  in.downwash = x.downwash;
  in.elevator = controls.elevator;
  in.aileron = controls.aileron;
  in.rudder = controls.rudder;
}

}  // namespace tiltrotor
