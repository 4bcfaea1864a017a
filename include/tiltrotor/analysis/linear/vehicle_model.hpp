// The linear model of the whole vehicle about any state: exact A = df/dx and B = df/du of the closed loop.
//
// By the chain rule through the airframe: its Jacobian with respect to states and controls is that of linear_model.hpp,
// with respect to the configuration that of a configuration with partials (configuration_sensitivity.hpp); both make its first-order expansion, through
// which the systems run on dual numbers, a few directions at a time.
#pragma once

#include <new>

#include "tiltrotor/analysis/linear/system_passes.hpp"

namespace tiltrotor {

template <class R, class Policy = DefaultDifferentiation>
struct VehicleModelWorkspace {
  union Stage {  // one after the other
    Stage() {}
    DerivativeSteps<R> point;
    LinearizationWorkspace<R, Policy> airframe;
    RotorExpansionWorkspace<R> rotors;
    SensitivityWorkspace<R> configuration;
    SystemPassWorkspace<R> systems;
  } stage;
  LinearPoint<R> point;
  ConfigurationSetting<R> base;  // before the systems put it
  SystemState<R> state;          // at the point
  AirframeDemand<R> demand;
  AirframeAnswer<R> answer;
  vehicle_linearization::Expansion<R> about;
  RotorExpansion<R> rotors;
};

namespace vehicle_linearization {

// Controls through which the airframe feels systems and inputs.
template <class R>
ControlSet felt_controls(const Vehicle<R>& v, const VehicleShape& shape) {
  bool used[control_count] = {};
  const Controls<int>& at = kControlIndex;
  if (v.on.actuators)
    for (const int j : kBladeControls.index) used[j] = true;
  for (int j = 0; j < shape.inputs; ++j) {
    const int input = shape.input[j];
    const bool is_gust = input < control_count && kControlVariables[input].kind == VariableKind::gust;
    const bool reaches = !v.on.actuators || input == at.lateral_cyclic || is_gust;
    if (input < control_count && reaches) used[input] = true;
  }
  if (v.on.governor != Governor::off) used[at.collective] = true;
  if (v.on.augmentation && !v.on.actuators)
    for (const int j : {at.long_stick, at.lat_stick, at.pedal}) used[j] = true;
  ControlSet set{0, {}};
  for (int j = 0; j < control_count; ++j)
    if (used[j]) set.index[set.count++] = j;
  return set;
}

// What systems move of the configuration.
template <class R>
bool is_moved(const Vehicle<R>& v, ConfigurationParameter parameter) {
  using P = ConfigurationParameter;
  return parameter == P::rotor_speed         ? v.on.governor == Governor::pi
         : parameter == P::rotor_difference  ? twists(v.on)
         : parameter == P::altitude          ? v.air_follows
         : parameter >= P::ground_wash_right ? v.on.ground_effect
                                             : v.on.conversion;
}

// Rows and columns of an expansion about `point`.
template <class R>
void list_columns(const Vehicle<R>& v, const VehicleShape& shape, const LinearPoint<R>& point,
                  Expansion<R>& about) {
  about.rows = 0;
  for (int& place : about.place) place = -1;
  const auto ask = [&about](int row) {
    about.place[row] = about.rows;
    about.row[about.rows++] = row;
  };
  for (int i = 0; i < shape.states; ++i)
    if (shape.state[i] < state_count) ask(shape.state[i]);
  for (const int torque : kTorqueRow) ask(torque);
  about.states = point.states;
  about.demands = 0;
  for (int j = 0; j < point.controls; ++j) about.demand[about.demands++] = point.control[j];
  for (int k = 0; k < kMovedCount; ++k)
    if (is_moved(v, kMoved[k])) about.demand[about.demands++] = kFirstMoved + k;
}

// Slopes with respect to what the systems move of the configuration, which stands behind the controls.
template <class R, class Policy>
void add_configuration_slopes(const Configuration<R>& c, const State<R>& x, const AirframeDemand<R>& demand,
                              R azimuth, int controls, VehicleModelWorkspace<R, Policy>& work,
                              Expansion<R>& about) {
  using Moved = SensitivityWorkspace<R>;
  using T = typename Moved::T;
  if (controls == about.demands) return;
  Moved& at = *::new (static_cast<void*>(&work.stage)) Moved;
  in_scalar(x, at.x);
  in_scalar(demand.controls, at.u);
  for (int first = controls; first < about.demands; first += kParameterDirections) {
    const int rest = about.demands - first, count = rest < kParameterDirections ? rest : kParameterDirections;
    ConfigurationParameter moved[kParameterDirections];
    T by[kParameterDirections];
    for (int k = 0; k < count; ++k) {
      moved[k] = kMoved[about.demand[first + k] - kFirstMoved];
      by[k] = T::variable(R(0), k);
    }
    moved_configuration(c, moved, by, count, at.configuration);
    at.configuration.outside.force = plus_fixed(at.configuration.outside.force, demand.gear.total.force);
    const Vec3<R> moment = demand.gear.total.moment + about.twist.moment;
    at.configuration.outside.moment = plus_fixed(at.configuration.outside.moment, moment);
    derivative(at.configuration, at.x, at.u, ExpandedRotors<R>{work.rotors}, azimuth, at.derivative,
               at.evaluation.rates);
    T found[kRows];
    flatten(at.evaluation.rates, found);
    for (const Side side : {right, left}) found[kTorqueRow[side]] = at.derivative.rotor[side].loads.torque;
    for (int i = 0; i < about.rows; ++i)
      for (int k = 0; k < count; ++k) about.slope(i, about.states + first + k) = found[about.row[i]].d.get(k);
  }
}

}  // namespace vehicle_linearization

// put_a(i, j, count, slopes): df_i/dx_j and the next ones of its row, and put_b(i, j, count, slopes): df_i/du_j, at (x, s, u),
// rows and columns as `shape` says, its states those of vehicle_states(); `xdot` and `sdot`: the rates there. `c`: as the systems have put it at this state
// (put_into()), and put there again.
// Status: ok; not_finite (a rate or an entry is not finite); bad_argument (c is not prepared, or other states); not_converged (an
// ideal governor finds no collective for the power of the engines).
// Cost: a Jacobian (2 beyond 32 directions), a third of one where masts, rotor speed, air or ground move, and two
// fifths for the systems; with an ideal governor some 10 derivatives more.
template <class R, class Policy, class PutA, class PutB>
Status linearize_vehicle(const Vehicle<R>& v, Configuration<R>& c, const State<R>& x, const SystemState<R>& s,
                         const Controls<R>& u, const VehicleShape& shape,
                         VehicleModelWorkspace<R, Policy>& work, State<R>& xdot, SystemState<R>& sdot,
                         PutA&& put_a, PutB&& put_b, R azimuth = R(0)) {
  namespace d = vehicle_linearization;
  if (c.aircraft == nullptr) return Status::bad_argument;
  d::Expansion<R>& about = work.about;
  // What the systems ask for;
  ConfigurationSetting<R>& base = work.base;
  SystemState<R>& point_state = work.state;
  base = c.setup;
  point_state = s;
  const bool searches = v.on.governor == Governor::ideal;
  VehicleFlows<R> flows;
  if (searches) {
    DerivativeSteps<R>& steps = *::new (static_cast<void*>(&work.stage)) DerivativeSteps<R>;
    vehicle_rates(v, c, base, c, x, s, v.commands, u, VehicleAirframe<R>{c, x, steps, azimuth}, work.demand,
                  work.answer, flows, sdot);
    xdot = work.answer.rates;
    if (!flows.held) return Status::not_converged;
    point_state.governor = flows.governed;
  } else {
    airframe_demand(v, c, base, c, x, s, v.commands, u, work.demand, flows, sdot);
    put_into(work.demand, c);
  }
  d::list_demands(work.demand, about.at);

  // the rotors, where the configuration moves,
  bool moves = false;
  for (const ConfigurationParameter parameter : d::kMoved) moves |= d::is_moved(v, parameter);
  if (moves) {
    auto& rotors = *::new (static_cast<void*>(&work.stage)) RotorExpansionWorkspace<R>;
    expand_rotors(c, x, work.demand.controls, azimuth, rotors, work.rotors);
  }

  // the airframe: states and controls,
  using Airframe = LinearizationWorkspace<R, Policy>;
  Airframe& airframe = *::new (static_cast<void*>(&work.stage)) Airframe;
  LinearPoint<R>& point = work.point;
  const Status possible = set_point(c, x, work.demand.controls, d::felt_controls(v, shape), airframe, point);
  if (possible != Status::ok) return possible;
  for (int i = 0; i < point.states; ++i)
    if (i >= shape.states || shape.state[i] != point.state[i]) return Status::bad_argument;
  d::list_columns(v, shape, point, about);
  const OwnStates own = own_states(point);
  const auto answer_of = [&](const auto& input, auto&& output) {
    place_point(input, point, airframe);
    auto& at = airframe.evaluation;
    derivative(c, at.state, at.controls, KnownRotors<R>{moves ? &work.rotors : nullptr, own.get()}, azimuth,
               at.derivative, at.rates);
    put_rates(at.rates, output);
    for (const Side side : {right, left}) output(d::kTorqueRow[side], at.derivative.rotor[side].loads.torque);
  };
  const int directions = point.states + point.controls;
  Policy::jacobian(answer_of, {directions, d::kRows, airframe.input, airframe.scale, about.output},
                   airframe.differentiation, [&](int row, int j, int count, const R* slope) {
                     const int i = about.place[row];
                     if (i >= 0) copy_row(slope, count, about.slope.row(i) + j);
                   });

  // the rates, of which the airframe's are known;
  about.outside = work.demand.gear.total;
  about.twist = Loads<R>{};
  if (!searches) {
    unflatten(about.output, work.answer.rates);
    for (const Side side : {right, left}) work.answer.torque[side] = about.output[d::kTorqueRow[side]];
    follow_airframe(v, c, x, s, v.commands, d::FoundAirframe<R>{c}, work.demand, work.answer, flows, sdot);
    xdot = work.answer.rates;
  }
  if (twists(v.on)) {
    about.twist = vehicle_parts::twist_reaction(c, work.demand.setting, sdot.twist_rate);
    State<R>& twisted = work.answer.rates;
    unflatten(about.output, twisted);
    add_load(c, about.twist, twisted);
    flatten(twisted, about.output);
  }

  // the configuration;
  d::add_configuration_slopes(c, x, work.demand, azimuth, point.controls, work, about);

  // the systems, through the airframe's expansion.
  auto& systems = *::new (static_cast<void*>(&work.stage)) SystemPassWorkspace<R>;
  return d::differentiate_systems(v, c, base, x, point_state, u, shape, about, systems, put_a, put_b)
             ? Status::ok
             : Status::not_finite;
}

}  // namespace tiltrotor
