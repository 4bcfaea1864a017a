/* The aircraft for ArduPilot's simulator (SITL), by its JSON interface.
 *
 *   cc ardupilot.c ground_start.c $(pkg-config --cflags --libs tiltrotor) -lm -o ardupilot
 *   ardupilot [--port 9002] [--frames N] &
 *   sim_vehicle.py -v ArduPlane --model JSON:127.0.0.1
 *
 * The protocol (libraries/SITL/examples/JSON of ArduPilot), UDP on port 9002, the answer to whoever asked:
 * it sends 40 bytes, in the byte order of its processor, which is little-endian here:
 *   uint16 magic 18458 | uint16 frame rate, Hz | uint32 frame count | uint16 pulse width of 16 servos, us
 * or 72 bytes with the magic 29569 and 32 servos, of which the first 16 count here. It wants one step a frame, and gets a
 * line of JSON, a new line before and behind it: timestamp (s), imu with gyro (rad/s) and accel_body (m/s^2, specific
 * force), position and velocity (north east down, m and m/s), quaternion (scalar first), and rng_1, the radio height (m).
 * A frame count that is not new was sent again: it is answered and not flown. One that goes back is a new start.
 *
 * Servos, in the order of ArduPlane: 1 aileron (lateral stick), 2 elevator (longitudinal stick, longer pulses nose up),
 * 3 throttle (of both engines; the governor follows with the collective), 4 rudder (pedal), 5 masts (1000 helicopter .. 2000
 * airplane); 1000..2000 us, neutral 1500. A pulse of 0 is none: that command stays. The aircraft begins on the ground; its
 * own augmentation is on. */
#define _POSIX_C_SOURCE 200809L
#include <arpa/inet.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>

#include "ground_start.h"

enum { SERVOS = 16, LONGEST_PACKET = 8 + 2 * 32, MAGIC_16 = 18458, MAGIC_32 = 29569 };

typedef struct servo_frame {
  unsigned rate;
  uint32_t count;
  unsigned pulse_us[SERVOS];
} servo_frame;

static tr_sim aircraft, started;
static tr_work work;
static tr_systems systems, started_systems;
static tr_imu imu;

static int failed(const char* what, tr_status status) {
  if (status == TR_OK) return 0;
  fprintf(stderr, "ardupilot: %s: %s (%s)\n", what, tr_status_word(status), tr_status_text(status));
  return 1;
}

/* ---- what it sends ---- */

static unsigned two_bytes(const unsigned char* at) { return at[0] | (unsigned)at[1] << 8; }

static int decode(const unsigned char* bytes, ssize_t length, servo_frame* frame) {
  const unsigned magic = length >= 8 ? two_bytes(bytes) : 0;
  int k;
  if (!(magic == MAGIC_16 && length == 8 + 2 * 16) && !(magic == MAGIC_32 && length == 8 + 2 * 32)) return 0;
  frame->rate = two_bytes(bytes + 2);
  frame->count = two_bytes(bytes + 4) | (uint32_t)two_bytes(bytes + 6) << 16;
  for (k = 0; k < SERVOS; ++k) frame->pulse_us[k] = two_bytes(bytes + 8 + 2 * k);
  return 1;
}

/* -1..1 between 1000 and 2000 us. */
static tr_real part(unsigned pulse_us) {
  const double x = ((double)pulse_us - 1500) / 500;
  return (tr_real)(x < -1 ? -1 : x > 1 ? 1 : x);
}

static tr_status command(const servo_frame* frame) {
  const tr_real stick_in = (tr_real)4.8, pedal_in = (tr_real)2.5;
  const unsigned* pulse = frame->pulse_us;
  const tr_systems before = systems;
  tr_state s;
  tr_status status = tr_get_state(&aircraft, &s);
  if (status != TR_OK) return status;
  if (pulse[0] > 0) s.u[TR_LAT_STICK] = stick_in * part(pulse[0]);
  if (pulse[1] > 0) s.u[TR_LONG_STICK] = -stick_in * part(pulse[1]);
  if (pulse[2] > 0) systems.throttle[0] = systems.throttle[1] = (1 + part(pulse[2])) / 2;
  if (pulse[3] > 0) s.u[TR_PEDAL] = pedal_in * part(pulse[3]);
  if (pulse[4] > 0) systems.mast_command_deg = 45 * (1 + part(pulse[4]));
  systems.brake[0] = systems.brake[1] = 0;
  if ((status = tr_set_controls(&aircraft, s.u, TR_PEDAL + 1)) != TR_OK) return status;
  if (memcmp(&before, &systems, sizeof systems) == 0) return TR_OK;
  return tr_set_systems(&aircraft, &systems);
}

/* One frame, in as many steps as keep each within 5 ms. */
static tr_status fly(const servo_frame* frame) {
  const unsigned rate = frame->rate < 50 ? 50 : frame->rate;
  const unsigned steps = (200 + rate - 1) / rate;
  tr_status status = command(frame);
  unsigned k;
  for (k = 0; k < steps && status == TR_OK; ++k)
    status = tr_step(&aircraft, &work, (tr_real)1 / (tr_real)(rate * steps));
  if (status == TR_OK) status = tr_read_imu(&aircraft, &imu, (tr_real)1 / (tr_real)rate);
  return status;
}

/* ---- what it gets ---- */

static int put_list(char* text, const char* name, const double* numbers, int count) {
  int k, length = sprintf(text, "\"%s\":[", name);
  for (k = 0; k < count; ++k)
    length += sprintf(text + length, "%.12g%s", numbers[k], k + 1 < count ? "," : "]");
  return length;
}

static tr_status answer(char* text, int* length) {
  double gyro[3], force[3], velocity[3], quaternion[4];
  tr_state s;
  tr_motion motion;
  tr_real height;
  tr_status status;
  int k, n;
  if ((status = tr_get_state(&aircraft, &s)) != TR_OK ||
      (status = tr_motion_at(&aircraft, imu.station_m, &motion)) != TR_OK ||
      (status = tr_radio_height_at(&aircraft, NULL, &height)) != TR_OK)
    return status;
  for (k = 0; k < 3; ++k) {
    gyro[k] = (double)imu.rates_radps[k].reading;
    force[k] = (double)imu.specific_force_mps2[k].reading;
    velocity[k] = (double)motion.velocity_ned_mps[k];
  }
  for (k = 0; k < 4; ++k) quaternion[k] = (double)motion.quaternion[k];
  n = sprintf(text, "\n{\"timestamp\":%.9f,\"imu\":{", s.time_s);
  n += put_list(text + n, "gyro", gyro, 3);
  text[n++] = ',';
  n += put_list(text + n, "accel_body", force, 3);
  n += sprintf(text + n, "},");
  n += put_list(text + n, "position", s.position_m, 3);
  text[n++] = ',';
  n += put_list(text + n, "quaternion", quaternion, 4);
  text[n++] = ',';
  n += put_list(text + n, "velocity", velocity, 3);
  n += sprintf(text + n, ",\"rng_1\":%.6g}\n", (double)(height > 0 ? height : 0));
  *length = n;
  return TR_OK;
}

/* ---- the link ---- */

static void restart(void) {
  aircraft = started;
  systems = started_systems;
  memset(&imu, 0, sizeof imu);
  imu.station_m[0] = (tr_real)7.65; /* m, about the centre of gravity */
  imu.station_m[2] = 2;
}

static int serve(int link, long frames) {
  unsigned char bytes[LONGEST_PACKET + 1];
  char text[1024];
  struct sockaddr_in from;
  servo_frame frame;
  uint32_t last = 0;
  long flown = 0;
  int length = 0, begun = 0;
  while (frames == 0 || flown < frames) {
    socklen_t size = sizeof from;
    const ssize_t received = recvfrom(link, bytes, sizeof bytes, 0, (struct sockaddr*)&from, &size);
    if (received < 0) return 1;
    if (!decode(bytes, received, &frame)) continue;
    if (!begun || frame.count < last) restart();
    if (!begun || frame.count != last) {
      if (failed("frame", fly(&frame))) restart();
      ++flown;
    }
    begun = 1;
    last = frame.count;
    if (failed("answer", answer(text, &length))) return 1;
    (void)!sendto(link, text, (size_t)length, 0, (struct sockaddr*)&from, size);
  }
  return 0;
}

int main(int count, char** words) {
  struct sockaddr_in here;
  socklen_t size = sizeof here;
  double hover_throttle;
  const char* where = "";
  long frames = 0;
  int port = 9002, k, link;
  tr_status status;
  for (k = 1; k + 1 < count; k += 2) {
    if (strcmp(words[k], "--port") == 0)
      port = atoi(words[k + 1]);
    else if (strcmp(words[k], "--frames") == 0)
      frames = atol(words[k + 1]);
    else
      break;
  }
  if (k < count || port < 0 || port > 65535 || frames < 0) {
    fprintf(stderr, "ardupilot: [--port 0..65535, 0: any] [--frames N, 0: for ever]\n");
    return 2;
  }
  status = start_on_ground(&started, &work, &started_systems, &hover_throttle, &where);
  if (failed(where, status)) return 1;
  memset(&here, 0, sizeof here);
  here.sin_family = AF_INET;
  here.sin_port = htons((unsigned short)port);
  here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  link = socket(AF_INET, SOCK_DGRAM, 0);
  if (link < 0 || bind(link, (struct sockaddr*)&here, sizeof here) != 0 ||
      getsockname(link, (struct sockaddr*)&here, &size) != 0) {
    perror("ardupilot");
    return 1;
  }
  printf("listening on 127.0.0.1 port %d\n", ntohs(here.sin_port));
  fflush(stdout);
  return serve(link, frames);
}
