// The complete aircraft: xdot = f(x, u). Flapping, inflow and
// downwash are states, so every step below uses only what stands above it: no loop is closed inside.
#pragma once

#include "tiltrotor/model/airframe.hpp"
#include "tiltrotor/model/control_mixing.hpp"
#include "tiltrotor/model/rigid_body.hpp"
#include "tiltrotor/model/rotor.hpp"

namespace tiltrotor {

// Everything one evaluation finds.
template <class T>
struct Evaluation {
  State<T> rates;              // xdot, in the shape of the state
  LoadRecord<T> loads;         // by component
  RotorResponse<T> rotor[2];   // in the rotor frames A
  T wing_alpha;                // rad
  T wing_downwash;             // at the tail, not lagged, rad
};

namespace detail {

// Hub motion and controls of one rotor in its own frame.
template <class T>
RotorInput<T> rotor_input(const Configuration<Real<T>>& c, const State<T>& x, const Vec3<T>& velocity,
                          const BladeControls<T>& controls, int side) {
  using R = Real<T>;
  const HubFrame<R>& hub = c.hub[side];
  // A moving mast carries the hub along an arc about the conversion axis and pitches the hub frame nose down.
  const Vec3<R> swing = {c.setup.mast_rate * c.aircraft->mast.length * cos(c.mast), R(0),
                         c.setup.mast_rate * c.aircraft->mast.length * sin(c.mast)};
  Vec3<T> hub_velocity = velocity + rate_cross_arm(x.rates, hub.arm);
  hub_velocity = {hub_velocity.x + swing.x, hub_velocity.y, hub_velocity.z + swing.z};
  Vec3<T> hub_rates = hub.from_body.apply(x.rates);
  hub_rates.y = hub_rates.y - c.setup.mast_rate;

  RotorInput<T> in;
  in.velocity = mirror_polar(hub.from_body.apply(hub_velocity), side);
  in.rates = mirror_axial(hub_rates, side);
  in.state = x.rotor[side];
  in.coning = c.setup.options.coning_states ? x.coning[side] : ConingState<T>{T(c.coning), T(R(0))};
  in.collective = controls.collective[side];
  in.lateral_cyclic = controls.lateral_cyclic[side];
  in.long_cyclic = controls.long_cyclic[side];
  return in;
}

// In-plane advance ratio of a hub velocity in the frame A.
template <class T>
T advance_ratio(const Configuration<Real<T>>& c, const Vec3<T>& hub_velocity) {
  using R = Real<T>;
  const R inverse_tip = R(1) / c.tip_speed;
  const T mx = hub_velocity.x * inverse_tip;
  const T my = hub_velocity.y * inverse_tip;
  return sqrt(mx * mx + my * my + square(c.aircraft->smooth.advance_ratio));
}

template <class T>
void store_rotor_rates(const RotorResponse<T>& rotor, RotorState<T>& rates) {
  rates = {rotor.flapping.b1c_rate,         rotor.flapping.b1s_rate, rotor.flapping.b1c_acceleration,
           rotor.flapping.b1s_acceleration, rotor.inflow.n0,         rotor.inflow.nc,
           rotor.inflow.ns};
}

}  // namespace detail

// xdot and what leads to it; `record(component, loads)` sees the loads of every component. `azimuth`: position of the
// right rotor's first blade (rad), used in the individual-blade mode alone; the left rotor mirrors it.
template <class T, class Record>
void evaluate(const Configuration<Real<T>>& c, const State<T>& x, const Controls<T>& u, Real<T> azimuth,
              State<T>& rates, RotorResponse<T> (&rotor)[2], AirframeResponse<T>& airframe, Record&& record) {
  using R = Real<T>;
  const Options& o = c.setup.options;
  const Vec3<T> velocity = x.velocity - u.gust;
  const BladeControls<T> controls = mix_controls(c, u, velocity);

  // Rotors.
  const bool averaged = o.azimuth == AzimuthMode::averaged;
  AirframeInput<T> in;
  Loads<T> total{};
  T force_sum = T(R(0));
  T advance_sum = T(R(0));
  for (int side = 0; side < 2; ++side) {
    const RotorInput<T> hub = detail::rotor_input(c, x, velocity, controls, side);
    rotor[side] = through_waist(hub, [&](const auto& local) {
      return averaged ? rotor_response(c, local, c.azimuth)
                      : rotor_response(c, local, individual_azimuth<R>(c.aircraft->rotor.blades, azimuth));
    });
    const Vec3<T>& force = rotor[side].loads.force;
    const Loads<T> loads = hub_loads(c, side, x.rotor[side], rotor[side].loads);
    record(side == right ? rotor_right : rotor_left, loads);
    total = side == right ? loads : total + loads;
    force_sum += sqrt(dot(force, force));
    advance_sum += detail::advance_ratio(c, hub.velocity);
    in.mean_wash[side] = c.tip_speed * x.rotor[side].n0;
  }

  // Airframe.
  const R radius = c.aircraft->rotor.radius;
  in.velocity = velocity;
  in.rates = x.rates;
  in.rotor_force = force_sum * (R(1) / (c.air.density * kPi<R> * square(c.tip_speed * radius)));
  in.advance_ratio = R(0.5) * advance_sum;
  in.downwash = x.downwash;
  in.elevator = controls.elevator;
  in.aileron = controls.aileron;
  in.rudder = controls.rudder;
  airframe = through_waist(in, [&](const auto& local) { return airframe_response(c, local, record); });
  total = total + airframe.total;

  // Rates of the state.
  const RigidBodyRates<T> body = rigid_body(c.mass, x.velocity, x.rates, x.roll, x.pitch, x.yaw, total);
  rates.velocity = body.velocity;
  rates.rates = body.rates;
  rates.roll = body.roll;
  rates.pitch = body.pitch;
  rates.yaw = body.yaw;
  rates.position = body.position;
  for (int side = 0; side < 2; ++side) {
    detail::store_rotor_rates(rotor[side], rates.rotor[side]);
    if (o.flap_angular_acceleration && o.flapping == FlapOrder::second) {
      const Vec3<T> w = mirror_axial(c.hub[side].from_body.apply(body.rates), side);
      rates.rotor[side].b1c_rate += w.y;
      rates.rotor[side].b1s_rate -= w.x;
    }
    rates.coning[side] = {o.coning_states ? x.coning[side].rate : T(R(0)),
                          o.coning_states ? rotor[side].coning_acceleration : T(R(0))};
  }
  const WingTables<R>& wing = c.aircraft->wing;
  rates.downwash = o.downwash_lag ? (airframe.downwash - x.downwash) * total_speed(velocity, wing.downwash_speed_floor) *
                                        (R(1) / wing.downwash_arm)
                                  : T(R(0));
}

// Everything, by component.
template <class T>
void evaluate(const Configuration<Real<T>>& c, const State<T>& x, const Controls<T>& u, Evaluation<T>& out,
              Real<T> azimuth = Real<T>(0)) {
  AirframeResponse<T> airframe;
  evaluate(c, x, u, azimuth, out.rates, out.rotor, airframe,
           [&out](Component component, const Loads<T>& loads) { out.loads.component[component] = loads; });
  out.wing_alpha = airframe.wing_alpha;
  out.wing_downwash = airframe.downwash;
}

// xdot alone.
template <class T>
void derivative(const Configuration<Real<T>>& c, const State<T>& x, const Controls<T>& u, State<T>& rates,
                Real<T> azimuth = Real<T>(0)) {
  RotorResponse<T> rotor[2];
  AirframeResponse<T> airframe;
  evaluate(c, x, u, azimuth, rates, rotor, airframe, [](Component, const auto&) {});
}

}  // namespace tiltrotor
