// load_factor means one thing: what tr_get_outputs gives of a trimmed aircraft is what the trim gives, and what
// the law of its flight demands. Gusts have one range.
// Expected: lift normal to the path, cos(climb) and sqrt(1 + (V rate / g)^2); tiltrotor.h.
#include <cmath>
#include <string>

#include "check.hpp"
#include "tiltrotor/tiltrotor.h"

namespace {

tr_work work;

tr_sim aircraft(tr_real mast_deg) {
  tr_setup setup;
  tr_sim sim;
  CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), mast_deg), TR_OK);
  CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK);
  return sim;
}

double load_factor(tr_real mast_deg, double speed, double climb, double turn_rate) {
  tr_sim sim = aircraft(mast_deg);
  const tr_flight flight = {static_cast<tr_real>(speed), static_cast<tr_real>(climb),
                            static_cast<tr_real>(turn_rate), 0};
  tr_outputs outputs;
  (void)tr_trim(&sim, &work, &flight, nullptr);
  CHECK_EQ(tr_get_outputs(&sim, &outputs), TR_OK);
  return outputs.load_factor;
}

}  // namespace

TEST(capi_load_factor_is_that_of_the_flight_path) {
  const double tolerance = sizeof(tr_real) > 4 ? 1e-8 : 1e-3;
  for (const double speed : {0.0, 20.0, 40.0}) CHECK_NEAR(load_factor(0, speed, 0, 0), 1, tolerance);
  CHECK_NEAR(load_factor(60, 60, 0.15, 0), std::cos(0.15), tolerance);
  const double lateral = 90 * 0.12 / 9.80665;
  CHECK_NEAR(load_factor(90, 90, 0, 0.12), std::sqrt(1 + lateral * lateral), tolerance);
}

TEST(capi_trim_and_controls_have_one_range_of_gusts) {
  tr_sim sim = aircraft(30);
  tr_state state;
  CHECK_EQ(tr_get_state(&sim, &state), TR_OK);
  const tr_flight flight = {40, 0, 0, 0};
  for (int gust : {TR_GUST_U, TR_GUST_V, TR_GUST_W}) {
    for (const tr_real most : {tr_real(50), tr_real(-50)}) {
      tr_state given = state;
      given.u[gust] = most;
      CHECK_EQ(tr_set_controls(&sim, given.u, TR_CONTROLS), TR_OK);
      CHECK(tr_trim(&sim, &work, &flight, nullptr) != TR_OUT_OF_RANGE);
      given.u[gust] = most * tr_real(1.0001);
      CHECK_EQ(tr_set_controls(&sim, given.u, TR_CONTROLS), TR_OUT_OF_RANGE);
      // A stored control may be beyond its range; no trim holds it.
      CHECK_EQ(tr_set_state(&sim, &given), TR_OK);
      tr_trim_result result;
      CHECK_EQ(tr_trim(&sim, &work, &flight, &result), TR_OUT_OF_RANGE);
      CHECK(std::string(result.text).find("gust must be within 50 m/s") != std::string::npos);
    }
  }
}
