// The C interface: masts, rotor speed and loading in flight, air that moves and changes, loads from outside.
// Expected: closed forms of the way, of the drift and of Newton's laws; other calls that say the same; the header's
// text.
#include <cmath>

#include "capi/flying.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

using namespace capi;

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180;

tr_configuration configuration_of(const tr_sim& sim) {
  tr_configuration configuration;
  std::memset(&configuration, 0, sizeof configuration);
  CHECK_EQ(tr_get_configuration(&sim, &configuration), TR_OK);
  return configuration;
}
tr_environment calm() {
  tr_environment environment;
  CHECK_EQ(tr_default_environment(&environment), TR_OK);
  return environment;
}
void fly(tr_sim& sim, int steps) {
  const auto work = new_work();
  for (int k = 0; k < steps; ++k) CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OK);
}
std::vector<double> rates_of(const tr_sim& sim) {
  tr_real rates[TR_STATES];
  CHECK_EQ(tr_derivative(&sim, rates, TR_STATES), TR_OK);
  return {rates, rates + TR_STATES};
}
void set_state(tr_sim& sim, const tr_state& state) { CHECK_EQ(tr_set_state(&sim, &state), TR_OK); }

// A twin in pedal and lateral stick at neutral, whose mixing does not look at the airspeed.
tr_sim moving_about() {
  tr_sim sim = trimmed_sim(30, 50);
  tr_state state = state_of(sim);
  state.x[TR_V] = 2;
  state.x[TR_P] = tr_real(0.1);
  state.x[TR_R] = tr_real(-0.05);
  state.u[TR_LAT_STICK] = state.u[TR_PEDAL] = 0;
  set_state(sim, state);
  return sim;
}

}  // namespace

TEST(capi_configuration_is_that_of_the_setup_and_then_what_was_set) {
  const tr_setup setup = setup_at(30);
  tr_sim sim = sim_at(30);
  tr_configuration c = configuration_of(sim);
  CHECK_EQ(c.mast_deg, setup.mast_deg);
  CHECK_EQ(c.flap_deg, setup.flap_deg);
  CHECK_EQ(c.rotor_radps, setup.rotor_radps);
  CHECK_EQ(c.mass_kg, setup.mass_kg);
  CHECK_EQ(c.cg_station_m, setup.cg_station_m);
  CHECK_EQ(c.mast_rate_radps, 0);
  CHECK_EQ(c.rotor_acceleration_radps2, 0);
  c.mast_deg = 42;
  c.flap_deg = 11;
  c.mass_kg *= tr_real(0.9);
  c.cg_station_m -= tr_real(0.05);
  c.cg_waterline_m += tr_real(0.02);
  c.mast_acceleration_radps2 = tr_real(0.1);
  CHECK_EQ(tr_set_configuration(&sim, &c), TR_OK);
  const tr_configuration got = configuration_of(sim);
  CHECK(same_bits(got, c));
}

// Set in flight is what tr_init would have made, but for the waterline, which a setup does not have.
TEST(capi_configuration_set_in_flight_is_that_of_a_new_aircraft) {
  tr_sim sim = trimmed_sim(30, 50);
  tr_setup setup = setup_at(47);
  setup.flap_deg = 13;
  setup.mass_kg *= tr_real(0.95);
  setup.rotor_radps = configuration_of(sim).rotor_radps;
  tr_configuration c = configuration_of(sim);
  c.mast_deg = 47;
  c.flap_deg = setup.flap_deg;
  c.mass_kg = setup.mass_kg;
  CHECK_EQ(tr_set_configuration(&sim, &c), TR_OK);
  tr_sim anew;
  CHECK_EQ(tr_init(&anew, TR_API_VERSION, &setup), TR_OK);
  set_state(anew, state_of(sim));
  CHECK(rates_of(sim) == rates_of(anew));
}

TEST(capi_configuration_moves_masts_and_rotors_through_steps) {
  tr_sim sim = trimmed_sim(30, 50);
  tr_configuration c = configuration_of(sim);
  const tr_state before = state_of(sim);
  c.mast_rate_radps = tr_real(0.13);
  c.mast_acceleration_radps2 = tr_real(-0.05);
  c.rotor_acceleration_radps2 = -1;
  CHECK_EQ(tr_set_configuration(&sim, &c), TR_OK);
  CHECK(same_bits(state_of(sim), before));  // the state stays
  fly(sim, 60);
  const double t = 60 * double(dt);
  const tr_configuration now = configuration_of(sim);
  const double rounding = sizeof(tr_real) == 8 ? 1e-11 : 1e-4;
  CHECK_NEAR(now.mast_deg, 30 + (0.13 * t - 0.025 * t * t) / kDegree, rounding);
  CHECK_NEAR(now.mast_rate_radps, 0.13 - 0.05 * t, rounding);
  CHECK_NEAR(now.rotor_radps, double(c.rotor_radps) - t, rounding);
  // A second at the conversion's rate reaches the stop of a mast at 85 deg, and not a bit more.
  tr_sim last = trimmed_sim(85, 80);
  tr_configuration up = configuration_of(last);
  up.mast_rate_radps = tr_real(7.5 * kDegree);
  CHECK_EQ(tr_set_configuration(&last, &up), TR_OK);
  fly(last, 140);
  CHECK_EQ(configuration_of(last).mast_deg, 90);
  CHECK_EQ(configuration_of(last).mast_rate_radps, 0);
}

TEST(capi_configuration_keeps_the_speed_of_the_inflow) {
  tr_sim sim = trimmed_sim(0, 20);
  tr_configuration c = configuration_of(sim);
  const tr_state before = state_of(sim);
  const double tip = c.rotor_radps;
  c.rotor_radps *= tr_real(0.9);
  CHECK_EQ(tr_set_configuration(&sim, &c), TR_OK);
  const tr_state after = state_of(sim);
  for (int i = 0; i < TR_STATES; ++i) {
    const bool inflow = (i >= TR_ROTOR_RIGHT + TR_MEAN_INFLOW && i < TR_ROTOR_LEFT) ||
                        (i >= TR_ROTOR_LEFT + TR_MEAN_INFLOW && i < TR_DOWNWASH);
    if (inflow)
      CHECK_NEAR(after.x[i] * c.rotor_radps, before.x[i] * tip, 1e-6);
    else
      CHECK_EQ(after.x[i], before.x[i]);
  }
}

TEST(capi_configuration_errors) {
  tr_sim sim = trimmed_sim(30, 50);
  const tr_sim before = sim;
  const tr_configuration good = configuration_of(sim);
  CHECK_EQ(tr_get_configuration(nullptr, nullptr), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_get_configuration(&sim, nullptr), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_set_configuration(nullptr, &good), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_set_configuration(&sim, nullptr), TR_BAD_ARGUMENT);
  constexpr std::size_t numbers = sizeof(tr_configuration) / sizeof(tr_real);
  for (std::size_t k = 0; k < numbers; ++k) {
    for (const tr_real bad : {kNan, kInfinity, tr_real(-1e5), tr_real(1e5)}) {
      tr_configuration c = good;
      std::memcpy(reinterpret_cast<char*>(&c) + k * sizeof(tr_real), &bad, sizeof bad);
      CHECK_EQ(tr_set_configuration(&sim, &c), std::isfinite(bad) ? TR_OUT_OF_RANGE : TR_NOT_FINITE);
    }
  }
  CHECK(same_bits(sim, before));
  // A step that leads out of the range of the rotor speed leaves everything.
  tr_configuration fast = good;
  fast.rotor_radps = tr_real(79.9);
  fast.rotor_acceleration_radps2 = 50;
  CHECK_EQ(tr_set_configuration(&sim, &fast), TR_OK);
  const tr_sim ready = sim;
  CHECK_EQ(tr_step(&sim, new_work().get(), dt), TR_OUT_OF_RANGE);
  CHECK(same_bits(state_of(sim), state_of(ready)));
  CHECK(same_bits(configuration_of(sim), configuration_of(ready)));
}

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
}

// Newton: a force accelerates by F/m, whatever its station turns; a couple is its moment.
TEST(capi_loads_accelerate_and_turn) {
  const tr_sim sim = moving_about();
  const std::vector<double> before = rates_of(sim);
  const double mass = configuration_of(sim).mass_kg;
  const auto change = [&](const std::vector<tr_load>& loads) {
    tr_sim loaded = sim;
    CHECK_EQ(tr_set_loads(&loaded, loads.data(), loads.size()), TR_OK);
    std::vector<double> rates = rates_of(loaded);
    for (std::size_t i = 0; i < rates.size(); ++i) rates[i] -= before[i];
    return rates;
  };
  const double rounding = sizeof(tr_real) == 8 ? 1e-12 : 1e-5;
  const std::vector<double> pulled = change({{{8, 1, 2}, {1000, -500, 2000}, {0, 0, 0}}});
  CHECK_NEAR(pulled[TR_U], 1000 / mass, rounding);
  CHECK_NEAR(pulled[TR_V], -500 / mass, rounding);
  CHECK_NEAR(pulled[TR_W], 2000 / mass, rounding);
  // Aft of the centre of gravity, a push down turns the nose up; further out to the right, the right wing down.
  const std::vector<double> aft = change({{{12, 0, 2}, {0, 0, 1000}, {0, 0, 0}}});
  CHECK_LT(0, aft[TR_Q]);
  const std::vector<double> aside = change({{{7.6, 3, 2}, {0, 0, 1000}, {0, 0, 0}}});
  CHECK_LT(0, aside[TR_P]);
  // Two metres apart and against each other: 2000 N m nose up, wherever.
  const std::vector<double> couple =
      change({{{12, 0, 2}, {0, 0, 1000}, {0, 0, 0}}, {{10, 0, 2}, {0, 0, -1000}, {0, 0, 0}}});
  const std::vector<double> moment = change({{{3, 1, 4}, {0, 0, 0}, {0, 2000, 0}}});
  for (const int i : {TR_U, TR_W, TR_P, TR_Q, TR_R}) CHECK_NEAR(couple[i], moment[i], rounding);
  // An accelerometer feels it as the air's.
  tr_sim loaded = sim;
  const tr_load up = {{8, 0, 2}, {0, 0, -3000}, {0, 0, 0}};
  tr_outputs a, b;
  CHECK_EQ(tr_get_outputs(&loaded, &a), TR_OK);
  CHECK_EQ(tr_set_loads(&loaded, &up, 1), TR_OK);
  CHECK_EQ(tr_get_outputs(&loaded, &b), TR_OK);
  CHECK_NEAR(b.specific_force_mps2[2] - a.specific_force_mps2[2], -3000 / mass, rounding * 10);
  CHECK_EQ(tr_set_loads(&loaded, nullptr, 0), TR_OK);
  CHECK(rates_of(loaded) == before);
}

TEST(capi_loads_errors) {
  tr_sim sim = trimmed_sim(30, 50);
  const tr_sim before = sim;
  const tr_load good = {{8, 0, 2}, {1, 2, 3}, {4, 5, 6}};
  std::vector<tr_load> many(TR_MOST_LOADS + 1, good);
  CHECK_EQ(tr_set_loads(nullptr, &good, 1), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_set_loads(&sim, nullptr, 1), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_set_loads(&sim, many.data(), many.size()), TR_BAD_ARGUMENT);
  for (std::size_t k = 0; k < 9; ++k) {
    for (const tr_real bad : {kNan, kInfinity, tr_real(1e8)}) {
      tr_load load = good;
      std::memcpy(reinterpret_cast<char*>(&load) + k * sizeof(tr_real), &bad, sizeof bad);
      CHECK_EQ(tr_set_loads(&sim, &load, 1), std::isfinite(bad) ? TR_OUT_OF_RANGE : TR_NOT_FINITE);
    }
  }
  CHECK(same_bits(sim, before));
}

// Saved in the middle of it all, the aircraft flies on bit for bit.
TEST(capi_saved_conditions_fly_on) {
  tr_sim sim = trimmed_sim(30, 50);
  tr_configuration c = configuration_of(sim);
  c.mast_rate_radps = tr_real(0.1);
  c.mast_acceleration_radps2 = tr_real(0.02);
  c.rotor_acceleration_radps2 = tr_real(-0.5);
  c.cg_waterline_m += tr_real(0.03);
  CHECK_EQ(tr_set_configuration(&sim, &c), TR_OK);
  tr_environment e = calm();
  e.wind_mps[1] = 6;
  e.gust_mps[TR_AT_LEFT_ROTOR][2] = -1;
  e.gust_mps[TR_AT_TAIL][1] = 2;
  e.gust_rates_radps[0] = tr_real(0.05);
  e.altitude_origin_m = 1500;
  e.temperature_offset_k = 12;
  e.pressure_ratio = tr_real(0.98);
  e.ground_down_m = 30;
  CHECK_EQ(tr_set_environment(&sim, &e), TR_OK);
  const tr_load load = {{7, 1, 1}, {300, 0, 900}, {0, 10, 0}};
  CHECK_EQ(tr_set_loads(&sim, &load, 1), TR_OK);
  fly(sim, 40);
  unsigned char bytes[TR_SAVED_SIZE];
  std::size_t used = 0;
  CHECK_EQ(tr_save(&sim, bytes, sizeof bytes, &used), TR_OK);
  tr_sim other;
  std::memset(&other, 0x33, sizeof other);
  CHECK_EQ(tr_load_saved(&other, TR_API_VERSION, bytes, used), TR_OK);
  CHECK(same_bits(state_of(other), state_of(sim)));
  CHECK(same_bits(configuration_of(other), configuration_of(sim)));
  CHECK(rates_of(other) == rates_of(sim));
  CHECK_EQ(flown_on(other, 60), flown_on(sim, 60));
  CHECK(same_bits(configuration_of(other), configuration_of(sim)));
  unsigned char again[TR_SAVED_SIZE], and_again[TR_SAVED_SIZE];
  std::size_t size = 0;
  CHECK_EQ(tr_save(&sim, again, sizeof again, &size), TR_OK);
  CHECK_EQ(tr_save(&other, and_again, sizeof and_again, &size), TR_OK);
  CHECK(std::memcmp(again, and_again, size) == 0);
}

// A point of the airframe while the masts move and the CG with them, in a wind: its velocity is the rate of its position,
// its specific force that of its velocity less gravity. Differences of a flight in steps of 0.1 ms.
TEST(capi_motion_of_a_station_while_the_masts_move) {
  if (sizeof(tr_real) == 4) return;  // nothing is left of such differences
  tr_sim sim = moving_about();
  tr_configuration c = configuration_of(sim);
  c.mast_rate_radps = tr_real(0.3);
  c.mast_acceleration_radps2 = 2;
  CHECK_EQ(tr_set_configuration(&sim, &c), TR_OK);
  tr_environment windy = calm();
  windy.wind_mps[0] = -8;
  windy.wind_mps[2] = 1;
  CHECK_EQ(tr_set_environment(&sim, &windy), TR_OK);
  const tr_load load = {{7, 1, 1}, {900, 300, 2000}, {0, 0, 0}};
  CHECK_EQ(tr_set_loads(&sim, &load, 1), TR_OK);
  const auto work = new_work();
  const tr_real station[3] = {tr_real(2.5), tr_real(1.5), tr_real(2.2)};
  const tr_real h = tr_real(1e-4);
  tr_motion at[3];
  for (tr_motion& m : at) {
    CHECK_EQ(tr_motion_at(&sim, station, &m), TR_OK);
    CHECK_EQ(tr_step(&sim, work.get(), h), TR_OK);
  }
  const tr_real* const q = at[1].quaternion;
  // Body axes in those of the earth: columns of the rotation of a quaternion, written out.
  const double to_earth[3][3] = {
      {1 - 2 * (q[2] * q[2] + q[3] * q[3]), 2 * (q[1] * q[2] - q[0] * q[3]), 2 * (q[1] * q[3] + q[0] * q[2])},
      {2 * (q[1] * q[2] + q[0] * q[3]), 1 - 2 * (q[1] * q[1] + q[3] * q[3]), 2 * (q[2] * q[3] - q[0] * q[1])},
      {2 * (q[1] * q[3] - q[0] * q[2]), 2 * (q[2] * q[3] + q[0] * q[1]),
       1 - 2 * (q[1] * q[1] + q[2] * q[2])}};
  for (int k = 0; k < 3; ++k) {
    CHECK_NEAR((at[2].position_m[k] - at[0].position_m[k]) / (2 * h), at[1].velocity_ned_mps[k], 1e-5);
    const double gravity = k == 2 ? 9.80665 : 0;
    double force = 0;
    for (int j = 0; j < 3; ++j) force += to_earth[k][j] * at[1].specific_force_mps2[j];
    CHECK_NEAR((at[2].velocity_ned_mps[k] - at[0].velocity_ned_mps[k]) / (2 * h), force + gravity, 2e-3);
  }
}
