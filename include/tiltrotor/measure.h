/* tiltrotor: what a rig reads beside the state, what it commands beyond the stops, what it asks after a refusal, and
 * how it takes long frames. Part of tiltrotor.h, which includes it; the same rules hold. */
#ifndef TILTROTOR_MEASURE_H
#define TILTROTOR_MEASURE_H

#include "tiltrotor/tiltrotor.h"

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

/* tr_get_outputs, then tr_step: the outputs belong to the beginning of the step. The same numbers as from the
 * two calls, bit for bit, for one derivative less. The step is made only when the outputs are TR_OK; when
 * only the step fails, `outputs` is valid. Statuses of both. Cost: that of tr_step. */
tr_status tr_step_with_outputs(tr_sim* sim, tr_work* work, tr_real dt, tr_outputs* outputs);

/* As tr_set_controls, but a control beyond its range is set to the end of it. `clipped`: bit i is set when
 * control i was. NaN and infinities are TR_NOT_FINITE, and none is set. TR_BAD_ARGUMENT. Cost: a few
 * comparisons. */
tr_status tr_saturate_controls(tr_sim* sim, const tr_real* controls, size_t length, uint32_t* clipped);

/* What the last failing call found on this aircraft, of those that fly or set it: tr_step,
 * tr_step_with_outputs, tr_linearize_and_step, tr_set_controls, tr_saturate_controls, tr_set_state. Later
 * calls that succeed leave it; tr_init and tr_load_saved begin anew; tr_save does not keep it. Not recorded:
 * TR_NOT_INITIALIZED and TR_BAD_ARITHMETIC. */
typedef struct tr_fault {
  int32_t status;  /* tr_status; TR_OK: no call has failed */
  int32_t state;   /* the first place in tr_state.x that is no number or beyond its bound; -1: none */
  int32_t control; /* the same in tr_state.u */
  double time_s;   /* of the aircraft when it was called: of the last good state */
} tr_fault;

/* TR_BAD_ARGUMENT. Cost: a copy. */
tr_status tr_last_fault(const tr_sim* sim, tr_fault* fault);

/* What is exceeded now.
 *
 * TR_TABLE_EDGE: the end value of a table is held where the source has no more. Numbers are those of the
 * XV-15. Mach number of the flight (beyond 0.6) and of an advancing tip (0.85). From the airspeed on at which a
 * unit of lift coefficient carries 2 % of the weight (11 m/s) also angle of attack (-10..28 deg) and sideslip
 * (51 deg) of the sidewash at the fins, and deflection of elevator and rudder (20 deg). Not counted are angles
 * of blade sections, which have a flat plate beyond their table, tables that go all around, and those that are
 * meant to end, as gearing along speed. */
enum {
  TR_SATURATED = 1,      /* a control at the end of its range or beyond (gusts do not count), or a surface,
                            moved by stick or pedal and its increment, beyond its stop */
  TR_AT_GIMBAL_STOP = 2, /* the tilt of a gimbal is beyond its stop */
  TR_OVER_POWER = 4, /* the rotors need more than the take-off power of the engines that run, or drive them */
  TR_OVER_TORQUE = 8,  /* a mast carries more than its largest steady torque */
  TR_TABLE_EDGE = 16,  /* see above */
  TR_VORTEX_RING = 32, /* a rotor descends in its own wake: the mean of an unsteady flow */
  TR_ON_GROUND = 64,   /* a wheel carries something: systems.h */
  TR_BELOW_GROUND =
      128 /* the CG lies below the ground: it has been struck, nothing of the library stops there */
};

/* A sum of the above. TR_NOT_FINITE. Cost: 1 derivative. */
tr_status tr_get_flags(const tr_sim* sim, uint32_t* flags);

/* As it is at the present mast angle. */
typedef struct tr_mass {
  tr_real mass_kg;
  tr_real cg_m[3];         /* station of the centre of gravity: aft, right, up */
  tr_real inertia_kgm2[4]; /* about it, body axes: xx yy zz xz, xz the integral of x z */
} tr_mass;

/* TR_BAD_ARGUMENT. Cost: a copy. */
tr_status tr_get_mass(const tr_sim* sim, tr_mass* mass);

/* Of a point fixed to the airframe, by its station. */
typedef struct tr_motion {
  tr_real position_m[3];          /* north east down, as TR_NORTH..TR_DOWN */
  tr_real velocity_ned_mps[3];    /* north east down, over the ground: with the wind at the aircraft */
  tr_real velocity_air_mps[3];    /* relative to the air at the aircraft, gust included; body axes */
  tr_real specific_force_mps2[3]; /* what an accelerometer there reads, body axes: 1 g up is -9.8 in z */
  tr_real rates_radps[3];         /* p q r */
  tr_real acceleration_radps2[3]; /* their rates */
  tr_real quaternion[4]; /* scalar first, >= 0: the rotation of the earth's axes into those of the body */
} tr_motion;

/* `station_m`: aft, right and up, in the aircraft's stations, as cg_m of tr_mass; within 1000 m. An IMU, an
 * eye point, a probe. TR_NOT_FINITE (a station that is no number, and nothing is written; or what was found,
 * and the motion is as computed), TR_OUT_OF_RANGE. Cost: 1 derivative. */
tr_status tr_motion_at(const tr_sim* sim, const tr_real station_m[3], tr_motion* motion);

typedef struct tr_air_data {
  tr_real static_pa;
  tr_real impact_pa; /* of compressible flow without shock: total less static pressure */
  tr_real
      tas_mps; /* true airspeed; gust, that of the wing and turbulence, and the turning of aircraft and air included */
  tr_real cas_mps; /* calibrated airspeed: that at sea level, ISA, of the same impact pressure */
  tr_real mach;
  tr_real alpha_rad, beta_rad; /* as in tr_outputs */
} tr_air_data;

/* What a probe without errors reads at a station, as tr_motion_at takes it: of the velocity there, not
 * disturbed by airframe or rotors. Formulas hold below Mach 1. TR_NOT_FINITE, TR_OUT_OF_RANGE; nothing is then
 * written. Cost: some 500 operations. */
tr_status tr_air_data_at(const tr_sim* sim, const tr_real station_m[3], tr_air_data* air);

/* How rates and outputs change along one direction: dxdot = A dx + B du over every state, doutputs = C dx + D
 * du; exact. `dx` holds TR_STATES numbers, `du` TR_CONTROLS, in the order and units of tr_state; `dxdot`
 * takes TR_STATES; doutputs->time_s is 0. TR_NOT_FINITE (in `dx` or `du`, and nothing is written; or in what
 * was found, which is then as computed). Outputs that have no derivative have 0: airspeed and its angles at
 * rest, the tilt of a gimbal that is not tilted. Cost: 1 Jacobian. Without systems the air is held as it is, also where
 * it follows the altitude. Systems, and their commands: systems.h. */
tr_status tr_directional(const tr_sim* sim, tr_work* work, const tr_real* dx, const tr_real* du,
                         tr_real* dxdot, tr_outputs* doutputs);

enum { TR_OUTPUTS = 23 }; /* numbers of tr_outputs after time_s */

/* C and D at the present state and controls, exact, by rows without gaps: how the numbers of tr_outputs, in
 * its order after time_s, change with the states and controls of tr_linearize for the same `columns`:
 * TR_OUTPUTS by states, TR_OUTPUTS by controls. `d` may be NULL with length 0. Derivatives that do not exist
 * are those of tr_directional. TR_SHORT_BUFFER; TR_NOT_FINITE (c and d are then as computed).
 * Cost: 1 Jacobian (2 with TR_ALL_CONTROLS); with systems: systems.h. */
tr_status tr_linearize_outputs(const tr_sim* sim, tr_work* work, int32_t columns, tr_real* c, size_t c_length,
                               tr_real* d, size_t d_length);

/* The model of the rigid body, 8 states, from one of tr_linearize: the rotors and the downwash follow at
 * once but for the first order of their lag, (I + A_rf A_ff^-2 A_fr) x_r' = (A_rr - A_rf A_ff^-1 A_fr) x_r + (B_r - A_rf
 * A_ff^-1 B_f) u. Its eigenvalues, by tr_eigenvalues or with `reduced_shape` by tr_modes, are those of the slow modes
 * to a few per cent, for a quarter of the cost of all: cheap enough for every step. The steady response is exact.
 * With systems their states stay, and the position down where it counts, behind the 8 in their order: some 15 states fewer
 * than all, for three quarters of the cost. `b` and
 * `reduced_b` may be NULL with lengths 0. Arrays by rows without gaps, `reduced_a` the square of reduced_shape->states;
 * `reduced_shape` comes first and may be `shape`, `reduced_a` may be `a`, `reduced_b` may be `b`. TR_SHORT_BUFFER, TR_SINGULAR, TR_NOT_FINITE. Cost: about n^3 multiplications. */
tr_status tr_rigid_model(tr_work* work, const tr_linear_shape* shape, const tr_real* a, size_t a_length,
                         const tr_real* b, size_t b_length, tr_linear_shape* reduced_shape,
                         tr_real* reduced_a, size_t reduced_a_length, tr_real* reduced_b,
                         size_t reduced_b_length);

/* tr_linearize, then a step by the exponential of A: the linear model solved exactly, from a frame of 5 ms to one of
 * 40 ms. Order 2, stable wherever the linear model is: tr_step is more accurate, this one cheaper where A is wanted
 * anyway, and the only one beyond 0.02 s. `control_rates`: of the columns of `shape`, a second, with which controls move
 * during the step and stay moved, and which needs `b`; NULL: they are held. The angles of Euler are integrated, whose
 * rates end at 90 deg pitch. With systems on TR_BAD_ARGUMENT. dt: 0..0.04 s. Statuses of tr_linearize_and_step. Cost: 1
 * Jacobian (2 with TR_ALL_CONTROLS), and at most 34 products with A for each part of the step in which dt A stays below
 * 5 (math/exponential_step.hpp): one part up to about 20 ms, together less than half a derivative. */
tr_status tr_linearize_and_step_exponential(tr_sim* sim, tr_work* work, tr_real dt,
                                            const tr_real* control_rates, int32_t columns,
                                            tr_linear_shape* shape, tr_real* a, size_t a_length, tr_real* b,
                                            size_t b_length);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif

#endif
