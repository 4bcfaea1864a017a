/* Trim at 40 m/s, fly two seconds with one degree more collective, print modes: the C interface in a page.
 *
 *   cc trim_and_fly.c $(pkg-config --cflags --libs tiltrotor) */
#include <stdio.h>
#include <tiltrotor/tiltrotor.h>

static tr_sim aircraft;
static tr_work work;

static int failed(const char* what, tr_status status) {
  if (status == TR_OK) return 0;
  fprintf(stderr, "%s: %s (%s)\n", what, tr_status_word(status), tr_status_text(status));
  return 1;
}

static int print_modes(void) {
  tr_real a[TR_MAX_LINEAR_STATES * TR_MAX_LINEAR_STATES];
  tr_mode modes[TR_MAX_LINEAR_STATES];
  tr_linear_shape shape;
  size_t count, i;
  const size_t room = sizeof a / sizeof a[0];
  if (failed("linearize", tr_linearize(&aircraft, &work, TR_INCEPTORS, &shape, a, room, NULL, 0))) return 1;
  if (failed("modes", tr_modes(&work, &shape, a, room, modes, TR_MAX_LINEAR_STATES, &count))) return 1;
  for (i = 0; i < count; ++i)
    printf("%-24s %9.4f %+9.4fi 1/s, damping ratio %.3f\n", modes[i].name, modes[i].real, modes[i].imag,
           modes[i].damping_ratio);
  return 0;
}

int main(void) {
  const tr_flight level = {40, 0, 0, 0}; /* m/s, climb, turn, sideslip */
  tr_setup setup;
  tr_trim_result trim;
  tr_state state;
  tr_outputs outputs;
  int frame;
  if (failed("setup", tr_default_setup(&setup, TR_API_VERSION, TR_XV15, 0))) return 1;
  if (failed("init", tr_init(&aircraft, TR_API_VERSION, &setup))) return 1;
  if (failed("trim", tr_trim(&aircraft, &work, &level, &trim))) return 1;
  printf("%s\n", trim.text);
  if (print_modes()) return 1;

  if (failed("state", tr_get_state(&aircraft, &state))) return 1;
  state.u[TR_COLLECTIVE] += 0.0174533;
  if (failed("controls", tr_set_controls(&aircraft, state.u, TR_CONTROLS))) return 1;
  for (frame = 1; frame <= 400; ++frame) {
    if (failed("step", tr_step(&aircraft, &work, 0.005))) return 1;
    if (frame % 100 != 0) continue;
    if (failed("outputs", tr_get_outputs(&aircraft, &outputs))) return 1;
    printf("%4.1f s: %6.2f m/s, climbs %5.2f m/s, load factor %.3f, %4.0f kW\n", outputs.time_s,
           outputs.airspeed_mps, outputs.climb_rate_mps, outputs.load_factor,
           (outputs.power_w[0] + outputs.power_w[1]) / 1000);
  }
  return 0;
}
