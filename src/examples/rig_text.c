/* The text that rig.c takes and gives: rig_text.h says its words. */
#include "rig_text.h"

#include <errno.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum { PILOT_CONTROLS = 4, SCRIPT_LINES = 500, SENSOR_NUMBERS = 29 };
static const double degree = 0.017453292519943295;
static const char blanks[] = " \t\r\n";

/* ---- commands ---- */

/* Members of tr_systems. */
typedef enum command_kind {
  SWITCH,
  NUMBER,
  BOTH /* numbers, of right and left */
} command_kind;
typedef struct command {
  const char* name;
  size_t place;
  command_kind kind;
} command;
static const command commands[] = {{"governor", offsetof(tr_systems, governor), SWITCH},
                                   {"conversion", offsetof(tr_systems, conversion), SWITCH},
                                   {"engines", offsetof(tr_systems, engines), SWITCH},
                                   {"actuators", offsetof(tr_systems, actuators), SWITCH},
                                   {"scas", offsetof(tr_systems, scas), SWITCH},
                                   {"gear_system", offsetof(tr_systems, gear), SWITCH},
                                   {"ground_effect", offsetof(tr_systems, ground_effect), SWITCH},
                                   {"turbulence", offsetof(tr_systems, turbulence), SWITCH},
                                   {"interconnect", offsetof(tr_systems, interconnect), SWITCH},
                                   {"wind_shear", offsetof(tr_systems, wind_shear), SWITCH},
                                   {"gear", offsetof(tr_systems, gear_down), SWITCH},
                                   {"failed_right", offsetof(tr_systems, engine_failed[0]), SWITCH},
                                   {"failed_left", offsetof(tr_systems, engine_failed[1]), SWITCH},
                                   {"mast", offsetof(tr_systems, mast_command_deg), NUMBER},
                                   {"flap", offsetof(tr_systems, flap_command_deg), NUMBER},
                                   {"rotor", offsetof(tr_systems, rotor_command_radps), NUMBER},
                                   {"wind_20_ft", offsetof(tr_systems, turbulence_w20_mps), NUMBER},
                                   {"throttle", offsetof(tr_systems, throttle), BOTH},
                                   {"brakes", offsetof(tr_systems, brake), BOTH},
                                   {"throttle_right", offsetof(tr_systems, throttle[0]), NUMBER},
                                   {"throttle_left", offsetof(tr_systems, throttle[1]), NUMBER},
                                   {"brake_right", offsetof(tr_systems, brake[0]), NUMBER},
                                   {"brake_left", offsetof(tr_systems, brake[1]), NUMBER}};
enum { COMMANDS = sizeof commands / sizeof *commands };

static double command_value(const tr_systems* s, const command* c) {
  const char* place = (const char*)s + c->place;
  return c->kind == SWITCH ? (double)*(const int32_t*)(const void*)place
                           : (double)*(const tr_real*)(const void*)place;
}

static int put_command(tr_systems* s, const command* c, double value) {
  void* place = (char*)s + c->place;
  if (c->kind == SWITCH) {
    if (value != 0 && value != 1 && value != 2) return 0;
    *(int32_t*)place = (int32_t)value;
    return 1;
  }
  ((tr_real*)place)[0] = (tr_real)value;
  if (c->kind == BOTH) ((tr_real*)place)[1] = (tr_real)value;
  return 1;
}

/* The command of this name, or NULL. */
static const command* find_command(const char* name, size_t length) {
  int k;
  for (k = 0; k < COMMANDS; ++k)
    if (strlen(commands[k].name) == length && strncmp(commands[k].name, name, length) == 0)
      return &commands[k];
  return NULL;
}

/* ---- lines ---- */

typedef struct line_content {
  tr_real u[PILOT_CONTROLS];
  size_t controls; /* 0 or all */
  tr_systems systems;
  int has_commands;
} line_content;

static int number_at(const char** text, double* number) {
  char* end;
  *number = strtod(*text, &end);
  if (end == *text) return 0;
  *text = end + strspn(end, blanks);
  return 1;
}

static int parse_line(const char* text, line_content* line) {
  double number;
  text += strspn(text, blanks);
  if (*text != '\0' && strchr("+-.0123456789", *text) != NULL)
    for (; line->controls < PILOT_CONTROLS; ++line->controls) {
      if (!number_at(&text, &number)) return 0;
      line->u[line->controls] = (tr_real)number;
    }
  while (*text != '\0') {
    const size_t length = strcspn(text, blanks);
    const command* c = find_command(text, length);
    text += length;
    text += strspn(text, blanks);
    if (c == NULL || !number_at(&text, &number) || !put_command(&line->systems, c, number)) return 0;
    line->has_commands = 1;
  }
  return 1;
}

int take_line(tr_sim* aircraft, tr_systems* commanded, const char* text) {
  const tr_sim before = *aircraft;
  line_content line;
  memset(&line, 0, sizeof line);
  line.systems = *commanded;
  if (!parse_line(text, &line)) return 0;
  if ((line.controls == 0 || tr_set_controls(aircraft, line.u, line.controls) == TR_OK) &&
      (!line.has_commands || tr_set_systems(aircraft, &line.systems) == TR_OK)) {
    *commanded = line.systems;
    return 1;
  }
  *aircraft = before;
  return 0;
}

void record_line(FILE* file, const tr_state* state, const tr_systems* before, const tr_systems* commanded) {
  int k;
  for (k = 0; k < PILOT_CONTROLS; ++k) fprintf(file, "%s%a", k == 0 ? "" : " ", (double)state->u[k]);
  for (k = 0; k < COMMANDS; ++k) {
    const double now = command_value(commanded, &commands[k]);
    if (commands[k].kind != BOTH && now != command_value(before, &commands[k]))
      fprintf(file, " %s %a", commands[k].name, now);
  }
  fputc('\n', file);
}

/* ---- scripts ---- */

static struct {
  double time_s;
  char text[RIG_LINE];
} script[SCRIPT_LINES];
static int script_lines, script_next;

static int add_script_line(char* line) {
  double time_s;
  const char* text = line;
  line[strcspn(line, "#")] = '\0';
  if (line[strspn(line, blanks)] == '\0') return 1;
  if (script_lines == SCRIPT_LINES || !number_at(&text, &time_s) || !(time_s >= 0 && time_s <= 1e9)) return 0;
  if (script_lines > 0 && time_s < script[script_lines - 1].time_s) return 0;
  script[script_lines].time_s = time_s;
  strcpy(script[script_lines++].text, text);
  return 1;
}

int read_script(const char* path) {
  char line[RIG_LINE];
  int number = 0, good = 1;
  FILE* file = fopen(path, "r");
  if (file == NULL) {
    fprintf(stderr, "rig: %s: %s\n", path, strerror(errno));
    return 0;
  }
  while (good && fgets(line, sizeof line, file) != NULL) {
    ++number;
    good = add_script_line(line);
  }
  fclose(file);
  if (!good)
    fprintf(stderr, "rig: %s:%d: not \"TIME_S LINE\" with a time that does not go back, or beyond %d lines\n",
            path, number, SCRIPT_LINES);
  return good;
}

unsigned long take_script(tr_sim* aircraft, tr_systems* commanded, double time_s) {
  const double rounding = 1e-9;
  unsigned long refused = 0;
  for (; script_next < script_lines && script[script_next].time_s <= time_s + rounding; ++script_next) {
    if (take_line(aircraft, commanded, script[script_next].text)) continue;
    fprintf(stderr, "rig: refused at %g s: %s", script[script_next].time_s, script[script_next].text);
    ++refused;
  }
  return refused;
}

/* ---- sensors ---- */

tr_status place_sensors(const tr_sim* aircraft, rig_sensors* sensors) {
  const tr_real of_imu = (tr_real)0.005, of_static = (tr_real)0.1, of_impact = (tr_real)0.05,
                of_vanes = (tr_real)0.02; /* time constants, s */
  tr_mass mass;
  const tr_status status = tr_get_mass(aircraft, &mass);
  int k;
  if (status != TR_OK) return status;
  memset(sensors, 0, sizeof *sensors);
  for (k = 0; k < 3; ++k) {
    sensors->imu.station_m[k] = sensors->probe.station_m[k] = mass.cg_m[k];
    sensors->imu.specific_force_mps2[k].time_constant_s = of_imu;
    sensors->imu.rates_radps[k].time_constant_s = of_imu;
  }
  sensors->probe.static_pa.time_constant_s = of_static;
  sensors->probe.impact_pa.time_constant_s = of_impact;
  sensors->probe.alpha_rad.time_constant_s = sensors->probe.beta_rad.time_constant_s = of_vanes;
  return TR_OK;
}

static double* put_vector(double* to, const tr_real* from, int count) {
  int k;
  for (k = 0; k < count; ++k) to[k] = (double)from[k];
  return to + count;
}

tr_status sensor_line(const tr_sim* aircraft, rig_sensors* sensors, tr_real dt_s, char* text) {
  const tr_geodetic origin = {37.415 * degree, -122.048 * degree, 0};
  double numbers[SENSOR_NUMBERS], *next = numbers;
  tr_state state;
  tr_geodetic place;
  tr_motion motion;
  tr_air_data air;
  tr_configuration now;
  tr_real height;
  uint32_t flags;
  tr_status status;
  int k, length = 0;
  if ((status = tr_get_state(aircraft, &state)) != TR_OK ||
      (status = tr_geodetic_at(&origin, state.position_m, &place)) != TR_OK ||
      (status = tr_radio_height_at(aircraft, NULL, &height)) != TR_OK ||
      (status = tr_read_imu(aircraft, &sensors->imu, dt_s)) != TR_OK ||
      (status = tr_read_air_probe(aircraft, &sensors->probe, dt_s, &air)) != TR_OK ||
      (status = tr_motion_at(aircraft, sensors->imu.station_m, &motion)) != TR_OK ||
      (status = tr_get_configuration(aircraft, &now)) != TR_OK ||
      (status = tr_get_flags(aircraft, &flags)) != TR_OK)
    return status;
  *next++ = state.time_s;
  *next++ = place.latitude_rad / degree;
  *next++ = place.longitude_rad / degree;
  *next++ = place.height_m;
  *next++ = (double)height;
  for (k = 0; k < 3; ++k) *next++ = (double)sensors->imu.specific_force_mps2[k].reading;
  for (k = 0; k < 3; ++k) *next++ = (double)sensors->imu.rates_radps[k].reading;
  next = put_vector(next, motion.quaternion, 4);
  next = put_vector(next, motion.velocity_ned_mps, 3);
  *next++ = (double)air.static_pa;
  *next++ = (double)air.impact_pa;
  *next++ = (double)air.cas_mps;
  *next++ = (double)air.alpha_rad;
  *next++ = (double)air.beta_rad;
  *next++ = (double)now.mast_deg;
  *next++ = (double)now.flap_deg;
  *next++ = (double)now.rotor_radps;
  next = put_vector(next, state.x + TR_POWER_RIGHT, 2);
  *next = (double)flags;
  for (k = 0; k < SENSOR_NUMBERS; ++k)
    length += snprintf(text + length, (size_t)(RIG_LINE - length), "%.12g%c", numbers[k],
                       k + 1 < SENSOR_NUMBERS ? ' ' : '\n');
  return TR_OK;
}
