#include "firmware/vehicle_flight.h"

static const tr_real frame_s = (tr_real)0.005;
enum { between_models = 20 /* frames */, most_states = TR_MAX_LINEAR_STATES };

static tr_sim sim;
static tr_work work;
static tr_real a[most_states * most_states];
static tr_real b[most_states * 4];
static tr_real eigenvalue_real[most_states], eigenvalue_imag[most_states];

tr_status equip(tr_sim* on, tr_work* at, int governor, int mast_deg, int speed_mps, tr_systems* systems) {
  tr_setup setup;
  tr_environment air;
  tr_flight flight;
  tr_status status = tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), (tr_real)mast_deg);
  if (status == TR_OK) status = tr_init(on, TR_API_VERSION, &setup);
  if (status == TR_OK) status = tr_default_environment(&air);
  if (status != TR_OK) return status;
  air.wind_mps[0] = -4;
  air.wind_mps[1] = 3;
  air.altitude_origin_m = 100;
  air.ground_down_m = 30;
  status = tr_set_environment(on, &air);
  if (status == TR_OK) status = tr_get_systems(on, systems);
  if (status != TR_OK) return status;
  systems->governor = governor;
  systems->conversion = systems->engines = systems->actuators = systems->scas = 1;
  systems->gear = systems->ground_effect = systems->turbulence = systems->interconnect = 1;
  systems->turbulence_w20_mps = 5;
  systems->turbulence_seed = 7;
  status = tr_set_systems(on, systems);
  if (status != TR_OK) return status;
  flight.speed_mps = (tr_real)speed_mps;
  flight.climb_rad = flight.turn_rate_radps = flight.sideslip_rad = 0;
  status = tr_trim(on, at, &flight, NULL);
  return status == TR_OK ? tr_get_systems(on, systems) : status;
}

/* Masts forward from 0.1 s, nose down from 0.5 to 1 s, more power from 1 s; the gear comes up at 1.5 s. */
static tr_status command(const tr_state* trimmed, tr_systems* systems, int frame) {
  tr_real u[4];
  int j;
  for (j = 0; j < 4; ++j) u[j] = trimmed->u[j];
  if (frame >= 100 && frame < 200) u[TR_LONG_STICK] += (tr_real)0.5;
  if (frame == 20) systems->mast_command_deg = 30;
  if (frame == 200) systems->throttle[0] = systems->throttle[1] = (tr_real)0.8;
  if (frame == 300) systems->gear_down = 0;
  if (frame == 20 || frame == 200 || frame == 300) {
    const tr_status status = tr_set_systems(&sim, systems);
    if (status != TR_OK) return status;
  }
  return tr_set_controls(&sim, u, 4);
}

int vehicle_flight(text_sink write, int frames) {
  uint64_t state_hash = TR_HASH_START;
  uint64_t model_hash = TR_HASH_START;
  uint64_t eigenvalue_hash = TR_HASH_START;
  tr_linear_shape shape;
  tr_systems systems;
  tr_state trimmed, state;
  tr_real least_stable = -1000;
  size_t n = 0, i;
  int frame;
  if (failed(write, "equip", equip(&sim, &work, TR_GOVERNOR_PI, 0, 30, &systems)) ||
      failed(write, "tr_get_state", tr_get_state(&sim, &trimmed)))
    return 1;
  for (frame = 0; frame < frames; ++frame) {
    if (failed(write, "commands", command(&trimmed, &systems, frame))) return 1;
    if (frame % between_models == 0) {
      if (failed(write, "tr_linearize",
                 tr_linearize(&sim, &work, TR_INCEPTORS, &shape, a, sizeof a / sizeof a[0], b,
                              sizeof b / sizeof b[0])))
        return 1;
      n = (size_t)shape.states;
      if (failed(write, "tr_eigenvalues", tr_eigenvalues(&work, a, n, eigenvalue_real, eigenvalue_imag, n)))
        return 1;
      tr_hash(a, n * n, &model_hash);
      tr_hash(b, n * (size_t)shape.controls, &model_hash);
      tr_hash(eigenvalue_real, n, &eigenvalue_hash);
      tr_hash(eigenvalue_imag, n, &eigenvalue_hash);
    }
    if (failed(write, "tr_step", tr_step(&sim, &work, frame_s)) ||
        failed(write, "tr_get_state", tr_get_state(&sim, &state)))
      return 1;
    tr_hash(state.x, TR_STATES, &state_hash);
  }
  for (i = 0; i < n; ++i)
    if (eigenvalue_real[i] > least_stable) least_stable = eigenvalue_real[i];
  write_count(write, "vehicle_states", (uint64_t)n);
  write_number(write, "vehicle_u_mps", (double)state.x[TR_U]);
  write_number(write, "vehicle_pitch_rad", (double)state.x[TR_PITCH]);
  write_number(write, "vehicle_down_m", (double)state.x[TR_DOWN]);
  write_number(write, "vehicle_mast_rad", (double)state.x[TR_MAST]);
  write_number(write, "vehicle_rotor_radps", (double)state.x[TR_ROTOR_SPEED]);
  write_number(write, "vehicle_power_w", (double)(state.x[TR_POWER_RIGHT] + state.x[TR_POWER_LEFT]));
  write_number(write, "vehicle_least_stable_root_per_s", (double)least_stable);
  write_hash(write, "hash_vehicle_states", state_hash);
  write_hash(write, "hash_vehicle_a_b", model_hash);
  write_hash(write, "hash_vehicle_eigenvalues", eigenvalue_hash);
  return 0;
}
