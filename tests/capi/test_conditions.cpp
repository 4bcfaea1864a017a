// The C interface: masts, rotor speed and loading in flight, loads from outside.
// Expected: closed forms of the way and Newton's laws; other calls that say the same; the header's text.
#include "capi/conditions.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

using namespace capi;

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

// Shaft torque is what the air takes and what speeds the blades up.
TEST(capi_configuration_that_speeds_the_rotors_up_takes_torque) {
  tr_sim sim = trimmed_sim(30, 50);
  tr_outputs a, b;
  CHECK_EQ(tr_get_outputs(&sim, &a), TR_OK);
  tr_configuration c = configuration_of(sim);
  c.rotor_acceleration_radps2 = 2;
  CHECK_EQ(tr_set_configuration(&sim, &c), TR_OK);
  CHECK_EQ(tr_get_outputs(&sim, &b), TR_OK);
  const auto& rotor = tiltrotor::aircraft_data<tr_real>().rotor;
  const double more = 2.0 * rotor.blades * double(rotor.flap_inertia);
  for (int side = 0; side < 2; ++side) {
    CHECK_NEAR(b.torque_nm[side] - a.torque_nm[side], more, 1e-3 * more);
    CHECK_NEAR(b.power_w[side] - a.power_w[side], more * c.rotor_radps, 1e-3 * more * c.rotor_radps);
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
  const auto& limits = tiltrotor::aircraft_data<tr_real>().limits;
  fast.rotor_radps = tr_real(0.999) * limits.rotor_speed.high;
  fast.rotor_acceleration_radps2 = limits.rotor_acceleration.high;
  CHECK_EQ(tr_set_configuration(&sim, &fast), TR_OK);
  const tr_sim ready = sim;
  CHECK_EQ(tr_step(&sim, new_work().get(), dt), TR_OUT_OF_RANGE);
  CHECK(same_bits(state_of(sim), state_of(ready)));
  CHECK(same_bits(configuration_of(sim), configuration_of(ready)));
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
