// The landing gear on its way, through the C interface. Expected: the eight seconds of the tables, a trim's rest, the flight
// that goes on after a load.
#include <cstring>
#include <vector>

#include "capi/conditions.hpp"

using namespace capi;

namespace {

void tell_gear(tr_sim& sim, std::int32_t on, std::int32_t down) {
  tr_systems systems = systems_of(sim);
  systems.gear = on;
  systems.gear_down = down;
  set_systems(sim, systems);
}
double out(const tr_sim& sim) { return static_cast<double>(state_of(sim).x[TR_GEAR]); }

}  // namespace

TEST_OF_XV15(capi_gear_is_eight_seconds_on_its_way) {
  tr_sim sim = trimmed_sim(90, 90);
  tell_gear(sim, 1, 0);
  CHECK_EQ(out(sim), 0);
  tell_gear(sim, 1, 1);
  CHECK_EQ(out(sim), 0);
  fly(sim, 800);  // of 5 ms
  CHECK_NEAR(out(sim), 0.5, 1e-3);
  // Saved on its way it goes on.
  std::vector<unsigned char> bytes(TR_SAVED_SIZE);
  std::size_t length = bytes.size();
  CHECK_EQ(tr_save(&sim, bytes.data(), bytes.size(), &length), TR_OK);
  tr_sim loaded;
  CHECK_EQ(tr_load_saved(&loaded, TR_API_VERSION, bytes.data(), length), TR_OK);
  fly(sim, 801);
  fly(loaded, 801);
  CHECK_EQ(out(sim), 1);
  CHECK(same_bits(state_of(sim), state_of(loaded)));
  tell_gear(sim, 1, 0);
  fly(sim, 400);
  CHECK_NEAR(out(sim), 0.75, 1e-3);
}

// No state has less of it out than none.
TEST(capi_gear_is_not_less_than_retracted) {
  tr_sim sim = sim_at(60);
  tell_gear(sim, 1, 0);
  tr_state state = state_of(sim);
  state.x[TR_GEAR] = tr_real(-0.1);
  CHECK_EQ(tr_set_state(&sim, &state), TR_OUT_OF_RANGE);
  state.x[TR_GEAR] = tr_real(0.4);
  CHECK_EQ(tr_set_state(&sim, &state), TR_OK);
  CHECK_NEAR(out(sim), 0.4, 1e-7);
}

// On it begins where it is told to be; off there is none; a trim has it at rest.
TEST(capi_gear_begins_and_is_trimmed_at_rest) {
  tr_sim sim = sim_at(60);
  tell_gear(sim, 1, 1);
  CHECK_EQ(out(sim), 1);
  tell_gear(sim, 1, 0);
  const auto work = new_work();
  CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OK);
  CHECK_LT(0.9, out(sim));
  const tr_flight flight = {50, 0, 0, 0};
  CHECK_EQ(tr_trim(&sim, work.get(), &flight, nullptr), TR_OK);
  CHECK_EQ(out(sim), 0);
  tell_gear(sim, 1, 1);
  CHECK_EQ(tr_trim(&sim, work.get(), &flight, nullptr), TR_OK);
  CHECK_EQ(out(sim), 1);
  tell_gear(sim, 0, 1);
  CHECK_EQ(out(sim), 0);
}
