/* Calls every function that computes or opens an aircraft and prints its status. Plain C for any processor. */
#include <stdio.h>
#include <string.h>

#include "tiltrotor/sensors.h"
#include "tiltrotor/tiltrotor.h"

static tr_sim sim;
static tr_work work;
static tr_real matrix[TR_MAX_LINEAR_STATES * TR_MAX_LINEAR_STATES];

static void print(const char* name, tr_status status) {
  printf("%s %s\n", name, tr_status_word(status));
  fflush(stdout);
}

int main(void) {
  unsigned char saved[TR_SAVED_SIZE];
  const tr_real control = 0, one = 1, inputs[TR_INPUTS] = {0};
  tr_real real, imag, rates[TR_STATES];
  tr_setup setup;
  tr_flight flight;
  tr_state state;
  tr_outputs outputs;
  tr_linear_shape shape;
  tr_mode modes[TR_MAX_LINEAR_STATES];
  tr_configuration configuration;
  tr_environment environment;
  tr_load load;
  tr_systems systems;
  tr_fault fault;
  tr_mass mass;
  tr_motion motion;
  tr_air_data air;
  tr_geodetic place;
  tr_lag lag;
  tr_imu imu;
  tr_air_probe probe;
  uint32_t bits = 0;
  size_t used = 0;
  const size_t length = sizeof matrix / sizeof *matrix;
  memset(&setup, 0, sizeof setup);
  memset(&flight, 0, sizeof flight);
  memset(&state, 0, sizeof state);
  memset(&shape, 0, sizeof shape);
  memset(&configuration, 0, sizeof configuration);
  memset(&environment, 0, sizeof environment);
  memset(&load, 0, sizeof load);
  memset(saved, 0, sizeof saved);
  memset(&place, 0, sizeof place);
  memset(&lag, 0, sizeof lag);
  memset(&imu, 0, sizeof imu);
  memset(&probe, 0, sizeof probe);
  flight.speed_mps = 40;
  print("default_setup", tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), 0));
  print("check_setup", tr_check_setup(&setup, TR_API_VERSION, 0, 0));
  print("init", tr_init(&sim, TR_API_VERSION, &setup));
  print("set_controls", tr_set_controls(&sim, &control, 1));
  print("trim", tr_trim(&sim, &work, &flight, NULL));
  print("step", tr_step(&sim, &work, (tr_real)0.005));
  print("get_state", tr_get_state(&sim, &state));
  print("set_state", tr_set_state(&sim, &state));
  print("get_configuration", tr_get_configuration(&sim, &configuration));
  print("set_configuration", tr_set_configuration(&sim, &configuration));
  print("default_environment", tr_default_environment(&environment));
  print("set_environment", tr_set_environment(&sim, &environment));
  print("set_loads", tr_set_loads(&sim, &load, 1));
  print("default_systems", tr_default_systems(&systems));
  print("get_systems", tr_get_systems(&sim, &systems));
  print("set_systems", tr_set_systems(&sim, &systems));
  print("check_systems", tr_check_systems(&systems, TR_API_VERSION, 0, 0));
  print("check_environment", tr_check_environment(&environment, TR_API_VERSION, 0, 0));
  print("check_configuration", tr_check_configuration(&configuration, TR_API_VERSION, 0, 0));
  print("get_range", tr_get_range("u.pedal", rates, rates + 1));
  print("save", tr_save(&sim, saved, sizeof saved, &used));
  print("load_saved", tr_load_saved(&sim, TR_API_VERSION, saved, sizeof saved));
  print("derivative", tr_derivative(&sim, rates, TR_STATES));
  print("get_outputs", tr_get_outputs(&sim, &outputs));
  print("step_with_outputs", tr_step_with_outputs(&sim, &work, (tr_real)0.005, &outputs));
  print("saturate_controls", tr_saturate_controls(&sim, state.u, TR_CONTROLS, &bits));
  print("last_fault", tr_last_fault(&sim, &fault));
  print("get_flags", tr_get_flags(&sim, &bits));
  print("get_mass", tr_get_mass(&sim, &mass));
  print("motion_at", tr_motion_at(&sim, mass.cg_m, &motion));
  print("air_data_at", tr_air_data_at(&sim, mass.cg_m, &air));
  print("geodetic_at", tr_geodetic_at(&place, state.position_m, &place));
  print("radio_height_at", tr_radio_height_at(&sim, NULL, rates));
  print("wheel_heights", tr_wheel_heights(&sim, NULL, rates, NULL));
  print("step_lag", tr_step_lag(&lag, 1, (tr_real)0.005));
  print("read_imu", tr_read_imu(&sim, &imu, (tr_real)0.005));
  print("read_air_probe", tr_read_air_probe(&sim, &probe, (tr_real)0.005, &air));
  print("directional", tr_directional(&sim, &work, state.x, state.u, rates, &outputs));
  print("directional_inputs", tr_directional_inputs(&sim, &work, state.x, inputs, rates, &outputs));
  print("linearize_outputs", tr_linearize_outputs(&sim, &work, TR_INCEPTORS, matrix, length, NULL, 0));
  print("linearize", tr_linearize(&sim, &work, TR_INCEPTORS, &shape, matrix, length, NULL, 0));
  print("linearize_and_step",
        tr_linearize_and_step(&sim, &work, (tr_real)0.005, TR_INCEPTORS, &shape, matrix, length, NULL, 0));
  print("linearize_and_step_exponential",
        tr_linearize_and_step_exponential(&sim, &work, (tr_real)0.02, NULL, TR_INCEPTORS, &shape, matrix,
                                          length, NULL, 0));
  print("rigid_model",
        tr_rigid_model(&work, &shape, matrix, length, NULL, 0, &shape, matrix, length, NULL, 0));
  print("eigenvalues", tr_eigenvalues(&work, &one, 1, &real, &imag, 1));
  print("modes", tr_modes(&work, &shape, matrix, length, modes, TR_MAX_LINEAR_STATES, &used));
  return 0;
}
