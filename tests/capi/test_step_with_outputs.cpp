// tr_step_with_outputs: the two calls in one.
// Expected: tr_get_outputs and tr_step, one after the other, bit for bit.
#include "capi/flying.hpp"

using namespace capi;

namespace {

tr_outputs cleared() {
  tr_outputs outputs;
  std::memset(&outputs, 0x5a, sizeof outputs);
  return outputs;
}

}  // namespace

TEST(capi_step_with_outputs_gives_the_bits_of_two_calls) {
  for (const tr_real mast : {tr_real(0), tr_real(30), tr_real(90)}) {
    tr_sim one = trimmed_sim(mast, mast < 90 ? tr_real(40) : tr_real(100));
    tr_sim two = one;
    const tr_state begin = state_of(one);
    const auto work = new_work();
    for (int k = 0; k < 60; ++k) {
      tr_real u[4];
      std::memcpy(u, begin.u, sizeof u);
      u[TR_LONG_STICK] += tr_real(0.02) * tr_real(k % 7 - 3);
      u[TR_LAT_STICK] += tr_real(0.02) * tr_real(k % 5 - 2);
      CHECK_EQ(tr_set_controls(&one, u, 4), TR_OK);
      CHECK_EQ(tr_set_controls(&two, u, 4), TR_OK);
      const tr_real lengths[] = {dt, tr_real(0.002),
                                 tr_real(0.02)};  // one part, and many of the other method
      tr_outputs together = cleared(), apart = cleared();
      CHECK_EQ(tr_step_with_outputs(&one, work.get(), lengths[k % 3], &together), TR_OK);
      CHECK_EQ(tr_get_outputs(&two, &apart), TR_OK);
      CHECK_EQ(tr_step(&two, work.get(), lengths[k % 3]), TR_OK);
      CHECK(same_bits(together, apart));
      CHECK(same_bits(one, two));
    }
  }
}

// After a turn on its back and a gust: bank and heading are counted, the air moves.
TEST(capi_step_with_outputs_after_many_turns) {
  tr_sim one = trimmed_sim(0, 20);
  tr_state state = state_of(one);
  state.x[TR_ROLL] = tr_real(40.3);
  state.roll_rad = 40.3;
  state.x[TR_YAW] = tr_real(-777.7);
  state.yaw_rad = -777.7;
  state.u[TR_GUST_V] = 6;
  CHECK_EQ(tr_set_state(&one, &state), TR_OK);
  tr_sim two = one;
  const auto work = new_work();
  tr_outputs together = cleared(), apart = cleared();
  CHECK_EQ(tr_step_with_outputs(&one, work.get(), dt, &together), TR_OK);
  CHECK_EQ(tr_get_outputs(&two, &apart), TR_OK);
  CHECK_EQ(tr_step(&two, work.get(), dt), TR_OK);
  CHECK(same_bits(together, apart) && same_bits(one, two));
}

// In steep flight, and with masts on their way or driven into their stop: the rates found for the outputs are those the
// step would find, or it finds its own.
TEST(capi_step_with_outputs_in_steep_flight_and_with_moving_masts) {
  for (int k = 0; k < 4; ++k) {
    tr_sim one = trimmed_sim(90, 100);
    if (k == 0) {
      tr_state state = state_of(one);
      state.x[TR_PITCH] = tr_real(1.22);
      state.x[TR_ROLL] = state.roll_rad = tr_real(0.7);
      state.x[TR_YAW] = state.yaw_rad = tr_real(-1.9);
      state.x[TR_Q] = tr_real(0.4);
      CHECK_EQ(tr_set_state(&one, &state), TR_OK);
    } else {
      tr_configuration c;
      CHECK_EQ(tr_get_configuration(&one, &c), TR_OK);
      c.mast_rate_radps = tr_real(k == 1 ? -0.1 : k == 2 ? 0.1 : 0);
      c.mast_acceleration_radps2 = tr_real(k == 3 ? 5 : 0);
      CHECK_EQ(tr_set_configuration(&one, &c), TR_OK);
    }
    tr_sim two = one;
    const auto work = new_work();
    tr_outputs together = cleared(), apart = cleared();
    for (int step = 0; step < 5; ++step) {
      CHECK_EQ(tr_step_with_outputs(&one, work.get(), dt, &together), TR_OK);
      CHECK_EQ(tr_get_outputs(&two, &apart), TR_OK);
      CHECK_EQ(tr_step(&two, work.get(), dt), TR_OK);
      CHECK(same_bits(together, apart) && same_bits(state_of(one), state_of(two)));
    }
  }
}

TEST(capi_step_with_outputs_refuses) {
  tr_sim sim = trimmed_sim(0, 20);
  const tr_state before = state_of(sim);
  const auto work = new_work();
  tr_outputs outputs = cleared();
  CHECK_EQ(tr_step_with_outputs(nullptr, work.get(), dt, &outputs), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_step_with_outputs(&sim, nullptr, dt, &outputs), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_step_with_outputs(&sim, work.get(), dt, nullptr), TR_BAD_ARGUMENT);
  for (const tr_real bad : {kNan, kInfinity})
    CHECK_EQ(tr_step_with_outputs(&sim, work.get(), bad, &outputs), TR_NOT_FINITE);
  for (const tr_real bad : {tr_real(0), tr_real(-0.005), tr_real(0.0201)})
    CHECK_EQ(tr_step_with_outputs(&sim, work.get(), bad, &outputs), TR_OUT_OF_RANGE);
  tr_sim raw;
  std::memset(&raw, 0x5a, sizeof raw);
  CHECK_EQ(tr_step_with_outputs(&raw, work.get(), dt, &outputs), TR_NOT_INITIALIZED);
  CHECK(same_bits(outputs, cleared()));
  CHECK(same_bits(state_of(sim), before));
  // When only the step fails, the outputs are those of the last good state.
  tr_state last = before;
  last.position_m[0] = 1e9;
  last.x[TR_NORTH] = tr_real(last.position_m[0]);
  last.x[TR_YAW] = 0;
  CHECK_EQ(tr_set_state(&sim, &last), TR_OK);
  const tr_state here = state_of(sim);
  tr_outputs expected = cleared();
  CHECK_EQ(tr_get_outputs(&sim, &expected), TR_OK);
  CHECK_EQ(tr_step_with_outputs(&sim, work.get(), dt, &outputs), TR_OUT_OF_RANGE);
  CHECK(same_bits(outputs, expected));
  CHECK(same_bits(state_of(sim), here));
}
