// The shaft between the rotors through the C interface. Expected values: rest, the same aircraft saved and loaded.
#include <cmath>

#include "capi/conditions.hpp"

using namespace capi;

namespace {

tr_systems systems_of(const tr_sim& sim) {
  tr_systems systems{};
  CHECK_EQ(tr_get_systems(&sim, &systems), TR_OK);
  return systems;
}
void set_systems(tr_sim& sim, const tr_systems& systems) { CHECK_EQ(tr_set_systems(&sim, &systems), TR_OK); }

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

TEST(capi_interconnect_swings_and_is_saved) {
  tr_sim sim = one_engine_out();
  tr_systems systems = systems_of(sim);
  systems.interconnect = 1;
  set_systems(sim, systems);
  systems.throttle[0] = tr_real(0.7);
  set_systems(sim, systems);
  const auto work = new_work();
  for (int k = 0; k < 20; ++k) CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OK);
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
  CHECK_EQ(state_of(sim).x[TR_SHAFT_TWIST], 0);
  CHECK_EQ(state_of(sim).x[TR_TWIST_RATE], 0);
}
