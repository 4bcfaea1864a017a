/* The text that rig.c takes and gives. */
#ifndef RIG_TEXT_H
#define RIG_TEXT_H

#include <stdio.h>
#include <tiltrotor/sensors.h>
#include <tiltrotor/tiltrotor.h>

enum { RIG_LINE = 1024 };

/* Acts on a line "[collective_rad long_stick_in lat_stick_in pedal_in] [NAME NUMBER]...", numbers decimal or hexadecimal.
 * `commanded` holds the systems as commanded. 0: it is no such line or the aircraft refuses it, and nothing is changed.
 * Names are members of tr_systems:
 *   governor 0..2; wind_shear 0..2; conversion engines actuators scas gear_system ground_effect turbulence interconnect 0 or 1   switches
 *   mast deg, flap deg, rotor rad/s, throttle 0..1.2, brakes 0..1, gear 1 down or 0 up             commands
 *   throttle_right throttle_left brake_right brake_left; failed_right failed_left; wind_20_ft m/s */
int take_line(tr_sim* aircraft, tr_systems* commanded, const char* text);

/* A line for take_line: the controls of `state`, and what has been commanded since `before`. */
void record_line(FILE* file, const tr_state* state, const tr_systems* before, const tr_systems* commanded);

/* Lines "TIME_S LINE" in the order of their times; # begins a remark. 0: one line on stderr says what and where. */
int read_script(const char* path);
/* Acts on those that are due; how many were refused, each with a line on stderr. */
unsigned long take_script(tr_sim* aircraft, tr_systems* commanded, double time_s);

/* Instruments at the centre of gravity as it is now. */
typedef struct rig_sensors {
  tr_imu imu;
  tr_air_probe probe;
} rig_sensors;
tr_status place_sensors(const tr_sim* aircraft, rig_sensors* sensors);

/* What they read `dt_s` after the last reading, 29 numbers apart by blanks:
 *    1 time s           2-4 latitude deg, longitude deg, height over WGS-84 m       5 radio height of the wheels m, or inf
 *    6-8 specific force m/s^2      9-11 p q r rad/s      12-15 quaternion, scalar first    16-18 velocity n e d m/s
 *    19 static pressure Pa    20 impact pressure Pa    21 calibrated airspeed m/s    22 alpha rad    23 beta rad
 *    24 mast deg    25 flap deg    26 rotor rad/s    27-28 engine power right and left W    29 flags of tr_get_flags
 * `text` holds RIG_LINE characters. Position 0 0 0 is at 37.415 N 122.048 W, height 0. */
tr_status sensor_line(const tr_sim* aircraft, rig_sensors* sensors, tr_real dt_s, char* text);

#endif
