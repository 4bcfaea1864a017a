// tr_step with every length it accepts: what decays in flight decays in the computation.
// Expected: decay to the trim, as short steps have it.
#include <cmath>
#include <cstring>
#include <memory>

#include "check.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/tiltrotor.h"

namespace {

struct Case {
  tr_real mast_deg, rotor_radps, altitude_m, speed_mps;
};
const tiltrotor::LimitTables<double>& kLimits = tiltrotor::aircraft_data<double>().limits;
const auto kFast = static_cast<tr_real>(kLimits.speed);
const auto kSlowRotor = static_cast<tr_real>(kLimits.rotor_speed.low);
const auto kFastRotor = static_cast<tr_real>(kLimits.rotor_speed.high);
const Case kCases[] = {{90, 0, 0, kFast},
                       {90, kFastRotor, static_cast<tr_real>(kLimits.altitude.low), kFast* tr_real(0.96)},
                       {75, kFastRotor, 0, kFast / 2},
                       {0, kFastRotor, 0, 0},
                       {90, kSlowRotor* tr_real(1.125), 0, kFast}};

bool trimmed(const Case& which, tr_work* work, tr_sim* sim) {
  tr_setup setup;
  CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), which.mast_deg), TR_OK);
  setup.altitude_m = which.altitude_m;
  setup.coning_states = 1;
  if (which.rotor_radps > 0) setup.rotor_radps = which.rotor_radps;
  if (!CHECK_EQ(tr_init(sim, TR_API_VERSION, &setup), TR_OK)) return false;
  const tr_flight flight = {which.speed_mps, 0, 0, 0};
  tr_trim_result result;
  const tr_status status = tr_trim(sim, work, &flight, &result);
  // Beyond a limit the modes are as fast.
  if (status == TR_OK || status == TR_WING_STALL || status == TR_CONTROL_LIMIT || status == TR_FLAP_LIMIT ||
      status == TR_POWER_LIMIT || status == TR_TORQUE_LIMIT)
    return true;
  NOTE(which.mast_deg << " deg " << which.speed_mps << " m/s: " << result.text);
  return false;
}

// Largest difference of harmonic inflow and gimbal tilt to trim.
tr_real off_trim(const tr_sim* sim, const tr_state& trim) {
  tr_state now;
  CHECK_EQ(tr_get_state(sim, &now), TR_OK);
  tr_real worst = 0;
  for (int rotor : {TR_ROTOR_RIGHT, TR_ROTOR_LEFT})
    for (int i : {0, 1, 4, 5, 6}) worst = std::fmax(worst, std::fabs(now.x[rotor + i] - trim.x[rotor + i]));
  return worst;
}

}  // namespace

TEST(capi_step_of_any_length_is_stable) {
  const auto work = std::make_unique<tr_work>();
  int flown = 0;
  for (const Case& which : kCases) {
    tr_sim trim;
    if (!trimmed(which, work.get(), &trim)) continue;
    ++flown;
    tr_state begin;
    CHECK_EQ(tr_get_state(&trim, &begin), TR_OK);
    for (double length : {0.0005, 0.005, 0.0099, 0.01, 0.0101, 0.0135, 0.015, 0.018, 0.02}) {
      const auto dt = static_cast<tr_real>(length);
      tr_sim sim = trim;
      tr_state disturbed = begin;
      disturbed.x[TR_ROTOR_RIGHT + TR_COSINE_INFLOW] += tr_real(0.05);
      disturbed.x[TR_ROTOR_LEFT + TR_B1C_RATE] += tr_real(0.5);
      CHECK_EQ(tr_set_state(&sim, &disturbed), TR_OK);
      tr_status status = TR_OK;
      for (int k = 0; k < static_cast<int>(1 / length) && status == TR_OK; ++k)
        status = tr_step(&sim, work.get(), dt);
      const tr_real left = off_trim(&sim, begin);
      if (!CHECK_EQ(status, TR_OK) || !CHECK_LT(left, tr_real(0.01)))
        NOTE(which.mast_deg << " deg " << which.speed_mps << " m/s " << which.rotor_radps << " rad/s, dt "
                            << dt << ": " << left);
    }
  }
  CHECK_EQ(flown, 5);
}

// Beyond the speeds of trim, in every direction and in a gust, begun with the inflow off balance: where short
// steps end.
TEST(capi_step_is_stable_in_fast_air) {
  const auto work = std::make_unique<tr_work>();
  for (int direction = 0; direction < 6; ++direction) {
    tr_sim sim;
    tr_setup setup;
    CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), 90), TR_OK);
    CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK);
    tr_state state;
    CHECK_EQ(tr_get_state(&sim, &state), TR_OK);
    state.x[direction / 2] = direction % 2 == 0 ? 250 : -250;
    state.x[TR_ROTOR_RIGHT + TR_COSINE_INFLOW] = tr_real(0.05);
    state.x[TR_ROTOR_LEFT + TR_SINE_INFLOW] = tr_real(-0.05);
    state.u[TR_GUST_U] = -50;
    const auto flown = [&](int steps, tr_real dt, tr_state* end) {
      CHECK_EQ(tr_set_state(&sim, &state), TR_OK);
      for (int k = 0; k < steps; ++k)
        if (!CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OK)) return;
      CHECK_EQ(tr_get_state(&sim, end), TR_OK);
    };
    tr_state fine, coarse;
    std::memset(&fine, 0, sizeof fine);
    std::memset(&coarse, 0, sizeof coarse);
    flown(200, tr_real(0.0005), &fine);
    for (int steps : {5, 7, 10, 20}) {
      flown(steps, tr_real(0.1) / static_cast<tr_real>(steps), &coarse);
      tr_real worst = 0;
      for (int rotor : {TR_ROTOR_RIGHT, TR_ROTOR_LEFT})
        for (int i : {5, 6}) worst = std::fmax(worst, std::fabs(coarse.x[rotor + i] - fine.x[rotor + i]));
      if (!CHECK_LT(worst, tr_real(0.005))) NOTE("direction " << direction << ", " << steps << " steps");
    }
  }
}

// A step in parts too: the linear model hands its rates to the first of them.
TEST(capi_linearize_and_step_in_parts_gives_the_bits_of_the_two_calls) {
  const auto work = std::make_unique<tr_work>();
  tr_sim apart;
  if (!CHECK(trimmed(kCases[0], work.get(), &apart))) return;
  tr_sim together = apart;
  const tr_real pushed[] = {tr_real(0.9), 1, 1, 1};
  CHECK_EQ(tr_set_controls(&apart, pushed, 4), TR_OK);
  CHECK_EQ(tr_set_controls(&together, pushed, 4), TR_OK);
  constexpr size_t capacity = TR_MAX_LINEAR_STATES * TR_MAX_LINEAR_STATES;
  static tr_real a[2][capacity];
  tr_linear_shape shape;
  for (int k = 0; k < 5; ++k) {
    CHECK_EQ(tr_linearize(&apart, work.get(), TR_INCEPTORS, &shape, a[0], capacity, nullptr, 0), TR_OK);
    CHECK_EQ(tr_step(&apart, work.get(), tr_real(0.02)), TR_OK);
    CHECK_EQ(tr_linearize_and_step(&together, work.get(), tr_real(0.02), TR_INCEPTORS, &shape, a[1], capacity,
                                   nullptr, 0),
             TR_OK);
    tr_state x, y;
    std::memset(&x, 0, sizeof x);
    std::memset(&y, 0, sizeof y);
    CHECK_EQ(tr_get_state(&apart, &x), TR_OK);
    CHECK_EQ(tr_get_state(&together, &y), TR_OK);
    CHECK(std::memcmp(&x, &y, sizeof x) == 0);
    CHECK(std::memcmp(a[0], a[1], sizeof a[0]) == 0);
  }
}
