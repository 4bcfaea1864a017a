/* An aircraft on its wheels, ready to lift off. */
#ifndef GROUND_START_H
#define GROUND_START_H

#include <tiltrotor/sensors.h>
#include <tiltrotor/tiltrotor.h>

/* Makes an XV-15 in helicopter mode that stands at position 0 0, time 0, on level ground at TR_DOWN 0: every system but
 * turbulence on, rotors at speed and carrying part of the weight, brakes set. `systems` is what is commanded,
 * `hover_throttle` what a hover away from the ground needs. `failed` names the call that did not succeed. */
tr_status start_on_ground(tr_sim* aircraft, tr_work* work, tr_systems* systems, double* hover_throttle,
                          const char** failed);

#endif
