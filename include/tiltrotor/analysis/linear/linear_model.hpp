// The linear model about any state, trimmed or not: A = df/dx, B = df/du.
#pragma once

#include <type_traits>

#include "tiltrotor/analysis/linear/differentiation.hpp"
#include "tiltrotor/math/algebra/matrix.hpp"

namespace tiltrotor {

// Heading and position are left out: nothing depends on them.
constexpr int count_linear_states() {
  int count = 0;
  for (int i = 0; i < state_count; ++i) count += !kStateVariables[i].facts().ignorable;
  return count;
}
inline constexpr int kMaxLinearStates = count_linear_states();
inline constexpr int kMaxLinearControls = control_count;

// The rigid body stands first, longitudinal states before lateral ones.
inline constexpr int kRigidOrder[] = {kStateIndex.velocity.x, kStateIndex.velocity.z, kStateIndex.rates.y,
                                      kStateIndex.pitch,      kStateIndex.velocity.y, kStateIndex.rates.x,
                                      kStateIndex.roll,       kStateIndex.rates.z};
inline constexpr int kRigidStates = sizeof(kRigidOrder) / sizeof(kRigidOrder[0]);
struct RigidPlaces {
  bool holds[state_count];
};
constexpr RigidPlaces rigid_places() {
  RigidPlaces places{};
  for (const int rigid : kRigidOrder) places.holds[rigid] = true;
  return places;
}
inline constexpr RigidPlaces kRigidPlaces = rigid_places();
constexpr bool is_rigid(int state) { return state < state_count && kRigidPlaces.holds[state]; }

// Columns of B: places in kControlVariables.
struct ControlSet {
  int count;
  int index[kMaxLinearControls];
};
// Collective lever, sticks and pedal, as the pilot moves them.
inline constexpr ControlSet kInceptors = {
    4, {kControlIndex.collective, kControlIndex.long_stick, kControlIndex.lat_stick, kControlIndex.pedal}};
// Blade angles and surfaces, one by one.
inline constexpr ControlSet kBladeControls = {
    7,
    {kControlIndex.collective, kControlIndex.long_cyclic, kControlIndex.diff_collective,
     kControlIndex.diff_long_cyclic, kControlIndex.elevator, kControlIndex.aileron, kControlIndex.rudder}};
// Every input of the model, lateral cyclic and gusts included.
constexpr ControlSet every_control() {
  ControlSet set{control_count, {}};
  for (int j = 0; j < control_count; ++j) set.index[j] = j;
  return set;
}
inline constexpr ControlSet kAllControls = every_control();

// The point, and what rows and columns mean. Units as in kStateVariables and kControlVariables.
template <class R>
struct LinearPoint {
  int states;
  int controls;
  int state[kMaxLinearStates];      // row and column i of A belong to kStateVariables[state[i]]
  int control[kMaxLinearControls];  // column j of B belongs to kControlVariables[control[j]]
  R x[kMaxLinearStates];
  R u[kMaxLinearControls];

  const char* state_name(int i) const { return kStateVariables[state[i]].name; }
  const char* state_unit(int i) const { return kStateVariables[state[i]].unit(); }
  const char* control_name(int j) const { return kControlVariables[control[j]].name; }
  const char* control_unit(int j) const { return kControlVariables[control[j]].unit(); }
};

// xdot - rates = A (x' - x) + B (u' - u).
template <class R>
struct LinearModel : LinearPoint<R> {
  R rates[kMaxLinearStates];  // f at the point; zero when it is trimmed and straight
  R xdot[state_count];        // the same for every state of the model, heading and position included
  Matrix<R, kMaxLinearStates, kMaxLinearStates> a;
  Matrix<R, kMaxLinearStates, kMaxLinearControls> b;
};

template <class R, class Policy = DefaultDifferentiation>
struct LinearizationWorkspace {
  static constexpr int kInputs = kMaxLinearStates + kMaxLinearControls;
  using Seeded = typename Policy::template Scalar<R, kModelDirections>;
  static constexpr int kOutputs = state_count + 2;  // rates, and the rotors' torques of vehicle_model.hpp
  typename Policy::template Workspace<R, kModelDirections, kInputs, kOutputs> differentiation;
  ModelWorkspace<Seeded> evaluation;
  R base_x[state_count];
  R base_u[control_count];
  R input[kInputs];
  R scale[kInputs];
};

// The states of a linear model in their order: u w q theta | v p phi r | right rotor | left rotor | downwash
// | coning.
template <class R>
void linear_states(const Options& options, LinearPoint<R>& point) {
  point.states = 0;
  for (const int index : kRigidOrder) point.state[point.states++] = index;
  const ActiveStates active = active_states(options, false);
  for (int k = 0; k < active.count; ++k) {
    const int index = active.index[k];
    if (!is_rigid(index) && !kStateVariables[index].facts().ignorable) point.state[point.states++] = index;
  }
}

template <class R>
void clear(LinearPoint<R>& point) {
  point.states = point.controls = 0;
  for (int i = 0; i < kMaxLinearStates; ++i) {
    point.state[i] = 0;
    point.x[i] = R(0);
  }
  for (int j = 0; j < kMaxLinearControls; ++j) {
    point.control[j] = 0;
    point.u[j] = R(0);
  }
}
template <class R>
void clear(LinearModel<R>& model) {
  clear(static_cast<LinearPoint<R>&>(model));
  for (R& rate : model.rates) rate = R(0);
  for (R& rate : model.xdot) rate = R(0);
  set_zero(model.a);
  set_zero(model.b);
}

// The point about which `work` differentiates: states first, then controls.
// Status: bad_argument: it is empty.
template <class R, class Policy>
Status set_point(const Configuration<R>& c, const State<R>& x, const Controls<R>& u,
                 const ControlSet& columns, LinearizationWorkspace<R, Policy>& work, LinearPoint<R>& point) {
  clear(point);
  if (c.aircraft == nullptr || columns.count < 0 || columns.count > kMaxLinearControls)
    return Status::bad_argument;
  for (int j = 0; j < columns.count; ++j)
    if (columns.index[j] < 0 || columns.index[j] >= control_count) return Status::bad_argument;

  linear_states(c.setup.options, point);
  point.controls = columns.count;
  const int n = point.states;
  flatten(x, work.base_x);
  flatten(u, work.base_u);
  for (int i = 0; i < n; ++i) {
    work.input[i] = point.x[i] = work.base_x[point.state[i]];
    work.scale[i] = state_scale<R>(point.state[i]);
  }
  for (int j = 0; j < point.controls; ++j) {
    point.control[j] = columns.index[j];
    work.input[n + j] = point.u[j] = work.base_u[point.control[j]];
    work.scale[n + j] = control_scale<R>(point.control[j]);
  }
  return Status::ok;
}

// State and controls of one evaluation, in `work.evaluation`: of the point, but for the inputs.
template <class Input, class R, class Policy>
TILTROTOR_NOINLINE void place_point(const Input& input, const LinearPoint<R>& point,
                                    LinearizationWorkspace<R, Policy>& work) {
  const ModelPlaces<typename Input::T> at(work.evaluation);
  int number[state_count + control_count];  // of the input that a state or control is
  for (int& j : number) j = -1;
  for (int i = 0; i < point.states; ++i) number[point.state[i]] = i;
  for (int j = 0; j < point.controls; ++j) number[state_count + point.control[j]] = point.states + j;
  const auto place = [&input](int j, R base, typename Input::T& to) {
    if (j >= 0) {
      input.put(j, to);
    } else {
      to = base;
    }
  };
  for (int i = 0; i < state_count; ++i) place(number[i], work.base_x[i], *at.x[i]);
  for (int j = 0; j < control_count; ++j) place(number[state_count + j], work.base_u[j], *at.u[j]);
}

template <class R>
OwnStates own_states(const LinearPoint<R>& point) {
  return OwnStates(point.states + point.controls,
                   [&point](int j) { return j < point.states ? point.state[j] : -1; });
}

// A and B at (x, u). The arguments are not changed; the model keeps no memory.
// Status: ok; not_finite (a number in the state, the controls, A or B is not finite: A, B and xdot are then
// what was found); bad_argument (`columns` names a control twice over the capacity or out of range, or c is
// not prepared: the model is empty). `azimuth`: rad, for individual blades alone. Cost: AutoDiff one pass of
// 32 directions for up to 32 states and controls, two beyond; NumDiff two evaluations each.
template <class R, class Policy>
Status linearize(const Configuration<R>& c, const State<R>& x, const Controls<R>& u,
                 const ControlSet& columns, LinearizationWorkspace<R, Policy>& work, LinearModel<R>& model,
                 R azimuth = R(0)) {
  clear(model);
  const Status possible = set_point(c, x, u, columns, work, model);
  if (possible != Status::ok) return possible;
  const int n = model.states;
  const int m = model.controls;
  const OwnStates own = own_states(model);
  const auto rates_of = [&](const auto& input, auto&& output) {
    place_point(input, model, work);
    model_rates(c, azimuth, work.evaluation, own.get());
    put_rates(work.evaluation.rates, output);
  };
  int row[state_count];
  for (int& i : row) i = -1;
  for (int i = 0; i < n; ++i) row[model.state[i]] = i;
  Policy::jacobian(rates_of, {n + m, state_count, work.input, work.scale, model.xdot}, work.differentiation,
                   [&model, &row, n](int state, int j, int count, const R* slope) {
                     const int i = row[state];
                     if (i < 0) return;
                     const int states = j >= n ? 0 : n - j < count ? n - j : count;  // the rest are controls
                     const int controls = count - states;
                     if (states > 0) copy_row(slope, states, model.a.row(i) + j);
                     if (controls > 0) copy_row(slope + states, controls, model.b.row(i) + (j + states - n));
                   });
  for (int i = 0; i < n; ++i) model.rates[i] = model.xdot[model.state[i]];
  const bool finite = all_finite(model.a, n, n) && all_finite(model.b, n, m);
  return finite ? Status::ok : Status::not_finite;
}

}  // namespace tiltrotor
