// The linear model of the whole vehicle about any state: exact A = df/dx and B = df/du of the closed loop.
//
// By the chain rule through the airframe: its Jacobian with respect to states and controls is that of linear_model.hpp,
// with respect to the configuration that of configuration_sensitivity.hpp; both make its first-order expansion, through
// which the systems run on dual numbers, a few directions at a time.
#pragma once

#include <new>
#include <type_traits>

#include "tiltrotor/analysis/linear/configuration_sensitivity.hpp"
#include "tiltrotor/analysis/linear/linear_model.hpp"
#include "tiltrotor/systems/vehicle_airframe.hpp"

namespace tiltrotor {

// Systems' states that a linear model has: not those on which nothing depends.
constexpr int count_linear_system_states() {
  int count = 0;
  for (int i = 0; i < system_state_count; ++i) count += !kSystemVariables[i].facts().ignorable;
  return count;
}
// With the position down, where ground or air make it count.
inline constexpr int kMaxVehicleStates = kMaxLinearStates + 1 + count_linear_system_states();

// Places of vehicle_variable() and vehicle_input() by row and column.
struct VehicleShape {
  int states, inputs;
  int state[kMaxVehicleStates];
  int input[vehicle_input_count];
};

// States of the airframe's linear model, the position down where something depends on it, then the systems'.
template <class R>
void vehicle_states(const Vehicle<R>& v, const Options& options, VehicleShape& shape) {
  LinearPoint<R> point;
  linear_states(options, point);
  shape.states = 0;
  for (int i = 0; i < point.states; ++i) shape.state[shape.states++] = point.state[i];
  if (v.air_follows || v.on.gear || v.on.ground_effect || shear_in_force(v) != WindShear::none)
    shape.state[shape.states++] = kStateIndex.position.z;
  const ActiveSystems active = active_systems(v.on);
  for (int k = 0; k < active.count; ++k)
    if (!kSystemVariables[active.index[k]].facts().ignorable)
      shape.state[shape.states++] = state_count + active.index[k];
}

namespace vehicle_linearization {

// Rates; those of north and east, which nobody asks for, leave their places to the torques of the rotors.
inline constexpr int kRows = state_count;
inline constexpr int kTorqueRow[2] = {kStateIndex.position.x, kStateIndex.position.y};
inline constexpr ConfigurationParameter kMoved[] = {ConfigurationParameter::mast,
                                                    ConfigurationParameter::mast_rate,
                                                    ConfigurationParameter::mast_acceleration,
                                                    ConfigurationParameter::flap,
                                                    ConfigurationParameter::rotor_speed,
                                                    ConfigurationParameter::rotor_difference,
                                                    ConfigurationParameter::altitude,
                                                    ConfigurationParameter::ground_wash_right,
                                                    ConfigurationParameter::ground_wash_left,
                                                    ConfigurationParameter::download};
inline constexpr int kMovedCount = sizeof kMoved / sizeof kMoved[0];
inline constexpr int kColumns = state_count + control_count + kMovedCount;
inline constexpr int kFirstControl = state_count;
inline constexpr int kFirstMoved = state_count + control_count;

// What the airframe depends on, in the order of the columns: mast and flap in rad.
template <class T>
void list_inputs(const State<T>& x, const AirframeDemand<T>& demand, T* to) {
  using R = Real<T>;
  flatten(x, to);
  flatten(demand.controls, to + kFirstControl);
  const ConfigurationSetting<T>& s = demand.setting;
  const T moved[kMovedCount] = {s.mast_deg * kRadPerDeg<R>,
                                s.mast_rate,
                                s.mast_acceleration,
                                s.flap_deg * kRadPerDeg<R>,
                                s.rotor_speed,
                                s.rotor_difference,
                                s.altitude,
                                demand.ground.wash[right],
                                demand.ground.wash[left],
                                demand.ground.download};
  for (int k = 0; k < kMovedCount; ++k) to[kFirstMoved + k] = moved[k];
}

// The airframe to first order about a point.
template <class R>
struct Expansion {
  R input[kColumns];
  R output[kRows];
  Loads<R> outside, twist;  // of the gear, and of a shaft that twists
  Matrix<R, kRows, kColumns> slope;
  bool used[kColumns];
};

template <class T>
struct ExpandedWorkspace {
  T input[kColumns], output[kRows];
  bool moves[kColumns];  // in this pass: states that are seeded, and what the systems ask for
};

template <class T>
struct ExpandedAirframe {
  const Expansion<Real<T>>& about;
  const Configuration<Real<T>>& c;
  const State<T>& x;
  ExpandedWorkspace<T>& work;

  void operator()(const AirframeDemand<T>& demand, AirframeAnswer<T>& answer) const {
    T(&z)[kColumns] = work.input;
    T(&found)[kRows] = work.output;
    list_inputs(x, demand, z);
    for (int i = 0; i < kRows; ++i) found[i] = T(about.output[i]);
    for (int j = 0; j < kColumns; ++j) {
      if (!work.moves[j]) continue;
      const T away = z[j] - about.input[j];
      for (int i = 0; i < kRows; ++i) found[i] += about.slope(i, j) * away;
    }
    unflatten(found, answer.rates);
    const Loads<T> more = {minus_fixed(demand.gear.total.force, about.outside.force),
                           minus_fixed(demand.gear.total.moment, about.outside.moment)};
    add_load(c, more, answer.rates);
    for (const Side side : {right, left}) answer.torque[side] = found[kTorqueRow[side]];
  }
  void add(const Loads<T>& loads, State<T>& rates) const {
    const Loads<T> more = {minus_fixed(loads.force, about.twist.force),
                           minus_fixed(loads.moment, about.twist.moment)};
    add_load(c, more, rates);
  }
};

}  // namespace vehicle_linearization

// Of one pass through the systems: in vectors twice as many cost a third more, on a microcontroller twice as much and code
// besides. Each direction is computed alike.
inline constexpr int kVehicleDirections = kWidestLanes<double> > 1 ? 16 : 8;

template <class R, class Policy = DefaultDifferentiation>
struct VehicleModelWorkspace {
  using T = Dual<R, kVehicleDirections>;
  struct Systems {
    Configuration<T> configuration;  // where ground counts
    State<T> x;
    SystemState<T> s, rates;
    Commands<T> commands;
    Controls<T> u;
    AirframeDemand<T> demand;
    AirframeAnswer<T> answer;
    VehicleFlows<T> flows;
    T states[vehicle_state_count];  // before the pass, and the rates after it
    T inputs[vehicle_input_count];
    vehicle_linearization::ExpandedWorkspace<T> expanded;
  };
  union Stage {  // one after the other
    Stage() {}
    DerivativeSteps<R> point;
    LinearizationWorkspace<R, Policy> airframe;
    SensitivityWorkspace<R> configuration;
    Systems systems;
  } stage;
  LinearPoint<R> point;
  AirframeDemand<R> demand;
  AirframeAnswer<R> answer;
  vehicle_linearization::Expansion<R> about;
};

namespace vehicle_linearization {

// Which columns the systems move.
template <class R>
void mark_used(const Vehicle<R>& v, const VehicleShape& shape, Expansion<R>& about) {
  for (bool& used : about.used) used = false;
  for (int i = 0; i < shape.states; ++i)
    if (shape.state[i] < state_count && !kStateVariables[shape.state[i]].facts().ignorable)
      about.used[shape.state[i]] = true;
  const auto use = [&about](int control) { about.used[kFirstControl + control] = true; };
  const Controls<int>& at = kControlIndex;
  if (v.on.actuators) {
    for (const int j : kBladeControls.index) use(j);
    use(at.lateral_cyclic);
  }
  for (int j = 0; j < shape.inputs; ++j) {
    const int input = shape.input[j];
    const bool reaches =
        !v.on.actuators || kControlVariables[input < control_count ? input : 0].kind == VariableKind::gust;
    if (input < control_count && reaches) use(input);
  }
  if (v.on.governor != Governor::off) use(at.collective);
  if (v.on.augmentation && !v.on.actuators)
    for (const int j : {at.long_stick, at.lat_stick, at.pedal}) use(j);
  for (int k = 0; k < kMovedCount; ++k) {
    const ConfigurationParameter moved = kMoved[k];
    using P = ConfigurationParameter;
    about.used[kFirstMoved + k] = moved == P::rotor_speed         ? v.on.governor == Governor::pi
                                  : moved == P::rotor_difference  ? twists(v.on)
                                  : moved == P::altitude          ? v.air_follows
                                  : moved >= P::ground_wash_right ? v.on.ground_effect
                                                                  : v.on.conversion;
  }
}

// Slopes with respect to what the systems move of the configuration.
template <class R, class Policy>
void add_configuration_slopes(const Configuration<R>& c, const State<R>& x, const AirframeDemand<R>& demand,
                              R azimuth, VehicleModelWorkspace<R, Policy>& work, Expansion<R>& about) {
  using Moved = SensitivityWorkspace<R>;
  using T = typename Moved::T;
  ParameterSet set{0, {}};
  int column[kMovedCount];
  for (int k = 0; k < kMovedCount; ++k) {
    if (!about.used[kFirstMoved + k]) continue;
    column[set.count] = kFirstMoved + k;
    set.parameter[set.count++] = kMoved[k];
  }
  if (set.count == 0) return;
  Moved& at = *::new (static_cast<void*>(&work.stage)) Moved;
  in_scalar(x, at.x);
  in_scalar(demand.controls, at.u);
  for (int first = 0; first < set.count; first += kParameterDirections) {
    const int count = set.count - first < kParameterDirections ? set.count - first : kParameterDirections;
    T by[kParameterDirections];
    for (int k = 0; k < count; ++k) by[k] = T::variable(R(0), k);
    moved_configuration(c, set.parameter + first, by, count, at.configuration);
    at.configuration.outside.force = plus_fixed(at.configuration.outside.force, demand.gear.total.force);
    const Vec3<R> moment = demand.gear.total.moment + about.twist.moment;
    at.configuration.outside.moment = plus_fixed(at.configuration.outside.moment, moment);
    derivative(at.configuration, at.x, at.u, at.derivative, at.evaluation.rates, azimuth);
    T found[kRows];
    flatten(at.evaluation.rates, found);
    for (const Side side : {right, left}) found[kTorqueRow[side]] = at.derivative.rotor[side].loads.torque;
    for (int i = 0; i < kRows; ++i)
      for (int k = 0; k < count; ++k) about.slope(i, column[first + k]) = found[i].d.get(k);
  }
}

// Columns through which the airframe feels the directions `first` to `last`.
template <class R, class T>
void mark_moves(const Expansion<R>& about, const VehicleShape& shape, int first, int last,
                ExpandedWorkspace<T>& to) {
  for (int j = 0; j < kColumns; ++j) to.moves[j] = about.used[j] && j >= kFirstControl;
  for (int k = first; k < last && k < shape.states; ++k)
    if (shape.state[k] < state_count) to.moves[shape.state[k]] = about.used[shape.state[k]];
}

// All states and inputs of a pass, those of its directions seeded.
template <class R, class Systems>
void seed(const State<R>& x, const SystemState<R>& s, const Commands<R>& commands, const Controls<R>& u,
          const VehicleShape& shape, int first, int last, Systems& to) {
  auto& states = to.states;
  auto& inputs = to.inputs;
  using T = std::remove_extent_t<std::remove_reference_t<decltype(states)>>;
  R flat[vehicle_state_count], flat_inputs[vehicle_input_count];
  flatten(x, flat);
  flatten(s, flat + state_count);
  flatten(u, flat_inputs);
  flatten(commands, flat_inputs + control_count);
  for (int i = 0; i < vehicle_state_count; ++i) states[i] = T(flat[i]);
  for (int j = 0; j < vehicle_input_count; ++j) inputs[j] = T(flat_inputs[j]);
  for (int k = first; k < last; ++k) {
    T& seeded = k < shape.states ? states[shape.state[k]] : inputs[shape.input[k - shape.states]];
    seeded.d.set(k - first, R(1));
  }
  unflatten(states, to.x);
  unflatten(states + state_count, to.s);
  unflatten(inputs, to.u);
  unflatten(inputs + control_count, to.commands);
}

}  // namespace vehicle_linearization

// put_a(i, j, df_i/dx_j) and put_b(i, j, df_i/du_j) at (x, s, u), rows and columns as `shape` says; `xdot` and `sdot`:
// the rates there. `c`: as the systems have put it at this state (put_into()), and put there again.
// Status: ok; not_finite (a rate or an entry is not finite); bad_argument (c is not prepared); not_converged (an
// ideal governor finds no collective for the power of the engines).
// Cost: 2 derivatives (7 with an ideal governor), a Jacobian (2 beyond 32 directions), a pass of configuration_sensitivity() where
// masts, rotor speed or air move.
template <class R, class Policy, class PutA, class PutB>
Status linearize_vehicle(const Vehicle<R>& v, Configuration<R>& c, const State<R>& x, const SystemState<R>& s,
                         const Controls<R>& u, const VehicleShape& shape,
                         VehicleModelWorkspace<R, Policy>& work, State<R>& xdot, SystemState<R>& sdot,
                         PutA&& put_a, PutB&& put_b, R azimuth = R(0)) {
  namespace d = vehicle_linearization;
  if (c.aircraft == nullptr) return Status::bad_argument;
  d::Expansion<R>& about = work.about;
  // The point;
  DerivativeSteps<R>& steps = *::new (static_cast<void*>(&work.stage)) DerivativeSteps<R>;
  const ConfigurationSetting<R> base = c.setup;
  VehicleFlows<R> flows;
  vehicle_rates(v, c, base, c, x, s, v.commands, u, VehicleAirframe<R>{c, x, steps, azimuth}, work.demand,
                work.answer, flows, sdot);
  xdot = work.answer.rates;
  if (!flows.held) return Status::not_converged;
  SystemState<R> point_state = s;
  if (v.on.governor == Governor::ideal) point_state.governor = flows.governed;
  d::list_inputs(x, work.demand, about.input);
  about.outside = work.demand.gear.total;
  about.twist =
      twists(v.on) ? vehicle_parts::twist_reaction(c, work.demand.setting, sdot.twist_rate) : Loads<R>{};
  c.outside = c.outside + about.twist;  // until the next put_into()
  d::mark_used(v, shape, about);
  set_zero(about.slope);

  // the airframe: states and controls,
  ControlSet columns{0, {}};
  for (int j = 0; j < control_count; ++j)
    if (about.used[d::kFirstControl + j]) columns.index[columns.count++] = j;
  using Airframe = LinearizationWorkspace<R, Policy>;
  Airframe& airframe = *::new (static_cast<void*>(&work.stage)) Airframe;
  LinearPoint<R>& point = work.point;
  const Status possible = set_point(c, x, work.demand.controls, columns, airframe, point);
  if (possible != Status::ok) return possible;
  const auto answer_of = [&](const auto* input, auto* found) {
    place_point(input, point, airframe);
    auto& at = airframe.evaluation;
    unflatten(at.x, at.state);
    unflatten(at.u, at.controls);
    derivative(c, at.state, at.controls, at.derivative, at.rates, azimuth);
    flatten(at.rates, found);
    for (const Side side : {right, left}) found[d::kTorqueRow[side]] = at.derivative.rotor[side].loads.torque;
  };
  const int n = point.states;
  Policy::jacobian(answer_of, {n + point.controls, d::kRows, airframe.input, airframe.scale, about.output},
                   airframe.differentiation, [&](int i, int j, int count, const R* slope) {
                     for (const R* const end = slope + count; slope < end; ++j)
                       about.slope(i, j < n ? point.state[j] : d::kFirstControl + point.control[j - n]) =
                           *slope++;
                   });

  // and the configuration;
  d::add_configuration_slopes(c, x, work.demand, azimuth, work, about);

  // the systems, through its expansion.
  using T = typename VehicleModelWorkspace<R, Policy>::T;
  using Systems = typename VehicleModelWorkspace<R, Policy>::Systems;
  Systems& systems = *::new (static_cast<void*>(&work.stage)) Systems;
  static_cast<FixedSetup<R>&>(systems.configuration) = c;
  systems.configuration.setup.options = c.setup.options;
  systems.configuration.around = c.around;
  R poison = R(0);  // x * 0 is 0 for every finite x and NaN otherwise
  const int all = shape.states + shape.inputs;
  for (int first = 0; first < all; first += kVehicleDirections) {
    const int last = first + kVehicleDirections < all ? first + kVehicleDirections : all;
    d::seed(x, point_state, v.commands, u, shape, first, last, systems);
    d::mark_moves(about, shape, first, last, systems.expanded);
    vehicle_rates<T>(v, c, base, systems.configuration, systems.x, systems.s, systems.commands, systems.u,
                     d::ExpandedAirframe<T>{about, c, systems.x, systems.expanded}, systems.demand,
                     systems.answer, systems.flows, systems.rates);
    T(&found)[vehicle_state_count] = systems.states;
    flatten(systems.answer.rates, found);
    flatten(systems.rates, found + state_count);
    for (int i = 0; i < shape.states; ++i) {
      const T& rate = found[shape.state[i]];
      R slope[kVehicleDirections];
      rate.d.copy_to(slope);
      poison += rate.v * R(0);
      for (int j = first; j < last; ++j) poison += slope[j - first] * R(0);
      int j = first;
      for (; j < last && j < shape.states; ++j) put_a(i, j, slope[j - first]);
      for (; j < last; ++j) put_b(i, j - shape.states, slope[j - first]);
    }
  }
  return poison == R(0) ? Status::ok : Status::not_finite;
}

}  // namespace tiltrotor
