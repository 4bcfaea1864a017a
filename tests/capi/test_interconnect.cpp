// The shaft between the rotors through the C interface. Expected values: rest, the same aircraft saved and loaded.
#include <cmath>

#include "capi/conditions.hpp"

using namespace capi;

namespace {

double rate_of(const tr_sim& sim, int state) { return rates_of(sim)[static_cast<std::size_t>(state)]; }

// In steady flight behind the right engine alone, with a rigid shaft.
tr_sim one_engine_out() {
  tr_sim sim = trimmed_sim(30, 50);
  tr_systems systems = systems_of(sim);
  systems.governor = TR_GOVERNOR_PI;
  systems.throttle[0] = 1;
  systems.engine_failed[1] = 1;
  set_systems(sim, systems);
  return sim;
}

// Then with a shaft that twists, flown on with another throttle.
tr_sim swinging(tr_real throttle, int steps) {
  tr_sim sim = one_engine_out();
  tr_systems systems = systems_of(sim);
  systems.interconnect = 1;
  set_systems(sim, systems);
  systems.throttle[0] = throttle;
  set_systems(sim, systems);
  const auto work = new_work();
  for (int k = 0; k < steps; ++k) CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OK);
  return sim;
}

}  // namespace

// The shaft begins at the twist that carries the other one's power: both rotors go on as they did.
TEST(capi_interconnect_begins_in_balance) {
  tr_sim sim = one_engine_out();
  const double before = rate_of(sim, TR_ROTOR_SPEED);
  tr_systems systems = systems_of(sim);
  systems.interconnect = 1;
  set_systems(sim, systems);
  CHECK_LT(0.01, state_of(sim).x[TR_SHAFT_TWIST]);
  CHECK_NEAR(rate_of(sim, TR_TWIST_RATE), 0, 1e-3);
  CHECK_NEAR(rate_of(sim, TR_ROTOR_SPEED), before, 1e-3);
  systems.interconnect = 2;
  CHECK_EQ(tr_set_systems(&sim, &systems), TR_BAD_ARGUMENT);
  CHECK_EQ(systems_of(sim).interconnect, 1);
}

// So do rotors that turn as actuators, augmentation and governor have put them: in a roll the torques differ.
TEST(capi_interconnect_begins_in_balance_amid_a_manoeuvre) {
  tr_sim sim = trimmed_sim(30, 50);
  tr_systems systems = systems_of(sim);
  systems.governor = TR_GOVERNOR_PI;
  systems.engines = systems.actuators = systems.scas = systems.turbulence = 1;
  systems.turbulence_w20_mps = 15;
  set_systems(sim, systems);
  tr_state state = state_of(sim);
  state.u[TR_LAT_STICK] = 1;
  CHECK_EQ(tr_set_state(&sim, &state), TR_OK);
  const auto work = new_work();
  for (int k = 0; k < 50; ++k) CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OK);
  const double before = rate_of(sim, TR_ROTOR_SPEED);
  systems.interconnect = 1;
  set_systems(sim, systems);
  CHECK_LT(1e-4, std::fabs(static_cast<double>(state_of(sim).x[TR_SHAFT_TWIST])));
  CHECK_NEAR(rate_of(sim, TR_TWIST_RATE), 0, 1e-3);
  CHECK_NEAR(rate_of(sim, TR_ROTOR_SPEED), before, 1e-3);
}

TEST(capi_interconnect_swings_and_is_saved) {
  tr_sim sim = swinging(tr_real(0.7), 20);
  tr_systems systems = systems_of(sim);
  const auto work = new_work();
  CHECK_LT(0.01, std::fabs(static_cast<double>(state_of(sim).x[TR_TWIST_RATE])));
  unsigned char bytes[TR_SAVED_SIZE];
  std::size_t used = 0;
  CHECK_EQ(tr_save(&sim, bytes, sizeof bytes, &used), TR_OK);
  tr_sim again;
  std::memset(&again, 0x33, sizeof again);
  CHECK_EQ(tr_load_saved(&again, TR_API_VERSION, bytes, used), TR_OK);
  for (int k = 0; k < 20; ++k) {
    CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OK);
    CHECK_EQ(tr_step(&again, work.get(), dt), TR_OK);
  }
  CHECK(same_bits(state_of(sim), state_of(again)));
  // Rigid again, the rotors turn alike.
  systems.interconnect = 0;
  set_systems(sim, systems);
  const tr_state state = state_of(sim);
  CHECK_EQ(state.x[TR_SHAFT_TWIST], 0);
  CHECK_EQ(state.x[TR_TWIST_RATE], 0);
  tr_sim rigid = one_engine_out();
  set_systems(rigid, systems);
  CHECK_EQ(tr_set_state(&rigid, &state), TR_OK);
  CHECK(rates_of(sim) == rates_of(rigid));
}

// The inflow keeps its speed when the rotors' speeds jump: its ratio to the tip's times each rotor's speed.
TEST(capi_interconnect_that_becomes_rigid_keeps_the_inflow) {
  tr_sim sim = swinging(tr_real(0.5), 10);
  tr_systems systems = systems_of(sim);
  const tr_state before = state_of(sim);
  systems.interconnect = 0;
  set_systems(sim, systems);
  const tr_state after = state_of(sim);
  const tr_real omega = before.x[TR_ROTOR_SPEED], half = before.x[TR_TWIST_RATE] / 2;
  for (const int k : {TR_MEAN_INFLOW, TR_COSINE_INFLOW, TR_SINE_INFLOW}) {
    const int r = TR_ROTOR_RIGHT + k, l = TR_ROTOR_LEFT + k;
    CHECK_NEAR(after.x[r] * omega, before.x[r] * (omega + half), 1e-6);
    CHECK_NEAR(after.x[l] * omega, before.x[l] * (omega - half), 1e-6);
  }
  CHECK_LT(1e-5, std::fabs(static_cast<double>(after.x[TR_ROTOR_RIGHT + TR_MEAN_INFLOW] -
                                               before.x[TR_ROTOR_RIGHT + TR_MEAN_INFLOW])));
}

// Rotors that swing turn alike while a trim is looked for: nothing lateral is left.
TEST(capi_interconnect_is_at_rest_in_a_new_trim) {
  tr_sim sim = trimmed_sim(30, 50);
  tr_systems systems = systems_of(sim);
  systems.governor = TR_GOVERNOR_PI;
  systems.interconnect = 1;
  set_systems(sim, systems);
  const auto work = new_work();
  const tr_flight flight = {50, 0, 0, 0};
  CHECK_EQ(tr_trim(&sim, work.get(), &flight, nullptr), TR_OK);
  systems = systems_of(sim);
  systems.throttle[0] *= tr_real(1.3);
  systems.throttle[1] *= tr_real(0.7);
  set_systems(sim, systems);
  for (int k = 0; k < 12; ++k) CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OK);
  CHECK_LT(0.1, std::fabs(static_cast<double>(state_of(sim).x[TR_TWIST_RATE])));
  CHECK_EQ(tr_trim(&sim, work.get(), &flight, nullptr), TR_OK);
  const tr_state state = state_of(sim);
  CHECK_EQ(state.u[TR_LAT_STICK], 0);
  CHECK_EQ(state.u[TR_PEDAL], 0);
  CHECK_NEAR(rate_of(sim, TR_P), 0, 1e-4);
}
