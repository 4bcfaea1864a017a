// What the tests of conditions in flight share.
#pragma once

#include <cmath>

#include "capi/flying.hpp"

namespace capi {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kDegree = kPi / 180;

inline tr_configuration configuration_of(const tr_sim& sim) {
  tr_configuration configuration;
  std::memset(&configuration, 0, sizeof configuration);
  CHECK_EQ(tr_get_configuration(&sim, &configuration), TR_OK);
  return configuration;
}
inline tr_environment calm() {
  tr_environment environment;
  CHECK_EQ(tr_default_environment(&environment), TR_OK);
  return environment;
}
inline void fly(tr_sim& sim, int steps) {
  const auto work = new_work();
  for (int k = 0; k < steps; ++k) CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OK);
}
inline std::vector<double> rates_of(const tr_sim& sim) {
  tr_real rates[TR_STATES];
  CHECK_EQ(tr_derivative(&sim, rates, TR_STATES), TR_OK);
  return {rates, rates + TR_STATES};
}
inline void set_state(tr_sim& sim, const tr_state& state) { CHECK_EQ(tr_set_state(&sim, &state), TR_OK); }

inline tr_systems systems_of(const tr_sim& sim) {
  tr_systems systems;
  std::memset(&systems, 0, sizeof systems);
  CHECK_EQ(tr_get_systems(&sim, &systems), TR_OK);
  return systems;
}
inline void set_systems(tr_sim& sim, const tr_systems& systems) {
  CHECK_EQ(tr_set_systems(&sim, &systems), TR_OK);
}

// A twin in pedal and lateral stick at neutral, whose mixing does not look at the airspeed.
inline tr_sim moving_about() {
  tr_sim sim = trimmed_sim(30, 50);
  tr_state state = state_of(sim);
  state.x[TR_V] = 2;
  state.x[TR_P] = tr_real(0.1);
  state.x[TR_R] = tr_real(-0.05);
  state.u[TR_LAT_STICK] = state.u[TR_PEDAL] = 0;
  set_state(sim, state);
  return sim;
}

}  // namespace capi
