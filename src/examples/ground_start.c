/* From a trimmed hover down onto the ground: the throttles keep part of the power, the wheels take what is missing. */
#include "ground_start.h"

#include <stddef.h>

/* The first call that fails is remembered; those behind it are not made. */
#define TRY(name, call)                                                                  \
  do                                                                                     \
    if (status == TR_OK && (status = (call)) != TR_OK && failed != NULL) *failed = name; \
  while (0)

tr_status start_on_ground(tr_sim* aircraft, tr_work* work, tr_systems* systems, double* hover_throttle,
                          const char** failed) {
  const double standing = 0.6;                           /* part of the hover's throttle */
  const double above = 0.2, settling_s = 10, dt = 0.005; /* m below extended wheels, s */
  const tr_flight hover = {0, 0, 0, 0};
  tr_status status = TR_OK;
  tr_setup setup;
  tr_environment air;
  tr_state s;
  tr_real height = 0;
  int k;
  TRY("setup", tr_default_setup(&setup, TR_API_VERSION, TR_XV15, 0));
  TRY("init", tr_init(aircraft, TR_API_VERSION, &setup));
  TRY("systems", tr_get_systems(aircraft, systems));
  if (status != TR_OK) return status;
  systems->governor = TR_GOVERNOR_PI;
  systems->conversion = systems->engines = systems->actuators = systems->scas = 1;
  systems->gear = systems->ground_effect = systems->gear_down = 1;
  systems->brake[0] = systems->brake[1] = 1;
  TRY("systems", tr_set_systems(aircraft, systems));
  TRY("trim", tr_trim(aircraft, work, &hover, NULL));
  TRY("systems", tr_get_systems(aircraft, systems));
  if (status != TR_OK) return status;
  *hover_throttle = (double)systems->throttle[0];

  TRY("environment", tr_default_environment(&air));
  air.ground_down_m = 0;
  TRY("environment", tr_set_environment(aircraft, &air));
  TRY("state", tr_get_state(aircraft, &s));
  TRY("radio height", tr_radio_height_at(aircraft, NULL, &height));
  if (status != TR_OK) return status;
  s.position_m[2] += (double)height + above;
  s.x[TR_DOWN] = (tr_real)s.position_m[2];
  systems->throttle[0] = systems->throttle[1] = (tr_real)(standing * *hover_throttle);
  TRY("state", tr_set_state(aircraft, &s));
  TRY("systems", tr_set_systems(aircraft, systems));
  for (k = 0; k * dt < settling_s; ++k) TRY("step", tr_step(aircraft, work, (tr_real)dt));
  TRY("state", tr_get_state(aircraft, &s));
  if (status != TR_OK) return status;
  s.time_s = 0;
  s.steps = 0;
  s.position_m[0] = s.position_m[1] = 0;
  s.x[TR_NORTH] = s.x[TR_EAST] = 0;
  TRY("state", tr_set_state(aircraft, &s));
  return status;
}
