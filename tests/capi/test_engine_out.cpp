// Engines that do not run, and what else a flight cannot be, through the C interface.
// Expected: the power of the engines that run by the trim's own power and the losses of the transmission; what a call gave
// is taken by the call that sets it.
#include <string>

#include "capi/conditions.hpp"
#include "this_aircraft.hpp"

using namespace capi;

namespace {

tr_sim with_failures(tr_real mast_deg, int governor, bool right_fails, bool left_fails) {
  tr_sim sim = sim_at(mast_deg);
  tr_systems systems = systems_of(sim);
  systems.governor = governor;
  systems.conversion = systems.engines = systems.actuators = 1;
  systems.engine_failed[0] = right_fails;
  systems.engine_failed[1] = left_fails;
  set_systems(sim, systems);
  return sim;
}

tr_status trimmed_at(tr_sim& sim, tr_real speed, std::string* text = nullptr) {
  const auto work = new_work();
  const tr_flight flight = {speed, 0, 0, 0};
  tr_trim_result result;
  const tr_status status = tr_trim(&sim, work.get(), &flight, &result);
  if (text != nullptr) *text = result.text;
  return status;
}

std::uint32_t flags_of(const tr_sim& sim) {
  std::uint32_t flags = 0;
  CHECK_EQ(tr_get_flags(&sim, &flags), TR_OK);
  return flags;
}

// What is there can be set and stored, whatever the trim found.
void check_settable(tr_sim& sim) {
  const tr_systems systems = systems_of(sim);
  for (const tr_real throttle : systems.throttle) CHECK(throttle >= 0 && throttle <= tr_real(1.2));
  CHECK_EQ(tr_set_systems(&sim, &systems), TR_OK);
  std::vector<unsigned char> bytes(TR_SAVED_SIZE);
  std::size_t used = 0;
  CHECK_EQ(tr_save(&sim, bytes.data(), bytes.size(), &used), TR_OK);
  tr_sim again;
  CHECK_EQ(tr_load_saved(&again, TR_API_VERSION, bytes.data(), used), TR_OK);
}

}  // namespace

TEST_OF_XV15(capi_trim_on_one_engine_has_its_power_alone) {
  std::string text;
  tr_sim hover = with_failures(0, TR_GOVERNOR_PI, true, false);
  CHECK_EQ(trimmed_at(hover, 0, &text), TR_POWER_LIMIT);
  CHECK(text.find("power") != std::string::npos);
  CHECK(flags_of(hover) & TR_OVER_POWER);
  CHECK_EQ(systems_of(hover).throttle[0], 0);
  check_settable(hover);
  // At 40 m/s one engine is enough, and gives what the rotors take with the losses on the way.
  tr_sim cruise = with_failures(0, TR_GOVERNOR_PI, true, false);
  CHECK_EQ(trimmed_at(cruise, 40), TR_OK);
  CHECK_EQ(flags_of(cruise) & TR_OVER_POWER, 0u);
  tr_outputs outputs;
  CHECK_EQ(tr_get_outputs(&cruise, &outputs), TR_OK);
  CHECK_EQ(state_of(cruise).x[TR_POWER_RIGHT], 0);
  CHECK_REL(
      double(state_of(cruise).x[TR_POWER_LEFT]) * this_aircraft::numbers().controls.transmission_efficiency,
      double(outputs.power_w[0] + outputs.power_w[1]), 1e-6);
  check_settable(cruise);
  // Both run, and have not enough.
  tr_sim fast = with_failures(90, TR_GOVERNOR_PI, false, false);
  const tr_status status = trimmed_at(fast, 145);
  CHECK(status == TR_POWER_LIMIT || status == TR_TORQUE_LIMIT);
  check_settable(fast);
}

TEST_OF_XV15(capi_trim_without_engines_says_that_the_power_is_missing) {
  for (const int governor : {TR_GOVERNOR_OFF, TR_GOVERNOR_IDEAL, TR_GOVERNOR_PI}) {
    tr_sim sim = with_failures(0, governor, true, true);
    CHECK_EQ(trimmed_at(sim, 40), TR_POWER_LIMIT);
    CHECK(flags_of(sim) & TR_OVER_POWER);
    check_settable(sim);
  }
  // A hover whose engines fail one after the other, its rotor speed held by nobody's power.
  tr_sim sim = with_failures(0, TR_GOVERNOR_OFF, false, false);
  CHECK_EQ(trimmed_at(sim, 0), TR_OK);
  CHECK_EQ(flags_of(sim) & TR_OVER_POWER, 0u);
  tr_systems systems = systems_of(sim);
  systems.engine_failed[1] = 1;
  set_systems(sim, systems);
  CHECK(flags_of(sim) & TR_OVER_POWER);
}

TEST(capi_flags_tell_an_aircraft_in_the_ground) {
  tr_sim sim = trimmed_sim(0, 30);
  tr_environment environment = calm();
  environment.ground_down_m = 5;
  CHECK_EQ(tr_set_environment(&sim, &environment), TR_OK);
  CHECK_EQ(flags_of(sim) & TR_BELOW_GROUND, 0u);
  tr_state state = state_of(sim);
  state.x[TR_DOWN] = tr_real(5.01);
  CHECK_EQ(tr_set_state(&sim, &state), TR_OK);
  CHECK_EQ(flags_of(sim) & TR_BELOW_GROUND, std::uint32_t{TR_BELOW_GROUND});
}

// A SCAS that has faded out leaves nothing in the state, so that what is read is what is set.
TEST(capi_a_scas_that_has_faded_leaves_nothing) {
  tr_sim sim = sim_at(0);
  tr_systems systems = systems_of(sim);
  systems.governor = TR_GOVERNOR_PI;
  systems.engines = systems.actuators = systems.scas = 1;
  set_systems(sim, systems);
  CHECK_EQ(trimmed_at(sim, 20), TR_OK);
  tr_real u[4];
  tr_state state = state_of(sim);
  std::copy(state.u, state.u + 4, u);
  u[TR_LAT_STICK] += tr_real(0.4);
  CHECK_EQ(tr_set_controls(&sim, u, 4), TR_OK);
  fly(sim, 100);
  systems = systems_of(sim);
  systems.scas = 0;
  set_systems(sim, systems);
  fly(sim, 600);
  state = state_of(sim);
  for (const int k :
       {int{TR_HELD_PITCH}, TR_HELD_PITCH + 1, int{TR_REST_LONG}, TR_REST_LONG + 1, int{TR_WASHOUT}})
    CHECK_EQ(state.x[k], 0);
  CHECK_EQ(tr_set_state(&sim, &state), TR_OK);
  CHECK(same_bits(state_of(sim), state));
}
