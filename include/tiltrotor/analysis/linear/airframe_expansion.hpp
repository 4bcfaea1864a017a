// The airframe to first order about a point, in what the systems make it feel: rates and torques over states, controls and
// configuration, for the systems to run through on dual numbers.
#pragma once

#include "tiltrotor/analysis/linear/configuration_sensitivity.hpp"
#include "tiltrotor/analysis/linear/linear_model.hpp"
#include "tiltrotor/systems/vehicle_airframe.hpp"

namespace tiltrotor {

namespace vehicle_linearization {

// Rates, and the torques of the rotors.
inline constexpr int kRows = state_count + 2;
inline constexpr int kTorqueRow[2] = {state_count, state_count + 1};
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

// The airframe to first order about a point. Columns count that systems and inputs move: `states` of the airframe, then
// controls, then the configuration.
template <class R>
struct Expansion {
  static constexpr int kMostRows = kMaxLinearStates + 3;  // and the position down, and the torques
  static constexpr int kMostColumns = kMaxLinearStates + kMaxLinearControls + kMovedCount;
  R input[kColumns];
  R output[kRows];
  Loads<R> outside, twist;                 // of the gear, and of a shaft that twists
  int rows, row[kMostRows], place[kRows];  // row[place[i]] is i; -1: not asked for
  int states, columns, column[kMostColumns];
  Matrix<R, kMostRows, kMostColumns> slope;  // (i, k): of row[i] along column[k]
};

template <class T>
struct ExpandedWorkspace {
  T input[kColumns], output[kRows];
  int first_state, last_state;  // that are seeded in this pass
};

template <class T>
struct ExpandedAirframe {
  const Expansion<Real<T>>& about;
  const Configuration<Real<T>>& c;
  const State<T>& x;
  ExpandedWorkspace<T>& work;

  void operator()(const AirframeDemand<T>& demand, AirframeAnswer<T>& answer) const {
    using R = Real<T>;
    T(&found)[kRows] = work.output;
    list_inputs(x, demand, work.input);
    const int from = work.first_state, to = work.last_state;
    T(&away)[kColumns] = work.input;
    const auto leave_point = [&](int j) { away[j] = away[j] - about.input[j]; };
    for (int k = from; k < to; ++k) leave_point(about.column[k]);
    for (int k = about.states; k < about.columns; ++k) leave_point(about.column[k]);
    for (T& nothing : found) nothing = T(R(0));
    for (int i = 0; i < about.rows; ++i) {
      const R* const slope = about.slope.row(i);
      T sum = T(about.output[about.row[i]]);
      for (int k = from; k < to; ++k) sum += slope[k] * away[about.column[k]];
      for (int k = about.states; k < about.columns; ++k) sum += slope[k] * away[about.column[k]];
      found[about.row[i]] = sum;
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

// The airframe where its rates have been found already.
template <class R>
struct FoundAirframe {
  const Configuration<R>& c;
  void add(const Loads<R>& loads, State<R>& rates) const { add_load(c, loads, rates); }
};

}  // namespace vehicle_linearization

}  // namespace tiltrotor
