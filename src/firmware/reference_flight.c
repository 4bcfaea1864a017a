#include "firmware/reference_flight.h"

static const tr_real degree = (tr_real)0.017453292519943295;
static const tr_real frame_s = (tr_real)0.005;

static tr_sim sim;
static tr_work work;
enum { states = 23 }; /* of the linear model: coning is constant, systems are off */
static tr_real a[states * states];
static tr_real b[states * 4];
static tr_real eigenvalue_real[states], eigenvalue_imag[states];
static tr_linear_shape shape;

static int trim(text_sink write) {
  tr_setup setup;
  tr_trim_result result;
  tr_state state;
  tr_flight flight;
  flight.speed_mps = 40;
  flight.climb_rad = flight.turn_rate_radps = flight.sideslip_rad = 0;
  if (failed(write, "tr_default_setup", tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), 0)) ||
      failed(write, "tr_init", tr_init(&sim, TR_API_VERSION, &setup)) ||
      failed(write, "tr_trim", tr_trim(&sim, &work, &flight, &result)) ||
      failed(write, "tr_get_state", tr_get_state(&sim, &state)))
    return 1;
  write_count(write, "trim_iterations", (uint64_t)result.iterations);
  write_number(write, "trim_pitch_rad", (double)state.x[TR_PITCH]);
  write_number(write, "trim_collective_rad", (double)state.u[TR_COLLECTIVE]);
  write_number(write, "trim_long_stick_in", (double)state.u[TR_LONG_STICK]);
  return 0;
}

/* Collective up by one degree at 0.1 s; lateral stick to the right from 0.5 s, to the left from 1 s to 1.5 s. */
static tr_status move_controls(const tr_state* trimmed, int frame) {
  tr_real u[4];
  int j;
  for (j = 0; j < 4; ++j) u[j] = trimmed->u[j];
  if (frame >= 20) u[TR_COLLECTIVE] += degree;
  if (frame >= 100 && frame < 200) u[TR_LAT_STICK] += (tr_real)0.5;
  if (frame >= 200 && frame < 300) u[TR_LAT_STICK] -= (tr_real)0.5;
  return tr_set_controls(&sim, u, 4);
}

static void write_state(text_sink write, const tr_state* state) {
  write_number(write, "time_s", state->time_s);
  write_number(write, "u_mps", (double)state->x[TR_U]);
  write_number(write, "w_mps", (double)state->x[TR_W]);
  write_number(write, "q_radps", (double)state->x[TR_Q]);
  write_number(write, "p_radps", (double)state->x[TR_P]);
  write_number(write, "roll_rad", (double)state->x[TR_ROLL]);
  write_number(write, "pitch_rad", (double)state->x[TR_PITCH]);
  write_number(write, "down_m", (double)state->x[TR_DOWN]);
}

/* Into bytes and back; the hash of the bytes, which are the same on every machine. */
static int save_and_load(text_sink write, uint64_t* hash) {
  unsigned char* const bytes = (unsigned char*)a;
  size_t used, k;
  if (failed(write, "tr_save", tr_save(&sim, bytes, sizeof a, &used))) return 1;
  for (k = 0; k < used; ++k) {
    const tr_real byte = bytes[k];
    tr_hash(&byte, 1, hash);
  }
  return failed(write, "tr_load_saved", tr_load_saved(&sim, TR_API_VERSION, bytes, used));
}

int reference_flight(text_sink write, int frames) {
  uint64_t state_hash = TR_HASH_START;
  uint64_t model_hash = TR_HASH_START;
  uint64_t eigenvalue_hash = TR_HASH_START;
  uint64_t saved_hash = TR_HASH_START;
  const size_t room = sizeof a / sizeof a[0];
  tr_real fastest = 0;
  tr_real least_stable = -1000;
  tr_state trimmed, state;
  int frame;
  size_t n = 0;
  size_t i;

  write_precision(write);
  if (trim(write) || failed(write, "tr_get_state", tr_get_state(&sim, &trimmed))) return 1;
  for (frame = 0; frame < frames; ++frame) {
    if (failed(write, "tr_set_controls", move_controls(&trimmed, frame)) ||
        failed(write, "tr_linearize_and_step",
               tr_linearize_and_step(&sim, &work, frame_s, TR_INCEPTORS, &shape, a, room, b,
                                     sizeof b / sizeof b[0])))
      return 1;
    n = (size_t)shape.states;
    if (failed(write, "tr_eigenvalues", tr_eigenvalues(&work, a, n, eigenvalue_real, eigenvalue_imag, n)) ||
        failed(write, "tr_get_state", tr_get_state(&sim, &state)))
      return 1;
    tr_hash(state.x, TR_MAST, &state_hash);
    tr_hash(a, n * n, &model_hash);
    tr_hash(b, n * (size_t)shape.controls, &model_hash);
    tr_hash(eigenvalue_real, n, &eigenvalue_hash);
    tr_hash(eigenvalue_imag, n, &eigenvalue_hash);
    if ((frame + 1) % 100 == 0) write_state(write, &state);
    if (frame + 1 == frames / 2 && save_and_load(write, &saved_hash)) return 1;
  }
  for (i = 0; i < n; ++i) {
    if (eigenvalue_imag[i] > fastest) fastest = eigenvalue_imag[i];
    if (eigenvalue_real[i] > least_stable) least_stable = eigenvalue_real[i];
  }
  write_count(write, "frames", (uint64_t)frames);
  write_number(write, "fastest_mode_radps", (double)fastest);
  write_number(write, "least_stable_root_per_s", (double)least_stable);
  write_hash(write, "hash_states", state_hash);
  write_hash(write, "hash_a_b", model_hash);
  write_hash(write, "hash_eigenvalues", eigenvalue_hash);
  write_hash(write, "hash_saved", saved_hash);
  return 0;
}
