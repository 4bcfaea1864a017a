// Heights of the wheels. Expected: the third row of the rotation, with arms from the published stations of the gear; slopes by
// differences of order 2; radio height, which is the least of them.
#include <algorithm>
#include <cmath>

#include "capi/conditions.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/sensors.h"

using namespace capi;

namespace {

constexpr bool kDouble = sizeof(tr_real) == 8;

// Masts and engines on, so that the CG moves with two states.
tr_sim flight_over_ground(double roll, double pitch) {
  tr_sim sim = sim_at(30);
  tr_environment air = calm();
  air.ground_down_m = tr_real(12.5);
  CHECK_EQ(tr_set_environment(&sim, &air), TR_OK);
  tr_systems systems = systems_of(sim);
  systems.conversion = systems.engines = systems.gear = 1;
  CHECK_EQ(tr_set_systems(&sim, &systems), TR_OK);
  tr_state s = state_of(sim);
  s.x[TR_ROLL] = tr_real(roll), s.x[TR_PITCH] = tr_real(pitch), s.x[TR_YAW] = tr_real(2);
  s.x[TR_FUEL] = 100;
  set_state(sim, s);
  return sim;
}

constexpr double kAttitudes[][2] = {{0, 0}, {0.3, 0}, {0, -0.4}, {-0.5, 0.2}};

}  // namespace

TEST(capi_wheel_heights_are_those_of_their_lowest_points) {
  const tiltrotor::GearTables<double>& gear = tiltrotor::aircraft_data<double>().gear;
  // Below the ground line by what oleo and tyre give at rest.
  const auto waterline = [&gear](const tiltrotor::StrutTables<double>& strut) {
    const double oleo = gear.static_stroke * strut.stroke;
    return gear.ground_wl - oleo - oleo * strut.oleo_stiffness / strut.tyre_stiffness;
  };
  const double stations[3][3] = {{gear.nose.sl, 0, waterline(gear.nose)},
                                 {gear.main.sl, gear.main.bl, waterline(gear.main)},
                                 {gear.main.sl, -gear.main.bl, waterline(gear.main)}};
  for (const auto& [roll, pitch] : kAttitudes) {
    const tr_sim sim = flight_over_ground(roll, pitch);
    tr_mass mass;
    CHECK_EQ(tr_get_mass(&sim, &mass), TR_OK);
    tr_real height[3];
    CHECK_EQ(tr_wheel_heights(&sim, nullptr, height, nullptr), TR_OK);
    for (int k = 0; k < 3; ++k) {
      const double* const at = stations[k];
      const double x = double(mass.cg_m[0]) - at[0], y = at[1], z = double(mass.cg_m[2]) - at[2];
      const double down = -std::sin(pitch) * x + std::cos(pitch) * (std::sin(roll) * y + std::cos(roll) * z);
      CHECK_NEAR(height[k], 12.5 - down, kDouble ? 1e-12 : 1e-5);
    }
    tr_real least = 0;
    CHECK_EQ(tr_radio_height_at(&sim, nullptr, &least), TR_OK);
    CHECK_EQ(least, *std::min_element(height, height + 3));
  }
}

// In floats a difference is worth little: there the slopes are those in doubles, which are tested here.
TEST(capi_wheel_heights_have_exact_slopes) {
  if (!kDouble) return;
  int moving = 0;
  for (const auto& [roll, pitch] : kAttitudes)
    for (int i = 0; i < TR_STATES; ++i) {
      tr_sim sim = flight_over_ground(roll, pitch);
      const tr_state here = state_of(sim);
      const tr_real size = i == TR_FUEL ? 10 : tr_real(1e-4);
      tr_real direction[TR_STATES] = {}, height[3], slope[3], found[2][3];
      direction[i] = 2;
      CHECK_EQ(tr_wheel_heights(&sim, direction, height, slope), TR_OK);
      for (const int way : {0, 1}) {
        tr_state beside = here;
        beside.x[i] += way == 0 ? size : -size;
        if (beside.x[i] < 0 && i == TR_GEAR) beside.x[i] = 0;
        if (beside.x[i] > 1 && i == TR_GEAR) beside.x[i] = 1;
        set_state(sim, beside);
        CHECK_EQ(tr_wheel_heights(&sim, nullptr, found[way], nullptr), TR_OK);
      }
      for (int k = 0; k < 3; ++k) {
        CHECK_NEAR(slope[k], (found[0][k] - found[1][k]) / size, i == TR_FUEL ? 1e-8 : 1e-7);
        if (slope[k] != 0) ++moving;
      }
    }
  CHECK_LE(4 * 3 * 4, moving);  // down, bank or pitch, mast, fuel
}

TEST(capi_wheel_heights_refuse) {
  tr_sim sim = flight_over_ground(0, 0);
  tr_real direction[TR_STATES] = {}, height[3], slope[3];
  CHECK_EQ(tr_wheel_heights(nullptr, direction, height, slope), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_wheel_heights(&sim, direction, nullptr, slope), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_wheel_heights(&sim, direction, height, nullptr), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_wheel_heights(&sim, nullptr, height, slope), TR_BAD_ARGUMENT);
  direction[TR_PITCH] = kNan;
  CHECK_EQ(tr_wheel_heights(&sim, direction, height, slope), TR_NOT_FINITE);
  sim = sim_at(0);
  CHECK_EQ(tr_wheel_heights(&sim, nullptr, height, nullptr), TR_OK);
  for (const tr_real each : height) CHECK_EQ(each, kInfinity);  // no ground
  tr_sim raw = {};
  CHECK_EQ(tr_wheel_heights(&raw, nullptr, height, nullptr), TR_NOT_INITIALIZED);
}
