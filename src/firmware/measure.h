/* Instructions of each call, smallest and largest over random states. */
#ifndef TILTROTOR_FIRMWARE_MEASURE_H
#define TILTROTOR_FIRMWARE_MEASURE_H

#include "firmware/reference_flight.h"

/* Instructions executed so far, wraps at 2^32. */
typedef uint32_t (*instruction_counter)(void);

/* Prints name_min and name_max of derivative, step, jacobian, eigenvalues and frame (step, A, B and
 * eigenvalues) over `states` random states, of frames by the exponential step, with all eigenvalues and with
 * those of the rigid body, and of one Newton step of a trim over the speeds of the corridor.
 */
int measure(text_sink write, instruction_counter count, int states);

#endif
