// Rates of the state from what rotors, airframe and rigid body found.
#pragma once

#include "tiltrotor/model/airframe/airframe.hpp"
#include "tiltrotor/model/rigid_body.hpp"
#include "tiltrotor/model/rotor/rotor.hpp"

namespace tiltrotor {

// `total`: force and moment about the CG, of the air, from outside and of moving nacelles. Wind carries the aircraft over the ground.
template <class T, class C>
void rigid_body_rates(const Configuration<C>& c, const State<T>& x, const Loads<T>& total, State<T>& rates) {
  const RigidBodyRates<T> body = rigid_body(c.mass, x.velocity, x.rates, x.roll, x.pitch, x.yaw, total);
  rates.velocity = body.velocity;
  rates.rates = body.rates;
  rates.roll = body.roll;
  rates.pitch = body.pitch;
  rates.yaw = body.yaw;
  rates.position = plus_fixed(body.position, c.around.wind_n);
}

// Angular acceleration of the hub, in the axes of its mast, which itself turns at -bM' about y.
template <class T, class C>
Vec3<T> hub_acceleration_h(const Configuration<C>& c, int side, const Vec3<T>& rates_b,
                           const Vec3<T>& acceleration_b) {
  const Vec3<T> rates = c.hub[side].from_body.apply(rates_b);
  const Vec3<T> turned = c.hub[side].from_body.apply(acceleration_b);
  return {turned.x + c.setup.mast_rate * rates.z, turned.y - c.setup.mast_acceleration,
          turned.z - c.setup.mast_rate * rates.x};
}

// The hub's angular acceleration, known from the rigid body, is added to the flapping on demand. Inflow keeps its
// speed when the rotor's changes, hence not its ratio to the tip's.
template <class T, class C>
void rotor_rates(const Configuration<C>& c, const State<T>& x, const RotorResponse<T>& rotor, int side,
                 State<T>& rates) {
  using R = Real<T>;
  const Options& o = c.setup.options;
  RotorState<T>& out = rates.rotor[side];
  out.b1c = rotor.flapping.b1c_rate;
  out.b1s = rotor.flapping.b1s_rate;
  out.b1c_rate = rotor.flapping.b1c_acceleration;
  out.b1s_rate = rotor.flapping.b1s_acceleration;
  const C slower = c.setup.rotor_acceleration / c.rotor[side].speed;
  out.lambda_0 = rotor.inflow.lambda_0 - slower * x.rotor[side].lambda_0;
  out.lambda_c = rotor.inflow.lambda_c - slower * x.rotor[side].lambda_c;
  out.lambda_s = rotor.inflow.lambda_s - slower * x.rotor[side].lambda_s;
  if (o.flap_angular_acceleration && o.flapping == FlapOrder::second) {
    const Vec3<T> acceleration_a = mirror_axial(hub_acceleration_h(c, side, x.rates, rates.rates), side);
    out.b1c_rate += acceleration_a.y;
    out.b1s_rate -= acceleration_a.x;
  }
  rates.coning[side].angle = o.coning_states ? x.coning[side].rate : T(R(0));
  rates.coning[side].rate = o.coning_states ? rotor.coning_acceleration : T(R(0));
}

// eps' = (eps_0 - eps) V/l_t: derived here, a lag by the time the flow takes from wing to tail, with V =
// sqrt(|v|^2 + (20 m/s)^2) (choices.csv: downwash_arm, downwash_speed_floor). `velocity_b`: of the
// airframe at the CG relative to the air at the wing, m/s.
template <class T, class C>
T downwash_rate(const Configuration<C>& c, const State<T>& x, const Vec3<T>& velocity_b,
                const T& downwash_at_rest) {
  using R = Real<T>;
  const WingTables<R>& wing = c.aircraft->wing;
  if (!c.setup.options.downwash_lag) return T(R(0));
  return (downwash_at_rest - x.downwash) * total_speed(velocity_b, wing.downwash_speed_floor) *
         (R(1) / wing.downwash_arm);
}

}  // namespace tiltrotor
