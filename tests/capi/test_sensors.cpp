// Sensors: radio height, lags, and the instruments made of them. Place on the earth: test_geodetic.cpp.
// Expected: geometry and tr_motion_at; the solution of the first-order equation with the exponential of the C library in
// long double; compressible flow; the header's text.
#include "tiltrotor/sensors.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "capi/conditions.hpp"
#include "capi/same_aircraft.hpp"

using namespace capi;

namespace {

class Generator {
 public:
  explicit Generator(unsigned seed) : bits_(seed) {}
  double between(double low, double high) { return low + (high - low) * 0x1p-53 * double(bits_() >> 11); }

 private:
  std::mt19937_64 bits_;
};

constexpr bool kDouble = sizeof(tr_real) == 8;
constexpr double kRounding = kDouble ? 3e-14 : 1e-5;

tr_lag lag_of(double time_constant) {
  tr_lag lag = {};
  lag.time_constant_s = tr_real(time_constant);
  return lag;
}

tr_real radio_height(const tr_sim& sim, const tr_real* station) {
  tr_real height = kNan;
  CHECK_EQ(tr_radio_height_at(&sim, station, &height), TR_OK);
  return height;
}

// y' = (u - y)/T with u from u0 to u1 in a straight line.
template <class Y>
long double solution(tr_real T, Y y0, tr_real u0, tr_real u1, tr_real step) {
  using L = long double;
  const L slope = (static_cast<L>(u1) - static_cast<L>(u0)) / static_cast<L>(step);
  const L late = slope * static_cast<L>(T);
  return static_cast<L>(u1) - late +
         (static_cast<L>(y0) - static_cast<L>(u0) + late) *
             std::exp(-static_cast<L>(step) / static_cast<L>(T));
}

tr_sim over_ground(double down, double roll, double pitch) {
  tr_sim sim = sim_at(0);
  tr_environment air = calm();
  air.ground_down_m = tr_real(down);
  CHECK_EQ(tr_set_environment(&sim, &air), TR_OK);
  tr_state s = state_of(sim);
  s.x[TR_ROLL] = tr_real(roll), s.x[TR_PITCH] = tr_real(pitch), s.x[TR_YAW] = tr_real(2);
  set_state(sim, s);
  return sim;
}

}  // namespace

TEST(capi_radio_height_is_vertical_and_that_of_the_station) {
  const tr_real stations[3][3] = {{7, 0, 2}, {tr_real(1.5), 0, tr_real(1.2)}, {8, -5, 3}};
  const double attitudes[4][2] = {{0, 0}, {0.3, 0}, {0, -0.4}, {-0.5, 0.2}};
  for (const auto& [roll, pitch] : attitudes) {
    const tr_sim sim = over_ground(12.5, roll, pitch);
    tr_mass mass;
    CHECK_EQ(tr_get_mass(&sim, &mass), TR_OK);
    for (const auto& station : stations) {
      // Arm in body axes, and the third row of the rotation into the earth's.
      const double x = double(mass.cg_m[0] - station[0]), y = double(station[1]),
                   z = double(mass.cg_m[2] - station[2]);
      const double down = -std::sin(pitch) * x + std::cos(pitch) * (std::sin(roll) * y + std::cos(roll) * z);
      const tr_real height = radio_height(sim, station);
      CHECK_NEAR(height, 12.5 - down, 10 * kRounding);
      tr_motion motion;
      CHECK_EQ(tr_motion_at(&sim, station, &motion), TR_OK);
      CHECK_NEAR(height, 12.5 - double(motion.position_m[2]), 10 * kRounding);
    }
  }
  CHECK_EQ(radio_height(sim_at(0), stations[0]), kInfinity);  // no ground
  CHECK_EQ(radio_height(sim_at(0), nullptr), kInfinity);
}

// Wheels say themselves when they touch: the flag of a load on them, which begins a little above the ground since contact
// is smooth, within 2 cm.
TEST(capi_radio_height_of_the_wheels_is_nothing_where_they_touch) {
  const double attitudes[4][2] = {{0, 0}, {0.1, 0}, {-0.1, 0.05}, {0, -0.15}};
  for (const auto& [roll, pitch] : attitudes) {
    double low = 0, high = 10;  // of the ground below the CG
    tr_real touching = kNan;
    for (int k = 0; k < 24; ++k) {
      const double ground = 0.5 * (low + high);
      tr_sim sim = over_ground(ground, roll, pitch);
      tr_systems systems;
      CHECK_EQ(tr_default_systems(&systems), TR_OK);
      systems.gear = 1;
      CHECK_EQ(tr_set_systems(&sim, &systems), TR_OK);
      std::uint32_t flags = 0;
      CHECK_EQ(tr_get_flags(&sim, &flags), TR_OK);
      ((flags & TR_ON_GROUND) != 0 ? low : high) = ground;
      touching = radio_height(sim, nullptr);
    }
    CHECK_NEAR(touching, 0, 0.02);
  }
}

TEST(capi_lag_is_the_solution_whatever_the_step) {
  constexpr unsigned seed = 1127;
  NOTE("seed " << seed);
  Generator random(seed);
  double worst = 0;
  for (int n = 0; n < 200; ++n) {
    const double T = std::pow(10, random.between(-4, 1.5));
    tr_lag lag = lag_of(T);
    CHECK_EQ(tr_step_lag(&lag, tr_real(random.between(-5, 5)), tr_real(0.3)), TR_OK);
    CHECK_EQ(lag.reading, lag.input);  // begins at rest
    for (int k = 0; k < 20; ++k) {
      const tr_lag before = lag;
      const tr_real step = std::min(tr_real(T * std::pow(10, random.between(-4, 3))), tr_real(100));
      const tr_real input = tr_real(random.between(-5, 5));
      CHECK_EQ(tr_step_lag(&lag, input, step), TR_OK);
      const double expected =
          double(solution(before.time_constant_s, before.reading, before.input, input, step));
      worst = std::max(worst, std::abs(double(lag.reading) - expected));
      CHECK_NEAR(lag.reading, expected, kRounding);
      CHECK(lag.reading <= std::max({before.reading, before.input, input}) + tr_real(kRounding));
      CHECK(lag.reading >= std::min({before.reading, before.input, input}) - tr_real(kRounding));
      CHECK(lag.input == input && lag.begun == 1 && lag.time_constant_s == before.time_constant_s);
    }
  }
  NOTE("within " << worst << " of inputs up to 5");
  // A ramp is read late by the time constant, read often or seldom.
  for (const double step : {0.001, 0.05, 2.0}) {
    tr_lag lag = lag_of(0.25);
    for (int k = 0; k * step < 20; ++k)
      CHECK_EQ(tr_step_lag(&lag, tr_real(3 * k * step), tr_real(step)), TR_OK);
    CHECK_NEAR(double(lag.input) - double(lag.reading), 3 * 0.25, kDouble ? 1e-12 : 1e-4);
  }
  // None: the input itself; no time: nothing happens.
  for (const double none : {0.0, 1e-9}) {
    tr_lag lag = lag_of(none);
    for (const double input : {3.0, -7.5}) {
      CHECK_EQ(tr_step_lag(&lag, tr_real(input), tr_real(0.01)), TR_OK);
      CHECK_EQ(lag.reading, tr_real(input));
    }
  }
  tr_lag still = lag_of(0.1);
  CHECK_EQ(tr_step_lag(&still, 1, 0), TR_OK);
  CHECK_EQ(tr_step_lag(&still, 2, 0), TR_OK);
  CHECK(still.reading == 1 && still.input == 2);
}

TEST(capi_lag_refuses) {
  tr_lag good = lag_of(0.1);
  CHECK_EQ(tr_step_lag(&good, 1, tr_real(0.01)), TR_OK);
  CHECK_EQ(tr_step_lag(nullptr, 1, tr_real(0.01)), TR_BAD_ARGUMENT);
  const auto refused = [&good](auto&& change, tr_real input, tr_real step, tr_status status) {
    tr_lag lag = good;
    change(lag);
    const tr_lag before = lag;
    CHECK_EQ(tr_step_lag(&lag, input, step), status);
    CHECK(same_bits(lag, before));
  };
  const auto nothing = [](tr_lag&) {};
  for (const tr_real bad : {kNan, kInfinity, -kInfinity}) {
    refused(nothing, bad, tr_real(0.01), TR_NOT_FINITE);
    refused(nothing, 1, bad, TR_NOT_FINITE);
    refused([bad](tr_lag& l) { l.time_constant_s = bad; }, 1, tr_real(0.01), TR_NOT_FINITE);
    refused([bad](tr_lag& l) { l.reading = bad; }, 1, tr_real(0.01), TR_NOT_FINITE);
    refused([bad](tr_lag& l) { l.input = bad; }, 1, tr_real(0.01), TR_NOT_FINITE);
    tr_lag fresh = lag_of(0.1);  // what a lag that has not begun remembers does not matter
    fresh.reading = fresh.input = bad;
    CHECK_EQ(tr_step_lag(&fresh, 1, tr_real(0.01)), TR_OK);
    CHECK_EQ(fresh.reading, 1);
  }
  for (const tr_real far : {tr_real(-1e-3), tr_real(101)}) {
    refused(nothing, 1, far, TR_OUT_OF_RANGE);
    refused([far](tr_lag& l) { l.time_constant_s = far; }, 1, tr_real(0.01), TR_OUT_OF_RANGE);
  }
}

// Of a flight that moves: without lag tr_motion_at itself, with one the solution over its readings.
TEST(capi_imu_is_the_motion_through_its_lags) {
  const double accelerometer = 0.02, gyro = 0.005;
  const tr_real nose[3] = {tr_real(1.5), tr_real(0.4), tr_real(1.8)};
  tr_imu bare = {}, lagging = {};
  std::memcpy(bare.station_m, nose, sizeof nose);
  std::memcpy(lagging.station_m, nose, sizeof nose);
  for (int k = 0; k < 3; ++k) {
    lagging.specific_force_mps2[k].time_constant_s = tr_real(accelerometer);
    lagging.rates_radps[k].time_constant_s = tr_real(gyro);
  }
  Flight flight(trimmed_sim(30, 50));
  long double force[3] = {}, rate[3] = {};
  tr_motion before = {};
  double moved = 0;
  for (int k = 0; k < 60; ++k) {
    tr_motion now;
    CHECK_EQ(tr_motion_at(&flight.sim(), nose, &now), TR_OK);
    CHECK_EQ(tr_read_imu(&flight.sim(), &bare, dt), TR_OK);
    CHECK_EQ(tr_read_imu(&flight.sim(), &lagging, dt), TR_OK);
    for (int i = 0; i < 3; ++i) {
      const auto next = [k](double T, long double y, tr_real u0, tr_real u1) {
        return k == 0 ? static_cast<long double>(u1) : solution(tr_real(T), y, u0, u1, dt);
      };
      force[i] = next(accelerometer, force[i], before.specific_force_mps2[i], now.specific_force_mps2[i]);
      rate[i] = next(gyro, rate[i], before.rates_radps[i], now.rates_radps[i]);
      CHECK_EQ(bare.specific_force_mps2[i].reading, now.specific_force_mps2[i]);
      CHECK_EQ(bare.rates_radps[i].reading, now.rates_radps[i]);
      CHECK_NEAR(lagging.specific_force_mps2[i].reading, double(force[i]), 20 * kRounding);
      CHECK_NEAR(lagging.rates_radps[i].reading, double(rate[i]), kRounding);
      moved = std::max(moved, std::abs(double(now.specific_force_mps2[i]) - double(force[i])));
    }
    before = now;
    flight.step(k);
  }
  CHECK_LT(1e-3, moved);  // the lags did something
}

// Without lag tr_air_data_at; with one the airspeed that a slowed pressure shows, by powers in long double.
TEST(capi_air_probe_indicates_what_its_pressures_say) {
  tr_air_probe bare = {}, slow = {};
  bare.station_m[0] = slow.station_m[0] = tr_real(1.5);
  bare.station_m[2] = slow.station_m[2] = 2;
  slow.static_pa.time_constant_s = tr_real(0.5);
  slow.impact_pa.time_constant_s = tr_real(0.2);
  slow.alpha_rad.time_constant_s = slow.beta_rad.time_constant_s = tr_real(0.1);
  tr_sim sim = trimmed_sim(60, 70);
  const tr_sim start = sim;
  for (int k = 0; k < 5; ++k) {
    tr_state s = state_of(start);
    s.x[TR_U] += tr_real(3 * k);
    s.x[TR_W] += tr_real(k % 2);
    set_state(sim, s);
    tr_air_data air, indicated, late;
    const tr_air_probe before = slow;
    CHECK_EQ(tr_air_data_at(&sim, bare.station_m, &air), TR_OK);
    CHECK_EQ(tr_read_air_probe(&sim, &bare, tr_real(0.1), &indicated), TR_OK);
    CHECK_EQ(tr_read_air_probe(&sim, &slow, tr_real(0.1), &late), TR_OK);
    CHECK(indicated.static_pa == air.static_pa && indicated.impact_pa == air.impact_pa);
    CHECK(indicated.alpha_rad == air.alpha_rad && indicated.beta_rad == air.beta_rad);
    CHECK_REL(indicated.cas_mps, air.cas_mps, kRounding);
    CHECK_REL(indicated.tas_mps, air.tas_mps, kRounding);
    CHECK_REL(indicated.mach, air.mach, kRounding);
    if (k == 0) continue;
    const long double impact = solution(slow.impact_pa.time_constant_s, before.impact_pa.reading,
                                        before.impact_pa.input, air.impact_pa, tr_real(0.1));
    CHECK_REL(late.impact_pa, double(impact), 10 * kRounding);
    CHECK_NEAR(late.alpha_rad,
               double(solution(slow.alpha_rad.time_constant_s, before.alpha_rad.reading,
                               before.alpha_rad.input, air.alpha_rad, tr_real(0.1))),
               kRounding);
    const auto q = static_cast<long double>(late.impact_pa), p = static_cast<long double>(late.static_pa);
    const double cas = double(340.29399L * std::sqrt(5 * std::expm1(std::log1p(q / 101325) * 2 / 7)));
    const double mach = double(std::sqrt(5 * std::expm1(std::log1p(q / p) * 2 / 7)));
    CHECK_REL(late.cas_mps, cas, 5e-5);  // constants of the atmosphere to five digits
    CHECK_REL(late.mach, mach, kDouble ? 1e-13 : 1e-5);
    CHECK_REL(late.tas_mps, mach * double(air.tas_mps) / double(air.mach), kDouble ? 1e-13 : 1e-5);
    CHECK_LT(late.cas_mps, air.cas_mps);
  }
}

TEST(capi_sensors_refuse) {
  const tr_sim sim = trimmed_sim(0, 20);
  tr_sim raw;
  std::memset(&raw, 0, sizeof raw);
  tr_imu imu = {};
  tr_air_probe probe = {};
  imu.station_m[0] = probe.station_m[0] = 7;
  tr_air_data air = {};
  tr_real height = 7;
  CHECK_EQ(tr_radio_height_at(nullptr, imu.station_m, &height), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_radio_height_at(&sim, imu.station_m, nullptr), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_radio_height_at(&sim, nullptr, nullptr), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_radio_height_at(&raw, imu.station_m, &height), TR_NOT_INITIALIZED);
  CHECK_EQ(tr_read_imu(nullptr, &imu, dt), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_read_imu(&sim, nullptr, dt), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_read_imu(&raw, &imu, dt), TR_NOT_INITIALIZED);
  CHECK_EQ(tr_read_air_probe(nullptr, &probe, dt, &air), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_read_air_probe(&sim, nullptr, dt, &air), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_read_air_probe(&sim, &probe, dt, nullptr), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_read_air_probe(&raw, &probe, dt, &air), TR_NOT_INITIALIZED);
  const auto refused = [&](const tr_imu& bad_imu, const tr_air_probe& bad_probe, tr_real step,
                           tr_status status) {
    tr_imu i = bad_imu;
    tr_air_probe p = bad_probe;
    const tr_air_data before = air;
    CHECK_EQ(tr_read_imu(&sim, &i, step), status);
    CHECK_EQ(tr_read_air_probe(&sim, &p, step, &air), status);
    CHECK(same_bits(i, bad_imu) && same_bits(p, bad_probe) && same_bits(air, before));
  };
  refused(imu, probe, kNan, TR_NOT_FINITE);
  refused(imu, probe, -dt, TR_OUT_OF_RANGE);
  for (const tr_real bad : {kNan, kInfinity}) {
    tr_imu i = imu;
    tr_air_probe p = probe;
    i.station_m[1] = p.station_m[1] = bad;
    refused(i, p, dt, TR_NOT_FINITE);
    CHECK_EQ(tr_radio_height_at(&sim, i.station_m, &height), TR_NOT_FINITE);
    i = imu, p = probe;
    i.rates_radps[2].time_constant_s = p.beta_rad.time_constant_s = bad;  // the last of them: none has moved
    refused(i, p, dt, TR_NOT_FINITE);
  }
  tr_imu i = imu;
  tr_air_probe p = probe;
  i.station_m[2] = p.station_m[2] = 1001;
  refused(i, p, dt, TR_OUT_OF_RANGE);
  CHECK_EQ(tr_radio_height_at(&sim, i.station_m, &height), TR_OUT_OF_RANGE);
  i = imu, p = probe;
  i.rates_radps[2].time_constant_s = p.beta_rad.time_constant_s = -1;
  refused(i, p, dt, TR_OUT_OF_RANGE);
  // Pressures that no air has: of a struct that was not begun here.
  p = probe;
  for (tr_lag* lag : {&p.static_pa, &p.impact_pa}) lag->time_constant_s = 100, lag->begun = 1;
  p.static_pa.reading = p.static_pa.input = 0;
  p.impact_pa.reading = p.impact_pa.input = std::numeric_limits<tr_real>::max() / 4;
  const tr_air_probe before = p;
  CHECK(tr_read_air_probe(&sim, &p, dt, &air) != TR_OK && same_bits(p, before));
  CHECK_EQ(height, 7);
}
