#include <tiltrotor/tiltrotor.h>
static tr_sim sim;
static tr_work work;
int main(void) {
  tr_setup setup;
  tr_flight flight = {40.0, 0.0, 0.0, 0.0}; /* speed m/s, climb rad, turn rad/s, sideslip rad */
  tr_default_setup(&setup, TR_API_VERSION, TR_XV15, 0.0);
  tr_init(&sim, TR_API_VERSION, &setup);
  tr_trim(&sim, &work, &flight, NULL);
  for (int frame = 0; frame < 600; ++frame) tr_step(&sim, &work, 0.005);
  return 0;
}
