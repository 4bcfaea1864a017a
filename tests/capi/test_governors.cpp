// C interface: one governor takes over from another in flight. Expected: the blades stay
// where they were, and so does the thrust.
#include "capi/conditions.hpp"

using namespace capi;

namespace {

struct Seen {
  double blades, thrust, added;  // rad, N, rad
};

Seen seen(const tr_sim& sim) {
  tr_outputs outputs;
  CHECK_EQ(tr_get_outputs(&sim, &outputs), TR_OK);
  return {outputs.collective_rad[0], outputs.thrust_n[0], state_of(sim).x[TR_GOVERNOR]};
}

}  // namespace

TEST(capi_a_governor_takes_over_what_another_added) {
  for (const int actuators : {0, 1})
    for (const int from : {TR_GOVERNOR_IDEAL, TR_GOVERNOR_PI})
      for (const int to : {TR_GOVERNOR_OFF, TR_GOVERNOR_IDEAL, TR_GOVERNOR_PI}) {
        tr_sim sim = trimmed_sim(75, 80);
        tr_systems systems = systems_of(sim);
        systems.governor = from;
        systems.engines = 1;
        systems.actuators = actuators;
        set_systems(sim, systems);
        const auto work = new_work();
        const tr_flight flight = {80, 0, 0, 0};
        CHECK_EQ(tr_trim(&sim, work.get(), &flight, nullptr), TR_OK);
        systems = systems_of(sim);
        for (tr_real& throttle : systems.throttle) throttle += tr_real(0.1);
        set_systems(sim, systems);
        fly(sim, 300);

        const Seen before = seen(sim);
        CHECK_LT(1e-3, before.added);
        systems.governor = to;
        set_systems(sim, systems);
        if (to == TR_GOVERNOR_OFF) {
          const tr_real lever = state_of(sim).u[0] + tr_real(before.added);
          CHECK_EQ(tr_set_controls(&sim, &lever, 1), TR_OK);
        }
        Seen after = seen(sim);
        // An ideal governor takes the power of the engines at once, where one of kind pi let the rotors speed up.
        const bool at_once = to == TR_GOVERNOR_IDEAL && from != to;
        CHECK_NEAR(after.blades, before.blades, at_once ? 5e-3 : 1e-6);
        CHECK_NEAR(after.thrust, before.thrust, (at_once ? 0.05 : 1e-4) * before.thrust);
        if (!at_once) CHECK_NEAR(after.added, to == TR_GOVERNOR_OFF ? 0 : before.added, 1e-12);
        fly(sim, 1);
        after = seen(sim);
        CHECK_NEAR(after.blades, before.blades, at_once ? 5e-3 : 1e-4);
        CHECK_NEAR(after.thrust, before.thrust, (at_once ? 0.05 : 5e-3) * before.thrust);
      }
}

// Under way with everything on, masts and flaps moving: what was read and is set again changes no bit of the flight.
TEST(capi_what_was_read_is_set_again_without_a_change) {
  tr_sim sim = trimmed_sim(0, 30);
  tr_systems systems = systems_of(sim);
  systems.governor = TR_GOVERNOR_PI;
  systems.conversion = systems.engines = systems.actuators = systems.scas = systems.gear = 1;
  set_systems(sim, systems);
  const auto work = new_work();
  const tr_flight flight = {30, 0, 0, 0};
  CHECK_EQ(tr_trim(&sim, work.get(), &flight, nullptr), TR_OK);
  systems = systems_of(sim);
  systems.mast_command_deg = 60;
  systems.flap_command_deg = 20;
  systems.gear_down = 0;
  set_systems(sim, systems);
  tr_sim twin = sim;
  for (int k = 0; k < 400; ++k) {
    fly(sim, 1);
    fly(twin, 1);
    tr_configuration configuration;
    CHECK_EQ(tr_get_configuration(&twin, &configuration), TR_OK);
    CHECK_EQ(tr_set_configuration(&twin, &configuration), TR_OK);
    set_state(twin, state_of(twin));
    set_systems(twin, systems_of(twin));
    CHECK(same_bits(state_of(sim), state_of(twin)));
  }
}
