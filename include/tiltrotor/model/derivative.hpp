// The complete aircraft: xdot = f(x, u). Flapping, inflow and downwash are states, so every step below uses
// only what stands above it: no loop is closed inside.
#pragma once

#include <type_traits>

#include "tiltrotor/model/airframe/airframe.hpp"
#include "tiltrotor/model/control_mixing.hpp"
#include "tiltrotor/model/rigid_body.hpp"
#include "tiltrotor/model/rotor/rotor.hpp"

namespace tiltrotor {

// Everything one evaluation finds.
template <class T>
struct Evaluation {
  State<T> rates;             // xdot, in the shape of the state
  LoadRecord<T> loads;        // by component
  RotorResponse<T> rotor[2];  // in the rotor frames A
  T wing_alpha;               // rad
  T wing_downwash;            // at the tail, not lagged, rad
};

namespace derivative_detail {

// Hub motion and controls of one rotor in its own frame.
template <class T>
TILTROTOR_NOINLINE void rotor_input(const Configuration<Real<T>>& c, const State<T>& x,
                                    const Vec3<T>& velocity, const BladeControls<T>& controls, int side,
                                    RotorInput<T>& in) {
  using R = Real<T>;
  const HubFrame<R>& hub = c.hub[side];
  // A moving mast carries the hub along an arc about the conversion axis and pitches the hub frame nose down.
  const Vec3<R> swing = {c.setup.mast_rate * c.aircraft->mast.length * cos(c.mast), R(0),
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

template <class T>
RotorInput<T> rotor_input(const Configuration<Real<T>>& c, const State<T>& x, const Vec3<T>& velocity,
                          const BladeControls<T>& controls, int side) {
  RotorInput<T> in;
  rotor_input(c, x, velocity, controls, side, in);
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
  rates = {rotor.flapping.b1c_rate,
           rotor.flapping.b1s_rate,
           rotor.flapping.b1c_acceleration,
           rotor.flapping.b1s_acceleration,
           rotor.inflow.lambda_0,
           rotor.inflow.lambda_c,
           rotor.inflow.lambda_s};
}

}  // namespace derivative_detail

// Two memories that are not needed at the same time, in one place where their types allow it.
template <class First, class Second,
          bool = std::is_trivially_default_constructible_v<First>&&
              std::is_trivially_default_constructible_v<Second>>
struct Overlay {
  union {
    First first;
    Second second;
  };
};
template <class First, class Second>
struct Overlay<First, Second, false> {
  First first;
  Second second;
};

// Memory beyond the waist of a rotor and of the airframe.
template <class T>
struct BeyondRotor {
  AzimuthStations<Real<T>> blades;  // individual blades alone
  PreaccumulationWorkspace<RotorInput, RotorResponse, T> waist;
  RotorWorkspace<LocalDual<RotorInput, T>> room;
};
template <class T>
struct BeyondAirframe {
  PreaccumulationWorkspace<AirframeInput, AirframeResponse, T> waist;
  AirframeWorkspace<LocalDual<AirframeInput, T>> room;
};

// Memory of one evaluation: placed by the caller, or on the stack by the functions without it (with many
// partials that is some 60 kB).
template <class T>
struct DerivativeWorkspace {
  Vec3<T> velocity;  // of the CG relative to the air
  BladeControls<T> controls;
  RotorInput<T> hub;  // of one rotor
  RotorResponse<T> rotor[2];
  Loads<T> hub_loads;
  Loads<T> total;
  T rotor_force_sum, advance_ratio_sum;
  AirframeInput<T> airframe_input;
  AirframeResponse<T> airframe;
  RigidBodyRates<T> body;
  Overlay<BeyondRotor<T>, BeyondAirframe<T>> beyond;  // one after the other
};

namespace derivative_detail {

// Controls and relative velocity; sums to zero.
template <class T>
TILTROTOR_NOINLINE void begin(const Configuration<Real<T>>& c, const State<T>& x, const Controls<T>& u,
                              DerivativeWorkspace<T>& work) {
  using R = Real<T>;
  work.velocity = x.velocity - u.gust;
  work.controls = mix_controls(c, u, work.velocity);
  work.rotor_force_sum = T(R(0));
  work.advance_ratio_sum = T(R(0));
}

// What airframe and rigid body need of one rotor.
template <class T>
TILTROTOR_NOINLINE void add_rotor(const Configuration<Real<T>>& c, const State<T>& x, int side,
                                  DerivativeWorkspace<T>& work) {
  work.hub_loads = hub_loads(c, side, x.rotor[side], work.rotor[side].loads);
  if (side == right) {
    work.total = work.hub_loads;
  } else {
    work.total = work.total + work.hub_loads;
  }
  const Vec3<T>& force = work.rotor[side].loads.force;
  work.rotor_force_sum += sqrt(dot(force, force));
  work.advance_ratio_sum += advance_ratio(c, work.hub.velocity);
}

template <class T, class Record>
TILTROTOR_NOINLINE void evaluate_rotor(const Configuration<Real<T>>& c, const State<T>& x, int side,
                                       Real<T> azimuth, DerivativeWorkspace<T>& work, Record& record) {
  using R = Real<T>;
  const bool averaged = c.setup.options.azimuth == AzimuthMode::averaged;
  rotor_input(c, x, work.velocity, work.controls, side, work.hub);
  BeyondRotor<T>& beyond = work.beyond.first;
  if (!averaged) individual_azimuth(c.aircraft->rotor.blades, azimuth, beyond.blades);
  const AzimuthStations<R>& stations = averaged ? c.azimuth : beyond.blades;
  preaccumulate(work.hub, beyond.waist, work.rotor[side],
                [&](const auto& in, auto& out) { rotor_response(c, in, stations, beyond.room, out); });
  add_rotor(c, x, side, work);
  record(side == right ? rotor_right : rotor_left, static_cast<const Loads<T>&>(work.hub_loads));
}

template <class T, class Record>
TILTROTOR_NOINLINE void evaluate_airframe(const Configuration<Real<T>>& c, const State<T>& x,
                                          DerivativeWorkspace<T>& work, Record& record) {
  using R = Real<T>;
  const R radius = c.aircraft->rotor.radius;
  AirframeInput<T>& in = work.airframe_input;
  in.velocity = work.velocity;
  in.rates = x.rates;
  for (int side = 0; side < 2; ++side) in.mean_wash[side] = c.tip_speed * x.rotor[side].lambda_0;
  in.rotor_force = work.rotor_force_sum * (R(1) / (c.air.density * kPi<R> * square(c.tip_speed * radius)));
  in.advance_ratio = R(0.5) * work.advance_ratio_sum;
  in.downwash = x.downwash;
  in.elevator = work.controls.elevator;
  in.aileron = work.controls.aileron;
  in.rudder = work.controls.rudder;
  preaccumulate(in, work.beyond.second.waist, work.airframe, [&](const auto& local, auto& out) {
    airframe_response(c, local, work.beyond.second.room, out, record);
  });
}

// Motion of the rigid body under all loads.
template <class T>
TILTROTOR_NOINLINE void balance(const Configuration<Real<T>>& c, const State<T>& x,
                                DerivativeWorkspace<T>& work) {
  work.total = work.total + work.airframe.total;
  work.body = rigid_body(c.mass, x.velocity, x.rates, x.roll, x.pitch, x.yaw, work.total);
}

// What the two rotors and the airframe found, as rates of the state.
template <class T>
TILTROTOR_NOINLINE void store_rates(const Configuration<Real<T>>& c, const State<T>& x,
                                    const DerivativeWorkspace<T>& work, State<T>& rates) {
  using R = Real<T>;
  const Options& o = c.setup.options;
  rates.velocity = work.body.velocity;
  rates.rates = work.body.rates;
  rates.roll = work.body.roll;
  rates.pitch = work.body.pitch;
  rates.yaw = work.body.yaw;
  rates.position = work.body.position;
  for (int side = 0; side < 2; ++side) {
    store_rotor_rates(work.rotor[side], rates.rotor[side]);
    if (o.flap_angular_acceleration && o.flapping == FlapOrder::second) {
      const Vec3<T> w = mirror_axial(c.hub[side].from_body.apply(work.body.rates), side);
      rates.rotor[side].b1c_rate += w.y;
      rates.rotor[side].b1s_rate -= w.x;
    }
    rates.coning[side].angle = o.coning_states ? x.coning[side].rate : T(R(0));
    rates.coning[side].rate = o.coning_states ? work.rotor[side].coning_acceleration : T(R(0));
  }
  const WingTables<R>& wing = c.aircraft->wing;
  rates.downwash = o.downwash_lag ? (work.airframe.downwash - x.downwash) *
                                        total_speed(work.velocity, wing.downwash_speed_floor) *
                                        (R(1) / wing.downwash_arm)
                                  : T(R(0));
}

}  // namespace derivative_detail

// xdot and, in the workspace, what leads to it; `record(component, loads)` sees the loads of every component.
// `azimuth`: position of the right rotor's first blade (rad), used in the individual-blade mode alone; the
// left rotor mirrors it.
template <class T, class Record>
void evaluate(const Configuration<Real<T>>& c, const State<T>& x, const Controls<T>& u, Real<T> azimuth,
              DerivativeWorkspace<T>& work, State<T>& rates, Record&& record) {
  derivative_detail::begin(c, x, u, work);
  derivative_detail::evaluate_rotor(c, x, right, azimuth, work, record);
  derivative_detail::evaluate_rotor(c, x, left, azimuth, work, record);
  derivative_detail::evaluate_airframe(c, x, work, record);
  derivative_detail::balance(c, x, work);
  derivative_detail::store_rates(c, x, work, rates);
}

// Everything, by component.
template <class T>
void evaluate(const Configuration<Real<T>>& c, const State<T>& x, const Controls<T>& u,
              DerivativeWorkspace<T>& work, Evaluation<T>& out, Real<T> azimuth = Real<T>(0)) {
  evaluate(c, x, u, azimuth, work, out.rates,
           [&out](Component component, const Loads<T>& loads) { out.loads.component[component] = loads; });
  for (int side = 0; side < 2; ++side) out.rotor[side] = work.rotor[side];
  out.wing_alpha = work.airframe.wing_alpha;
  out.wing_downwash = work.airframe.downwash;
}
template <class T>
void evaluate(const Configuration<Real<T>>& c, const State<T>& x, const Controls<T>& u, Evaluation<T>& out,
              Real<T> azimuth = Real<T>(0)) {
  DerivativeWorkspace<T> work;
  evaluate(c, x, u, work, out, azimuth);
}

// xdot alone.
template <class T>
void derivative(const Configuration<Real<T>>& c, const State<T>& x, const Controls<T>& u,
                DerivativeWorkspace<T>& work, State<T>& rates, Real<T> azimuth = Real<T>(0)) {
  evaluate(c, x, u, azimuth, work, rates, [](Component, const auto&) {});
}
template <class T>
void derivative(const Configuration<Real<T>>& c, const State<T>& x, const Controls<T>& u, State<T>& rates,
                Real<T> azimuth = Real<T>(0)) {
  DerivativeWorkspace<T> work;
  derivative(c, x, u, work, rates, azimuth);
}

}  // namespace tiltrotor
