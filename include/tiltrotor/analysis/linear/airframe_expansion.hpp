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
// What the systems put the airframe into: controls, then the configuration, mast and flap in rad.
inline constexpr int kFirstMoved = control_count;
inline constexpr int kDemands = control_count + kMovedCount;

template <class T>
void list_demands(const AirframeDemand<T>& demand, T* to) {
  using R = Real<T>;
  flatten(demand.controls, to);
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

// The airframe to first order about a point. Columns: its `states`, then those of the demands that systems and inputs
// move.
template <class R>
struct Expansion {
  static constexpr int kMostRows = kMaxLinearStates + 3;  // and the position down, and the torques
  static constexpr int kMostColumns = kMaxLinearStates + kMaxLinearControls + kMovedCount;
  R at[kDemands];
  R output[kRows];
  Loads<R> outside, twist;                 // of the gear, and of a shaft that twists
  int rows, row[kMostRows], place[kRows];  // row[place[i]] is i; -1: not asked for
  int states, demands, demand[kDemands];
  Matrix<R, kMostRows, kMostColumns> slope;  // (i, k): of row[i] along column k
};

template <class T>
struct ExpandedWorkspace {
  T demand[kDemands], away[kDemands];
  int first_state, states;  // the airframe's in this pass: its first directions
  bool searches;            // a governor tries demands away from the point
};

// Partials follow the demand; values do where `searches` says so, and are else those of the point.
template <class T>
struct ExpandedAirframe {
  const Expansion<Real<T>>& about;
  const Configuration<Real<T>>& c;
  ExpandedWorkspace<T>& work;

  void operator()(const AirframeDemand<T>& demand, AirframeAnswer<T>& answer) const {
    using R = Real<T>;
    T* found[kRows] = {};
    list_places(answer.rates, found);
    for (const Side side : {right, left}) found[kTorqueRow[side]] = &answer.torque[side];
    list_demands(demand, work.demand);
    for (int k = 0; k < about.demands; ++k)
      work.away[k] = work.demand[about.demand[k]] - about.at[about.demand[k]];
    for (int i = 0; i < kRows; ++i)
      if (about.place[i] < 0) *found[i] = T(R(0));
    for (int i = 0; i < about.rows; ++i) {
      const R* const slope = about.slope.row(i);
      const R* const by_demand = slope + about.states;
      T& sum = *found[about.row[i]];
      sum.v = about.output[about.row[i]];
      if (work.searches)
        for (int k = 0; k < about.demands; ++k) sum.v += by_demand[k] * work.away[k].v;
      sum.d.copy_from(slope + work.first_state, work.states);
      add_chained(sum.d, about.demands, by_demand, work.away);
    }
    const Loads<T> more = {minus_fixed(demand.gear.total.force, about.outside.force),
                           minus_fixed(demand.gear.total.moment, about.outside.moment)};
    add_load(c, more, answer.rates);
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
