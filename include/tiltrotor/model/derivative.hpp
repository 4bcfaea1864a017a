// The complete aircraft: xdot = f(x, u). Flapping, inflow and downwash are states, so every step below uses
// only what stands above it: no loop is closed inside.
#pragma once

#include "tiltrotor/model/component_inputs.hpp"
#include "tiltrotor/model/derivative_workspace.hpp"
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

namespace derivative_detail {

// Partials of a configuration reach a component beside its input: it must then be evaluated on T itself.
template <class T, class C>
inline constexpr bool kScalarsFit = kIsPlain<C> ||
                                    (std::is_same_v<C, T> && std::is_same_v<LocalDual<RotorInput, T>, T> &&
                                     std::is_same_v<LocalDual<AirframeInput, T>, T>);

// The components on scalars of their own, which carry as many directions as a component sees.
template <class T, class C>
void local_rotor_response(const Configuration<C>& c, const RotorInput<T>& in, Real<T> azimuth,
                          LocalRotorWorkspace<T>& work, RotorResponse<T>& out) {
  const bool averaged = c.setup.options.azimuth == AzimuthMode::averaged;
  if (!averaged) individual_azimuth(c.aircraft->rotor.blades, azimuth, work.blades);
  const AzimuthStations<Real<T>>& stations = averaged ? c.azimuth : work.blades;
  preaccumulate(in, work.chain, out, [&](const auto& local, auto& found) {
    rotor_response(c, local, stations, work.rotor, found);
  });
}
template <class T, class C, class Record>
void local_airframe_response(const Configuration<C>& c, const AirframeInput<T>& in,
                             LocalAirframeWorkspace<T>& work, AirframeResponse<T>& out, Record& record) {
  preaccumulate(in, work.chain, out, [&](const auto& local, auto& found) {
    airframe_response(c, local, work.airframe, found, record);
  });
}

}  // namespace derivative_detail

// xdot and, in `work`, what leads to it; `record(component, loads)` sees the loads of every component.
// `azimuth`: position of the right rotor's first blade (rad), used in the individual-blade mode alone; the
// left rotor mirrors it.
template <class T, class C, class Record>
void recorded_derivative(const Configuration<C>& c, const State<T>& x, const Controls<T>& u, Real<T> azimuth,
                         DerivativeWorkspace<T>& work, State<T>& rates, Record&& record) {
  static_assert(derivative_detail::kScalarsFit<T, C>,
                "a configuration with partials has the scalar of the state, of at most 16 directions");
  out_of_line([&] {
    work.velocity_b = x.velocity - u.gust;
    work.controls = mix_controls(c, u, work.velocity_b);
  });

  for (const Side side : {right, left}) {
    rotor_input(c, x, work.velocity_b, work.controls, side, work.rotor_input);
    derivative_detail::local_rotor_response(c, work.rotor_input, azimuth, work.local.rotor, work.rotor[side]);
    out_of_line([&] {
      work.advance_ratio[side] = advance_ratio(c, work.rotor_input.velocity_a);
      work.hub_loads[side] = hub_loads(c, side, x.rotor[side], work.rotor[side].loads);
    });
    record(side == right ? rotor_right : rotor_left, work.hub_loads[side]);
  }

  airframe_input(c, x, work.velocity_b, work.controls, work.rotor, work.advance_ratio, work.airframe_input);
  derivative_detail::local_airframe_response(c, work.airframe_input, work.local.airframe, work.airframe,
                                             record);

  out_of_line([&] { work.total = work.hub_loads[right] + work.hub_loads[left] + work.airframe.total; });
  out_of_line([&] { rigid_body_rates(c, x, work.total, rates); });
  out_of_line([&] {
    for (const Side side : {right, left}) rotor_rates(c, x, work.rotor[side], side, rates);
    rates.downwash = downwash_rate(c, x, work.velocity_b, work.airframe.downwash);
  });
}

// Everything, by component.
template <class T, class C>
void evaluate_aircraft(const Configuration<C>& c, const State<T>& x, const Controls<T>& u,
                       DerivativeWorkspace<T>& work, Evaluation<T>& out, Real<T> azimuth = Real<T>(0)) {
  recorded_derivative(c, x, u, azimuth, work, out.rates, [&out](Component component, const Loads<T>& loads) {
    out.loads.component[component] = loads;
  });
  for (const Side side : {right, left}) out.rotor[side] = work.rotor[side];
  out.wing_alpha = work.airframe.wing_alpha;
  out.wing_downwash = work.airframe.downwash;
}
template <class T, class C>
void evaluate_aircraft(const Configuration<C>& c, const State<T>& x, const Controls<T>& u, Evaluation<T>& out,
                       Real<T> azimuth = Real<T>(0)) {
  DerivativeWorkspace<T> work;
  evaluate_aircraft(c, x, u, work, out, azimuth);
}

// xdot alone.
template <class T, class C>
void derivative(const Configuration<C>& c, const State<T>& x, const Controls<T>& u,
                DerivativeWorkspace<T>& work, State<T>& rates, Real<T> azimuth = Real<T>(0)) {
  recorded_derivative(c, x, u, azimuth, work, rates, [](Component, const auto&) {});
}
template <class T, class C>
void derivative(const Configuration<C>& c, const State<T>& x, const Controls<T>& u, State<T>& rates,
                Real<T> azimuth = Real<T>(0)) {
  DerivativeWorkspace<T> work;
  derivative(c, x, u, work, rates, azimuth);
}

}  // namespace tiltrotor
