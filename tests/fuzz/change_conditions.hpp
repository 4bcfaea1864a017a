// What a fuzzer does to masts, rotors, loading, air and loads of an aircraft of the C interface.
#pragma once

#include <cstring>

#include "fuzz/target.hpp"
#include "tiltrotor/tiltrotor.h"

namespace fuzz {

// Whatever is refused changes nothing, and is explained with its status.
inline void change_conditions(tr_sim& sim, Bytes& in) {
  const auto known = [](tr_status status) { return status >= TR_OK && status < TR_STATUS_COUNT; };
  const tr_sim before = sim;
  tr_configuration c{};
  const bool ready = tr_get_configuration(&sim, &c) == TR_OK;
  tr_real* const setting[] = {&c.mast_deg, &c.mast_rate_radps, &c.mast_acceleration_radps2,
                              &c.flap_deg, &c.rotor_radps,     &c.rotor_acceleration_radps2,
                              &c.mass_kg,  &c.cg_station_m,    &c.cg_waterline_m};
  for (int changes = in.below(4); changes > 0; --changes) *setting[in.below(9)] = in.number();
  const tr_status set = tr_set_configuration(&sim, &c);
  REQUIRE(known(set) && (ready || set == TR_NOT_INITIALIZED));
  char line[100];
  const tr_status possible = tr_check_configuration(&c, TR_API_VERSION, line, in.byte() % sizeof line);
  if (ready && possible != TR_OK) REQUIRE(set == possible);
  if (set != TR_OK) REQUIRE(std::memcmp(&sim, &before, sizeof sim) == 0);
  tr_environment e;
  REQUIRE(tr_default_environment(&e) == TR_OK);
  tr_real* const air[] = {&e.wind_mps[0],
                          &e.wind_mps[2],
                          &e.gust_mps[TR_AT_WING][1],
                          &e.gust_mps[TR_AT_LEFT_ROTOR][2],
                          &e.gust_rates_radps[0],
                          &e.altitude_origin_m,
                          &e.temperature_offset_k,
                          &e.pressure_ratio,
                          &e.ground_down_m};
  for (int changes = in.below(4); changes > 0; --changes) *air[in.below(9)] = in.number();
  const tr_status blows = tr_check_environment(&e, TR_API_VERSION, line, in.byte() % sizeof line);
  if (in.below(2) == 0) {
    const tr_status blown = tr_set_environment(&sim, &e);
    REQUIRE(known(blown) && (blows == TR_OK || blown == blows || blown == TR_NOT_INITIALIZED));
  }
  tr_load load{};
  load.station_m[0] = in.number();
  load.force_n[2] = in.number();
  REQUIRE(known(tr_set_loads(&sim, &load, in.below(2))));
}

}  // namespace fuzz
