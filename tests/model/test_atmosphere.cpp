// Air against the printed tables of the International Standard Atmosphere (ISO 2533, geopotential altitude)
// and the sea-level values of the printed GTRS runs.
#include "tiltrotor/model/setup/atmosphere.hpp"

#include "check.hpp"

using namespace tiltrotor;

TEST(atmosphere_standard_tables) {
  struct Row {
    double altitude, density, sound;
  };
  // Density kg/m^3, speed of sound m/s.
  for (const Row& row :
       {Row{0, 1.22500, 340.294}, Row{1000, 1.11164, 336.434}, Row{2000, 1.00649, 332.529},
        Row{5000, 0.736116, 320.529}, Row{8000, 0.525168, 308.063}, Row{11000, 0.363918, 295.070}}) {
    const Air<double> air = standard_air(row.altitude);
    CHECK_REL(air.density, row.density, 1e-4);
    CHECK_REL(air.speed_of_sound, row.sound, 1e-5);
  }
}

TEST(atmosphere_sea_level_of_the_printed_runs) {
  const Air<double> air = standard_air(0.0);
  const double slug_per_cubic_foot = 14.593903 / (0.3048 * 0.3048 * 0.3048);
  CHECK_REL(air.density / slug_per_cubic_foot, 0.0023769, 2e-5);
  CHECK_REL(air.speed_of_sound / 0.3048, 1116.45, 1e-5);
}

// Hydrostatic balance dp = -rho g dh with p = rho R T, by finite differences: exponent and lapse rate belong
// together.
TEST(atmosphere_is_hydrostatic) {
  const auto pressure = [](double h) {
    const Air<double> air = standard_air(h);
    return air.density * air.speed_of_sound * air.speed_of_sound / 1.4;  // a^2 = gamma p / rho
  };
  for (double h = -400; h < 11000; h += 900) {
    const double slope = (pressure(h + 1) - pressure(h - 1)) / 2;
    CHECK_REL(slope, -standard_air(h).density * 9.80665, 1e-4);
  }
}

TEST(atmosphere_float) {
  CHECK_REL(standard_air(2500.0f).density, standard_air(2500.0).density, 1e-6);
  CHECK_REL(standard_air(2500.0f).speed_of_sound, standard_air(2500.0).speed_of_sound, 1e-6);
}
