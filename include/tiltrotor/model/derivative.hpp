// The complete aircraft: xdot = f(x, u). Flapping, inflow and downwash are states, so every step below uses
// only what stands above it: no loop is closed inside.
#pragma once

#include "tiltrotor/model/airframe/engine_jet.hpp"
#include "tiltrotor/model/component_inputs.hpp"
#include "tiltrotor/model/rotor_expansion.hpp"
#include "tiltrotor/model/state_rates.hpp"

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

// xdot and, in `steps`, what leads to it; `record(component, loads)` sees the loads of every component;
// `rotors(c, side, azimuth, steps)` finds steps.rotor[side] (rotor_expansion.hpp).
// `azimuth`: position of the right rotor's first blade (rad), used in the individual-blade mode alone; the
// left rotor mirrors it.
template <class T, class C, class Record, class Rotors = AskedRotors>
void recorded_derivative(const Configuration<C>& c, const State<T>& x, const Controls<T>& u, Real<T> azimuth,
                         DerivativeSteps<T>& steps, State<T>& rates, Record&& record, Rotors rotors = {}) {
  out_of_line([&] {
    const Vec3<T> velocity_b = x.velocity - u.gust;
    steps.controls = mix_controls(c, u, velocity_b);
    steps.velocity_b = airframe_velocity(velocity_b, c.mass.nacelles);
  });

  for (const Side side : {right, left}) {
    rotor_input(c, x, steps.velocity_b, steps.controls, side, steps.rotor_input);
    rotors(c, side, azimuth, steps);
    out_of_line([&] {
      steps.advance_ratio[side] = advance_ratio(c, side, steps.rotor_input.velocity_a);
      steps.hub_loads[side] = hub_loads(c, side, x.rotor[side], steps.rotor[side].loads);
    });
    record(side == right ? Component::rotor_right : Component::rotor_left, steps.hub_loads[side]);
  }

  airframe_input(c, x, steps.velocity_b, steps.controls, steps.rotor, steps.advance_ratio,
                 steps.airframe_input);
  local_airframe_response(c, steps.airframe_input, steps.local.second, steps.airframe, record);

  out_of_line([&] { steps.total = steps.hub_loads[right] + steps.hub_loads[left] + steps.airframe.total; });
  out_of_line([&] {
    Loads<T> jets{};
    if (c.setup.options.engine_jets) {
      T power = T(Real<T>(0));
      for (const Side side : {right, left})
        power = power + (steps.rotor[side].loads.torque + c.rotor[side].spin_up) * c.rotor[side].speed;
      jets = engine_jet_loads(c, power, total_speed(steps.velocity_b, c.aircraft->smooth.airspeed));
      steps.total = steps.total + jets;
    }
    record(Component::engine_jets, static_cast<const Loads<T>&>(jets));
  });
  out_of_line([&] {
    steps.total.force = plus_fixed(steps.total.force, c.outside.force);
    steps.total.moment =
        plus_fixed(steps.total.moment, c.outside.moment) + nacelle_moment(c.mass.nacelles, x.rates);
  });
  out_of_line([&] { rigid_body_rates(c, x, steps.total, rates); });
  out_of_line([&] {
    for (const Side side : {right, left}) rotor_rates(c, x, steps.rotor[side], side, rates);
    rates.downwash = downwash_rate(c, x, steps.airframe_input.velocity_b, steps.airframe.downwash);
  });
}

// Everything, by component.
template <class T, class C>
void evaluate_aircraft(const Configuration<C>& c, const State<T>& x, const Controls<T>& u,
                       DerivativeSteps<T>& steps, Evaluation<T>& out, Real<T> azimuth = Real<T>(0)) {
  recorded_derivative(c, x, u, azimuth, steps, out.rates,
                      [&out](Component component, const Loads<T>& loads) { out.loads[component] = loads; });
  for (const Side side : {right, left}) out.rotor[side] = steps.rotor[side];
  out.wing_alpha = steps.airframe.wing_alpha;
  out.wing_downwash = steps.airframe.downwash;
}
template <class T, class C>
void evaluate_aircraft(const Configuration<C>& c, const State<T>& x, const Controls<T>& u, Evaluation<T>& out,
                       Real<T> azimuth = Real<T>(0)) {
  DerivativeSteps<T> steps;
  evaluate_aircraft(c, x, u, steps, out, azimuth);
}

// xdot alone.
template <class T, class C, class Rotors>
void derivative(const Configuration<C>& c, const State<T>& x, const Controls<T>& u, Rotors rotors,
                Real<T> azimuth, DerivativeSteps<T>& steps, State<T>& rates) {
  recorded_derivative(
      c, x, u, azimuth, steps, rates, [](Component, const auto&) {}, rotors);
}
template <class T, class C>
void derivative(const Configuration<C>& c, const State<T>& x, const Controls<T>& u, DerivativeSteps<T>& steps,
                State<T>& rates, Real<T> azimuth = Real<T>(0), const RotorDirections* own = nullptr) {
  if constexpr (kIsPlain<C> && OuterPartials<T>::count > 0) {
    derivative(c, x, u, KnownRotors<Real<T>>{nullptr, own}, azimuth, steps, rates);
  } else {
    derivative(c, x, u, AskedRotors{}, azimuth, steps, rates);
  }
}
template <class T, class C>
void derivative(const Configuration<C>& c, const State<T>& x, const Controls<T>& u, State<T>& rates,
                Real<T> azimuth = Real<T>(0)) {
  DerivativeSteps<T> steps;
  derivative(c, x, u, steps, rates, azimuth);
}

}  // namespace tiltrotor
