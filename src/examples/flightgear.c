/* Shows a flight in FlightGear: sends its native flight dynamics packet.
 *
 *   cc flightgear.c rig_text.c ground_start.c $(pkg-config --cflags --libs tiltrotor) -o flightgear
 *   fgfs --fdm=external --native-fdm=socket,in,60,,5500,udp &
 *   flightgear [--port 5500] [--seconds 20] [--fast] hop.txt
 *
 * The packet FGNetFDM, version 24 (src/Network/net_fdm.hxx of FlightGear): 408 bytes, every number big-endian, u: unsigned
 * and i: signed integers, f: floats of 4 bytes, d: floats of 8.
 *     0 u version 24, u padding | 8 d longitude, latitude (rad), altitude (m) | 32 f height above ground (m)
 *    36 f roll, pitch, heading, angle of attack, sideslip (rad) | 56 f rates of roll, pitch, heading (rad/s)
 *    68 f calibrated airspeed (kt), climb rate (ft/s) | 76 f velocity north, east, down (ft/s) | 88 f along the body (ft/s)
 *   100 f acceleration along the body at the pilot (ft/s^2) | 112 f stall warning 0..1, slip ball (deg)
 *   120 u engines, u[4] state: 2 runs | 140 f[4] each: rpm, fuel flow, fuel pressure, EGT, CHT, manifold pressure, TIT,
 *       oil temperature, oil pressure | 284 u tanks, f[4] fuel | 304 u wheels, u[3] weight on wheels, f[3] each: position
 *       0..1, steering, compression | 356 u time (s since 1970), i offset to it (s), f visibility (m)
 *   368 f -1..1: elevator, its tab, left and right flap, left and right aileron, rudder, nose wheel, speed brake, spoilers */
#define _POSIX_C_SOURCE 200809L
#include <arpa/inet.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>

#include "ground_start.h"
#include "rig_text.h"

enum { PACKET = 408, RATE = 240, FRAMES_A_PACKET = 4 }; /* 60 packets a second */
static const double degree = 0.017453292519943295, foot = 0.3048, knot = 0.514444444444444;

static tr_sim aircraft;
static tr_work work;

/* ---- the packet ---- */

typedef struct packet {
  unsigned char bytes[PACKET];
  size_t used;
} packet;

static void put_bits(packet* p, uint64_t bits, int bytes) {
  for (; bytes > 0; --bytes) p->bytes[p->used++] = (unsigned char)(bits >> (8 * (bytes - 1)));
}
static void put_integer(packet* p, uint32_t number) { put_bits(p, number, 4); }
static void put_float(packet* p, double number) {
  const float single = (float)number;
  uint32_t bits;
  memcpy(&bits, &single, sizeof bits);
  put_bits(p, bits, 4);
}
static void put_double(packet* p, double number) {
  uint64_t bits;
  memcpy(&bits, &number, sizeof bits);
  put_bits(p, bits, 8);
}
static void put_floats(packet* p, const tr_real* numbers, int count, double unit) {
  int k;
  for (k = 0; k < count; ++k) put_float(p, (double)numbers[k] / unit);
}
static void put_zeros(packet* p, int count) {
  for (; count > 0; --count) put_integer(p, 0);
}

/* What the visual sees of a number. */
static double single(double number) { return (double)(float)number; }

/* The aircraft as it is now; prints a part of it, as peer.c prints what arrives. */
static tr_status fill(packet* p) {
  const tr_geodetic origin = {37.415 * degree, -122.048 * degree, 0};
  const tr_real eye[3] = {3, 0, 2}; /* station of the pilot, about */
  tr_state s;
  tr_real rates[TR_STATES], height;
  tr_geodetic place;
  tr_motion motion;
  tr_air_data air;
  tr_outputs outputs;
  tr_configuration now;
  tr_systems systems;
  uint32_t flags;
  tr_status status;
  int k;
  if ((status = tr_get_state(&aircraft, &s)) != TR_OK ||
      (status = tr_derivative(&aircraft, rates, TR_STATES)) != TR_OK ||
      (status = tr_geodetic_at(&origin, s.position_m, &place)) != TR_OK ||
      (status = tr_radio_height_at(&aircraft, NULL, &height)) != TR_OK ||
      (status = tr_motion_at(&aircraft, eye, &motion)) != TR_OK ||
      (status = tr_air_data_at(&aircraft, eye, &air)) != TR_OK ||
      (status = tr_get_outputs(&aircraft, &outputs)) != TR_OK ||
      (status = tr_get_configuration(&aircraft, &now)) != TR_OK ||
      (status = tr_get_systems(&aircraft, &systems)) != TR_OK ||
      (status = tr_get_flags(&aircraft, &flags)) != TR_OK)
    return status;
  p->used = 0;
  put_integer(p, 24);
  put_integer(p, 0);
  put_double(p, place.longitude_rad);
  put_double(p, place.latitude_rad);
  put_double(p, place.height_m);
  put_float(p, (double)height);
  put_floats(p, s.x + TR_ROLL, 3, 1);
  put_float(p, (double)air.alpha_rad);
  put_float(p, (double)air.beta_rad);
  put_floats(p, rates + TR_ROLL, 3, 1);
  put_float(p, (double)air.cas_mps / knot);
  put_float(p, -(double)motion.velocity_ned_mps[2] / foot);
  put_floats(p, motion.velocity_ned_mps, 3, foot);
  put_floats(p, motion.velocity_air_mps, 3, foot);
  put_floats(p, motion.specific_force_mps2, 3, foot);
  put_zeros(p, 2);
  put_integer(p, 2);
  for (k = 0; k < 4; ++k) put_integer(p, k < 2 && !systems.engine_failed[k] ? 2 : 0);
  for (k = 0; k < 4; ++k)
    put_float(p, k < 2 ? (double)now.rotor_radps / (6 * degree) : 0); /* of the rotors */
  put_zeros(p, 32);
  put_zeros(p, 5);
  put_integer(p, 3);
  for (k = 0; k < 3; ++k) put_integer(p, (flags & TR_ON_GROUND) != 0);
  for (k = 0; k < 3; ++k) put_float(p, (double)s.x[TR_GEAR]);
  put_zeros(p, 6);
  put_integer(p, (uint32_t)time(NULL));
  put_integer(p, 0);
  put_float(p, 20000);
  put_float(p, (double)outputs.elevator_rad / (20 * degree));
  put_float(p, 0);
  for (k = 0; k < 2; ++k) put_float(p, (double)now.flap_deg / 75);
  for (k = 0; k < 2; ++k) put_float(p, (k == 0 ? -1 : 1) * (double)outputs.aileron_rad / (20 * degree));
  put_float(p, (double)outputs.rudder_rad / (20 * degree));
  put_zeros(p, 3);
  if (p->used != PACKET) return TR_SHORT_BUFFER;
  printf("%.9f %.9f %.4f %.4f %.6f %.6f %.6f %.4f %.4f %.2f %u\n", place.longitude_rad, place.latitude_rad,
         place.height_m, single(height), single(s.x[TR_ROLL]), single(s.x[TR_PITCH]), single(s.x[TR_YAW]),
         single((double)motion.velocity_ned_mps[0] / foot),
         single((double)motion.specific_force_mps2[2] / foot), single((double)now.rotor_radps / (6 * degree)),
         (unsigned)((flags & TR_ON_GROUND) != 0));
  return TR_OK;
}

/* ---- flight ---- */

static int failed(const char* what, tr_status status) {
  if (status == TR_OK) return 0;
  fprintf(stderr, "flightgear: %s: %s (%s)\n", what, tr_status_word(status), tr_status_text(status));
  return 1;
}

static int fly(int to, double seconds, int fast, tr_systems* systems) {
  const long period_ns = 1000000000L / RATE * FRAMES_A_PACKET;
  const long frames = (long)(seconds * RATE + 0.5);
  static packet p;
  struct timespec due;
  long frame;
  clock_gettime(CLOCK_MONOTONIC, &due);
  for (frame = 0; frame < frames; ++frame) {
    take_script(&aircraft, systems, (double)frame / RATE);
    if (frame % FRAMES_A_PACKET == 0) {
      if (failed("packet", fill(&p))) return 1;
      (void)!send(to, p.bytes, PACKET, 0);
      due.tv_nsec += period_ns;
      due.tv_sec += due.tv_nsec / 1000000000L;
      due.tv_nsec %= 1000000000L;
      if (!fast) clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, NULL);
    }
    if (failed("step", tr_step(&aircraft, &work, (tr_real)1 / RATE))) return 1;
  }
  return 0;
}

int main(int count, char** words) {
  struct sockaddr_in visual;
  double seconds = 20, hover_throttle;
  int port = 5500, fast = 0, k, to;
  const char *script = NULL, *where = "";
  tr_systems systems;
  tr_status status;
  for (k = 1; k < count; ++k) {
    if (strcmp(words[k], "--fast") == 0)
      fast = 1;
    else if (strcmp(words[k], "--port") == 0 && k + 1 < count)
      port = atoi(words[++k]);
    else if (strcmp(words[k], "--seconds") == 0 && k + 1 < count)
      seconds = atof(words[++k]);
    else
      script = words[k];
  }
  if (script == NULL || port < 1 || port > 65535 || !(seconds >= 0 && seconds <= 1e6)) {
    fprintf(stderr, "flightgear: [--port 1..65535] [--seconds 0..1e6] [--fast] SCRIPT\n");
    return 2;
  }
  if (!read_script(script)) return 2;
  memset(&visual, 0, sizeof visual);
  visual.sin_family = AF_INET;
  visual.sin_port = htons((unsigned short)port);
  visual.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  to = socket(AF_INET, SOCK_DGRAM, 0);
  if (to < 0 || connect(to, (struct sockaddr*)&visual, sizeof visual) != 0) {
    perror("flightgear");
    return 1;
  }
  status = start_on_ground(&aircraft, &work, &systems, &hover_throttle, &where);
  return failed(where, status) || fly(to, seconds, fast, &systems);
}
