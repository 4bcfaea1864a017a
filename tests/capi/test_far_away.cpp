// The C interface far from the origin, after many turns and at the bounds of tr_set_state.
// Expected: the same flight at the origin without turns; the bounds of the header's text.
#include <cmath>

#include "capi/flying.hpp"
#include "capi/same_aircraft.hpp"

using namespace capi;

namespace {

constexpr bool kDouble = sizeof(tr_real) == 8;
constexpr double kTurn = 2 * 3.14159265358979323846;

tr_sim with(tr_sim sim, int index, tr_real number) {
  tr_state state = state_of(sim);
  state.x[index] = number;
  CHECK_EQ(tr_set_state(&sim, &state), TR_OK);
  return sim;
}

tr_state after_a_second(tr_sim sim) {
  const auto work = new_work();
  for (int k = 0; k < 200; ++k) CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OK);
  return state_of(sim);
}

tr_sim turning(tr_real mast, tr_real speed) {
  tr_sim sim = sim_at(mast);
  const tr_flight flight = {speed, 0, tr_real(0.1), 0};
  CHECK_EQ(tr_trim(&sim, new_work().get(), &flight, nullptr), TR_OK);
  return sim;
}

}  // namespace

// The same way from anywhere: nothing depends on the place.
TEST(capi_positions_keep_their_accuracy_far_away) {
  const tr_sim home = turning(0, 40);
  const tr_state near_by = after_a_second(home);
  for (const tr_real far : {tr_real(1e5), tr_real(1e7), tr_real(-9e8)}) {
    for (int axis = 0; axis < 3; ++axis) {
      const tr_state start = state_of(with(home, TR_NORTH + axis, far));
      const tr_state end = after_a_second(with(home, TR_NORTH + axis, far));
      CHECK_EQ(start.position_m[axis], double(far));
      for (int k = 0; k < 3; ++k) {
        const double way = end.position_m[k] - start.position_m[k];
        CHECK_NEAR(way, near_by.position_m[k], 200 * 1.2e-16 * std::abs(start.position_m[k]) + 1e-12);
        CHECK_EQ(end.x[TR_NORTH + k], static_cast<tr_real>(end.position_m[k]));
      }
      CHECK(std::memcmp(end.x, near_by.x, TR_NORTH * sizeof(tr_real)) == 0);
    }
  }
  CHECK_REL(std::hypot(near_by.position_m[0], near_by.position_m[1]), 40, 1e-3);
}

// After whole turns the flight is the same, to the digits of the angle that it began with.
TEST(capi_heading_keeps_its_accuracy_after_many_turns) {
  const tr_sim once = turning(0, 40);
  const tr_state fresh = after_a_second(once);
  CHECK_REL(fresh.yaw_rad, 0.1, kDouble ? 1e-6 : 2e-3);
  for (const double turns : {1.0, 652.0, -3500.0, 159000.0}) {
    const tr_sim turned = with(once, TR_YAW, static_cast<tr_real>(turns * kTurn));
    const tr_state start = state_of(turned), end = after_a_second(turned);
    const double off = start.yaw_rad - turns * kTurn;                 // by rounding to tr_real
    const double rounding = 200 * 1.2e-16 * std::abs(start.yaw_rad);  // of the sum, once a step
    CHECK_NEAR(end.yaw_rad - start.yaw_rad, fresh.yaw_rad, rounding + (kDouble ? 1e-12 : 1e-7));
    const double c = std::cos(off), s = std::sin(off);
    const double north = c * fresh.position_m[0] - s * fresh.position_m[1];
    const double east = s * fresh.position_m[0] + c * fresh.position_m[1];
    CHECK_NEAR(end.position_m[0], north, 40 * rounding + (kDouble ? 1e-9 : 1e-4));
    CHECK_NEAR(end.position_m[1], east, 40 * rounding + (kDouble ? 1e-9 : 1e-4));
    CHECK_EQ(end.x[TR_YAW], static_cast<tr_real>(end.yaw_rad));
  }
}

// Bank too, on which everything depends.
TEST(capi_bank_keeps_its_accuracy_after_many_rolls) {
  const tr_sim level = trimmed_sim(90, 100);
  tr_state rolling = state_of(level);
  rolling.x[TR_P] = tr_real(0.05);
  tr_sim once = level;
  CHECK_EQ(tr_set_state(&once, &rolling), TR_OK);
  const tr_state fresh = after_a_second(once);
  for (const double turns : {1.0, -159.0}) {
    const tr_sim rolled = with(once, TR_ROLL, static_cast<tr_real>(turns * kTurn));
    const tr_state start = state_of(rolled), end = after_a_second(rolled);
    const double off = std::abs(start.roll_rad - turns * kTurn);
    CHECK_NEAR(end.roll_rad - start.roll_rad, fresh.roll_rad, off + (kDouble ? 1e-9 : 1e-6));
    for (int i = TR_U; i <= TR_W; ++i) CHECK_NEAR(end.x[i], fresh.x[i], 20 * off + (kDouble ? 1e-7 : 1e-4));
  }
}

TEST(capi_far_away_replays_bit_for_bit) {
  tr_sim sim = with(with(turning(30, 50), TR_NORTH, tr_real(3e6)), TR_YAW, tr_real(7777.7));
  flown_on(sim, 50);
  const tr_state state = state_of(sim);
  tr_sim other = trimmed_sim(30, 60);
  CHECK_EQ(tr_set_state(&other, &state), TR_OK);
  const tr_state back = state_of(other);
  CHECK(same_bits(back, state));
  CHECK_EQ(flown_on(other, 50), flown_on(sim, 50));
  const tr_state a = state_of(sim), b = state_of(other);
  CHECK(same_bits(a, b));
}

// A program that writes x alone is understood, whatever lies in the digits beyond.
TEST(capi_states_are_set_by_x) {
  tr_sim sim = turning(0, 40);
  flown_on(sim, 30);
  for (const double beyond : {std::nan(""), HUGE_VAL, 0.0, -5.0}) {
    tr_state state = state_of(sim);
    state.x[TR_EAST] = tr_real(12.5);
    state.x[TR_YAW] = tr_real(-3.25);
    state.yaw_rad = state.position_m[1] = beyond;
    tr_sim other = sim;
    CHECK_EQ(tr_set_state(&other, &state), TR_OK);
    const tr_state set = state_of(other);
    CHECK_EQ(set.x[TR_EAST], tr_real(12.5));
    CHECK_EQ(set.position_m[1], 12.5);
    CHECK_EQ(set.yaw_rad, -3.25);
    CHECK_EQ(set.position_m[0], state.position_m[0]);
  }
}

// At its bound every number is accepted, and the next step answers; beyond it none is.
TEST(capi_every_state_is_bounded_where_a_step_can_go) {
  const auto work = new_work();
  const auto bound = [](int i) {
    if (i <= TR_W) return tr_real(300);
    if (i <= TR_R) return tr_real(20);
    if (i == TR_ROLL) return tr_real(1000);
    if (i == TR_PITCH) return tr_real(89.9999) * tr_real(3.14159265358979323846L) / tr_real(180);
    if (i == TR_YAW) return tr_real(1e6);
    if (i >= TR_NORTH) return tr_real(1e9);
    if (i > TR_DOWNWASH) return i % 2 == 1 ? tr_real(200) : tr_real(2);
    const int place = (i - TR_ROTOR_RIGHT) % 7;
    return i < TR_DOWNWASH && (place == 2 || place == 3) ? tr_real(200) : tr_real(2);
  };
  tr_setup setup = setup_at(30);
  setup.coning_states = 1;
  tr_sim coning;
  CHECK_EQ(tr_init(&coning, TR_API_VERSION, &setup), TR_OK);
  int flown = 0;
  for (const tr_sim& sim : {trimmed_sim(30, 50), coning}) {
    const tr_state good = state_of(sim);
    for (int i = 0; i < TR_MAST; ++i) {
      for (const tr_real sign : {tr_real(1), tr_real(-1)}) {
        tr_state state = good;
        state.x[i] = sign * bound(i) * (1 - 2 * std::numeric_limits<tr_real>::epsilon());
        tr_sim here = sim;
        CHECK_EQ(tr_set_state(&here, &state), TR_OK);
        const tr_status status = tr_step(&here, work.get(), dt);
        CHECK(status == TR_OK || status == TR_OUT_OF_RANGE);
        flown += status == TR_OK;
        const tr_state reached = state_of(here);
        CHECK_EQ(tr_set_state(&here, &reached), TR_OK);
        const tr_sim unmoved = here;
        for (const tr_real beyond : {bound(i) * (1 + 4 * std::numeric_limits<tr_real>::epsilon()),
                                     tr_real(2e9), std::numeric_limits<tr_real>::max()}) {
          state.x[i] = sign * beyond;
          CHECK_EQ(tr_set_state(&here, &state), TR_OUT_OF_RANGE);
        }
        CHECK(same_but_for_the_fault(here, unmoved));
      }
    }
  }
  CHECK_LE(60, flown);
  const tr_sim sim = trimmed_sim(30, 50);
  for (int j = 0; j < TR_CONTROLS; ++j) {
    for (const tr_real sign : {tr_real(1), tr_real(-1)}) {
      tr_state state = state_of(sim);
      state.u[j] = sign * 100;
      tr_sim here = sim;
      CHECK_EQ(tr_set_state(&here, &state), TR_OK);
      const tr_status status = tr_step(&here, work.get(), dt);
      CHECK(status == TR_OK || status == TR_OUT_OF_RANGE || status == TR_NOT_FINITE);
      state.u[j] = sign * tr_real(100.001);
      CHECK_EQ(tr_set_state(&here, &state), TR_OUT_OF_RANGE);
    }
  }
}

// A flight that reaches the end of a range says so, and stays in what can be set again.
TEST(capi_flight_ends_at_the_bounds) {
  const auto work = new_work();
  const tr_state trimmed = state_of(turning(0, 40));
  const auto ends = [&](auto&& change) {
    tr_sim sim = sim_at(0);
    tr_state state = trimmed;
    change(state);
    CHECK_EQ(tr_set_state(&sim, &state), TR_OK);
    tr_status status = TR_OK;
    for (int k = 0; k < 3 && status == TR_OK; ++k) status = tr_step(&sim, work.get(), tr_real(0.02));
    CHECK_EQ(status, TR_OUT_OF_RANGE);
    const tr_state last = state_of(sim);
    CHECK_EQ(tr_set_state(&sim, &last), TR_OK);
  };
  ends([](tr_state& s) { s.x[TR_YAW] = tr_real(1e6); });
  ends([](tr_state& s) { s.x[TR_NORTH] = tr_real(1e9); });
  ends([](tr_state& s) { s.time_s = 1e9; });
  ends([](tr_state& s) { s.steps = UINT64_C(1000000000000000); });
  tr_sim sim = sim_at(0);
  tr_state state = trimmed;
  for (const double time : {1.0000001e9, 1e300}) {
    state.time_s = time;
    CHECK_EQ(tr_set_state(&sim, &state), TR_OUT_OF_RANGE);
  }
  state.time_s = 1;
  for (const std::uint64_t steps : {UINT64_C(1000000000000001), ~UINT64_C(0)}) {
    state.steps = steps;
    CHECK_EQ(tr_set_state(&sim, &state), TR_OUT_OF_RANGE);
  }
}
