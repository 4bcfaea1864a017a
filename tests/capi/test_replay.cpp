// The C interface: a copied struct replays exactly, and aircraft do not disturb each other.
// Expected: the first run, bit for bit.
#include "capi/flying.hpp"

using namespace capi;

TEST(capi_a_copied_struct_replays_bit_for_bit) {
  Flight whole(trimmed_sim(30, 50));
  Flight first(trimmed_sim(30, 50));
  for (int k = 0; k < 200; ++k) whole.step(k);
  for (int k = 0; k < 80; ++k) first.step(k);
  const tr_state snapshot = state_of(first.sim());

  // Restored into another aircraft of the same setup, which has flown something else.
  tr_sim other = trimmed_sim(30, 60);
  CHECK_EQ(tr_step(&other, new_work().get(), dt), TR_OK);
  CHECK_EQ(tr_set_state(&other, &snapshot), TR_OK);
  const tr_state back = state_of(other);
  CHECK(same_bits(back, snapshot));
  const tr_sim copied = first.sim();
  Flight by_copy(copied);
  for (const tr_sim* sim : {static_cast<const tr_sim*>(&other), &copied}) {
    tr_sim s = *sim;
    const auto work = new_work();
    const tr_state start_state = whole.states()[79];
    CHECK(same_bits(state_of(s), start_state));
    for (int k = 80; k < 200; ++k) {
      const tr_state& wanted = whole.states()[static_cast<std::size_t>(k)];
      CHECK_EQ(tr_set_controls(&s, wanted.u, TR_CONTROLS), TR_OK);
      CHECK_EQ(tr_step(&s, work.get(), dt), TR_OK);
      if (!CHECK(same_bits(state_of(s), wanted))) break;
    }
  }
}

TEST(capi_interleaved_aircraft_give_the_same_bits_as_alone) {
  Flight alone_a(trimmed_sim(0, 20));
  Flight alone_b(trimmed_sim(90, 100));
  for (int k = 0; k < 100; ++k) alone_a.step(k);
  for (int k = 0; k < 100; ++k) alone_b.step(k);

  Flight a(trimmed_sim(0, 20));
  Flight b(trimmed_sim(90, 100));
  const auto shared = new_work();
  for (int k = 0; k < 100; ++k) {
    a.step(k);
    if (k % 3 == 0) a.disturb_work();
    // What else runs between the steps, on the same scratch memory, must not be seen.
    tr_sim visitor = sim_at(60);
    const tr_flight flight = {60, 0, 0, 0};
    if (k % 25 == 0) CHECK_EQ(tr_trim(&visitor, shared.get(), &flight, nullptr), TR_OK);
    b.step(k);
    tr_outputs outputs;
    CHECK_EQ(tr_get_outputs(&a.sim(), &outputs), TR_OK);
  }
  CHECK(same_flight(a, alone_a));
  CHECK(same_flight(b, alone_b));
}

TEST(capi_misplaced_work) {
  // The address of the scratch memory does not change a bit: 8, 16, ... 64 bytes beyond a line of the cache.
  std::vector<std::uint64_t> memory(sizeof(tr_work) / 8 + 16);
  tr_sim reference = trimmed_sim(0, 20);
  CHECK_EQ(tr_step(&reference, new_work().get(), dt), TR_OK);
  for (std::size_t shift = 0; shift < 8; ++shift) {
    auto* work = reinterpret_cast<tr_work*>(memory.data() + shift);
    tr_sim sim = sim_at(0);
    const tr_flight flight = {20, 0, 0, 0};
    CHECK_EQ(tr_trim(&sim, work, &flight, nullptr), TR_OK);
    CHECK_EQ(tr_step(&sim, work, dt), TR_OK);
    CHECK(same_bits(state_of(sim), state_of(reference)));
  }
}

TEST(slow_capi_a_minute_under_control) {
  // Flight at 200 Hz under an autopilot that holds the trimmed attitude and banks to and fro.
  tr_sim sim = trimmed_sim(0, 40);
  const auto work = new_work();
  const tr_state trimmed = state_of(sim);
  tr_state state = trimmed;
  int errors = 0;
  for (int k = 0; k < 60 * 200 && errors == 0; ++k) {
    tr_real u[4];
    std::memcpy(u, trimmed.u, sizeof u);
    const auto held = [](tr_real x, tr_real low, tr_real high) {
      return x < low ? low : x > high ? high : x;
    };
    const tr_real roll_wanted = tr_real(0.1) * tr_real((k / 4000) % 3 - 1);
    u[TR_COLLECTIVE] +=
        held(tr_real(0.01) * (state.x[TR_W] - trimmed.x[TR_W]), tr_real(-0.05), tr_real(0.05));
    u[TR_LONG_STICK] =
        held(u[TR_LONG_STICK] + 8 * (state.x[TR_PITCH] - trimmed.x[TR_PITCH]) + 5 * state.x[TR_Q],
             tr_real(-4.8), tr_real(4.8));
    u[TR_LAT_STICK] = held(u[TR_LAT_STICK] - 4 * (state.x[TR_ROLL] - roll_wanted) - 3 * state.x[TR_P],
                           tr_real(-4.8), tr_real(4.8));
    u[TR_PEDAL] = held(u[TR_PEDAL] - 2 * state.x[TR_R], tr_real(-2.5), tr_real(2.5));
    if (tr_set_controls(&sim, u, 4) != TR_OK || tr_step(&sim, work.get(), dt) != TR_OK) ++errors;
    if (tr_get_state(&sim, &state) != TR_OK) ++errors;
  }
  CHECK_EQ(errors, 0);
  CHECK_NEAR(state.time_s, 60 * 200 * double(dt), 1e-6);
  NOTE("after " << state.time_s << " s: u " << state.x[TR_U] << " m/s, pitch " << state.x[TR_PITCH]
                << " rad, " << state.steps << " steps, " << errors << " errors");
}
