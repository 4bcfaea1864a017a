// Any sensors of the C interface, read from an aircraft.
#pragma once

#include <cmath>

#include "fuzz/target.hpp"
#include "tiltrotor/sensors.h"

// Lags that remember anything, places anywhere. What is read is a number; NaN is refused.
inline void read_sensors(const tr_sim& sim, fuzz::Bytes& in) {
  const auto number = [&in] { return static_cast<tr_real>(in.number()); };
  const auto lag = [&] { return tr_lag{number(), number(), number(), in.below(3)}; };
  tr_imu imu = {};
  tr_air_probe probe = {};
  for (int k = 0; k < 3; ++k) imu.station_m[k] = probe.station_m[k] = number();
  for (int changes = in.below(3); changes > 0; --changes) {
    imu.rates_radps[in.below(3)] = imu.specific_force_mps2[in.below(3)] = lag();
    probe.static_pa = probe.impact_pa = lag();
    probe.beta_rad = lag();
  }
  const tr_real wait = number();
  if (tr_read_imu(&sim, &imu, wait) == TR_OK)
    for (int k = 0; k < 3; ++k)
      REQUIRE(std::isfinite(imu.specific_force_mps2[k].reading) && std::isfinite(imu.rates_radps[k].reading));
  tr_air_data air;
  if (tr_read_air_probe(&sim, &probe, wait, &air) == TR_OK)
    REQUIRE(std::isfinite(air.mach) && std::isfinite(air.tas_mps) && std::isfinite(air.cas_mps));
  tr_lag one = lag();
  if (tr_step_lag(&one, number(), number()) == TR_OK) REQUIRE(std::isfinite(one.reading));
  tr_real height = 0;
  if (tr_radio_height_at(&sim, in.below(2) == 0 ? nullptr : imu.station_m, &height) == TR_OK)
    REQUIRE(!std::isnan(height));
  tr_real wheels[3], slopes[3], direction[TR_STATES] = {};
  direction[in.below(TR_STATES)] = number();
  if (tr_wheel_heights(&sim, direction, wheels, slopes) == TR_OK)
    for (int k = 0; k < 3; ++k) REQUIRE(!std::isnan(wheels[k]) && std::isfinite(slopes[k]));
  const tr_geodetic origin = {in.number(), in.number(), in.number()};
  const double position[3] = {in.number(), in.number(), in.number()};
  tr_geodetic place;
  if (tr_geodetic_at(&origin, position, &place) == TR_OK)
    REQUIRE(std::fabs(place.latitude_rad) <= 1.5707963267948967 &&
            std::fabs(place.longitude_rad) <= 3.1415926535897932 && std::isfinite(place.height_m));
}
