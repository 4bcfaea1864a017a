// What is exceeded, and controls that are held at their stops.
// Expected: the ranges of tiltrotor.h, ratings of the aircraft against tr_outputs, statuses of tr_trim, velocity
// triangles.
#include <cmath>

#include "capi/flying.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/setup/atmosphere.hpp"

using namespace capi;

namespace {

std::uint32_t flags_of(const tr_sim& sim) {
  std::uint32_t flags = 0x5a5a5a5a;
  CHECK_EQ(tr_get_flags(&sim, &flags), TR_OK);
  return flags;
}

template <class Change>
tr_sim changed(tr_sim sim, Change&& change) {
  tr_state state = state_of(sim);
  change(state);
  CHECK_EQ(tr_set_state(&sim, &state), TR_OK);
  return sim;
}

constexpr tr_real kLimits[TR_CONTROLS] = {
    tr_real(1.4), tr_real(4.8), tr_real(4.8), tr_real(2.5), tr_real(0.5), tr_real(0.5), tr_real(0.5),
    tr_real(0.5), tr_real(0.5), tr_real(0.5), tr_real(0.5), 50,           50,           50};

}  // namespace

TEST_OF_XV15(capi_saturated_controls_stop_at_the_ends_of_their_ranges) {
  const tr_sim begin = trimmed_sim(0, 20);
  for (std::size_t j = 0; j < TR_CONTROLS; ++j) {
    for (const bool up : {false, true}) {
      const tr_real end = up ? kLimits[j] : j == TR_COLLECTIVE ? tr_real(-0.35) : -kLimits[j];
      tr_real u[TR_CONTROLS];
      for (std::size_t k = 0; k < TR_CONTROLS; ++k) u[k] = tr_real(0.01) * tr_real(k);
      tr_sim set = begin, held = begin;
      u[j] = end * tr_real(1.0625);
      std::uint32_t clipped = 0;
      CHECK_EQ(tr_saturate_controls(&held, u, TR_CONTROLS, &clipped), TR_OK);
      CHECK_EQ(clipped, std::uint32_t{1} << j);
      u[j] = end;
      CHECK_EQ(tr_set_controls(&set, u, TR_CONTROLS), TR_OK);
      CHECK(same_bits(set, held));
      CHECK_EQ(tr_saturate_controls(&held, u, TR_CONTROLS, &clipped),
               TR_OK);  // at the end: nothing is clipped
      CHECK_EQ(clipped, 0);
      CHECK(same_bits(set, held));
    }
  }
}

TEST(capi_saturated_controls_are_those_given) {
  tr_sim sim = trimmed_sim(0, 20);
  const tr_state before = state_of(sim);
  const tr_real u[2] = {tr_real(-1e30), tr_real(1e30)};
  std::uint32_t clipped = 0;
  CHECK_EQ(tr_saturate_controls(&sim, u, 2, &clipped), TR_OK);
  CHECK_EQ(clipped, 3);
  const tr_state after = state_of(sim);
  for (int j = 2; j < TR_CONTROLS; ++j) CHECK_EQ(after.u[j], before.u[j]);
  CHECK_LT(after.u[TR_COLLECTIVE], before.u[TR_COLLECTIVE]);
  CHECK_LT(before.u[TR_LONG_STICK], after.u[TR_LONG_STICK]);

  clipped = 77;
  for (const tr_real bad : {kNan, kInfinity, -kInfinity}) {
    const tr_real wrong[3] = {0, 99, bad};
    CHECK_EQ(tr_saturate_controls(&sim, wrong, 3, &clipped), TR_NOT_FINITE);
  }
  CHECK_EQ(tr_saturate_controls(&sim, u, 0, &clipped), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_saturate_controls(&sim, u, TR_CONTROLS + 1, &clipped), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_saturate_controls(&sim, nullptr, 2, &clipped), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_saturate_controls(&sim, u, 2, nullptr), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_saturate_controls(nullptr, u, 2, &clipped), TR_BAD_ARGUMENT);
  tr_sim raw;
  std::memset(&raw, 0, sizeof raw);
  CHECK_EQ(tr_saturate_controls(&raw, u, 2, &clipped), TR_NOT_INITIALIZED);
  CHECK_EQ(clipped, 77);
  CHECK(same_bits(state_of(sim), after));
}

TEST_OF_XV15(capi_flags_of_ordinary_flight_are_none) {
  for (const tr_real mast : {tr_real(0), tr_real(30), tr_real(90)})
    CHECK_EQ(flags_of(trimmed_sim(mast, mast < 90 ? tr_real(40) : tr_real(90))), 0);
  CHECK_EQ(flags_of(trimmed_sim(0, 0)), 0);
}

TEST_OF_XV15(capi_flags_name_controls_at_their_stops) {
  const tr_sim begin = trimmed_sim(0, 40);
  for (int j = 0; j < TR_GUST_U; ++j) {
    const auto with = [&](tr_real part) {
      return flags_of(changed(begin, [&](tr_state& s) { s.u[j] = part * kLimits[j]; })) & TR_SATURATED;
    };
    CHECK_EQ(with(1), TR_SATURATED);
    CHECK_EQ(with(2), TR_SATURATED);
    CHECK_EQ(with(-1), TR_SATURATED);  // of the collective -1.4, beyond -0.35
    if (j != TR_ELEVATOR && j != TR_AILERON && j != TR_RUDDER && j != TR_LONG_STICK && j != TR_LAT_STICK)
      CHECK_EQ(with(tr_real(0.2)), 0);
  }
  CHECK_EQ(flags_of(changed(begin, [](tr_state& s) { s.u[TR_GUST_V] = 50; })) & TR_SATURATED, 0);
  // Each within its range, the surface beyond its stop of 20 deg.
  const auto together = [](tr_state& s) {
    s.u[TR_LONG_STICK] = 4;
    s.u[TR_ELEVATOR] = tr_real(0.2);  // 11.5 deg on the 16.7 of the stick
  };
  CHECK_EQ(flags_of(changed(begin, together)) & TR_SATURATED, TR_SATURATED);
  CHECK_EQ(flags_of(changed(begin, [](tr_state& s) { s.u[TR_LONG_STICK] = 4; })) & TR_SATURATED, 0);
}

TEST_OF_XV15(capi_flags_name_a_gimbal_at_its_stop) {
  const tr_sim begin = trimmed_sim(0, 20);
  const tr_real degree = tr_real(0.0174532925199433);
  for (const int rotor : {TR_ROTOR_RIGHT, TR_ROTOR_LEFT}) {
    const auto tilted = [&](tr_real degrees) {
      return flags_of(changed(begin,
                              [&](tr_state& s) {
                                s.x[rotor + TR_B1C] = tr_real(0.6) * degrees * degree;
                                s.x[rotor + TR_B1S] = tr_real(-0.8) * degrees * degree;
                              })) &
             TR_AT_GIMBAL_STOP;
    };
    CHECK_EQ(tilted(tr_real(11.9)), 0);
    CHECK_EQ(tilted(tr_real(12.1)), TR_AT_GIMBAL_STOP);
  }
}

// Against the outputs: more collective until a rating is passed.
TEST_OF_XV15(capi_flags_name_power_and_torque_beyond_the_ratings) {
  const tiltrotor::ControlTables<tr_real>& t = tiltrotor::aircraft_data<tr_real>().controls;
  const tr_real absorbed = tr_real(t.engines) * t.engine_power * (1 - t.transmission_efficiency);
  int over_power = 0, over_torque = 0, within = 0;
  for (const tr_real altitude : {tr_real(0), tr_real(2000)}) {
    tr_setup setup = setup_at(0);
    setup.altitude_m = altitude;
    tr_sim sim;
    CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK);
    const auto work = new_work();
    const tr_flight flight = {20, 0, 0, 0};
    CHECK_EQ(tr_trim(&sim, work.get(), &flight, nullptr), TR_OK);
    // Pressure over the square root of temperature, as choice engine_lapse says.
    const auto here = tiltrotor::standard_air(double(altitude)), sea = tiltrotor::standard_air(0.0);
    const double lapse = here.density * here.temperature / (sea.density * sea.temperature) /
                         std::sqrt(here.temperature / sea.temperature);
    const double available = t.engines * double(t.engine_power) * double(t.transmission_efficiency) *
                             (1 + double(t.engine_lapse) * (lapse - 1));
    for (int k = -12; k < 24; ++k) {
      const tr_sim now = changed(sim, [&](tr_state& s) { s.u[TR_COLLECTIVE] += tr_real(0.01) * tr_real(k); });
      tr_outputs o;
      CHECK_EQ(tr_get_outputs(&now, &o), TR_OK);
      const double power = double(o.power_w[0]) + double(o.power_w[1]);
      const bool power_beyond = power > available || power < -double(absorbed);
      const bool torque_beyond =
          std::fabs(o.torque_nm[0]) > t.mast_torque || std::fabs(o.torque_nm[1]) > t.mast_torque;
      const std::uint32_t flags = flags_of(now);
      CHECK_EQ((flags & TR_OVER_POWER) != 0, power_beyond);
      CHECK_EQ((flags & TR_OVER_TORQUE) != 0, torque_beyond);
      over_power += power_beyond;
      over_torque += torque_beyond;
      within += !power_beyond && !torque_beyond;
    }
  }
  NOTE("beyond power " << over_power << ", torque " << over_torque << ", within both " << within);
  CHECK(over_power > 2 && over_torque > 2 && within > 10);
  // Rotors that drive the engines.
  const tr_sim windmill =
      changed(trimmed_sim(90, 90), [](tr_state& s) { s.u[TR_COLLECTIVE] -= tr_real(0.06); });
  tr_outputs o;
  CHECK_EQ(tr_get_outputs(&windmill, &o), TR_OK);
  CHECK_LT(o.power_w[0] + o.power_w[1], -absorbed);
  CHECK_EQ(flags_of(windmill) & TR_OVER_POWER, TR_OVER_POWER);
}

// A trim that names a limit has its flag, one without any has none of them.
TEST_OF_XV15(capi_flags_agree_with_the_trim) {
  int seen[TR_STATUS_COUNT] = {};
  const auto work = new_work();
  for (int k = 0; k < 60; ++k) {
    const tr_real mast = tr_real(k % 4 * 30);
    tr_sim sim = sim_at(mast);
    const tr_flight flight = {tr_real(k % 10) * tr_real(12),
                              tr_real(k % 7 - 3) * (k % 10 ? tr_real(0.15) : 0), 0,
                              k % 10 ? tr_real(k % 3 - 1) * tr_real(0.2) : 0};
    const tr_status status = tr_trim(&sim, work.get(), &flight, nullptr);
    ++seen[status];
    const std::uint32_t any = TR_AT_GIMBAL_STOP | TR_OVER_POWER | TR_OVER_TORQUE | TR_VORTEX_RING;
    if (status == TR_OK) CHECK_EQ(flags_of(sim) & (any | TR_SATURATED), 0);
    const struct {
      tr_status status;
      std::uint32_t flag;
    } named[] = {{TR_CONTROL_LIMIT, TR_SATURATED},
                 {TR_FLAP_LIMIT, TR_AT_GIMBAL_STOP},
                 {TR_VORTEX_RING_STATE, TR_VORTEX_RING},
                 {TR_POWER_LIMIT, TR_OVER_POWER},
                 {TR_TORQUE_LIMIT, TR_OVER_TORQUE}};
    for (const auto& name : named)
      if (status == name.status) CHECK_EQ(flags_of(sim) & name.flag, name.flag);
  }
  CHECK(seen[TR_OK] > 5 && seen[TR_POWER_LIMIT] > 0 && seen[TR_CONTROL_LIMIT] > 0);
  NOTE("ok " << seen[TR_OK] << ", controls " << seen[TR_CONTROL_LIMIT] << ", vortex ring "
             << seen[TR_VORTEX_RING_STATE] << ", power " << seen[TR_POWER_LIMIT] << ", torque "
             << seen[TR_TORQUE_LIMIT]);
}

// Sinking from hover at a part of the hover's induced speed: vortex ring from 0.45 on (NASA/TP-2005-213477).
TEST_OF_XV15(capi_flags_name_vortex_ring) {
  const tr_sim hover = trimmed_sim(0, 0);
  tr_outputs o;
  CHECK_EQ(tr_get_outputs(&hover, &o), TR_OK);
  const double disk = 3.14159265358979 * 3.81 * 3.81;
  const double induced = std::sqrt(double(o.thrust_n[0]) / (2 * 1.225 * disk));
  const auto sinking = [&](double part) {
    // Thrust changes with the descent: collective falls with it, to stay near.
    return flags_of(changed(hover, [&](tr_state& s) { s.x[TR_W] = tr_real(part * induced); })) &
           TR_VORTEX_RING;
  };
  CHECK_EQ(sinking(0), 0);
  CHECK_EQ(sinking(0.2), 0);
  CHECK_EQ(sinking(0.9), TR_VORTEX_RING);
}

TEST_OF_XV15(capi_flags_name_the_edge_of_the_tables) {
  const tr_sim airplane = trimmed_sim(90, 90);
  const auto edge = [&](auto&& change) { return flags_of(changed(airplane, change)) & TR_TABLE_EDGE; };
  const double sound = std::sqrt(1.4 * 287.053 * 288.15);
  // Advancing tip in airplane mode: the helix of 206 m/s and the flight, 0.85 at 202 m/s; the flight itself 0.6.
  CHECK_EQ(edge([&](tr_state& s) { s.x[TR_U] = tr_real(0.58 * sound); }), 0);
  CHECK_EQ(edge([&](tr_state& s) { s.x[TR_U] = tr_real(0.61 * sound); }), TR_TABLE_EDGE);
  CHECK_EQ(edge([&](tr_state& s) { s.x[TR_U] = 150, s.u[TR_GUST_U] = tr_real(-0.61 * sound + 150); }),
           TR_TABLE_EDGE);
  const auto at_alpha = [&](double degrees) {
    return edge([&](tr_state& s) {
      s.x[TR_U] = tr_real(90 * std::cos(degrees / 57.2957795));
      s.x[TR_W] = tr_real(90 * std::sin(degrees / 57.2957795));
    });
  };
  CHECK_EQ(at_alpha(27.9), 0);
  CHECK_EQ(at_alpha(28.1), TR_TABLE_EDGE);
  CHECK_EQ(at_alpha(-9.9), 0);
  CHECK_EQ(at_alpha(-10.1), TR_TABLE_EDGE);
  const auto at_beta = [&](double degrees) {
    return edge([&](tr_state& s) {
      s.x[TR_U] = tr_real(60 * std::cos(degrees / 57.2957795));
      s.x[TR_V] = tr_real(60 * std::sin(degrees / 57.2957795));
      s.x[TR_W] = 0;
    });
  };
  CHECK_EQ(at_beta(50), 0);
  CHECK_EQ(at_beta(52.5), TR_TABLE_EDGE);
  CHECK_EQ(at_beta(-52.5), TR_TABLE_EDGE);
  CHECK_EQ(edge([](tr_state& s) { s.u[TR_RUDDER] = tr_real(0.36); }), TR_TABLE_EDGE);
  CHECK_EQ(edge([](tr_state& s) { s.u[TR_ELEVATOR] = tr_real(-0.45); }), TR_TABLE_EDGE);
  // In the hover angles say nothing, and the advancing tip, 0.66 Mach, is reached by 64 m/s from the side.
  const tr_sim hover = trimmed_sim(0, 0);
  CHECK_EQ(flags_of(changed(hover, [](tr_state& s) { s.x[TR_V] = 8; })) & TR_TABLE_EDGE, 0);
  const auto sideways = [&](double tip) {
    const double turning = double(setup_at(0).rotor_radps) * 3.81;
    return flags_of(changed(hover, [&](tr_state& s) { s.x[TR_U] = tr_real(tip * sound - turning); })) &
           TR_TABLE_EDGE;
  };
  CHECK_EQ(sideways(0.845), 0);
  CHECK_EQ(sideways(0.86), TR_TABLE_EDGE);
}

TEST(capi_flags_refuse) {
  const tr_sim sim = trimmed_sim(0, 20);
  std::uint32_t flags = 77;
  CHECK_EQ(tr_get_flags(nullptr, &flags), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_get_flags(&sim, nullptr), TR_BAD_ARGUMENT);
  tr_sim raw;
  std::memset(&raw, 0xff, sizeof raw);
  CHECK_EQ(tr_get_flags(&raw, &flags), TR_NOT_INITIALIZED);
  CHECK_EQ(flags, 77);
}
