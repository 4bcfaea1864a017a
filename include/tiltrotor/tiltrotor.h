/* tiltrotor: flight dynamics of a tilt-rotor aircraft, as a C library.
 *
 *   static tr_sim sim;        the aircraft: configuration, state, controls; a copy of it is a snapshot,
 *                             tr_save writes one that any machine reads
 *   static tr_work work;      scratch of the calls that name it; nothing in it outlives a call
 *   tr_setup setup;
 *   tr_default_setup(&setup, TR_API_VERSION, TR_XV15, 0.0);
 *   tr_init(&sim, TR_API_VERSION, &setup);
 *   tr_flight flight = {40.0, 0.0, 0.0, 0.0};
 *   tr_trim(&sim, &work, &flight, NULL);
 *   for (;;) tr_step(&sim, &work, 0.005);
 *
 * Memory: the caller owns all of it. No function allocates, keeps a pointer, does input or output, or writes
 * a global variable; two aircraft never disturb each other. Threads may run at once on different tr_sim with
 * different tr_work. One tr_work serves any number of aircraft that take turns.
 *
 * Errors: every function that can fail returns a tr_status. When it is not TR_OK, outputs are untouched
 * unless the function says otherwise, and the aircraft is as it was but for tr_last_fault. Null pointers,
 * NaN, infinities, short arrays, numbers out of range, a wrong version and an aircraft that is not
 * initialised are all found and reported; so is a processor set to another rounding mode than to nearest or to
 * take the smallest numbers for zero, by every call that computes (TR_BAD_ARITHMETIC). Nothing else writes a tr_sim.
 *
 * Units: SI and radians unless the name says otherwise. Body axes x forward, y right, z down; attitude 3-2-1
 * Euler. Right rotor first.
 *
 * Air that moves: velocity (TR_U..TR_W) of the state is relative to the undisturbed air, which the wind of
 * tr_environment carries over the ground; position is over the ground. TR_GUST_U..TR_GUST_W is the velocity of
 * the air at the aircraft relative to the undisturbed air: a gust.
 * What blades, wing and instruments feel is relative to the air at the aircraft: velocity minus gust. So
 * airspeed, angle of attack and sideslip of tr_outputs, and speed, climb and sideslip of tr_flight; climb
 * rate is that of the state.
 *
 * Costs are worst cases, in evaluations of the equations of motion ("derivatives") and of their Jacobian. A
 * derivative is constant work: the same for every state but for the branches of table searches.
 *
 * Define TR_SINGLE_PRECISION to use a library built with PRECISION=single: tr_real is then float. */
#ifndef TILTROTOR_TILTROTOR_H
#define TILTROTOR_TILTROTOR_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

/* Less is enough on a microcontroller. */
#if defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M'
#define TR_DOUBLE_WORK_SIZE 86528
#define TR_SINGLE_WORK_SIZE 44800
#else
#define TR_DOUBLE_WORK_SIZE 245760
#define TR_SINGLE_WORK_SIZE 135168
#endif

#ifdef TR_SINGLE_PRECISION
typedef float tr_real;
#define TR_API_VERSION 0x00070004u
#define TR_SIM_SIZE 3968
#define TR_WORK_SIZE TR_SINGLE_WORK_SIZE
#else
typedef double tr_real;
/* Changes when a program must be compiled again: interface in the upper half, bytes of a tr_real in the
 * lower. */
#define TR_API_VERSION 0x00070008u
#define TR_SIM_SIZE 7424 /* bytes */
#define TR_WORK_SIZE TR_DOUBLE_WORK_SIZE
#endif

/* Names for the linker: a program of one precision finds nothing in a library of the other, and the functions
 * that are not told the version find it in their name. dlsym() finds the plain names, in a library of single
 * precision with _single behind them. */
#define TR_PASTED(name, version) name##_##version
#define TR_WITH(name, version) TR_PASTED(name, version)
#define TR_OF_VERSION(name) TR_WITH(name, TR_API_VERSION)
#define tr_eigenvalues TR_OF_VERSION(tr_eigenvalues)
#define tr_modes TR_OF_VERSION(tr_modes)
#define tr_hash TR_OF_VERSION(tr_hash)
#ifdef TR_SINGLE_PRECISION
#include "tiltrotor/single_precision_names.h"
#endif

typedef enum tr_status {
  TR_OK,
  TR_NOT_CONVERGED,     /* the iteration reached its limit before its tolerance */
  TR_SINGULAR,          /* a matrix that must be inverted is singular */
  TR_NOT_FINITE,        /* NaN or infinity in an input, or arisen in the computation */
  TR_OUT_OF_RANGE,      /* an input, or the state after a step, is outside the range of the model */
  TR_BAD_ARGUMENT,      /* a null pointer, an unknown choice or an impossible size */
  TR_SHORT_BUFFER,      /* an array is too short for the result */
  TR_WRONG_VERSION,     /* the program was compiled for another version or precision of the library */
  TR_NOT_INITIALIZED,   /* tr_init has not succeeded on this tr_sim */
  TR_WING_STALL,        /* trimmed, but the wing is past its stall */
  TR_CONTROL_LIMIT,     /* trimmed, but a control is beyond its stop */
  TR_FLAP_LIMIT,        /* trimmed, but a gimbal is beyond its stop */
  TR_ROTOR_STALL,       /* no trim: the rotors stall before the weight is carried */
  TR_DAMAGED,           /* not the bytes of tr_save, or changed since */
  TR_BAD_ARITHMETIC,    /* the processor does not round to nearest, flushes to zero, or lacks instructions */
  TR_VORTEX_RING_STATE, /* trimmed, but a rotor descends in its own wake: the mean of an unsteady flow */
  TR_POWER_LIMIT,       /* trimmed, but the rotors need more than take-off power, or drive the engines */
  TR_TORQUE_LIMIT,      /* trimmed, but a mast carries more than its largest steady torque */
  TR_STATUS_COUNT
} tr_status;

/* ---- the aircraft ---- */

/* Opaque. Plain memory without addresses: may be copied, moved, stored, and read back by the same program. */
typedef struct tr_sim {
  uint64_t reserved[TR_SIM_SIZE / 8];
} tr_sim;
typedef struct tr_work {
  uint64_t reserved[TR_WORK_SIZE / 8];
} tr_work;

/* Aircraft with tables in this project; a library holds those it was made with (tr_aircraft_at). Numbers from
 * 1000 on are for aircraft of your own. */
typedef enum tr_aircraft {
  TR_XV15 = 1,
  TR_SCALED_XV15 = 2 /* four blades, 0.8 times the size; flies at 8866 m as the XV-15 at sea level */
} tr_aircraft;
typedef enum tr_grid {
  TR_GRID_REALTIME = 1,     /* fewest blade stations that keep the accuracy of the finer grid */
  TR_GRID_SPECIFICATION = 2 /* 20 radial by 24 azimuth stations a rotor */
} tr_grid;
typedef enum tr_tables {
  TR_TABLES_SMOOTH = 1, /* continuous slopes; along mast and flap linear */
  TR_TABLES_LINEAR = 2  /* the tables' own linear interpolation */
} tr_tables;

/* What a flight begins with. tr_default_setup fills it; change fields afterwards. Ranges are the
 * aircraft's, here those of the XV-15; tr_check_setup says them. */
typedef struct tr_setup {
  int32_t aircraft;      /* tr_aircraft */
  int32_t grid;          /* tr_grid; default TR_GRID_REALTIME */
  int32_t tables;        /* tr_tables; default TR_TABLES_SMOOTH */
  int32_t coning_states; /* 0: coning is constant (default); 1: two more states a rotor */
  tr_real mast_deg;      /* 0 helicopter .. 90 airplane */
  tr_real flap_deg;      /* 0..75; default 40, 20 or 0 by mast angle */
  tr_real altitude_m;    /* of the air's density, ISA, -500..11000; default 0 */
  tr_real mass_kg;       /* 3000..10000; default 13000 lbf */
  tr_real rotor_radps;   /* rotor speed, 20..80; default by mast angle */
  tr_real cg_station_m;  /* station of the centre of gravity at mast 0, 7..8; default 301.2 in */
} tr_setup;

/* States in the order of tr_state.x. Inflow over tip speed; flapping and inflow in each rotor's mirrored
 * frame. */
enum {
  TR_U,
  TR_V,
  TR_W, /* m/s */
  TR_P,
  TR_Q,
  TR_R, /* rad/s */
  TR_ROLL,
  TR_PITCH,
  TR_YAW,               /* rad */
  TR_ROTOR_RIGHT = 9,   /* b1c b1s (rad), their rates (rad/s), n0 nc ns */
  TR_ROTOR_LEFT = 16,   /* the same */
  TR_DOWNWASH = 23,     /* at the tail, rad */
  TR_CONING_RIGHT = 24, /* angle (rad), rate (rad/s) */
  TR_CONING_LEFT = 26,
  TR_NORTH = 28,
  TR_EAST,
  TR_DOWN, /* position over the ground, m: the wind of tr_environment carries along */
  TR_MAST, /* from here on those of systems.h, 0 while theirs are off */
  TR_STATES = 75
};

/* After TR_ROTOR_RIGHT and TR_ROTOR_LEFT: x[TR_ROTOR_LEFT + TR_MEAN_INFLOW]. */
enum { TR_B1C, TR_B1S, TR_B1C_RATE, TR_B1S_RATE, TR_MEAN_INFLOW, TR_COSINE_INFLOW, TR_SINE_INFLOW };

/* Controls in the order of tr_state.u, with the ranges tr_set_controls accepts. */
enum {
  TR_COLLECTIVE, /* mean blade pitch at 0.75 radius, rad, -0.35..1.4 */
  TR_LONG_STICK,
  TR_LAT_STICK,   /* in from neutral, + forward and right, within 4.8 */
  TR_PEDAL,       /* in from neutral, + right, within 2.5 */
  TR_LONG_CYCLIC, /* increments on blades and surfaces, rad, within 0.5: */
  TR_DIFF_COLLECTIVE,
  TR_DIFF_LONG_CYCLIC,
  TR_ELEVATOR,
  TR_AILERON,
  TR_RUDDER,
  TR_LATERAL_CYCLIC,
  TR_GUST_U,
  TR_GUST_V,
  TR_GUST_W,        /* velocity of the air at the aircraft, body axes, m/s, within 50 */
  TR_CONTROLS = 14, /* the commands of systems.h follow in linear models, up to: */
  TR_INPUTS = 19
};

/* The state of a flight: restoring it replays bit for bit, what conditions.h and systems.h change being as it was
 * (also whether a SCAS fades out: tr_save holds all of it). */
typedef struct tr_state {
  double time_s;
  uint64_t steps; /* done so far */
  tr_real x[TR_STATES];
  tr_real u[TR_CONTROLS];
  /* What adds up, in double precision whatever tr_real is. x holds the same, rounded. */
  double roll_rad, yaw_rad, position_m[3];
} tr_state;

/* The defaults for a tr_aircraft and a mast angle, 0..90 deg. TR_WRONG_VERSION, TR_BAD_ARGUMENT, TR_OUT_OF_RANGE. */
tr_status tr_default_setup(tr_setup* setup, uint32_t version, int32_t aircraft, tr_real mast_deg);

/* What tr_init would say of `setup`, and which field it refuses, in one line: "mass 2000 kg lies outside
 * 3000..10000 kg". `text` holds `length` characters (100 are enough) and is always terminated; it may be NULL
 * with length 0, and stays empty with other statuses than TR_OUT_OF_RANGE. TR_WRONG_VERSION, TR_BAD_ARGUMENT,
 * TR_OUT_OF_RANGE. Cost: a few comparisons. */
tr_status tr_check_setup(const tr_setup* setup, uint32_t version, char* text, size_t length);

/* The aircraft in this library: a tr_aircraft for place 0, 1, ..., 0 beyond the last. */
int32_t tr_aircraft_at(int32_t place);
/* "XV-15", and a line about it. Never NULL; "unknown" and "" for others. */
const char* tr_aircraft_name(int32_t aircraft);
const char* tr_aircraft_description(int32_t aircraft);

/* Makes an aircraft at rest: all states and controls zero, time zero. `version` is TR_API_VERSION.
 * With TR_WRONG_VERSION `sim` is untouched; with TR_BAD_ARGUMENT and TR_OUT_OF_RANGE it is not initialised.
 * Cost: some 40 derivatives, once. */
tr_status tr_init(tr_sim* sim, uint32_t version, const tr_setup* setup);

/* Bytes really used: at most TR_SIM_SIZE and TR_WORK_SIZE. */
size_t tr_sim_size(void);
size_t tr_work_size(void);

/* ---- flying ---- */

/* Sets the first `length` controls (1..TR_CONTROLS), in force from the next step; the others keep their value. One bad
 * number and none is set. TR_NOT_FINITE, TR_OUT_OF_RANGE, TR_BAD_ARGUMENT. Cost: a few comparisons. */
tr_status tr_set_controls(tr_sim* sim, const tr_real* controls, size_t length);

/* One step of 0 < dt <= 0.02 s, controls held, by a Runge-Kutta method: of order 3 up to 0.01 s, of order 4
 * beyond. Where dt is too long for the fastest modes (inflow, the faster the more air passes the disk; gimbal
 * tilt, twice the rotor speed) the step is made of equal parts, so that every dt is stable at every rotor
 * speed, up to 200 m/s in any direction. TR_OUT_OF_RANGE (dt, or the flight has diverged), TR_NOT_FINITE: the
 * aircraft stays where it was.
 * Cost: 3 derivatives a part, beyond 0.01 s 4. Parts in flights that tr_trim accepts: 1 up to 0.005 s, at
 * most 2 beyond; at most 45 in any state (300 m/s with an inflow of six tip speeds). */
tr_status tr_step(tr_sim* sim, tr_work* work, tr_real dt);

/* Snapshot and restore. tr_set_state accepts finite states of |velocity| <= 300 m/s, |rates| <= 20 rad/s,
 * |roll| <= 1000 rad, |pitch| <= 89.9999 deg, |yaw| <= 1e6 rad, |angles and inflow| <= 2, |their rates| <= 200
 * rad/s, |position| <= 1e9 m, |controls| <= 100, time 0..1e9 s, steps <= 1e15; no step leads beyond.
 * roll_rad, yaw_rad and position_m count where they round to their numbers in x; elsewhere x counts.
 * TR_NOT_FINITE, TR_OUT_OF_RANGE. Cost: a copy; with air that follows the altitude, a twentieth of a derivative. */
tr_status tr_get_state(const tr_sim* sim, tr_state* state);
tr_status tr_set_state(tr_sim* sim, const tr_state* state);

/* The whole aircraft in bytes, for files and other machines: no addresses, fixed byte order, format, version
 * and precision, the tables, a checksum. `used` is the size, at most TR_SAVED_SIZE, and filled with
 * TR_SHORT_BUFFER too. Cost: a copy. */
#define TR_SAVED_SIZE 2048 /* bytes */
tr_status tr_save(const tr_sim* sim, void* bytes, size_t length, size_t* used);

/* Makes the aircraft that was saved; it flies on bit for bit. `sim` need not be initialised, and is untouched
 * unless TR_OK; `length` may be more than was used. TR_SHORT_BUFFER (cut off), TR_DAMAGED, TR_WRONG_VERSION
 * (`version`, or bytes of another version, precision, library or aircraft's tables), TR_BAD_ARGUMENT,
 * TR_NOT_FINITE and TR_OUT_OF_RANGE (numbers that tr_init, tr_set_state or a call of conditions.h refuses). Cost: 1 derivative. */
tr_status tr_load_saved(tr_sim* sim, uint32_t version, const void* bytes, size_t length);

/* Time derivative of the state, for integrators of your own: rates[i] belongs to x[i]; `length` >= TR_STATES.
 * TR_SHORT_BUFFER; TR_NOT_FINITE (rates are then as computed). Cost: 1 derivative. */
tr_status tr_derivative(const tr_sim* sim, tr_real* rates, size_t length);

typedef struct tr_outputs {
  double time_s;
  tr_real airspeed_mps;                      /* relative to the air at the aircraft, gust included */
  tr_real angle_of_attack_rad, sideslip_rad; /* the same; of the body; 0 at rest */
  tr_real specific_force_mps2[3]; /* at the centre of gravity, body axes: what an accelerometer reads */
  tr_real load_factor;    /* specific force normal to the motion through the air (at rest all) over gravity,
                          < 0 where it pushes down */
  tr_real climb_rate_mps; /* relative to the undisturbed air */
  tr_real thrust_n[2];    /* resultant force of a rotor on its hub */
  tr_real torque_nm[2];
  tr_real power_w[2];        /* shaft power */
  tr_real collective_rad[2]; /* blade pitch at 0.75 radius */
  tr_real long_cyclic_rad[2];
  tr_real gimbal_tilt_rad[2];
  tr_real elevator_rad, aileron_rad, rudder_rad;
} tr_outputs;

/* What an instrument would read now. TR_NOT_FINITE (outputs are then as computed). Cost: 1 derivative. */
tr_status tr_get_outputs(const tr_sim* sim, tr_outputs* outputs);

/* ---- trim ---- */

/* Relative to the air at the aircraft. */
typedef struct tr_flight {
  tr_real speed_mps;       /* 0..150 */
  tr_real climb_rad;       /* of the flight path, + up, within 90 deg; 0 at speed 0, below 1e-15 m/s */
  tr_real turn_rate_radps; /* of the heading, + right, within 60 deg/s */
  tr_real sideslip_rad;    /* + wind from the right, within 60 deg; 0 at speed 0 and climb +-90 deg */
} tr_flight;

typedef struct tr_trim_result {
  int32_t iterations; /* Newton steps */
  int32_t attempts;   /* 1: the cold start converged; more: continuation from an easier flight */
  tr_real residual;   /* largest left over, accelerations over gravity */
  char text[160];     /* how it ended; the longitudinal stick counts 0..9.6 in, neutral 4.8 */
} tr_trim_result;

/* Puts the aircraft in steady flight: state and inceptors. Heading, position and gust stay; the other
 * controls, time and steps become 0. The gust is held in body axes: in straight flight the loads are those of
 * still air, in a turn the air turns with the aircraft. With TR_WING_STALL, TR_CONTROL_LIMIT, TR_FLAP_LIMIT,
 * TR_VORTEX_RING_STATE, TR_POWER_LIMIT and TR_TORQUE_LIMIT too: the equations are fulfilled, a limit is
 * exceeded. NaN and infinity in `flight` are TR_NOT_FINITE. Otherwise (TR_ROTOR_STALL,
 * TR_NOT_CONVERGED, TR_SINGULAR, TR_NOT_FINITE, TR_OUT_OF_RANGE) the aircraft stays as it was. `result` may
 * be NULL; it is filled whenever the aircraft is initialised. Cost: 3 to 9 Jacobians as a rule, at most about
 * 1800 with 12 derivatives each. */
tr_status tr_trim(tr_sim* sim, tr_work* work, const tr_flight* flight, tr_trim_result* result);

/* ---- linear model and modes ---- */

enum { TR_MAX_LINEAR_STATES = 48 }; /* 27 without systems */

typedef enum tr_columns {
  TR_INCEPTORS = 1,      /* collective, sticks, pedal: 4 */
  TR_BLADE_CONTROLS = 2, /* blade angles and surfaces: 7 */
  TR_ALL_CONTROLS = 3,   /* 14 */
  TR_ALL_INPUTS = 4      /* controls, then the commands of tr_systems: 19 */
} tr_columns;

/* Meaning of rows and columns: A is states by states, B states by controls. */
typedef struct tr_linear_shape {
  int32_t states;
  int32_t controls;
  int32_t state[TR_MAX_LINEAR_STATES]; /* place in tr_state.x; see tr_state_name */
  int32_t control[TR_INPUTS];          /* place in tr_state.u; from TR_CONTROLS on a command */
} tr_linear_shape;

/* A = df/dx and B = df/du at the present state and controls, exact, by rows without gaps: a[i * states + j].
 * Heading and position are left out. `columns` is a tr_columns. `shape` comes first and is filled with
 * TR_SHORT_BUFFER too: call with lengths 0 to learn the sizes. `b` may be NULL with length 0 when only A is
 * wanted and the columns are still counted. The aircraft is not changed. TR_SHORT_BUFFER; TR_NOT_FINITE (a
 * and b are then as computed). Cost: 1 Jacobian (2 with TR_ALL_CONTROLS). */
tr_status tr_linearize(const tr_sim* sim, tr_work* work, int32_t columns, tr_linear_shape* shape, tr_real* a,
                       size_t a_length, tr_real* b, size_t b_length);

/* tr_linearize, then tr_step: the model belongs to the beginning of the step. The same numbers as from the
 * two calls, bit for bit, for one derivative less. The step is made only when the linear model is TR_OK; when
 * only the step fails, `shape`, `a` and `b` are valid. Statuses of both.
 * Cost: 1 Jacobian (2 with TR_ALL_CONTROLS) and one derivative less than tr_step. */
tr_status tr_linearize_and_step(tr_sim* sim, tr_work* work, tr_real dt, int32_t columns,
                                tr_linear_shape* shape, tr_real* a, size_t a_length, tr_real* b,
                                size_t b_length);

/* Eigenvalues of any real square matrix of order n (1..TR_MAX_LINEAR_STATES) given by rows. `real` and `imag`
 * hold at least n numbers (`length`). With TR_NOT_CONVERGED those not found are NaN. TR_NOT_FINITE,
 * TR_SHORT_BUFFER. Cost: about 10 n^3 multiplications, at most 30 n sweeps. */
tr_status tr_eigenvalues(tr_work* work, const tr_real* a, size_t n, tr_real* real, tr_real* imag,
                         size_t length);

typedef struct tr_mode {
  tr_real real, imag;      /* eigenvalue, 1/s; imag >= 0, a conjugate pair is one mode */
  tr_real frequency_radps; /* |eigenvalue| */
  tr_real damping_ratio;
  tr_real time_to_half_s; /* negative: time to double */
  char name[32];          /* short_period, dutch_roll, flap_regressing_sym, ... */
} tr_mode;

/* Modes of a linear model made by tr_linearize, longitudinal ones first; names depend on `a` alone. `capacity` of
 * shape->states is always enough; *count is the number found, with TR_SHORT_BUFFER that needed. TR_NOT_CONVERGED,
 * TR_NOT_FINITE, TR_SHORT_BUFFER. Cost: about 25 n^3 multiplications. */
tr_status tr_modes(tr_work* work, const tr_linear_shape* shape, const tr_real* a, size_t a_length,
                   tr_mode* modes, size_t capacity, size_t* count);

/* ---- words and hashes ---- */

/* Never NULL; "unknown" and "" out of range. */
const char* tr_status_word(int32_t status);
const char* tr_status_text(int32_t status);
const char* tr_state_name(int32_t index);
const char* tr_state_unit(int32_t index);
const char* tr_control_name(int32_t index);
const char* tr_control_unit(int32_t index);
const char* tr_version(void); /* of the library, "0.2.0" */

#define TR_HASH_START UINT64_C(14695981039346656037)

/* Continues *hash (begin with TR_HASH_START) over the bits of `length` numbers: FNV-1a, least significant byte first
 * on every machine. Equal hashes: two flights agree bit for bit. Cost: 8 multiplications a number. */
tr_status tr_hash(const tr_real* numbers, size_t length, uint64_t* hash);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif

#include "tiltrotor/conditions.h"
#include "tiltrotor/measure.h"
#include "tiltrotor/systems.h"

#endif
