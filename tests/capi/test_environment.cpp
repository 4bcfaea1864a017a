// The C interface: air that moves and changes.
// Expected: closed forms of the drift and of the atmosphere; other calls that say the same; the header's text.
#include "capi/conditions.hpp"

using namespace capi;

// Hover over the ground in a wind that begins: the velocity over the ground stays, then the drift is the wind's.
TEST(capi_environment_wind_carries_and_keeps_the_velocity_over_the_ground) {
  tr_sim sim = sim_at(0);
  tr_state state = state_of(sim);
  state.x[TR_U] = 3;
  state.x[TR_W] = tr_real(0.5);
  state.x[TR_ROLL] = tr_real(0.3);
  state.x[TR_PITCH] = tr_real(-0.2);
  state.x[TR_YAW] = tr_real(2.1);
  set_state(sim, state);
  const std::vector<double> before = rates_of(sim);
  tr_environment windy = calm();
  windy.wind_mps[0] = 7;
  windy.wind_mps[1] = -4;
  windy.wind_mps[2] = tr_real(0.5);
  CHECK_EQ(tr_set_environment(&sim, &windy), TR_OK);
  const std::vector<double> after = rates_of(sim);
  const double rounding = sizeof(tr_real) == 8 ? 1e-12 : 1e-5;
  for (int k = 0; k < 3; ++k) CHECK_NEAR(after[TR_NORTH + k], before[TR_NORTH + k], rounding);
  CHECK_LT(1, std::fabs(state_of(sim).x[TR_U] - 3));
  // The instruments feel it: a climb is still one relative to the air.
  tr_outputs outputs;
  CHECK_EQ(tr_get_outputs(&sim, &outputs), TR_OK);
  CHECK_NEAR(outputs.climb_rate_mps, -(after[TR_DOWN] - 0.5), rounding);
  // Back to calm: everything as it was.
  const tr_environment still = calm();
  CHECK_EQ(tr_set_environment(&sim, &still), TR_OK);
  const std::vector<double> again = rates_of(sim);
  for (int i = 0; i < TR_STATES; ++i) CHECK_NEAR(again[i], before[i], 1e-9 * (1 + std::fabs(before[i])));
}

// Trimmed in a wind: the aircraft flies as without, and drifts.
TEST(capi_environment_wind_changes_no_trim_and_no_flight) {
  tr_sim still = trimmed_sim(30, 50), blown = sim_at(30);
  tr_environment windy = calm();
  windy.wind_mps[0] = 10;
  windy.wind_mps[1] = -5;
  const auto work = new_work();
  CHECK_EQ(tr_set_environment(&blown, &windy), TR_OK);
  const tr_flight flight = {50, 0, 0, 0};
  CHECK_EQ(tr_trim(&blown, work.get(), &flight, nullptr), TR_OK);
  for (int k = 0; k < 100; ++k) {
    CHECK_EQ(tr_step(&still, work.get(), dt), TR_OK);
    CHECK_EQ(tr_step(&blown, work.get(), dt), TR_OK);
  }
  const tr_state a = state_of(still), b = state_of(blown);
  const double rounding = sizeof(tr_real) == 8 ? 1e-9 : 1e-3;
  for (int i = 0; i < TR_NORTH; ++i) CHECK_NEAR(a.x[i], b.x[i], rounding);
  const double t = 100 * double(dt);
  CHECK_NEAR(b.position_m[0] - a.position_m[0], 10 * t, rounding);
  CHECK_NEAR(b.position_m[1] - a.position_m[1], -5 * t, rounding);
}

// The same gust at every place is one that is felt everywhere.
TEST(capi_environment_gusts_at_all_places_are_one_gust) {
  tr_sim everywhere = moving_about(), places = everywhere;
  const tr_real gust[3] = {tr_real(1.5), tr_real(-2), tr_real(0.7)};
  tr_environment e = calm();
  for (auto& place : e.gust_mps) std::memcpy(place, gust, sizeof gust);
  CHECK_EQ(tr_set_environment(&places, &e), TR_OK);
  tr_state state = state_of(everywhere);
  std::memcpy(&state.u[TR_GUST_U], gust, sizeof gust);
  set_state(everywhere, state);
  const std::vector<double> a = rates_of(everywhere), b = rates_of(places);
  const double rounding = sizeof(tr_real) == 8 ? 1e-10 : 2e-2;
  for (int i = 0; i < TR_NORTH; ++i) CHECK_NEAR(a[i], b[i], rounding);
}

// Each place acts on what stands there: a gust from below lifts it.
TEST(capi_environment_gusts_act_where_they_are) {
  const tr_sim sim = moving_about();
  const std::vector<double> before = rates_of(sim);
  const auto change = [&](int place) {
    tr_sim gusty = sim;
    tr_environment e = calm();
    e.gust_mps[place][2] = -2;
    CHECK_EQ(tr_set_environment(&gusty, &e), TR_OK);
    std::vector<double> rates = rates_of(gusty);
    for (std::size_t i = 0; i < rates.size(); ++i) rates[i] -= before[i];
    return rates;
  };
  const auto at_right = change(TR_AT_RIGHT_ROTOR), at_left = change(TR_AT_LEFT_ROTOR),
             wing = change(TR_AT_WING), tail = change(TR_AT_TAIL);
  for (const auto* place : {&at_right, &at_left, &wing, &tail}) CHECK_LT((*place)[TR_W], 0);
  CHECK_LT(at_right[TR_P], 0);  // right side up
  CHECK_LT(0, at_left[TR_P]);
  CHECK_LT(tail[TR_Q], 0);  // tail up, nose down
  CHECK_LT(std::fabs(wing[TR_Q]), std::fabs(tail[TR_Q]));
  // Only what feels the flow itself changes its inflow.
  CHECK_EQ(at_right[TR_ROTOR_LEFT + TR_MEAN_INFLOW], 0);
  CHECK_EQ(tail[TR_ROTOR_LEFT + TR_MEAN_INFLOW], 0);
  // Air that rolls to the right, its right side sinking, takes the aircraft along.
  tr_sim rolled = sim;
  tr_environment e = calm();
  e.gust_rates_radps[0] = tr_real(0.2);
  CHECK_EQ(tr_set_environment(&rolled, &e), TR_OK);
  CHECK_LT(before[TR_P], rates_of(rolled)[TR_P]);
}

TEST(capi_environment_air_follows_the_altitude) {
  tr_setup setup = setup_at(90);
  setup.altitude_m = 2500;
  tr_sim high;
  CHECK_EQ(tr_init(&high, TR_API_VERSION, &setup), TR_OK);
  tr_sim low = trimmed_sim(90, 90);
  tr_state state = state_of(low);
  state.position_m[2] = state.x[TR_DOWN] = -500;
  set_state(low, state);
  set_state(high, state);
  tr_environment e = calm();
  e.altitude_origin_m = 2000;
  CHECK_EQ(tr_set_environment(&low, &e), TR_OK);
  CHECK(rates_of(low) == rates_of(high));
  // Moved by hand, the air goes along.
  state.position_m[2] = state.x[TR_DOWN] = -100;
  set_state(low, state);
  setup.altitude_m = 2100;
  CHECK_EQ(tr_init(&high, TR_API_VERSION, &setup), TR_OK);
  set_state(high, state);
  CHECK(rates_of(low) == rates_of(high));
  // And on a climb: after it, the rates are those of an aircraft made up there.
  fly(low, 200);
  const tr_state there = state_of(low);
  CHECK_LT(0.01, std::fabs(there.x[TR_DOWN] + 100));
  setup.altitude_m = 2000 - there.x[TR_DOWN];
  CHECK_EQ(tr_init(&high, TR_API_VERSION, &setup), TR_OK);
  set_state(high, there);
  CHECK(rates_of(low) == rates_of(high));
  // Out of the atmosphere: refused, and nothing is changed.
  state.position_m[2] = state.x[TR_DOWN] = -9500;
  CHECK_EQ(tr_set_state(&low, &state), TR_OUT_OF_RANGE);
  CHECK(same_bits(state_of(low), there));
  e.altitude_origin_m = 20000;
  CHECK_EQ(tr_set_environment(&low, &e), TR_OUT_OF_RANGE);
  CHECK(rates_of(low) == rates_of(high));
}

// Hot air and low pressure are thin: a rotor in axial flow at rest in the air has loads that go with the density, all
// else equal. Speed of sound goes with the root of temperature: pressure alone changes the density.
TEST(capi_environment_pressure_and_temperature) {
  tr_sim sim = sim_at(0);
  tr_state state = state_of(sim);
  state.u[TR_COLLECTIVE] = tr_real(0.15);
  set_state(sim, state);
  tr_outputs outputs;
  CHECK_EQ(tr_get_outputs(&sim, &outputs), TR_OK);
  const double thrust = outputs.thrust_n[0];
  tr_environment e = calm();
  e.pressure_ratio = tr_real(0.9);
  CHECK_EQ(tr_set_environment(&sim, &e), TR_OK);
  CHECK_EQ(tr_get_outputs(&sim, &outputs), TR_OK);
  CHECK_REL(outputs.thrust_n[0], 0.9 * thrust, 1e-6);
  // So warm that the density is that of the lower pressure: T = T0/0.9. The tip's Mach number is lower.
  e.pressure_ratio = 1;
  e.temperature_offset_k = tr_real(288.15 / 0.9 - 288.15);
  CHECK_EQ(tr_set_environment(&sim, &e), TR_OK);
  CHECK_EQ(tr_get_outputs(&sim, &outputs), TR_OK);
  CHECK_REL(outputs.thrust_n[0], 0.9 * thrust, 0.03);
  CHECK(std::fabs(outputs.thrust_n[0] - 0.9 * thrust) > 1e-5 * thrust);
}

TEST(capi_environment_errors) {
  tr_sim sim = trimmed_sim(30, 50);
  const tr_sim before = sim;
  const tr_environment good = calm();
  CHECK_EQ(tr_default_environment(nullptr), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_set_environment(nullptr, &good), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_set_environment(&sim, nullptr), TR_BAD_ARGUMENT);
  constexpr std::size_t numbers = sizeof(tr_environment) / sizeof(tr_real);
  for (std::size_t k = 0; k < numbers; ++k) {
    for (const tr_real bad : {kNan, -kInfinity, tr_real(-1e5), tr_real(1e5)}) {
      tr_environment e = good;
      std::memcpy(reinterpret_cast<char*>(&e) + k * sizeof(tr_real), &bad, sizeof bad);
      const bool ground = k == numbers - 1 && std::isfinite(bad);  // may be anywhere
      if (!ground)
        CHECK_EQ(tr_set_environment(&sim, &e), std::isfinite(bad) ? TR_OUT_OF_RANGE : TR_NOT_FINITE);
    }
  }
  CHECK(same_bits(sim, before));
  // The ends of a range belong to it.
  for (const tr_real ratio : {tr_real(0.8), tr_real(1.2)}) {
    tr_environment e = good;
    e.pressure_ratio = ratio;
    CHECK_EQ(tr_set_environment(&sim, &e), TR_OK);
  }
}
