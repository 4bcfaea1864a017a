// How rates and the readings of the instruments change: C = dy/dx and D = dy/du beside A and B, and all of it
// along one direction.
#pragma once

#include "tiltrotor/analysis/flight/instruments.hpp"
#include "tiltrotor/analysis/linear/linear_model.hpp"

namespace tiltrotor {

template <class R, class Policy = DefaultDifferentiation>
struct OutputModelWorkspace {
  LinearizationWorkspace<R, Policy> linear;
  Instruments<typename LinearizationWorkspace<R, Policy>::Seeded> readings;
};

// Directions are those of a Jacobian, whose code is then shared; one alone needs code of its own.
template <class R, class Policy = DefaultDifferentiation, int Directions = kModelDirections>
struct DirectionalWorkspace {
  static constexpr int kOutputs = state_count + Instruments<R>::kCount;
  using Seeded = typename Policy::template Scalar<R, Directions>;
  typename Policy::template Workspace<R, Directions, 1, kOutputs> differentiation;
  ModelWorkspace<Seeded> evaluation;
  Instruments<Seeded> readings;
  R base_x[state_count];
  R base_u[control_count];
  R found[kOutputs];
};

namespace output_model_detail {

// State and controls of `at` -> at.rates, and the readings.
template <class T>
TILTROTOR_NOINLINE void rates_and_readings(const Configuration<Real<T>>& c, Real<T> azimuth,
                                           ModelWorkspace<T>& at, Instruments<T>& readings) {
  derivative(c, at.state, at.controls, at.derivative, at.rates, azimuth);
  read_instruments(c, at.state, at.derivative, at.rates, readings);
}

// output(first + i, reading i), for each.
template <class T, class Output>
TILTROTOR_NOINLINE void put_readings(const Instruments<T>& readings, int first, Output&& output) {
  const T* reading[Instruments<T>::kCount];
  list_places(readings, reading);
  for (int i = 0; i < Instruments<T>::kCount; ++i) output(first + i, *reading[i]);
}

// State and controls of one evaluation, input 0 times the direction beside the point.
template <class Input, class R, class Work>
TILTROTOR_NOINLINE void place_along(const Input& input, const R* dx, const R* du, Work& work) {
  const ModelPlaces<typename Input::T> at(work.evaluation);
  const typename Input::T way = input[0];
  for (int i = 0; i < state_count; ++i) *at.x[i] = work.base_x[i] + dx[i] * way;
  for (int j = 0; j < control_count; ++j) *at.u[j] = work.base_u[j] + du[j] * way;
}

// How far along the direction until the model bends.
template <class R>
R direction_scale(const R* dx, const R* du) {
  R most = R(0);
  const auto take = [&most](R size) { most = size > most ? size : most; };
  for (int i = 0; i < state_count; ++i) take(std::fabs(dx[i]) / state_scale<R>(i));
  for (int j = 0; j < control_count; ++j) take(std::fabs(du[j]) / control_scale<R>(j));
  return most > R(0) ? R(1) / most : R(1);
}

}  // namespace output_model_detail

// put_c(i, j, dy_i/dx_j) and put_d(i, j, dy_i/du_j) at (x, u), y the readings in the order of Instruments.
// `point` says the states j and controls j. Status: ok; bad_argument, as
// linearize(). Cost: that of linearize().
template <class R, class Policy, class PutC, class PutD>
Status linearize_outputs(const Configuration<R>& c, const State<R>& x, const Controls<R>& u,
                         const ControlSet& columns, OutputModelWorkspace<R, Policy>& work,
                         LinearPoint<R>& point, PutC&& put_c, PutD&& put_d, R azimuth = R(0)) {
  constexpr int outputs = Instruments<R>::kCount;
  static_assert(outputs <= state_count, "the workspace of a linear model holds the readings");
  const Status possible = set_point(c, x, u, columns, work.linear, point);
  if (possible != Status::ok) return possible;
  const int n = point.states;
  const auto readings_of = [&](const auto& input, auto&& output) {
    place_point(input, point, work.linear);
    output_model_detail::rates_and_readings(c, azimuth, work.linear.evaluation, work.readings);
    output_model_detail::put_readings(work.readings, 0, output);
  };
  R y[outputs];
  Policy::jacobian(readings_of, {n + point.controls, outputs, work.linear.input, work.linear.scale, y},
                   work.linear.differentiation, [&](int i, int j, int count, const R* slope) {
                     const R* const end = slope + count;
                     for (; j < n && slope < end; ++j) put_c(i, j, *slope++);
                     for (; slope < end; ++j) put_d(i, j - n, *slope++);
                   });
  return Status::ok;
}

// dxdot[state_count] and dy[Instruments::kCount] along dx[state_count] and du[control_count]: A dx + B du over
// every state, C dx + D du. Status: ok; not_finite (what was found is then written); bad_argument (c is not
// prepared). Cost: a Jacobian, or
// with one direction about two derivatives.
template <class R, class Policy, int Directions>
Status directional(const Configuration<R>& c, const State<R>& x, const Controls<R>& u, const R* dx,
                   const R* du, DirectionalWorkspace<R, Policy, Directions>& work, R* dxdot, R* dy,
                   R azimuth = R(0)) {
  constexpr int outputs = DirectionalWorkspace<R, Policy, Directions>::kOutputs;
  if (c.aircraft == nullptr) return Status::bad_argument;
  flatten(x, work.base_x);
  flatten(u, work.base_u);
  const auto along_direction = [&](const auto& input, auto&& output) {
    output_model_detail::place_along(input, dx, du, work);
    output_model_detail::rates_and_readings(c, azimuth, work.evaluation, work.readings);
    put_rates(work.evaluation.rates, output);
    output_model_detail::put_readings(work.readings, state_count, output);
  };
  const R here = R(0);
  const R scale = output_model_detail::direction_scale(dx, du);
  bool finite = true;
  Policy::jacobian(along_direction, {1, outputs, &here, &scale, work.found}, work.differentiation,
                   [&](int i, int, int, const R* slope) {
                     finite &= is_finite(*slope);
                     (i < state_count ? dxdot[i] : dy[i - state_count]) = *slope;
                   });
  return finite ? Status::ok : Status::not_finite;
}

}  // namespace tiltrotor
