/* Flies the aircraft in real time on a POSIX timer, as a hardware-in-the-loop rig does.
 *
 *   cc rig.c rig_text.c ground_start.c $(pkg-config --cflags --libs tiltrotor) -lrt -o rig
 *   rig [--rate HZ] [--seconds S] [--mast DEG] [--speed MPS] [--ground] [--udp PORT] [--script FILE] [--publish PORT]
 *       [--sensors PORT] [--record FILE] [--fast]
 *
 * Begins in trimmed level flight with the systems off, or with --ground on the wheels: every system on, rotors at speed and
 * carrying part of the weight, brakes set.
 * Inputs: lines of controls and commands (rig_text.h says which) on standard input, or datagrams with the same text at
 * 127.0.0.1:PORT. What arrived last before a frame acts in it; without input everything stays. With --fast there is no
 * timer, and every frame takes one line of input: so a recording replays. --script: lines with their times, as hop.txt.
 * Outputs: datagrams of text to 127.0.0.1:PORT at every frame, with --publish of the state, with --sensors of what
 * instruments read (sensor_line of rig_text.h).
 * --record: the inputs of every frame, exact (hexadecimal), in the format of the input: replay with
 *   rig --fast ... < FILE. The hash printed at the end is then the same, every time, on every machine.
 * At the end: frames, overruns (frames that began a period late), percentiles of wake-up latency and computing time. */
#define _POSIX_C_SOURCE 200809L
#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include "ground_start.h"
#include "rig_text.h"

enum { LINE = RIG_LINE, BUCKETS = 100000 };

typedef struct rig_options {
  double rate, seconds, mast_deg, speed_mps;
  int udp_port, publish_port, sensors_port, ground, fast;
  const char *record, *script;
} rig_options;

/* Times in microseconds, counted in fixed memory. */
typedef struct histogram {
  unsigned long count[BUCKETS];
  unsigned long total;
} histogram;

static tr_sim aircraft;
static tr_work work;
static tr_systems commanded;
static rig_sensors sensors;
static histogram latency, computing;
static volatile sig_atomic_t stopped;

static void stop(int signal_number) {
  (void)signal_number;
  stopped = 1;
}

static void add(histogram* h, double microseconds) {
  const double last = BUCKETS - 1;
  ++h->count[(int)(microseconds < 0 ? 0 : microseconds > last ? last : microseconds)];
  ++h->total;
}

static int percentile(const histogram* h, double part) {
  unsigned long sum = 0;
  int i;
  for (i = 0; i < BUCKETS - 1; ++i) {
    sum += h->count[i];
    if ((double)sum >= part * (double)h->total) break;
  }
  return i;
}

static void print_histogram(const char* name, const histogram* h) {
  printf("%s_us p50 %d p90 %d p99 %d p99.9 %d max %d\n", name, percentile(h, 0.5), percentile(h, 0.9),
         percentile(h, 0.99), percentile(h, 0.999), percentile(h, 1));
}

static double seconds_between(const struct timespec* from, const struct timespec* to) {
  return (double)(to->tv_sec - from->tv_sec) + 1e-9 * (double)(to->tv_nsec - from->tv_nsec);
}

static int failed(const char* what, tr_status status) {
  if (status == TR_OK) return 0;
  fprintf(stderr, "rig: %s: %s (%s)\n", what, tr_status_word(status), tr_status_text(status));
  return 1;
}

/* ---- options ---- */

static int usage(const char* word) {
  fprintf(stderr,
          "rig: bad option %s: [--rate 50..10000] [--seconds S] [--mast 0..90] [--speed 0..150] [--ground] "
          "[--udp PORT] [--script FILE] [--publish PORT] [--sensors PORT] [--record FILE] [--fast]\n",
          word);
  return 0;
}

static int number_within(const char* text, double low, double high, double* number) {
  char* end;
  *number = strtod(text, &end);
  return *text != '\0' && *end == '\0' && *number >= low && *number <= high;
}

static int read_options(int count, char** words, rig_options* o) {
  int i;
  double port;
  for (i = 1; i < count; ++i) {
    const char* word = words[i];
    const char* argument = i + 1 < count ? words[i + 1] : "";
    if (strcmp(word, "--fast") == 0)
      o->fast = 1;
    else if (strcmp(word, "--ground") == 0)
      o->ground = 1;
    else if (strcmp(word, "--rate") == 0 && number_within(argument, 50, 10000, &o->rate))
      ++i;
    else if (strcmp(word, "--seconds") == 0 && number_within(argument, 0, 1e6, &o->seconds))
      ++i;
    else if (strcmp(word, "--mast") == 0 && number_within(argument, 0, 90, &o->mast_deg))
      ++i;
    else if (strcmp(word, "--speed") == 0 && number_within(argument, 0, 150, &o->speed_mps))
      ++i;
    else if (strcmp(word, "--udp") == 0 && number_within(argument, 1, 65535, &port))
      o->udp_port = (int)port, ++i;
    else if (strcmp(word, "--publish") == 0 && number_within(argument, 1, 65535, &port))
      o->publish_port = (int)port, ++i;
    else if (strcmp(word, "--sensors") == 0 && number_within(argument, 1, 65535, &port))
      o->sensors_port = (int)port, ++i;
    else if (strcmp(word, "--script") == 0 && *argument != '\0')
      o->script = words[++i];
    else if (strcmp(word, "--record") == 0 && *argument != '\0')
      o->record = words[++i];
    else
      return usage(word);
  }
  return 1;
}

/* ---- input and output ---- */

static int loopback_socket(int port, int to_receive) {
  struct sockaddr_in address;
  const int s = socket(AF_INET, SOCK_DGRAM, 0);
  memset(&address, 0, sizeof address);
  address.sin_family = AF_INET;
  address.sin_port = htons((unsigned short)port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (s < 0 || (to_receive ? bind(s, (struct sockaddr*)&address, sizeof address)
                           : connect(s, (struct sockaddr*)&address, sizeof address)) != 0) {
    fprintf(stderr, "rig: 127.0.0.1:%d: %s\n", port, strerror(errno));
    return -1;
  }
  return s;
}

/* A line that the aircraft refuses, or that is none, changes nothing and is counted. */
static unsigned long refused;
static void take(const char* text) {
  if (!take_line(&aircraft, &commanded, text)) ++refused;
}

/* All that has arrived, without waiting; the last line wins. 0 at the end of the input. */
static int take_what_arrived(int descriptor, int datagrams) {
  static char text[LINE];
  static size_t length;
  struct pollfd ready = {descriptor, POLLIN, 0};
  int reads;
  for (reads = 0; reads < 64 && poll(&ready, 1, 0) > 0; ++reads) { /* a flood must not stop the clock */
    char* newline;
    ssize_t received;
    if (datagrams) length = 0;
    received = read(descriptor, text + length, sizeof text - 1 - length);
    if (received <= 0) return datagrams;
    length += (size_t)received;
    text[length] = '\0';
    if (datagrams) {
      take(text);
      continue;
    }
    while ((newline = strchr(text, '\n')) != NULL) {
      *newline = '\0';
      take(text);
      length -= (size_t)(newline + 1 - text);
      memmove(text, newline + 1, length + 1);
    }
    if (length == sizeof text - 1) length = 0, ++refused; /* no line is that long */
  }
  return 1;
}

static void publish(int descriptor, const tr_state* s) {
  char text[LINE];
  const int length =
      snprintf(text, sizeof text, "%.6f %.4f %.4f %.4f %.5f %.5f %.5f %.5f %.5f %.5f %.3f %.3f %.3f\n",
               s->time_s, (double)s->x[TR_U], (double)s->x[TR_V], (double)s->x[TR_W], (double)s->x[TR_P],
               (double)s->x[TR_Q], (double)s->x[TR_R], (double)s->x[TR_ROLL], (double)s->x[TR_PITCH],
               (double)s->x[TR_YAW], (double)s->x[TR_NORTH], (double)s->x[TR_EAST], (double)s->x[TR_DOWN]);
  if (length > 0) (void)!send(descriptor, text, (size_t)length, MSG_DONTWAIT); /* nobody listens: no matter */
}

static int sense(int descriptor, double period) {
  char text[LINE];
  if (failed("sensors", sensor_line(&aircraft, &sensors, (tr_real)period, text))) return 1;
  (void)!send(descriptor, text, strlen(text), MSG_DONTWAIT);
  return 0;
}

/* ---- flight ---- */

static int begin_in_trim(const rig_options* o) {
  tr_setup setup;
  tr_flight level = {0, 0, 0, 0};
  tr_trim_result result;
  tr_status status;
  level.speed_mps = (tr_real)o->speed_mps;
  if (failed("setup", tr_default_setup(&setup, TR_API_VERSION, TR_XV15, (tr_real)o->mast_deg))) return 0;
  if (failed("init", tr_init(&aircraft, TR_API_VERSION, &setup))) return 0;
  status = tr_trim(&aircraft, &work, &level, &result);
  if (status != TR_OK) fprintf(stderr, "rig: trim: %s\n", result.text);
  return status == TR_OK && !failed("systems", tr_get_systems(&aircraft, &commanded));
}

static int begin_on_ground(void) {
  const char* where = "";
  double hover_throttle;
  const tr_status status = start_on_ground(&aircraft, &work, &commanded, &hover_throttle, &where);
  if (failed(where, status)) return 0;
  printf("hover_throttle %.4f\n", hover_throttle);
  return 1;
}

/* Frame number `frame` of the clock; microseconds late. */
static double wait_for(const struct timespec* start, unsigned long frame, double period) {
  struct timespec due = *start, now;
  const double offset = (double)frame * period;
  const long long ns = start->tv_nsec + (long long)((offset - (double)(long)offset) * 1e9);
  due.tv_sec += (time_t)offset + (time_t)(ns / 1000000000);
  due.tv_nsec = (long)(ns % 1000000000);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, NULL) == EINTR && !stopped) {
  }
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1e6 * seconds_between(&due, &now);
}

static int fly(const rig_options* o, int input, int output, int sensed, FILE* log, uint64_t* hash) {
  const double period = 1 / o->rate;
  const unsigned long frames = (unsigned long)(o->seconds * o->rate + 0.5);
  unsigned long frame, overruns = 0;
  int open = 1, errors = 0;
  char line[LINE];
  tr_state state;
  tr_systems last = commanded;
  struct timespec start, before, after;
  clock_gettime(CLOCK_MONOTONIC, &start);
  for (frame = 0; frame < frames && !stopped && errors == 0; ++frame) {
    if (o->fast) {
      if (open && (open = fgets(line, sizeof line, stdin) != NULL)) take(line);
    } else {
      const double late = wait_for(&start, frame, period);
      add(&latency, late);
      if (late > 1e6 * period) ++overruns;
      if (open) open = take_what_arrived(input, o->udp_port > 0);
    }
    refused += take_script(&aircraft, &commanded, (double)frame * period);
    clock_gettime(CLOCK_MONOTONIC, &before);
    errors += failed("step", tr_step(&aircraft, &work, (tr_real)period));
    clock_gettime(CLOCK_MONOTONIC, &after);
    add(&computing, 1e6 * seconds_between(&before, &after));
    errors += failed("state", tr_get_state(&aircraft, &state));
    tr_hash(state.x, TR_STATES, hash);
    if (log != NULL) record_line(log, &state, &last, &commanded);
    last = commanded;
    if (output >= 0) publish(output, &state);
    if (sensed >= 0) errors += sense(sensed, period);
  }
  clock_gettime(CLOCK_MONOTONIC, &after);
  printf("frames %lu overruns %lu refused_inputs %lu errors %d\n", frame, overruns, refused, errors);
  printf("flown_s %.3f took_s %.3f\n", state.time_s, seconds_between(&start, &after));
  if (!o->fast) print_histogram("latency", &latency);
  print_histogram("computing", &computing);
  return errors;
}

int main(int count, char** words) {
  rig_options o = {200, 3, 0, 40, 0, 0, 0, 0, 0, NULL, NULL};
  uint64_t hash = TR_HASH_START;
  int input = STDIN_FILENO, output = -1, sensed = -1, errors;
  FILE* log = NULL;
  if (!read_options(count, words, &o)) return 2;
  signal(SIGINT, stop);
  signal(SIGTERM, stop);
  if (o.udp_port > 0 && (input = loopback_socket(o.udp_port, 1)) < 0) return 1;
  if (o.publish_port > 0 && (output = loopback_socket(o.publish_port, 0)) < 0) return 1;
  if (o.sensors_port > 0 && (sensed = loopback_socket(o.sensors_port, 0)) < 0) return 1;
  if (o.script != NULL && !read_script(o.script)) return 2;
  if (o.record != NULL && (log = fopen(o.record, "w")) == NULL) {
    fprintf(stderr, "rig: %s: %s\n", o.record, strerror(errno));
    return 1;
  }
  if (!(o.ground ? begin_on_ground() : begin_in_trim(&o))) return 1;
  if (failed("sensors", place_sensors(&aircraft, &sensors))) return 1;
  errors = fly(&o, input, output, sensed, log, &hash);
  if (log != NULL && fclose(log) != 0) errors = 1;
  printf("hash %016llx\n", (unsigned long long)hash);
  return errors != 0;
}
