#include "firmware/measure.h"
#include "firmware/vehicle_flight.h"

static tr_sim sim;
static tr_work work;
enum { most_states = TR_MAX_LINEAR_STATES };
static tr_real a[most_states * most_states];
static tr_real b[most_states * 4];
static tr_real eigenvalue_real[most_states], eigenvalue_imag[most_states];

typedef struct extremes {
  uint32_t least, most;
} extremes;

static void add(extremes* e, uint32_t count) {
  if (count < e->least) e->least = count;
  if (count > e->most) e->most = count;
}

static void write_extremes(text_sink write, const char* least_name, const char* most_name,
                           const extremes* e) {
  write_count(write, least_name, e->least);
  write_count(write, most_name, e->most);
}

/* Uniform in low..high; the 32-bit xorshift generator of Marsaglia (2003). */
static uint32_t random_bits = 2463534242u;
static tr_real random_between(tr_real low, tr_real high) {
  random_bits ^= random_bits << 13;
  random_bits ^= random_bits >> 17;
  random_bits ^= random_bits << 5;
  return low + (high - low) * ((tr_real)(random_bits >> 8) / (tr_real)16777216);
}

/* Speed, attitude, rates, flapping, inflow and controls at random, with a collective that fits the speed. */
static void random_state(tr_real mast_deg, tr_state* s) {
  const tr_real part = mast_deg / 90;
  int i, side;
  for (i = 0; i < TR_STATES; ++i) s->x[i] = 0;
  for (i = 0; i < TR_CONTROLS; ++i) s->u[i] = 0;
  s->x[TR_U] = random_between(30 * part, 45 + 85 * part);
  s->x[TR_V] = random_between(-8, 8);
  s->x[TR_W] = random_between(-8, 8);
  for (i = TR_P; i <= TR_R; ++i) s->x[i] = random_between((tr_real)-0.3, (tr_real)0.3);
  s->x[TR_ROLL] = random_between((tr_real)-0.5, (tr_real)0.5);
  s->x[TR_PITCH] = random_between((tr_real)-0.4, (tr_real)0.4);
  for (side = 0; side < 2; ++side) {
    tr_real* rotor = s->x + (side == 0 ? TR_ROTOR_RIGHT : TR_ROTOR_LEFT);
    for (i = 0; i < 2; ++i) rotor[i] = random_between((tr_real)-0.06, (tr_real)0.06);
    for (i = 2; i < 4; ++i) rotor[i] = random_between((tr_real)-0.3, (tr_real)0.3);
    rotor[4] = random_between((tr_real)0.01, (tr_real)0.08);
    for (i = 5; i < 7; ++i) rotor[i] = random_between((tr_real)-0.02, (tr_real)0.02);
  }
  s->x[TR_DOWNWASH] = random_between((tr_real)-0.05, (tr_real)0.15);
  s->u[TR_COLLECTIVE] = part * s->x[TR_U] / 160 + random_between((tr_real)0.08, (tr_real)0.2);
  s->u[TR_LONG_STICK] = random_between(-3, 3);
  s->u[TR_LAT_STICK] = random_between(-2, 2);
  s->u[TR_PEDAL] = random_between(-1, 1);
}

static tr_status init(tr_real mast_deg) {
  tr_setup setup;
  const tr_status status = tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), mast_deg);
  return status != TR_OK ? status : tr_init(&sim, TR_API_VERSION, &setup);
}

static int measure_flight(text_sink write, instruction_counter count, int states) {
  static const int masts[] = {0, 30, 60, 90};
  const size_t room = sizeof a / sizeof a[0];
  const extremes none = {0xffffffffu, 0};
  extremes derivative = none, step = none, jacobian = none, eigenvalues = none, frame = none;
  extremes exponential_frame = none, slow_frame = none;
  tr_real rates[TR_STATES];
  tr_linear_shape shape;
  tr_state state;
  int k, failures = 0;
  if (init(0) != TR_OK || tr_get_state(&sim, &state) != TR_OK) return 1;
  for (k = 0; k < states; ++k) {
    const int place = (int)((int64_t)k * 4 / states);
    const tr_real mast = (tr_real)masts[place];
    uint32_t t[8];
    if (k == 0 || place != (int)((int64_t)(k - 1) * 4 / states)) failures += init(mast) != TR_OK;
    random_state(mast, &state);
    failures += tr_set_state(&sim, &state) != TR_OK;
    t[0] = count();
    failures += tr_derivative(&sim, rates, TR_STATES) != TR_OK;
    t[1] = count();
    failures += tr_step(&sim, &work, (tr_real)0.005) != TR_OK;
    t[2] = count();
    failures += tr_linearize(&sim, &work, TR_INCEPTORS, &shape, a, room, b, sizeof b / sizeof b[0]) != TR_OK;
    t[3] = count();
    failures +=
        tr_eigenvalues(&work, a, (size_t)shape.states, eigenvalue_real, eigenvalue_imag, room) != TR_OK;
    t[4] = count();
    failures += tr_linearize_and_step(&sim, &work, (tr_real)0.005, TR_INCEPTORS, &shape, a, room, b,
                                      sizeof b / sizeof b[0]) != TR_OK;
    failures +=
        tr_eigenvalues(&work, a, (size_t)shape.states, eigenvalue_real, eigenvalue_imag, room) != TR_OK;
    t[5] = count();
    failures += tr_linearize_and_step_exponential(&sim, &work, (tr_real)0.005, NULL, TR_INCEPTORS, &shape, a,
                                                  room, b, sizeof b / sizeof b[0]) != TR_OK;
    t[6] = count();
    failures +=
        tr_eigenvalues(&work, a, (size_t)shape.states, eigenvalue_real, eigenvalue_imag, room) != TR_OK;
    t[7] = count();
    add(&exponential_frame, t[7] - t[5]);
    failures += tr_rigid_model(&work, &shape, a, room, NULL, 0, &shape, a, room, NULL, 0) != TR_OK;
    failures +=
        tr_eigenvalues(&work, a, (size_t)shape.states, eigenvalue_real, eigenvalue_imag, room) != TR_OK;
    add(&slow_frame, t[6] - t[5] + (count() - t[7]));
    add(&derivative, t[1] - t[0]);
    add(&step, t[2] - t[1]);
    add(&jacobian, t[3] - t[2]);
    add(&eigenvalues, t[4] - t[3]);
    add(&frame, t[5] - t[4]);
  }
  write_count(write, "states", (uint64_t)states);
  write_extremes(write, "derivative_min", "derivative_max", &derivative);
  write_extremes(write, "step_min", "step_max", &step);
  write_extremes(write, "jacobian_min", "jacobian_max", &jacobian);
  write_extremes(write, "eigenvalues_min", "eigenvalues_max", &eigenvalues);
  write_extremes(write, "frame_min", "frame_max", &frame);
  write_extremes(write, "exponential_frame_min", "exponential_frame_max", &exponential_frame);
  write_extremes(write, "slow_frame_min", "slow_frame_max", &slow_frame);
  if (failures > 0) write_count(write, "failed calls", (uint64_t)failures);
  return failures > 0;
}

static int measure_trim(text_sink write, instruction_counter count) {
  static const int mast_deg[] = {0, 0, 0, 30, 60, 90};
  static const int speed_mps[] = {0, 20, 40, 40, 60, 100};
  extremes whole = {0xffffffffu, 0};
  extremes newton_step = {0xffffffffu, 0};
  int k, failures = 0;
  for (k = 0; k < 6; ++k) {
    tr_flight flight;
    tr_trim_result result;
    uint32_t start;
    flight.speed_mps = (tr_real)speed_mps[k];
    flight.climb_rad = flight.turn_rate_radps = flight.sideslip_rad = 0;
    failures += init((tr_real)mast_deg[k]) != TR_OK;
    start = count();
    failures += tr_trim(&sim, &work, &flight, &result) != TR_OK;
    start = count() - start;
    if (result.iterations < 1) continue;
    add(&whole, start);
    add(&newton_step, start / (uint32_t)result.iterations);
  }
  write_extremes(write, "trim_min", "trim_max", &whole);
  write_extremes(write, "trim_iteration_min", "trim_iteration_max", &newton_step);
  if (failures > 0) write_count(write, "failed trims", (uint64_t)failures);
  return failures > 0;
}

/* Every system on, in flight from a trim, the stick moved at every step. */
static int measure_systems(text_sink write, instruction_counter count, int states) {
  static const int mast_deg[] = {0, 30, 60, 90};
  static const int speed_mps[] = {20, 40, 60, 100};
  const extremes none = {0xffffffffu, 0};
  extremes step[3] = {none, none, none}, linear[3] = {none, none, none}, frame[3] = {none, none, none},
           set = none, trim = none, roots = none, slow = none;
  const size_t room = sizeof a / sizeof a[0];
  int governor, place, k, failures = 0;
  for (governor = TR_GOVERNOR_OFF; governor <= TR_GOVERNOR_PI; ++governor) {
    for (place = 0; place < 4; ++place) {
      tr_systems systems;
      tr_linear_shape shape;
      tr_state state;
      uint32_t start = count();
      failures += equip(&sim, &work, governor, mast_deg[place], speed_mps[place], &systems) != TR_OK;
      add(&trim, count() - start);
      start = count();
      failures += tr_set_systems(&sim, &systems) != TR_OK;
      add(&set, count() - start);
      failures += tr_get_state(&sim, &state) != TR_OK;
      for (k = 0; k < states / 12; ++k) {
        tr_real u[TR_CONTROLS];
        int j;
        for (j = 0; j < TR_CONTROLS; ++j) u[j] = state.u[j];
        u[TR_LONG_STICK] += random_between((tr_real)-0.3, (tr_real)0.3);
        u[TR_LAT_STICK] += random_between((tr_real)-0.3, (tr_real)0.3);
        failures += tr_set_controls(&sim, u, TR_CONTROLS) != TR_OK;
        start = count();
        failures += tr_step(&sim, &work, (tr_real)0.005) != TR_OK;
        add(&step[governor], count() - start);
        if (k % 8 != 0) continue;
        start = count();
        failures +=
            tr_linearize(&sim, &work, TR_INCEPTORS, &shape, a, room, b, sizeof b / sizeof b[0]) != TR_OK;
        add(&linear[governor], count() - start);
        start = count();
        failures += tr_eigenvalues(&work, a, (size_t)shape.states, eigenvalue_real, eigenvalue_imag,
                                   most_states) != TR_OK;
        add(&roots, count() - start);
        start = count();
        failures += tr_rigid_model(&work, &shape, a, room, NULL, 0, &shape, a, room, NULL, 0) != TR_OK;
        failures += tr_eigenvalues(&work, a, (size_t)shape.states, eigenvalue_real, eigenvalue_imag,
                                   most_states) != TR_OK;
        add(&slow, count() - start);
        start = count();
        failures += tr_linearize_and_step(&sim, &work, (tr_real)0.005, TR_INCEPTORS, &shape, a, room, b,
                                          sizeof b / sizeof b[0]) != TR_OK;
        failures += tr_rigid_model(&work, &shape, a, room, NULL, 0, &shape, a, room, NULL, 0) != TR_OK;
        failures += tr_eigenvalues(&work, a, (size_t)shape.states, eigenvalue_real, eigenvalue_imag,
                                   most_states) != TR_OK;
        add(&frame[governor], count() - start);
      }
    }
  }
  write_extremes(write, "set_systems_min", "set_systems_max", &set);
  write_extremes(write, "trim_with_systems_min", "trim_with_systems_max", &trim);
  write_extremes(write, "step_with_systems_min", "step_with_systems_max", &step[TR_GOVERNOR_OFF]);
  write_extremes(write, "step_with_ideal_governor_min", "step_with_ideal_governor_max",
                 &step[TR_GOVERNOR_IDEAL]);
  write_extremes(write, "step_with_pi_governor_min", "step_with_pi_governor_max", &step[TR_GOVERNOR_PI]);
  write_extremes(write, "jacobian_with_systems_min", "jacobian_with_systems_max", &linear[TR_GOVERNOR_OFF]);
  write_extremes(write, "jacobian_with_ideal_governor_min", "jacobian_with_ideal_governor_max",
                 &linear[TR_GOVERNOR_IDEAL]);
  write_extremes(write, "jacobian_with_pi_governor_min", "jacobian_with_pi_governor_max",
                 &linear[TR_GOVERNOR_PI]);
  write_extremes(write, "eigenvalues_with_systems_min", "eigenvalues_with_systems_max", &roots);
  write_extremes(write, "rigid_roots_with_systems_min", "rigid_roots_with_systems_max", &slow);
  write_extremes(write, "rigid_frame_with_systems_min", "rigid_frame_with_systems_max",
                 &frame[TR_GOVERNOR_OFF]);
  write_extremes(write, "rigid_frame_with_pi_governor_min", "rigid_frame_with_pi_governor_max",
                 &frame[TR_GOVERNOR_PI]);
  if (failures > 0) write_count(write, "failed calls with systems", (uint64_t)failures);
  return failures > 0;
}

static void write_sizes(text_sink write) {
  write_count(write, "sizeof_tr_sim", sizeof(tr_sim));
  write_count(write, "sizeof_tr_work", sizeof(tr_work));
  write_count(write, "used_of_tr_sim", tr_sim_size());
  write_count(write, "used_of_tr_work", tr_work_size());
  write_count(write, "sizeof_tr_setup", sizeof(tr_setup));
  write_count(write, "sizeof_tr_state", sizeof(tr_state));
  write_count(write, "sizeof_tr_outputs", sizeof(tr_outputs));
  write_count(write, "sizeof_tr_flight", sizeof(tr_flight));
  write_count(write, "sizeof_tr_trim_result", sizeof(tr_trim_result));
  write_count(write, "sizeof_tr_linear_shape", sizeof(tr_linear_shape));
  write_count(write, "sizeof_tr_mode", sizeof(tr_mode));
}

int measure(text_sink write, instruction_counter count, int states) {
  int flight_failed, systems_failed;
  write_sizes(write);
  flight_failed = measure_flight(write, count, states);
  systems_failed = measure_systems(write, count, states);
  return measure_trim(write, count) || flight_failed || systems_failed;
}
