// The flight of a C program: trim, five seconds under moving controls, hash of the states.
#include <cstdio>

#include "tiltrotor/tiltrotor.h"

int main() {
  static tr_sim sim;
  static tr_work work;
  tr_setup setup;
  tr_flight flight = {};
  flight.speed_mps = 40;
  tr_state state;
  uint64_t hash = TR_HASH_START;
  if (tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), 30) != TR_OK) return 1;
  if (tr_init(&sim, TR_API_VERSION, &setup) != TR_OK) return 2;
  if (tr_trim(&sim, &work, &flight, nullptr) != TR_OK) return 3;
  if (tr_get_state(&sim, &state) != TR_OK) return 4;
  tr_real controls[TR_CONTROLS];
  for (int frame = 0; frame < 1000; ++frame) {
    for (int j = 0; j < TR_CONTROLS; ++j) controls[j] = state.u[j];
    controls[TR_LONG_STICK] += static_cast<tr_real>(frame % 100) / 200;
    if (tr_set_controls(&sim, controls, TR_CONTROLS) != TR_OK) return 5;
    if (tr_step(&sim, &work, static_cast<tr_real>(0.005)) != TR_OK) return 6;
  }
  if (tr_get_state(&sim, &state) != TR_OK) return 7;
  if (tr_hash(state.x, TR_STATES, &hash) != TR_OK) return 8;
  std::printf("%016llx\n", static_cast<unsigned long long>(hash));
  return 0;
}
