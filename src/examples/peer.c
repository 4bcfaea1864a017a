/* The other ends of the lines, for check.sh: written from the protocols alone, it shares nothing with the examples.
 *
 *   peer pilot      sends commands to a rig and looks at its sensors
 *   peer visual     takes the packets of flightgear.c and prints what is in them
 *   peer autopilot PORT    asks as ArduPilot's simulator does and looks at the answers
 * The first two print the port where they listen, `pilot` then the one where it will send to. */
#define _POSIX_C_SOURCE 200809L
#include <arpa/inet.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

static int wrong;
static void expect(int good, const char* what, double number) {
  if (good) return;
  printf("peer: %s: %g\n", what, number);
  wrong = 1;
}

static struct sockaddr_in loopback(int port) {
  struct sockaddr_in address;
  memset(&address, 0, sizeof address);
  address.sin_family = AF_INET;
  address.sin_port = htons((unsigned short)port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

/* A socket that waits up to `seconds` for a datagram, at any free port, which is printed. */
static int listening(int seconds) {
  const struct timeval patience = {seconds, 0};
  struct sockaddr_in address = loopback(0);
  socklen_t size = sizeof address;
  const int s = socket(AF_INET, SOCK_DGRAM, 0);
  if (s < 0 || bind(s, (struct sockaddr*)&address, sizeof address) != 0 ||
      getsockname(s, (struct sockaddr*)&address, &size) != 0 ||
      setsockopt(s, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience) != 0)
    exit(1);
  printf("port %d\n", ntohs(address.sin_port));
  fflush(stdout);
  return s;
}

static int connected(int port) {
  const struct sockaddr_in address = loopback(port);
  const int s = socket(AF_INET, SOCK_DGRAM, 0);
  if (s < 0 || connect(s, (const struct sockaddr*)&address, sizeof address) != 0) exit(1);
  return s;
}

/* ---- a rig ---- */

static int numbers_in(const char* text, double* numbers, int most) {
  char* end;
  int n;
  for (n = 0; n < most; ++n, text = end) {
    numbers[n] = strtod(text, &end);
    if (end == text) break;
  }
  return n;
}

/* Tilts the masts, and sends rubbish, while the aircraft stands; the sensors of a second and a half. */
static int pilot(void) {
  enum { NUMBERS = 29, SAMPLES = 300 };
  const char* const lines[] = {"mast 5", "mast 95", "nonsense 1", "throttle nan", "gear 3", "mast 6 flap 30"};
  const int from = listening(20), probe = listening(1);
  struct sockaddr_in address;
  socklen_t size = sizeof address;
  double now[NUMBERS + 1], last_time = 0;
  int to, k;
  getsockname(probe, (struct sockaddr*)&address, &size);
  close(probe); /* the rig takes this port */
  to = connected(ntohs(address.sin_port));
  for (k = 0; k < SAMPLES; ++k) {
    char text[2048];
    const ssize_t length = recv(from, text, sizeof text - 1, 0);
    if (length <= 0) break;
    text[length] = '\0';
    if (numbers_in(text, now, NUMBERS + 1) != NUMBERS) break;
    expect(now[0] > last_time, "time of the sensors goes back, s", now[0]);
    last_time = now[0];
    expect(fabs(sqrt(now[5] * now[5] + now[6] * now[6] + now[7] * now[7]) - 9.80665) < 0.5, "specific force",
           now[7]);
    expect(fabs(now[4]) < 0.3, "height of the wheels on the ground", now[4]);
    expect(fabs(now[1] - 37.415) < 1e-5 && fabs(now[2] + 122.048) < 1e-5, "place, deg", now[1]);
    if (k >= 20 && k % 20 == 0 && k / 20 <= 6)
      (void)!send(to, lines[k / 20 - 1], strlen(lines[k / 20 - 1]), 0);
  }
  expect(k == SAMPLES, "lines of sensors", k);
  expect(k == SAMPLES && now[23] > 4 && now[23] < 6.1, "mast, deg", now[23]);
  expect(k == SAMPLES && now[24] < 36, "flap, deg", now[24]);
  expect(k == SAMPLES && ((unsigned)now[28] & 64) != 0, "flags on the ground", now[28]);
  return wrong;
}

/* ---- a visual ---- */

static uint64_t big_endian(const unsigned char* at, int bytes) {
  uint64_t bits = 0;
  for (; bytes > 0; --bytes) bits = bits << 8 | *at++;
  return bits;
}
static double float_at(const unsigned char* packet, int place) {
  const uint32_t bits = (uint32_t)big_endian(packet + place, 4);
  float number;
  memcpy(&number, &bits, sizeof number);
  return (double)number;
}
static double double_at(const unsigned char* packet, int place) {
  const uint64_t bits = big_endian(packet + place, 8);
  double number;
  memcpy(&number, &bits, sizeof number);
  return number;
}

/* Every packet, until none comes for two seconds. */
static int visual(void) {
  const int from = listening(2);
  unsigned char p[1000];
  int packets = 0;
  ssize_t length;
  while ((length = recv(from, p, sizeof p, 0)) > 0 || packets == 0) {
    if (length <= 0) continue;
    ++packets;
    expect(length == 408, "bytes of a packet", (double)length);
    expect(big_endian(p, 4) == 24, "version", (double)big_endian(p, 4));
    printf("%.9f %.9f %.4f %.4f %.6f %.6f %.6f %.4f %.4f %.2f %u\n", double_at(p, 8), double_at(p, 16),
           double_at(p, 24), float_at(p, 32), float_at(p, 36), float_at(p, 40), float_at(p, 44),
           float_at(p, 76), float_at(p, 108), float_at(p, 140), (unsigned)big_endian(p + 308, 4));
    expect(big_endian(p + 120, 4) == 2 && big_endian(p + 304, 4) == 3, "engines", (double)p[123]);
    expect(float_at(p, 364) > 100, "visibility", float_at(p, 364));
    expect(big_endian(p + 356, 4) > 1600000000u, "time", (double)big_endian(p + 356, 4));
  }
  return wrong;
}

/* ---- an autopilot ---- */

typedef struct answer {
  double time, gyro[3], force[3], position[3], velocity[3], quaternion[4];
} answer;

static void list_in(const char* text, const char* name, double* numbers, int count) {
  const char* at = strstr(text, name);
  char* end;
  int k;
  at = at == NULL ? "" : strchr(at, ':') + 1;
  for (k = 0; k < count; ++k) {
    at += strspn(at, "[,");
    numbers[k] = strtod(at, &end);
    expect(end != at, name, k);
    at = end;
  }
}

static void ask(int link, unsigned magic, uint32_t frame, const unsigned* pulses, int servos) {
  unsigned char bytes[8 + 2 * 32];
  int k;
  bytes[0] = (unsigned char)magic, bytes[1] = (unsigned char)(magic >> 8);
  bytes[2] = 400 & 255, bytes[3] = 400 >> 8;
  for (k = 0; k < 4; ++k) bytes[4 + k] = (unsigned char)(frame >> (8 * k));
  for (k = 0; k < servos; ++k) {
    const unsigned pulse = k < 5 ? pulses[k] : 0;
    bytes[8 + 2 * k] = (unsigned char)pulse, bytes[9 + 2 * k] = (unsigned char)(pulse >> 8);
  }
  (void)!send(link, bytes, (size_t)(8 + 2 * servos), 0);
}

static answer hear(int link) {
  char text[4096];
  answer a;
  const ssize_t length = recv(link, text, sizeof text - 1, 0);
  memset(&a, 0, sizeof a);
  expect(length > 2, "no answer", (double)length);
  if (length <= 2) exit(1);
  text[length] = '\0';
  expect(text[0] == '\n' && text[length - 1] == '\n' && text[1] == '{' && text[length - 2] == '}',
         "a line of JSON between new lines", text[0]);
  list_in(text, "\"timestamp\"", &a.time, 1);
  list_in(text, "\"gyro\"", a.gyro, 3);
  list_in(text, "\"accel_body\"", a.force, 3);
  list_in(text, "\"position\"", a.position, 3);
  list_in(text, "\"velocity\"", a.velocity, 3);
  list_in(text, "\"quaternion\"", a.quaternion, 4);
  return a;
}

/* Two seconds with more and more power: position follows velocity, the aircraft becomes light and lifts off. */
static int autopilot(int port) {
  enum { FRAMES = 1600 };
  const struct timeval patience = {20, 0};
  const int link = connected(port);
  unsigned pulses[5] = {1500, 1500, 1400, 1500, 1000};
  double way[3] = {0, 0, 0};
  answer first, last, a;
  uint32_t frame;
  int k;
  setsockopt(link, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  ask(link, 4711, 1, pulses, 16); /* not of an autopilot: no answer */
  ask(link, 18458, 1, pulses, 16);
  first = last = hear(link);
  expect(fabs(first.time - 1 / 400.0) < 1e-9, "time after the first frame, s", first.time);
  expect(fabs(first.force[2] + 9.8) < 0.3, "specific force on the ground, m/s^2", first.force[2]);
  for (frame = 2; frame <= FRAMES; ++frame) {
    pulses[2] = frame < 800 ? 1400 + frame / 3 : 1670;
    ask(link, frame % 2 == 0 ? 18458 : 29569, frame, pulses, frame % 2 == 0 ? 16 : 32);
    a = hear(link);
    expect(fabs(a.time - frame / 400.0) < 1e-7, "time of a frame, s", a.time);
    for (k = 0; k < 3; ++k) way[k] += 0.5 * (a.velocity[k] + last.velocity[k]) * (a.time - last.time);
    last = a;
  }
  for (k = 0; k < 3; ++k)
    expect(fabs(last.position[k] - first.position[k] - way[k]) < 0.02, "way flown, m",
           last.position[k] - first.position[k] - way[k]);
  expect(last.position[2] < first.position[2] - 0.5, "lifted off, m down",
         last.position[2] - first.position[2]);
  for (way[0] = 0, k = 0; k < 4; ++k) way[0] += last.quaternion[k] * last.quaternion[k];
  expect(fabs(way[0] - 1) < 1e-9, "square of the quaternion", way[0]);
  ask(link, 18458, FRAMES, pulses, 16); /* again: nothing is flown */
  a = hear(link);
  expect(a.time == last.time && a.position[2] == last.position[2], "time of a repeated frame, s", a.time);
  pulses[2] = 1400;
  ask(link, 18458, 1, pulses, 16); /* a new start */
  a = hear(link);
  expect(a.time == first.time && a.position[2] == first.position[2], "time after a new start, s", a.time);
  return wrong;
}

int main(int count, char** words) {
  if (count == 2 && strcmp(words[1], "pilot") == 0) return pilot();
  if (count == 2 && strcmp(words[1], "visual") == 0) return visual();
  if (count == 3 && strcmp(words[1], "autopilot") == 0) return autopilot(atoi(words[2]));
  fprintf(stderr, "peer: pilot | visual | autopilot PORT\n");
  return 2;
}
