#include "page/page.h"

#include "firmware/reference_flight.h"
#include "page/component_forces.h"

static tr_sim sims[PAGE_AIRCRAFT];
static tr_work work;

static tr_real setup_numbers[6], system_numbers[17], environment_numbers[4];
static tr_state state;
static tr_outputs outputs;
static tr_configuration configuration;
static tr_real a[TR_MAX_LINEAR_STATES * TR_MAX_LINEAR_STATES];
static tr_real b[TR_MAX_LINEAR_STATES * TR_INPUTS];
static tr_real mode_numbers[TR_MAX_LINEAR_STATES * 5];
static tr_real state_places[TR_MAX_LINEAR_STATES], control_places[TR_INPUTS];
static tr_real forces[3 * COMPONENTS];
static tr_mode modes[TR_MAX_LINEAR_STATES];
static tr_linear_shape shape;
static size_t mode_count;

static char text[8192];
static size_t text_length;

static void write_text(const char* more) {
  while (*more != '\0' && text_length + 1 < sizeof text) text[text_length++] = *more++;
  text[text_length] = '\0';
}

static void begin_text(const char* first) {
  text_length = 0;
  write_text(first);
}

tr_real* page_array(int32_t which) {
  tr_real* const place[PAGE_ARRAYS] = {setup_numbers,
                                       system_numbers,
                                       environment_numbers,
                                       state.x,
                                       state.u,
                                       &outputs.time_s,
                                       &configuration.mast_deg,
                                       a,
                                       b,
                                       mode_numbers,
                                       state_places,
                                       control_places,
                                       forces};
  return which >= 0 && which < PAGE_ARRAYS ? place[which] : (tr_real*)0;
}

char* page_text(void) { return text; }

int32_t page_begin(int32_t aircraft) {
  tr_setup setup;
  tr_real* const field[6] = {&setup.mast_deg, &setup.flap_deg,     &setup.altitude_m,
                             &setup.mass_kg,  &setup.cg_station_m, &setup.rotor_radps};
  const tr_status status = tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), setup_numbers[0]);
  int k;
  begin_text("");
  if (status != TR_OK) return status;
  for (k = 1; k < 6; ++k)
    if (setup_numbers[k] >= 0 || k == 2) *field[k] = setup_numbers[k];
  if (tr_check_setup(&setup, TR_API_VERSION, text, sizeof text) != TR_OK) return TR_OUT_OF_RANGE;
  return tr_init(&sims[aircraft], TR_API_VERSION, &setup);
}

int32_t page_trim(int32_t aircraft, tr_real speed_mps) {
  tr_trim_result result;
  tr_flight flight;
  tr_status status;
  flight.speed_mps = speed_mps;
  flight.climb_rad = flight.turn_rate_radps = flight.sideslip_rad = 0;
  result.text[0] = '\0';
  status = tr_trim(&sims[aircraft], &work, &flight, &result);
  begin_text(result.text);
  return status;
}

int32_t page_set_systems(int32_t aircraft) {
  tr_systems systems;
  const tr_real* const n = system_numbers;
  const tr_status status = tr_get_systems(&sims[aircraft], &systems);
  if (status != TR_OK) return status;
  systems.governor = (int32_t)n[0];
  systems.conversion = (int32_t)n[1];
  systems.engines = (int32_t)n[2];
  systems.actuators = (int32_t)n[3];
  systems.scas = (int32_t)n[4];
  systems.gear = (int32_t)n[5];
  systems.ground_effect = (int32_t)n[6];
  systems.turbulence = (int32_t)n[7];
  systems.mast_command_deg = n[8];
  systems.flap_command_deg = n[9];
  systems.rotor_command_radps = n[10];
  systems.throttle[0] = n[11];
  systems.throttle[1] = n[12];
  systems.gear_down = (int32_t)n[13];
  systems.turbulence_seed = (uint64_t)n[14];
  systems.turbulence_w20_mps = n[15];
  systems.interconnect = (int32_t)n[16];
  return tr_set_systems(&sims[aircraft], &systems);
}

static void look_at_systems(const tr_systems* systems) {
  tr_real* const n = system_numbers;
  n[0] = systems->governor;
  n[1] = systems->conversion;
  n[2] = systems->engines;
  n[3] = systems->actuators;
  n[4] = systems->scas;
  n[5] = systems->gear;
  n[6] = systems->ground_effect;
  n[7] = systems->turbulence;
  n[8] = systems->mast_command_deg;
  n[9] = systems->flap_command_deg;
  n[10] = systems->rotor_command_radps;
  n[11] = systems->throttle[0];
  n[12] = systems->throttle[1];
  n[13] = systems->gear_down;
  n[14] = (tr_real)systems->turbulence_seed;
  n[15] = systems->turbulence_w20_mps;
  n[16] = systems->interconnect;
}

int32_t page_set_environment(int32_t aircraft) {
  tr_environment environment;
  int k;
  tr_default_environment(&environment);
  for (k = 0; k < 3; ++k) environment.wind_mps[k] = environment_numbers[k];
  environment.altitude_origin_m = environment_numbers[3];
  environment.ground_down_m = 0;
  return tr_set_environment(&sims[aircraft], &environment);
}

int32_t page_set_height(int32_t aircraft, tr_real height_m) {
  const tr_status status = tr_get_state(&sims[aircraft], &state);
  if (status != TR_OK) return status;
  state.x[TR_DOWN] = -height_m;
  state.position_m[2] = -(double)height_m;
  return tr_set_state(&sims[aircraft], &state);
}

int32_t page_set_controls(int32_t aircraft) {
  uint32_t clipped;
  const tr_status status = tr_saturate_controls(&sims[aircraft], state.u, 4, &clipped);
  return status == TR_OK ? tr_get_state(&sims[aircraft], &state) : status;
}

int32_t page_step(int32_t aircraft, tr_real dt) { return tr_step(&sims[aircraft], &work, dt); }

int32_t page_look(int32_t aircraft) {
  tr_systems systems;
  tr_status status = tr_get_state(&sims[aircraft], &state);
  if (status == TR_OK) status = tr_get_systems(&sims[aircraft], &systems);
  if (status == TR_OK) look_at_systems(&systems);
  if (status == TR_OK) status = tr_get_configuration(&sims[aircraft], &configuration);
  if (status == TR_OK) status = tr_get_outputs(&sims[aircraft], &outputs);
  return status;
}

uint32_t page_flags(int32_t aircraft) {
  uint32_t flags = 0;
  return tr_get_flags(&sims[aircraft], &flags) == TR_OK ? flags : 0;
}

int32_t page_component_forces(int32_t aircraft) { return component_forces(&sims[aircraft], forces); }
const char* page_component_name(int32_t component) { return component_name(component); }

int32_t page_linearize(int32_t aircraft, int32_t columns) {
  tr_status status = tr_linearize(&sims[aircraft], &work, columns, &shape, a, sizeof a / sizeof a[0], b,
                                  sizeof b / sizeof b[0]);
  int32_t k;
  mode_count = 0;
  if (status != TR_OK) return status;
  status = tr_modes(&work, &shape, a, sizeof a / sizeof a[0], modes, TR_MAX_LINEAR_STATES, &mode_count);
  if (status != TR_OK) mode_count = 0;
  for (k = 0; k < (int32_t)mode_count; ++k) {
    tr_real* const to = mode_numbers + 5 * k;
    to[0] = modes[k].real;
    to[1] = modes[k].imag;
    to[2] = modes[k].frequency_radps;
    to[3] = modes[k].damping_ratio;
    to[4] = modes[k].time_to_half_s;
  }
  for (k = 0; k < shape.states; ++k) state_places[k] = shape.state[k];
  for (k = 0; k < shape.controls; ++k) control_places[k] = shape.control[k];
  return status;
}

int32_t page_states(void) { return shape.states; }
int32_t page_controls(void) { return shape.controls; }
int32_t page_modes(void) { return (int32_t)mode_count; }
const char* page_mode_name(int32_t mode) {
  return mode >= 0 && mode < (int32_t)mode_count ? modes[mode].name : "";
}

int32_t page_reference_flight(int32_t frames) {
  begin_text("");
  return reference_flight(write_text, frames);
}

const char* page_state_name(int32_t place) { return tr_state_name(place); }
const char* page_control_name(int32_t place) { return tr_control_name(place); }
const char* page_status_text(int32_t status) { return tr_status_text(status); }
const char* page_status_word(int32_t status) { return tr_status_word(status); }
const char* page_version(void) { return tr_version(); }

const char* page_fault(int32_t aircraft) {
  tr_fault fault;
  if (tr_last_fault(&sims[aircraft], &fault) != TR_OK || fault.state < 0) return "";
  return tr_state_name(fault.state);
}
