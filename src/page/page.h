/* What the page calls: the C interface with everything that JavaScript would have to know of its structs taken away.
 * Numbers come and go through arrays whose places page_array() says; texts through page_text(). Two aircraft: that of
 * Explore and that of Fly. No imports, no heap: memory is fixed when the module is linked. */
#ifndef TILTROTOR_PAGE_H
#define TILTROTOR_PAGE_H

#include "tiltrotor/tiltrotor.h"

enum { PAGE_EXPLORE, PAGE_FLY, PAGE_AIRCRAFT };

/* Arrays of tr_real, in this order; the JavaScript beside has the same list. */
enum {
  PAGE_SETUP, /* mast deg, flap deg, altitude m, mass kg, cg station m, rotor rad/s; < 0: the default */
  PAGE_SYSTEMS, /* governor, conversion, engines, actuators, scas, gear, ground effect, turbulence, mast deg, flap
                         deg, rotor rad/s, throttle right, left, gear down, seed, w20 m/s, interconnect */
  PAGE_ENVIRONMENT,   /* wind north, east, down m/s, altitude of the origin m */
  PAGE_X,             /* tr_state.x */
  PAGE_U,             /* tr_state.u */
  PAGE_OUTPUTS,       /* tr_outputs, time_s first */
  PAGE_CONFIGURATION, /* tr_configuration */
  PAGE_A,
  PAGE_B,
  PAGE_MODES, /* real, imag, frequency, damping ratio, time to half of every mode */
  PAGE_STATE_PLACES,
  PAGE_CONTROL_PLACES, /* of rows and columns of A and B */
  PAGE_FORCES,         /* x, y, z of every component, body axes, N */
  PAGE_ARRAYS
};

tr_real* page_array(int32_t which);
char* page_text(void);

/* A tr_status each. page_begin: tr_init of PAGE_SETUP, everything off; the text says what is refused. page_trim: level
 * flight in straight line; the text says how it ended. page_look fills X, U, OUTPUTS, CONFIGURATION and SYSTEMS. */
int32_t page_begin(int32_t aircraft);
int32_t page_trim(int32_t aircraft, tr_real speed_mps);
int32_t page_set_systems(int32_t aircraft);
int32_t page_set_environment(int32_t aircraft);
int32_t page_set_height(int32_t aircraft, tr_real height_m);
int32_t page_set_controls(int32_t aircraft); /* the first 4 of PAGE_U, which then has them as set */
int32_t page_step(int32_t aircraft, tr_real dt);
int32_t page_look(int32_t aircraft);
uint32_t page_flags(int32_t aircraft);

/* Fills FORCES, of state and controls as they are; what systems add to the controls is left out: of a trim, nothing. */
int32_t page_component_forces(int32_t aircraft);
const char* page_component_name(int32_t component);

/* A, B of `columns` and the modes; *shape by the two counts. Names by number: page_mode_name(k). */
int32_t page_linearize(int32_t aircraft, int32_t columns);
int32_t page_states(void);
int32_t page_controls(void);
int32_t page_modes(void);
const char* page_mode_name(int32_t mode);

/* The reference flight of src/firmware; its output is the text. 0: flown. */
int32_t page_reference_flight(int32_t frames);
const char* page_state_name(int32_t place);
const char* page_control_name(int32_t place);
const char* page_status_text(int32_t status);
const char* page_status_word(int32_t status);
const char* page_version(void);
/* Of the last call that failed on this aircraft: the state that left its range, or "". */
const char* page_fault(int32_t aircraft);

#endif
