/* tiltrotor: sensors of a rig: place on the earth, radio height, and instruments with a first-order lag. Include it
 * beside tiltrotor.h, which does not; the rules there hold. Sensors keep nothing of their own: what a lag remembers
 * lies in a plain struct of the caller, and a copy of it is a snapshot. No errors of position, bias or noise. */
#ifndef TILTROTOR_SENSORS_H
#define TILTROTOR_SENSORS_H

#include "tiltrotor/tiltrotor.h"

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

/* ---- place on the earth ---- */

/* Geodetic, on the ellipsoid WGS-84 (a = 6378137 m, 1/f = 298.257223563). In double precision whatever tr_real is. */
typedef struct tr_geodetic {
  double latitude_rad;  /* + north, within pi/2 */
  double longitude_rad; /* + east, within pi */
  double height_m;      /* over the ellipsoid */
} tr_geodetic;

/* Where a position lies: north, east and down of the plane that touches the earth below `origin`, as position_m of
 * tr_state. Ranges: of the origin as above with a height of -10000..100000 m, of each component of the position within
 * 1000000 m. The plane leaves the earth: 10 km away its height is 8 m more than -down, 100 km away some 785 m, and north
 * there differs from that of the plane by the distance east over the earth's radius, times tan(latitude); a flight that
 * goes far moves its origin along. Within 1e-8 m of the exact place; at a pole the longitude stays that of the origin.
 * TR_NOT_FINITE, TR_OUT_OF_RANGE, TR_BAD_ARGUMENT. Cost: some 200 operations. */
tr_status tr_geodetic_at(const tr_geodetic* origin, const double position_m[3], tr_geodetic* place);

/* ---- height ---- */

/* Vertical height of a station (aft, right, up, as tr_motion_at takes it) over the ground of tr_environment, + above:
 * what a radio altimeter reads whose beam is wider than bank and pitch, since the nearest ground is below. `station_m`
 * NULL: the least of the three wheels, extended and not loaded, so that it is negative by what oleos and tyres give on
 * the ground. Infinite without ground. TR_NOT_FINITE, TR_OUT_OF_RANGE, TR_BAD_ARGUMENT. Cost: some 100 operations, three
 * times that for the wheels. */
tr_status tr_radio_height_at(const tr_sim* sim, const tr_real station_m[3], tr_real* height_m);

/* That of each wheel, nose, right and left, extended and not loaded, and how it changes along a direction of states
 * (TR_STATES numbers, as those of tr_directional): exact, moving masts and burnt fuel included. `dx` and `dheight_m` may
 * both be NULL. TR_NOT_FINITE (in `dx`, and nothing is written), TR_BAD_ARGUMENT. Cost: some 600 operations. */
tr_status tr_wheel_heights(const tr_sim* sim, const tr_real* dx, tr_real height_m[3], tr_real dheight_m[3]);

/* ---- lag ---- */

/* reading' = (input - reading) / time constant. Begin with a time constant and zeros. */
typedef struct tr_lag {
  tr_real time_constant_s; /* 0..100; 0, or less than a millionth of the step: the reading is the input */
  tr_real reading;
  tr_real input; /* the last */
  int32_t begun; /* 0: the next input is where the reading begins, as if at rest before */
} tr_lag;

/* The reading `dt_s` (0..100) after the last one. The solution for an input that went there in a straight line from the
 * last one, whatever the step: a ramp is read late by the time constant, a reading never passes the largest and the
 * least of its inputs. TR_NOT_FINITE (also of what the lag remembers), TR_OUT_OF_RANGE, TR_BAD_ARGUMENT: the lag is as it
 * was. Cost: some 50 operations. */
tr_status tr_step_lag(tr_lag* lag, tr_real input, tr_real dt_s);

/* ---- instruments with lag ---- */

/* Inertial unit: the readings are those of its lags, in units and axes of tr_motion. */
typedef struct tr_imu {
  tr_real station_m[3]; /* aft, right, up */
  tr_lag specific_force_mps2[3];
  tr_lag rates_radps[3];
} tr_imu;

/* Reads tr_motion_at now, `dt_s` after the last reading. One aircraft may carry any number of them, each read at a rate
 * of its own. Statuses of tr_motion_at and tr_step_lag; unless TR_OK all is as it was. Cost: 1 derivative. */
tr_status tr_read_imu(const tr_sim* sim, tr_imu* imu, tr_real dt_s);

/* Air data probe: lags of the lines and vanes. */
typedef struct tr_air_probe {
  tr_real station_m[3]; /* aft, right, up */
  tr_lag static_pa, impact_pa;
  tr_lag alpha_rad, beta_rad;
} tr_air_probe;

/* Reads tr_air_data_at now, `dt_s` after the last reading. `indicated` is what follows from the lagged pressures: Mach
 * number and calibrated airspeed, and true airspeed with the temperature of the air. Without lags it is tr_air_data_at,
 * speeds but for rounding. Statuses of tr_air_data_at and tr_step_lag; unless TR_OK all is as it was. Cost: some 300
 * operations. */
tr_status tr_read_air_probe(const tr_sim* sim, tr_air_probe* probe, tr_real dt_s, tr_air_data* indicated);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif

#endif
