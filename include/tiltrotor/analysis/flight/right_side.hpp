// The right side of a flight: the rates of all states that are alive, as an integrator asks for them.
#pragma once

#include <type_traits>

#include "tiltrotor/analysis/flight/attitude.hpp"
#include "tiltrotor/analysis/flight/configuration_motion.hpp"
#include "tiltrotor/analysis/flight/simulation.hpp"
#include "tiltrotor/analysis/linear/differentiation.hpp"
#include "tiltrotor/math/exponential_step.hpp"
#include "tiltrotor/systems/vehicle_airframe.hpp"
#include "tiltrotor/systems/vehicle_events.hpp"

namespace tiltrotor {

template <class R, class Policy = DefaultDifferentiation>
struct SimulationWorkspace {
  using Seeded = typename Policy::template Scalar<R, kModelDirections>;
  ModelWorkspaces<R, Seeded> model;
  typename Policy::template Workspace<R, kModelDirections, state_count, state_count> differentiation;
  Matrix<R, state_count, state_count> jacobian;
  union Method {
    RungeKuttaWorkspace<R, vehicle_state_count> runge_kutta;
    RosenbrockWorkspace<R, state_count> rosenbrock;
    ExponentialWorkspace<R, state_count> exponential;
  } method;
  ActiveStates active;
  ActiveSystems systems;
  R x[vehicle_state_count];  // active states, those of systems last; of the sums what the step adds
  R rates[vehicle_state_count];
  R ahead[state_count], behind[state_count];
  R scale[state_count];
  R upright[vehicle_state_count];  // active states with Euler angles, in steep flight
  R whole[state_count];            // every state, for those that stand still
  AirframeDemand<R> demand;
  AirframeAnswer<R> answer;
  VehicleFlows<R> flows;

  // Of a state in x: its place in vehicle_variable().
  int place(int k) const {
    return k < active.count ? active.index[k] : state_count + systems.index[k - active.count];
  }
  int count() const { return active.count + systems.count; }
};

// The systems of a flight: moved on with it.
template <class R>
struct SystemFlight {
  Vehicle<R> vehicle;
  SystemState<R> state;
  std::uint64_t steps;  // done so far: the number of a step's noise
};

namespace flight_step {

// Places of the attitude and of the body rates among the active states: the first nine are alive always.
inline constexpr int kRoll = kStateIndex.roll, kPitch = kStateIndex.pitch, kYaw = kStateIndex.yaw;
inline constexpr int kRates[] = {kStateIndex.rates.x, kStateIndex.rates.y, kStateIndex.rates.z};
static_assert(kYaw == 8 && kRoll == 6 && kPitch == 7);

// Attitude at the beginning of a part in steep flight.
template <class R>
struct SteepStart {
  EulerAngles<R> angles;
  Rotation<R> rotation;
  R bank, heading;  // added since the beginning of the step
};

// Systems beside the airframe, while a step lasts.
template <class R>
struct SystemPart {
  SystemFlight<R>* flight;
  Configuration<R>* c;           // put into what they ask for
  ConfigurationSetting<R> base;  // where they ask for nothing
};

// Right side of the active states at constant controls.
template <class R, class Policy>
struct RightSide {
  const Configuration<R>& c;
  SimulationWorkspace<R, Policy>& work;
  const Controls<R>& controls;
  int& fault_state;
  R azimuth_at_0;
  const MovingConfiguration<R>* moving;  // of `c`, or nullptr
  const SteepStart<R>* steep;            // of a part in steep flight, or nullptr
  SystemPart<R>* systems;                // or nullptr

  R azimuth(R time) const {
    if (moving == nullptr) return azimuth_at_0 + c.setup.rotor_speed * time;
    if (moving->from.rotor_acceleration == R(0)) return azimuth_at_0 + moving->from.rotor_speed * time;
    return azimuth_at_0 + moving->from.rotor_speed * moving->begin +
           turned(moving->from, time - moving->begin);
  }
  void place_configuration(R time, const R* x) const {
    if (moving == nullptr) return;
    if (systems != nullptr) {
      systems->base = carried(moving->from, time - moving->begin);
      return;
    }
    R down = work.whole[kStateIndex.position.z];
    for (int k = 0; k < work.active.count; ++k)
      if (work.active.index[k] == kStateIndex.position.z) down += x[k];
    place(*moving, time, down);
  }

  // State and controls of an evaluation at the active states x; a sum (sum_of()) is what the step adds to it.
  template <class Input, class T>
  TILTROTOR_NOINLINE void place_point(const Input& x, ModelWorkspace<T>& at) const {
    const ModelPlaces<T> places(at);
    R u[control_count];
    flatten(controls, u);
    for (int i = 0; i < state_count; ++i) *places.x[i] = work.whole[i];
    for (int j = 0; j < control_count; ++j) *places.u[j] = u[j];
    for (int k = 0; k < work.active.count; ++k) {
      const int i = work.active.index[k];
      x.put(k, *places.x[i]);
      if (sum_of(i) >= 0) *places.x[i] = work.whole[i] + *places.x[i];
    }
  }
  // output(k, rate) of the active state k, for each, at x[k].
  template <class Input, class Output>
  void evaluate(const Input& x, Output&& output, R azimuth) const {
    using T = typename Input::T;
    ModelWorkspace<T>& at = work.model.template of<T>();
    place_point(x, at);
    if constexpr (kIsPlain<T>) {
      if (systems != nullptr) {
        rates_with_systems(at, x.x, output, azimuth);
        return;
      }
    }
    model_rates(c, azimuth, at);
    put_active(at.rates, output);
  }
  // Of the airframe alone.
  template <class T, class Output>
  TILTROTOR_NOINLINE void put_active(const State<T>& rates, Output&& output) const {
    const T* rate[state_count];
    list_places(rates, rate);
    for (int k = 0; k < work.active.count; ++k) output(k, *rate[work.active.index[k]]);
  }

  // State of the systems from the active ones at the end of x.
  SystemState<R> system_state(const R* x) const {
    R flat[system_state_count];
    flatten(systems->flight->state, flat);
    for (int k = 0; k < work.systems.count; ++k) flat[work.systems.index[k]] = x[work.active.count + k];
    SystemState<R> s;
    unflatten(flat, s);
    return s;
  }
  // State of the airframe from the active ones in x, with Euler angles.
  State<R> airframe_state(const R* x) const {
    R flat[state_count];
    for (int i = 0; i < state_count; ++i) flat[i] = work.whole[i];
    for (int k = 0; k < work.active.count; ++k) {
      const int i = work.active.index[k];
      flat[i] = sum_of(i) < 0 ? x[k] : flat[i] + x[k];
    }
    State<R> state;
    unflatten(flat, state);
    return state;
  }
  template <class Output>
  void rates_with_systems(ModelWorkspace<R>& at, const R* x, Output&& output, R azimuth) const {
    const Vehicle<R>& v = systems->flight->vehicle;
    SystemState<R> found;
    vehicle_rates(v, c, systems->base, *systems->c, at.state, system_state(x), v.commands, at.controls,
                  VehicleAirframe<R>{*systems->c, at.state, at.derivative, azimuth}, work.demand, work.answer,
                  work.flows, found);
    // Where the next search of an ideal governor begins.
    if (v.on.governor == Governor::ideal) systems->flight->state.governor = work.flows.governed;
    R flat[vehicle_state_count];
    flatten(work.answer.rates, flat);
    flatten(found, flat + state_count);
    for (int k = 0; k < work.count(); ++k) output(k, flat[work.place(k)]);
  }

  // The attitude by its turn since the beginning of the part: attitude.hpp.
  void steep_rates(const R* x, R* xdot, R azimuth) const {
    const Vec3<R> turn = {x[kRoll], x[kPitch], x[kYaw]};
    // At the beginning the angles themselves, so that rates found there before are the same bits.
    const bool begins = turn.x == R(0) && turn.y == R(0) && turn.z == R(0);
    const EulerAngles<R> now =
        begins ? steep->angles : euler_angles(turned_by(turn, steep->rotation), steep->angles.roll);
    for (int k = 0; k < work.count(); ++k) work.upright[k] = x[k];
    work.upright[kRoll] = begins ? steep->bank : now.roll - work.whole[kRoll];
    work.upright[kPitch] = now.pitch;
    work.upright[kYaw] = begins ? steep->heading : now.yaw - work.whole[kYaw];
    evaluate(PlainInputs<R>{work.upright}, PlainOutputs<R>{xdot}, azimuth);
    const Vec3<R> rate = turn_rate(turn, {x[kRates[0]], x[kRates[1]], x[kRates[2]]});
    xdot[kRoll] = rate.x;
    xdot[kPitch] = rate.y;
    xdot[kYaw] = rate.z;
  }

  Status operator()(R time, const R* x, R* xdot) const {
    place_configuration(time, x);
    if (steep == nullptr) {
      evaluate(PlainInputs<R>{x}, PlainOutputs<R>{xdot}, azimuth(time));
    } else {
      steep_rates(x, xdot, azimuth(time));
    }
    for (int k = 0; k < work.count(); ++k) {
      if (!is_finite(xdot[k])) {
        fault_state = work.place(k);
        return Status::not_finite;
      }
    }
    if (systems != nullptr && !work.flows.held) {
      fault_state = state_count + kSystemIndex.governor;
      return Status::out_of_range;
    }
    return Status::ok;
  }
};

}  // namespace flight_step

}  // namespace tiltrotor
