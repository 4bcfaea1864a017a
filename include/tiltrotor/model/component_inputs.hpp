// What each component sees of the aircraft: motion, state and controls, a rotor's in its own frame A.
#pragma once

#include "tiltrotor/model/airframe/airflow.hpp"
#include "tiltrotor/model/control_mixing.hpp"
#include "tiltrotor/model/rotor/rotor.hpp"

namespace tiltrotor {

// `velocity_b`: of the airframe at the CG relative to the air, m/s; gusts of the rotor's place are taken off here. A
// moving mast carries the hub along an arc about the
// conversion axis and pitches the hub frame nose down. Derived here; mast geometry NASA CR-166536 p. B-31:
// V_H = C_HB [ V + omega x r_hub + bM' l (cos bM, 0, sin bM) ],  omega_H = C_HB omega - (0, bM', 0).
template <class T, class C>
void rotor_input(const Configuration<C>& c, const State<T>& x, const Vec3<T>& velocity_b,
                 const BladeControls<T>& controls, int side, RotorInput<T>& in) {
  using R = Real<T>;
  const HubFrame<C>& hub = c.hub[side];
  const C swing = c.setup.mast_rate * c.aircraft->mast.length;
  const Vec3<C> swing_b = {swing * -c.nacelle_axis_b.z, C(R(0)), swing * c.nacelle_axis_b.x};
  const Vec3<T> rates_in_air = minus_fixed(x.rates, c.around.gust_rates_b);
  Vec3<T> hub_velocity_b =
      minus_fixed(velocity_b, c.around.rotor_gust_b[side]) + rate_cross_arm(rates_in_air, hub.arm_b);
  hub_velocity_b = {hub_velocity_b.x + swing_b.x, hub_velocity_b.y, hub_velocity_b.z + swing_b.z};
  Vec3<T> hub_rates_h = hub.from_body.apply(x.rates);
  hub_rates_h.y = hub_rates_h.y - c.setup.mast_rate;

  in.velocity_a = mirror_polar(hub.from_body.apply(hub_velocity_b), side);
  in.rates_a = mirror_axial(hub_rates_h, side);
  in.state = x.rotor[side];
  in.coning.angle = c.setup.options.coning_states ? x.coning[side].angle : T(c.coning);
  in.coning.rate = c.setup.options.coning_states ? x.coning[side].rate : T(R(0));
  in.collective = controls.collective[side];
  in.lateral_cyclic = controls.lateral_cyclic[side];
  in.long_cyclic = controls.long_cyclic[side];
}

// In-plane advance ratio of a hub: mu = sqrt(Vx^2 + Vy^2)/(Omega R), smooth at rest.
template <class T, class C>
T advance_ratio(const Configuration<C>& c, int side, const Vec3<T>& hub_velocity_a) {
  using R = Real<T>;
  const C inverse_tip = R(1) / c.rotor[side].tip_speed;
  const T mu_x = hub_velocity_a.x * inverse_tip;
  const T mu_y = hub_velocity_a.y * inverse_tip;
  return sqrt(mu_x * mu_x + mu_y * mu_y + square(c.aircraft->smooth.advance_ratio));
}

// `advance`: advance ratio of each rotor. C_RF = sum |F| / (rho pi Omega^2 R^4): NASA CR-166536 p. A-38;
// their mean advance ratio goes with it into alpha_WFS (p. A-70).
template <class T, class C>
void airframe_input(const Configuration<C>& c, const State<T>& x, const Vec3<T>& velocity_b,
                    const BladeControls<T>& controls, const RotorResponse<T> (&rotor)[2],
                    const T (&advance)[2], AirframeInput<T>& in) {
  using R = Real<T>;
  const C unit_force = c.air.density * kPi<R> * square(c.tip_speed * c.aircraft->rotor.radius);
  const auto size = [](const Vec3<T>& force) { return sqrt(dot(force, force)); };
  in.velocity_b = minus_fixed(velocity_b, c.around.wing_gust_b);
  in.rates_b = minus_fixed(x.rates, c.around.gust_rates_b);
  for (const Side side : {right, left}) in.mean_wash[side] = c.rotor[side].tip_speed * x.rotor[side].lambda_0;
  in.rotor_force = (size(rotor[right].loads.force_a) + size(rotor[left].loads.force_a)) * (R(1) / unit_force);
  in.advance_ratio = R(0.5) * (advance[right] + advance[left]);
  in.downwash = x.downwash;
  in.elevator = controls.elevator;
  in.aileron = controls.aileron;
  in.rudder = controls.rudder;
}

}  // namespace tiltrotor
