/* A flight of the complete vehicle: every system on, wind and turbulence, masts on their way, with A, B and the
 * eigenvalues of the closed loop now and then, through the C interface alone. Compared as the reference flight is. */
#ifndef TILTROTOR_VEHICLE_FLIGHT_H
#define TILTROTOR_VEHICLE_FLIGHT_H

#include "firmware/reference_flight.h"

/* Prints the flight to `write`; returns 0, or 1 when a call failed (it is named in the output). */
int vehicle_flight(text_sink write, int frames);

/* The aircraft with every system on, in a trim at `mast_deg` and `speed_mps`. */
tr_status equip(tr_sim* sim, tr_work* work, int governor, int mast_deg, int speed_mps, tr_systems* systems);

#endif
