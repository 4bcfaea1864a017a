// The C interface in air that moves: instruments read the air, and a trim keeps wind, heading and position.
// Expected: velocity triangles, and the same flight in still air.
#include <cmath>
#include <limits>
#include <vector>

#include "capi/flying.hpp"

using namespace capi;

namespace {

constexpr bool kDouble = sizeof(tr_real) == 8;

tr_outputs outputs_of(const tr_sim& sim) {
  tr_outputs outputs;
  CHECK_EQ(tr_get_outputs(&sim, &outputs), TR_OK);
  return outputs;
}

tr_sim at_state(tr_sim sim, const tr_state& state) {
  CHECK_EQ(tr_set_state(&sim, &state), TR_OK);
  return sim;
}

void check_same_loads(const tr_outputs& a, const tr_outputs& b, double tolerance) {
  for (int k = 0; k < 2; ++k) {
    CHECK_REL(a.thrust_n[k], b.thrust_n[k], tolerance);
    CHECK_REL(a.power_w[k], b.power_w[k], tolerance);
  }
  CHECK_NEAR(a.load_factor, b.load_factor, tolerance);
  CHECK_NEAR(a.angle_of_attack_rad, b.angle_of_attack_rad, tolerance);
  CHECK_NEAR(a.sideslip_rad, b.sideslip_rad, tolerance);
}

}  // namespace

// Airspeed and angles from the velocity triangle; and the whole aircraft carried along by the gust reads what
// it reads in still air.
TEST(capi_outputs_are_relative_to_the_air) {
  for (const tr_real mast : {tr_real(0), tr_real(90)}) {
    const tr_sim still = trimmed_sim(mast, mast < 90 ? tr_real(40) : tr_real(100));
    const tr_outputs calm = outputs_of(still);
    tr_state state = state_of(still);
    const tr_real gust[3] = {12, -7, tr_real(4.5)};
    for (int k = 0; k < 3; ++k) state.u[TR_GUST_U + k] = gust[k];
    const tr_outputs gusty = outputs_of(at_state(still, state));
    const double u = double(state.x[TR_U]) - 12, v = double(state.x[TR_V]) + 7,
                 w = double(state.x[TR_W]) - 4.5;
    const double tolerance = kDouble ? 1e-13 : 1e-5;
    CHECK_REL(gusty.airspeed_mps, std::sqrt(u * u + v * v + w * w), tolerance);
    CHECK_NEAR(gusty.angle_of_attack_rad, std::atan2(w, u), tolerance);
    CHECK_NEAR(gusty.sideslip_rad, std::asin(v / std::sqrt(u * u + v * v + w * w)), tolerance);
    CHECK_EQ(gusty.climb_rate_mps, calm.climb_rate_mps);
    CHECK_LT(0.01, std::abs(gusty.load_factor - calm.load_factor));  // the loads feel it

    for (int k = 0; k < 3; ++k) state.x[TR_U + k] += gust[k];
    const tr_outputs carried = outputs_of(at_state(still, state));
    check_same_loads(carried, calm, kDouble ? 1e-9 : 2e-3);
    CHECK_REL(carried.airspeed_mps, calm.airspeed_mps, kDouble ? 1e-13 : 1e-5);
  }
  const tr_sim rest = sim_at(0);
  CHECK_EQ(outputs_of(rest).angle_of_attack_rad, 0);
  CHECK_EQ(outputs_of(rest).airspeed_mps, 0);
}

// Straight flight: the loads of still air. Any flight: steady, at the airspeed and turn rate asked for.
TEST(capi_trim_keeps_wind_heading_and_position) {
  struct Case {
    tr_real mast, speed, climb, turn, sideslip;
  };
  const Case cases[] = {{0, 0, 0, 0, 0},
                        {0, 30, 0, 0, 0},
                        {30, 50, tr_real(0.05), 0, 0},
                        {0, 25, 0, 0, tr_real(0.1)},
                        {90, 100, tr_real(-0.04), 0, 0},
                        {0, 35, tr_real(0.02), tr_real(0.1), 0},
                        {90, 110, 0, tr_real(-0.05), 0}};
  const auto work = new_work();
  for (const Case& k : cases) {
    const tr_flight flight = {k.speed, k.climb, k.turn, k.sideslip};
    tr_sim still = sim_at(k.mast);
    CHECK_EQ(tr_trim(&still, work.get(), &flight, nullptr), TR_OK);
    tr_state state = state_of(sim_at(k.mast));
    state.x[TR_YAW] = tr_real(9.25);
    state.x[TR_NORTH] = tr_real(54321.25);
    state.x[TR_EAST] = tr_real(-321.5);
    state.x[TR_DOWN] = tr_real(-1000.125);
    state.u[TR_GUST_U] = 8;
    state.u[TR_GUST_V] = -3;
    state.u[TR_GUST_W] = tr_real(1.5);
    state.u[TR_ELEVATOR] = tr_real(0.1);
    state.time_s = 5;
    state.steps = 12;
    tr_sim windy = at_state(sim_at(k.mast), state);
    flown_on(windy, 2);  // positions with more digits than tr_real holds
    const tr_state before = state_of(windy);
    tr_trim_result result;
    if (!CHECK_EQ(tr_trim(&windy, work.get(), &flight, &result), TR_OK)) NOTE(result.text);
    const tr_state after = state_of(windy);
    CHECK_EQ(after.yaw_rad, before.yaw_rad);
    for (int i = 0; i < 3; ++i) {
      CHECK_EQ(after.position_m[i], before.position_m[i]);
      CHECK_EQ(after.x[TR_NORTH + i], before.x[TR_NORTH + i]);
      CHECK_EQ(after.u[TR_GUST_U + i], before.u[TR_GUST_U + i]);
    }
    CHECK_EQ(after.x[TR_YAW], before.x[TR_YAW]);
    CHECK_EQ(after.u[TR_ELEVATOR], 0);
    CHECK_EQ(after.time_s, 0);
    CHECK_EQ(after.steps, 0);

    tr_real rates[TR_STATES];
    CHECK_EQ(tr_derivative(&windy, rates, TR_STATES), TR_OK);
    for (int i = TR_U; i <= TR_PITCH; ++i) CHECK_NEAR(rates[i], 0, kDouble ? 1e-8 : 2e-3);
    CHECK_NEAR(rates[TR_YAW], k.turn, 1e-6);
    const tr_outputs calm = outputs_of(still), wind = outputs_of(windy);
    CHECK_NEAR(wind.airspeed_mps, k.speed, 1e-4);
    if (k.speed > 0) CHECK_NEAR(wind.sideslip_rad, k.sideslip, kDouble ? 1e-9 : 1e-4);
    if (k.turn == 0) check_same_loads(wind, calm, kDouble ? 1e-7 : 5e-3);

    // And it stays in that flight, carried by the air.
    CHECK_EQ(tr_step(&windy, work.get(), dt), TR_OK);
    for (int step = 0; step < 50; ++step) CHECK_EQ(tr_step(&windy, work.get(), dt), TR_OK);
    CHECK_NEAR(outputs_of(windy).airspeed_mps, k.speed, kDouble ? 1e-6 : 1e-2);
  }
}

// A trim that fails leaves all of it, one that succeeds without wind begins as ever.
TEST(capi_trim_without_wind_is_in_still_air) {
  tr_sim sim = trimmed_sim(30, 50);
  const tr_state state = state_of(sim);
  for (int i = TR_YAW; i < TR_STATES; i += i == TR_YAW ? TR_NORTH - TR_YAW : 1) CHECK_EQ(state.x[i], 0);
  for (int i = TR_GUST_U; i < TR_CONTROLS; ++i) CHECK_EQ(state.u[i], 0);
}

// A wind that grows with height: switched on, with the ground or with another wind the aircraft keeps its velocity over the
// ground, which is that through the air and the wind of its height; saved and loaded it is the same.
TEST(capi_wind_shear_keeps_the_velocity_over_the_ground) {
  tr_sim sim = trimmed_sim(30, 50);
  tr_environment air;
  CHECK_EQ(tr_default_environment(&air), TR_OK);
  const auto moves = [&sim] {
    const tr_real station[3] = {tr_real(7.65), 0, 2};
    tr_motion m;
    CHECK_EQ(tr_motion_at(&sim, station, &m), TR_OK);
    return m;
  };
  const tr_motion before = moves();
  const auto check = [&](double wind_share) {
    const tr_motion now = moves();
    const tr_state x = state_of(sim);
    for (int k = 0; k < 3; ++k)
      CHECK_NEAR(now.velocity_ned_mps[k], before.velocity_ned_mps[k], kDouble ? 1e-11 : 1e-4);
    tr_real rates[TR_STATES];
    CHECK_EQ(tr_derivative(&sim, rates, TR_STATES), TR_OK);
    CHECK_NEAR(rates[TR_NORTH], before.velocity_ned_mps[0], kDouble ? 1e-10 : 1e-3);
    const double pitch = static_cast<double>(x.x[TR_PITCH]);
    const double ahead =
        static_cast<double>(x.x[TR_U]) * std::cos(pitch) + static_cast<double>(x.x[TR_W]) * std::sin(pitch);
    CHECK_NEAR(ahead - wind_share * 9, before.velocity_ned_mps[0], kDouble ? 1e-10 : 1e-3);
  };
  air.wind_mps[0] = -9;
  air.ground_down_m = 30;
  CHECK_EQ(tr_set_environment(&sim, &air), TR_OK);
  check(1);
  tr_systems systems;
  CHECK_EQ(tr_get_systems(&sim, &systems), TR_OK);
  systems.wind_shear = TR_SHEAR_OTHER;
  CHECK_EQ(tr_set_systems(&sim, &systems), TR_OK);
  const auto share = [](double height_m) { return std::log(height_m / (2 * 0.3048)) / std::log(10.0); };
  check(share(30));
  air.ground_down_m = 12;
  CHECK_EQ(tr_set_environment(&sim, &air), TR_OK);
  check(share(12));
  std::vector<unsigned char> bytes(TR_SAVED_SIZE);
  std::size_t length = 0;
  CHECK_EQ(tr_save(&sim, bytes.data(), bytes.size(), &length), TR_OK);
  tr_sim loaded;
  CHECK_EQ(tr_load_saved(&loaded, TR_API_VERSION, bytes.data(), length), TR_OK);
  CHECK(same_bits(state_of(loaded), state_of(sim)));
  CHECK_EQ(tr_get_systems(&loaded, &systems), TR_OK);
  CHECK_EQ(systems.wind_shear, int{TR_SHEAR_OTHER});
  systems.wind_shear = 3;
  CHECK_EQ(tr_set_systems(&sim, &systems), TR_BAD_ARGUMENT);
  systems.wind_shear = TR_SHEAR_NONE;
  CHECK_EQ(tr_set_systems(&sim, &systems), TR_OK);
  check(1);
}

// Refused, an environment and systems leave the aircraft as it is, bit for bit; any ground that is finite gives rates.
TEST(capi_wind_shear_refuses_without_a_trace) {
  tr_sim sim = trimmed_sim(30, 50);
  tr_environment air;
  CHECK_EQ(tr_default_environment(&air), TR_OK);
  air.wind_mps[0] = air.wind_mps[1] = -100;
  air.ground_down_m = 1000;
  CHECK_EQ(tr_set_environment(&sim, &air), TR_OK);
  tr_systems systems;
  CHECK_EQ(tr_get_systems(&sim, &systems), TR_OK);
  const auto without_a_trace = [&sim](const char* what, tr_status expected, auto&& call) {
    const tr_sim before = sim;
    if (!(CHECK_EQ(call(), expected) & CHECK(same_bits(sim, before)))) NOTE(what);
  };
  tr_systems all = systems;
  all.wind_shear = TR_SHEAR_OTHER;  // 270 m/s at that height, and the aircraft against it
  tr_state state = state_of(sim);
  state.x[TR_U] = tr_real(290);
  CHECK_EQ(tr_set_state(&sim, &state), TR_OK);
  without_a_trace("velocity", TR_OUT_OF_RANGE, [&] { return tr_set_systems(&sim, &all); });
  state.x[TR_U] = tr_real(50);
  CHECK_EQ(tr_set_state(&sim, &state), TR_OK);
  air.wind_mps[0] = -5;
  air.wind_mps[1] = 0;
  CHECK_EQ(tr_set_environment(&sim, &air), TR_OK);
  CHECK_EQ(tr_set_systems(&sim, &all), TR_OK);
  for (const tr_real ground : {-kInfinity, kNan}) {
    air.ground_down_m = ground;
    without_a_trace("ground", TR_NOT_FINITE, [&] { return tr_set_environment(&sim, &air); });
  }
  const tr_real largest = std::numeric_limits<tr_real>::max();
  for (const tr_real ground : {largest, -largest, tr_real(1e6), kInfinity}) {
    air.ground_down_m = ground;
    tr_real rates[TR_STATES];
    CHECK_EQ(tr_set_environment(&sim, &air), TR_OK);
    CHECK_EQ(tr_derivative(&sim, rates, TR_STATES), TR_OK);
  }
}

// On its wheels in a wind that grows with height the aircraft stands, and its air is the wind of its height.
TEST(capi_wind_shear_blows_past_an_aircraft_on_its_wheels) {
  tr_setup setup = setup_at(0);
  setup.rotor_radps = 30;
  tr_sim sim;
  CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK);
  tr_environment air;
  CHECK_EQ(tr_default_environment(&air), TR_OK);
  air.wind_mps[0] = -8;
  air.ground_down_m = 0;
  CHECK_EQ(tr_set_environment(&sim, &air), TR_OK);
  tr_systems systems;
  CHECK_EQ(tr_get_systems(&sim, &systems), TR_OK);
  systems.gear = 1;
  systems.wind_shear = TR_SHEAR_OTHER;
  systems.brake[0] = systems.brake[1] = 1;
  CHECK_EQ(tr_set_systems(&sim, &systems), TR_OK);
  tr_state state = state_of(sim);
  state.x[TR_DOWN] = tr_real(-1.85);
  state.x[TR_U] = 4;
  CHECK_EQ(tr_set_state(&sim, &state), TR_OK);
  const tr_real collective = tr_real(-0.03);
  CHECK_EQ(tr_set_controls(&sim, &collective, 1), TR_OK);
  const auto work = new_work();
  for (int k = 0; k < 3000; ++k) CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OK);
  const tr_state rests = state_of(sim);
  const double height_ft = -static_cast<double>(rests.x[TR_DOWN]) / 0.3048;
  const double pitch = static_cast<double>(rests.x[TR_PITCH]);
  const double ahead = static_cast<double>(rests.x[TR_U]) * std::cos(pitch) +
                       static_cast<double>(rests.x[TR_W]) * std::sin(pitch);
  CHECK_NEAR(ahead, 8 * std::log(height_ft / 2) / std::log(10.0), 0.02);
}
