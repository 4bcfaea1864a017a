// Any systems for an aircraft of the C interface.
#pragma once

#include <cstring>

#include "fuzz/target.hpp"
#include "tiltrotor/tiltrotor.h"

// Switches, commands and failures of the systems.
inline void change_systems(tr_sim& sim, fuzz::Bytes& in) {
  const tr_sim before = sim;
  tr_systems s{};
  REQUIRE(tr_default_systems(&s) == TR_OK);
  const bool ready = tr_get_systems(&sim, &s) == TR_OK;
  std::int32_t* const choice[] = {
      &s.governor,  &s.conversion,       &s.engines,         &s.actuators,    &s.scas,
      &s.gear,      &s.ground_effect,    &s.turbulence,      &s.interconnect, &s.wind_shear,
      &s.gear_down, &s.engine_failed[0], &s.engine_failed[1]};
  tr_real* const command[] = {&s.mast_command_deg, &s.flap_command_deg, &s.rotor_command_radps,
                              &s.throttle[0],      &s.throttle[1],      &s.turbulence_w20_mps,
                              &s.brake[0]};
  for (int changes = in.below(6); changes > 0; --changes) *choice[in.below(13)] = in.below(4) - 1;
  for (int changes = in.below(3); changes > 0; --changes) *command[in.below(7)] = in.number();
  s.turbulence_seed = in.raw<std::uint32_t>();
  const tr_status set = tr_set_systems(&sim, &s);
  REQUIRE(set >= TR_OK && set < TR_STATUS_COUNT && (ready || set == TR_NOT_INITIALIZED));
  char line[100];
  const tr_status possible = tr_check_systems(&s, TR_API_VERSION, line, in.byte() % sizeof line);
  if (ready && possible != TR_OK) REQUIRE(set == possible);
  if (set == TR_NOT_INITIALIZED) REQUIRE(std::memcmp(&sim, &before, sizeof sim) == 0);
}
