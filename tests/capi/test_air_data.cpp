// Air data at a station.
// Expected: the laws of the standard atmosphere and of compressible flow with powers of the C library, in long
// double; velocity triangles.
#include <cmath>

#include "capi/flying.hpp"

using namespace capi;

namespace {

constexpr bool kDouble = sizeof(tr_real) == 8;

tr_air_data air_of(const tr_sim& sim, const tr_real (&station)[3]) {
  tr_air_data air;
  CHECK_EQ(tr_air_data_at(&sim, station, &air), TR_OK);
  return air;
}

tr_sim flying_at(tr_real altitude, const tr_real (&velocity)[3], const tr_real (&gust)[3]) {
  tr_setup setup = setup_at(90);
  setup.altitude_m = altitude;
  tr_sim sim;
  CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK);
  tr_state s = state_of(sim);
  for (int k = 0; k < 3; ++k) s.x[TR_U + k] = velocity[k], s.u[TR_GUST_U + k] = gust[k];
  CHECK_EQ(tr_set_state(&sim, &s), TR_OK);
  return sim;
}

constexpr tr_real kNose[3] = {tr_real(1.5), 0, 2};

}  // namespace

TEST(capi_air_data_are_those_of_compressible_flow) {
  double worst = 0;
  for (const tr_real altitude : {tr_real(-500), tr_real(0), tr_real(3000), tr_real(11000)}) {
    // ISO 2533: pressure by the hydrostatic equation.
    const long double temperature = 288.15L - 0.0065L * static_cast<long double>(altitude);
    const long double pressure = 101325 * std::pow(temperature / 288.15L, 9.80665L / (287.05287L * 0.0065L));
    const long double sound = std::sqrt(1.4L * 287.05287L * temperature), sound_0 = 340.29399L;
    for (const tr_real speed :
         {tr_real(0.01), tr_real(0.5), tr_real(5), tr_real(60), tr_real(150), tr_real(290)}) {
      const tr_air_data air = air_of(flying_at(altitude, {speed, 0, 0}, {0, 0, 0}), kNose);
      const long double mach = static_cast<long double>(speed) / sound;
      const long double ratio = std::expm1(3.5L * std::log1p(0.2L * mach * mach));
      const long double impact = pressure * ratio;
      const long double back = std::expm1(std::log1p(impact / 101325) * (2.0L / 7));
      const long double calibrated = sound_0 * std::sqrt(5 * back);
      // The product's atmosphere rounds its exponent and constants to five digits: 2e-5 of the pressure.
      const double tolerance = 5e-5;
      CHECK_REL(air.static_pa, double(pressure), tolerance);
      CHECK_EQ(air.tas_mps, speed);
      CHECK_REL(air.mach, double(mach), tolerance);
      CHECK_REL(air.impact_pa, double(impact), 2 * tolerance);
      CHECK_REL(air.cas_mps, double(calibrated), tolerance);
      worst = std::max(worst, std::abs(double(air.cas_mps) / double(calibrated) - 1));
      // Of its own Mach number and static pressure: to rounding, however slow.
      const long double own = air.mach;
      CHECK_REL(
          air.impact_pa,
          double(static_cast<long double>(air.static_pa) * std::expm1(3.5L * std::log1p(0.2L * own * own))),
          kDouble ? 1e-14 : 1e-6);
    }
  }
  NOTE("calibrated airspeed within " << worst);
}

// At sea level both airspeeds are the same; higher up the calibrated one is less.
TEST(capi_air_data_at_sea_level_calibrated_is_true) {
  for (const tr_real speed : {tr_real(1e-3), tr_real(0.3), tr_real(20), tr_real(130), tr_real(300)}) {
    const tr_air_data low = air_of(flying_at(0, {speed, 0, 0}, {0, 0, 0}), kNose);
    CHECK_REL(low.cas_mps, low.tas_mps, kDouble ? 1e-14 : 1e-6);
    const tr_air_data high = air_of(flying_at(3000, {speed, 0, 0}, {0, 0, 0}), kNose);
    CHECK_LT(high.cas_mps, tr_real(0.9) * high.tas_mps);
  }
  const tr_air_data rest = air_of(flying_at(0, {0, 0, 0}, {0, 0, 0}), kNose);
  CHECK_EQ(rest.tas_mps, 0);
  CHECK_EQ(rest.cas_mps, 0);
  CHECK_EQ(rest.impact_pa, 0);
  CHECK_EQ(rest.alpha_rad, 0);
  CHECK_EQ(rest.beta_rad, 0);
}

TEST(capi_air_data_of_a_probe_on_a_turning_aircraft) {
  tr_sim sim = flying_at(1000, {80, 4, 6}, {5, -3, 2});
  tr_state s = state_of(sim);
  const double p = 0.3, q = -0.2, r = 0.4;
  s.x[TR_P] = tr_real(p), s.x[TR_Q] = tr_real(q), s.x[TR_R] = tr_real(r);
  CHECK_EQ(tr_set_state(&sim, &s), TR_OK);
  tr_mass mass;
  CHECK_EQ(tr_get_mass(&sim, &mass), TR_OK);
  // 4 m ahead of the CG, 5 m to the right, 1 m below.
  const tr_real probe[3] = {mass.cg_m[0] - 4, mass.cg_m[1] + 5, mass.cg_m[2] - 1};
  const tr_air_data air = air_of(sim, probe);
  const double u = 75 + q * 1 - r * 5, v = 7 + r * 4 - p * 1, w = 4 + p * 5 - q * 4;
  const double tolerance = kDouble ? 1e-14 : 2e-6;
  const double speed = std::sqrt(u * u + v * v + w * w);
  CHECK_REL(air.tas_mps, speed, 4 * tolerance);
  CHECK_NEAR(air.alpha_rad, std::atan2(w, u), tolerance);
  CHECK_NEAR(air.beta_rad, std::asin(v / speed), tolerance);
  // At the CG: what tr_get_outputs says.
  tr_outputs o;
  CHECK_EQ(tr_get_outputs(&sim, &o), TR_OK);
  const tr_air_data at_cg = air_of(sim, mass.cg_m);
  CHECK_EQ(at_cg.tas_mps, o.airspeed_mps);
  CHECK_EQ(at_cg.alpha_rad, o.angle_of_attack_rad);
  CHECK_EQ(at_cg.beta_rad, o.sideslip_rad);
}

TEST(capi_air_data_refuse) {
  const tr_sim sim = trimmed_sim(0, 20);
  tr_air_data air;
  std::memset(&air, 0x5a, sizeof air);
  const tr_air_data before = air;
  CHECK_EQ(tr_air_data_at(nullptr, kNose, &air), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_air_data_at(&sim, nullptr, &air), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_air_data_at(&sim, kNose, nullptr), TR_BAD_ARGUMENT);
  for (int k = 0; k < 3; ++k) {
    tr_real station[3] = {7, 0, 2};
    for (const tr_real bad : {kNan, kInfinity, -kInfinity}) {
      station[k] = bad;
      CHECK_EQ(tr_air_data_at(&sim, station, &air), TR_NOT_FINITE);
    }
    station[k] = tr_real(-1001);
    CHECK_EQ(tr_air_data_at(&sim, station, &air), TR_OUT_OF_RANGE);
  }
  tr_sim raw;
  std::memset(&raw, 0, sizeof raw);
  CHECK_EQ(tr_air_data_at(&raw, kNose, &air), TR_NOT_INITIALIZED);
  CHECK(same_bits(air, before));
}

// Velocity triangles: a gust at the wing, and air that turns about the CG.
TEST(capi_air_data_feel_the_gust_of_the_wing_and_air_that_turns) {
  tr_sim sim = flying_at(0, {100, 0, 3}, {1, 0, 0});
  tr_environment environment;
  CHECK_EQ(tr_default_environment(&environment), TR_OK);
  const tr_real gust[3] = {-15, 2, 4}, turning[3] = {tr_real(0.1), tr_real(-0.2), tr_real(0.3)};
  for (int k = 0; k < 3; ++k) {
    environment.gust_mps[TR_AT_WING][k] = gust[k];
    environment.gust_rates_radps[k] = turning[k];
  }
  CHECK_EQ(tr_set_environment(&sim, &environment), TR_OK);
  tr_mass mass;
  CHECK_EQ(tr_get_mass(&sim, &mass), TR_OK);
  const double x = 4, y = 5, z = 1;
  const tr_real probe[3] = {mass.cg_m[0] - tr_real(x), mass.cg_m[1] + tr_real(y), mass.cg_m[2] - tr_real(z)};
  const tr_air_data air = air_of(sim, probe);
  // 100 - 1 + 15, .. less the way of the air, turning x arm.
  const double u = 114 - (-0.2 * z - 0.3 * y), v = -2 - (0.3 * x - 0.1 * z), w = -1 - (0.1 * y + 0.2 * x);
  const double tolerance = kDouble ? 1e-13 : 2e-6;
  CHECK_REL(air.tas_mps, std::sqrt(u * u + v * v + w * w), tolerance);
  CHECK_NEAR(air.alpha_rad, std::atan2(w, u), tolerance);
}

// Its strength along the path is W20 itself, far above the ground a tenth of it and more: Dryden's model.
TEST(capi_air_data_feel_turbulence) {
  tr_sim sim = trimmed_sim(90, 90);
  tr_systems systems;
  CHECK_EQ(tr_get_systems(&sim, &systems), TR_OK);
  systems.turbulence = 1;
  systems.turbulence_w20_mps = 23;
  CHECK_EQ(tr_set_systems(&sim, &systems), TR_OK);
  const auto work = new_work();
  double squares = 0, mean = 0;
  const int steps = 2000;
  for (int k = 0; k < steps; ++k) {
    CHECK_EQ(tr_step(&sim, work.get(), tr_real(0.01)), TR_OK);
    const tr_state s = state_of(sim);
    const double still =
        std::sqrt(double(s.x[TR_U] * s.x[TR_U] + s.x[TR_V] * s.x[TR_V] + s.x[TR_W] * s.x[TR_W]));
    const double felt = double(air_of(sim, kNose).tas_mps) - still;
    mean += felt / steps;
    squares += felt * felt / steps;
  }
  const double spread = std::sqrt(squares - mean * mean);
  NOTE("spread " << spread << " m/s");
  CHECK_LT(0.8, spread);
  CHECK_LT(spread, 7);
}
