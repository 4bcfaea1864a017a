/* The reference flight: trim, then 3 s at 200 Hz with A, B and the eigenvalues of A at every frame, through
 * the C interface alone. The same source runs on a workstation and on a microcontroller; its output is
 * compared line by line. */
#ifndef TILTROTOR_REFERENCE_FLIGHT_H
#define TILTROTOR_REFERENCE_FLIGHT_H

#include "firmware/text.h"

#define REFERENCE_FRAMES 600

/* Prints the flight to `write`; returns 0, or 1 when a call failed (it is named in the output). Needs no C
 * library. */
int reference_flight(text_sink write, int frames);

#endif
