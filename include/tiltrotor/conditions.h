/* tiltrotor: what may change in flight beside state and controls: masts, flaps, rotor speed and loading; air and
 * ground; loads from outside. Part of tiltrotor.h, which includes it; the same rules hold. */
#ifndef TILTROTOR_CONDITIONS_H
#define TILTROTOR_CONDITIONS_H

#include "tiltrotor/tiltrotor.h"

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

/* Masts, flaps, rotor speed and loading. While steps last, masts and rotors move on as their rates and
 * accelerations carry them: every evaluation of the equations of motion sees them where they are. At 0 and
 * 90 deg a mast stops; its rate and acceleration are 0 from there on, without a blow on the airframe. A step that leads
 * a rate or the rotor speed out of its range is TR_OUT_OF_RANGE. A trim is one of the moment: at the mast angle and rate as they are. Ranges
 * are the aircraft's, here those of the XV-15. */
typedef struct tr_configuration {
  tr_real mast_deg;                  /* 0 helicopter .. 90 airplane */
  tr_real mast_rate_radps;           /* + towards airplane, within 1 */
  tr_real mast_acceleration_radps2;  /* within 10 */
  tr_real flap_deg;                  /* 0..75, also between the settings of the tables */
  tr_real rotor_radps;               /* 20..80 */
  tr_real rotor_acceleration_radps2; /* within 50 */
  tr_real mass_kg;                   /* 3000..10000; inertia belongs to the gross weight and is not scaled */
  tr_real cg_station_m;              /* of the centre of gravity with the masts at 0, 7..8 */
  tr_real cg_waterline_m;            /* likewise, 1.5..2.5 */
} tr_configuration;

/* As it is now. TR_BAD_ARGUMENT. Cost: a copy. */
tr_status tr_get_configuration(const tr_sim* sim, tr_configuration* configuration);

/* In force from now on. The state stays as it is; inflow keeps its speed in m/s, so that its ratio to the tip speed
 * in tr_state.x follows the rotor speed. Velocity is that of the centre of gravity, wherever that lies.
 * TR_NOT_FINITE, TR_OUT_OF_RANGE, TR_BAD_ARGUMENT: nothing is changed. Cost: a twentieth of a derivative; a step with
 * something moving costs a twentieth more for every derivative. */
tr_status tr_set_configuration(tr_sim* sim, const tr_configuration* configuration);

/* Places at which air may move differently. Wing: and fuselage, pylons, and the rotors' wakes on the wing; tail:
 * horizontal tail and fins. */
enum { TR_AT_RIGHT_ROTOR, TR_AT_LEFT_ROTOR, TR_AT_WING, TR_AT_TAIL, TR_PLACES };

/* Air and ground; held during a step. The undisturbed air is carried along by the wind: velocities of the state are
 * relative to it, positions are over the ground. Gusts are of the air at a place relative to the undisturbed air,
 * and add to TR_GUST_U..TR_GUST_W, which are felt everywhere; instruments of tr_outputs know the latter alone, probes
 * (tr_air_data_at) those of the wing too. */
typedef struct tr_environment {
  tr_real wind_mps[3];            /* north east down, each within 100; along height see tr_wind_shear */
  tr_real gust_mps[TR_PLACES][3]; /* body axes, each within 50 */
  tr_real
      gust_rates_radps[3]; /* turning of the air about the centre of gravity, body axes, within 2: what grows
                                     along span and body. The growth across a single disk is left out */
  tr_real altitude_origin_m; /* altitude = altitude_origin_m - x[TR_DOWN], -500..11000: density follows it */
  tr_real temperature_offset_k; /* from the standard atmosphere at that altitude, within 60 */
  tr_real pressure_ratio;       /* to it, 0.8..1.2 */
  tr_real
      ground_down_m; /* x[TR_DOWN] of the level ground of gear, ground effect and wind shear of systems.h; infinity:
                                     none */
} tr_environment;

/* Air at rest and standard over all altitudes, origin at sea level, no ground. TR_BAD_ARGUMENT. */
tr_status tr_default_environment(tr_environment* environment);

/* Until the first call the air is at rest and that of tr_setup.altitude_m wherever the aircraft flies. When the wind
 * changes, or in a wind shear the ground, the aircraft keeps its velocity over the ground: velocities of the state change. TR_NOT_FINITE,
 * TR_OUT_OF_RANGE (also of the altitude or velocity that follows), TR_BAD_ARGUMENT: nothing is changed. Afterwards
 * tr_set_state refuses positions outside the atmosphere, and a step does that leads there. Cost: as
 * tr_set_configuration. */
tr_status tr_set_environment(tr_sim* sim, const tr_environment* environment);

/* Which field tr_set_configuration or tr_set_environment would refuse, in one line: "mast_deg 95 lies outside 0..90",
 * "wind_mps[0] is no finite number, which lies in -100..100"; its status, but for what follows from the state (altitude
 * and velocity). `text` and `length` as with tr_check_setup. TR_WRONG_VERSION, TR_BAD_ARGUMENT, TR_NOT_FINITE,
 * TR_OUT_OF_RANGE. Cost: a few comparisons. */
tr_status tr_check_configuration(const tr_configuration* configuration, uint32_t version, char* text,
                                 size_t length);
tr_status tr_check_environment(const tr_environment* environment, uint32_t version, char* text,
                               size_t length);

/* The ends of a range, as the calls that set the number check them. `name`: a field of tr_setup, tr_flight,
 * tr_configuration, tr_environment or tr_systems ("throttle[1]"; speed_mps is that of tr_flight), or "x." or "u." before
 * tr_state_name or tr_control_name ("u.pedal", in its unit). Where there is no end, the largest number. TR_BAD_ARGUMENT (no
 * such number). Cost: comparisons of names. */
tr_status tr_get_range(const char* name, tr_real* low, tr_real* high);

/* A load from outside: slung, towed, thrown. */
#define TR_MOST_LOADS 8
typedef struct tr_load {
  tr_real station_m[3]; /* aft, right, up; each within 1000 */
  tr_real force_n[3];   /* body axes */
  tr_real moment_nm[3];
} tr_load;

/* Held until set again; 0 loads: none. Each component of all of them together: force within 200000 N, moment about the
 * origin of the stations within 4000000 N m. They are felt by accelerometers as the air's are. TR_NOT_FINITE,
 * TR_OUT_OF_RANGE, TR_BAD_ARGUMENT (more than TR_MOST_LOADS): nothing is changed. Cost: as tr_set_configuration. */
tr_status tr_set_loads(tr_sim* sim, const tr_load* loads, size_t count);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif

#endif
