/* An autopilot in the loop: holds attitude and descent rate, banks to and fro, for as long as asked; every status
 * is counted. Prints a line a minute, and the hash of the whole flight at the end.
 *
 *   cc autopilot.c $(pkg-config --cflags --libs tiltrotor) -o autopilot && ./autopilot 3600 */
#include <stdio.h>
#include <stdlib.h>
#include <tiltrotor/tiltrotor.h>

static tr_sim aircraft;
static tr_work work;

static tr_real within(tr_real x, tr_real limit) { return x < -limit ? -limit : x > limit ? limit : x; }

/* Gains in inches of stick per radian and per radian a second, radians of collective per m/s. */
static void control(const tr_state* now, const tr_state* trimmed, tr_real bank, tr_real* u) {
  u[TR_COLLECTIVE] =
      trimmed->u[TR_COLLECTIVE] + within((now->x[TR_W] - trimmed->x[TR_W]) / 100, (tr_real)0.05);
  u[TR_LONG_STICK] =
      within(trimmed->u[TR_LONG_STICK] + 8 * (now->x[TR_PITCH] - trimmed->x[TR_PITCH]) + 5 * now->x[TR_Q],
             (tr_real)4.8);
  u[TR_LAT_STICK] =
      within(trimmed->u[TR_LAT_STICK] - 4 * (now->x[TR_ROLL] - bank) - 3 * now->x[TR_P], (tr_real)4.8);
  u[TR_PEDAL] = within(trimmed->u[TR_PEDAL] - 2 * now->x[TR_R], (tr_real)2.5);
}

int main(int count, char** arguments) {
  const long seconds = count > 1 ? atol(arguments[1]) : 10;
  const long frames = seconds * 200;
  const tr_flight level = {40, 0, 0, 0};
  uint64_t hash = TR_HASH_START;
  tr_setup setup;
  tr_state trimmed, now;
  long frame, errors = 0;
  if (tr_default_setup(&setup, TR_API_VERSION, TR_XV15, 0) != TR_OK ||
      tr_init(&aircraft, TR_API_VERSION, &setup) != TR_OK ||
      tr_trim(&aircraft, &work, &level, NULL) != TR_OK || tr_get_state(&aircraft, &trimmed) != TR_OK)
    return 1;
  now = trimmed;
  for (frame = 0; frame < frames; ++frame) {
    tr_real u[4];
    control(&now, &trimmed, (tr_real)0.1 * (tr_real)(frame / 4000 % 3 - 1), u);
    errors += tr_set_controls(&aircraft, u, 4) != TR_OK;
    errors += tr_step(&aircraft, &work, (tr_real)0.005) != TR_OK;
    errors += tr_get_state(&aircraft, &now) != TR_OK;
    tr_hash(now.x, TR_STATES, &hash);
    if ((frame + 1) % 12000 == 0)
      printf("%6.0f s: %6.2f m/s, roll %6.3f rad, pitch %6.3f rad, %ld errors\n", now.time_s,
             (double)now.x[TR_U], (double)now.x[TR_ROLL], (double)now.x[TR_PITCH], errors);
  }
  printf("flown_s %.3f errors %ld hash %016llx\n", now.time_s, errors, (unsigned long long)hash);
  return errors > 0;
}
