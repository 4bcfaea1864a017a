// The way into every function that computes: past a processor that can run it. Compiled without -march, for
// compilers move arguments with any instruction before the first line of a function.
#include "library/c_entry.hpp"

namespace tiltrotor::c_interface::checked {

decltype(::tr_default_setup) tr_default_setup;
decltype(::tr_check_setup) tr_check_setup;
decltype(::tr_init) tr_init;
decltype(::tr_set_controls) tr_set_controls;
decltype(::tr_step) tr_step;
decltype(::tr_get_state) tr_get_state;
decltype(::tr_set_state) tr_set_state;
decltype(::tr_save) tr_save;
decltype(::tr_load_saved) tr_load_saved;
decltype(::tr_derivative) tr_derivative;
decltype(::tr_get_outputs) tr_get_outputs;
decltype(::tr_get_configuration) tr_get_configuration;
decltype(::tr_set_configuration) tr_set_configuration;
decltype(::tr_default_environment) tr_default_environment;
decltype(::tr_set_environment) tr_set_environment;
decltype(::tr_set_loads) tr_set_loads;
decltype(::tr_trim) tr_trim;
decltype(::tr_linearize) tr_linearize;
decltype(::tr_linearize_and_step) tr_linearize_and_step;
decltype(::tr_linearize_and_step_exponential) tr_linearize_and_step_exponential;
decltype(::tr_rigid_model) tr_rigid_model;
decltype(::tr_eigenvalues) tr_eigenvalues;
decltype(::tr_modes) tr_modes;
decltype(::tr_step_with_outputs) tr_step_with_outputs;
decltype(::tr_saturate_controls) tr_saturate_controls;
decltype(::tr_last_fault) tr_last_fault;
decltype(::tr_get_flags) tr_get_flags;
decltype(::tr_get_mass) tr_get_mass;
decltype(::tr_motion_at) tr_motion_at;
decltype(::tr_air_data_at) tr_air_data_at;
decltype(::tr_directional) tr_directional;
decltype(::tr_directional_inputs) tr_directional_inputs;
decltype(::tr_linearize_outputs) tr_linearize_outputs;
decltype(::tr_default_systems) tr_default_systems;
decltype(::tr_get_systems) tr_get_systems;
decltype(::tr_set_systems) tr_set_systems;

}  // namespace tiltrotor::c_interface::checked

using namespace tiltrotor::c_interface;

namespace {

tr_status processor_status() {
  return entry_status(tiltrotor::compiled_instructions, tiltrotor::processor_instructions());
}

}  // namespace

tr_status tr_default_setup(tr_setup* setup, uint32_t version, int32_t aircraft, tr_real mast_deg) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_default_setup(setup, version, aircraft, mast_deg) : status;
}

tr_status tr_check_setup(const tr_setup* setup, uint32_t version, char* text, size_t length) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_check_setup(setup, version, text, length) : status;
}

tr_status tr_init(tr_sim* sim, uint32_t version, const tr_setup* setup) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_init(sim, version, setup) : status;
}

tr_status tr_set_controls(tr_sim* sim, const tr_real* controls, size_t length) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_set_controls(sim, controls, length) : status;
}

tr_status tr_step(tr_sim* sim, tr_work* work, tr_real dt) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_step(sim, work, dt) : status;
}

tr_status tr_get_state(const tr_sim* sim, tr_state* state) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_get_state(sim, state) : status;
}

tr_status tr_set_state(tr_sim* sim, const tr_state* state) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_set_state(sim, state) : status;
}

tr_status tr_save(const tr_sim* sim, void* bytes, size_t length, size_t* used) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_save(sim, bytes, length, used) : status;
}

tr_status tr_load_saved(tr_sim* sim, uint32_t version, const void* bytes, size_t length) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_load_saved(sim, version, bytes, length) : status;
}

tr_status tr_derivative(const tr_sim* sim, tr_real* rates, size_t length) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_derivative(sim, rates, length) : status;
}

tr_status tr_get_outputs(const tr_sim* sim, tr_outputs* outputs) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_get_outputs(sim, outputs) : status;
}

tr_status tr_trim(tr_sim* sim, tr_work* work, const tr_flight* flight, tr_trim_result* result) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_trim(sim, work, flight, result) : status;
}

tr_status tr_linearize(const tr_sim* sim, tr_work* work, int32_t columns, tr_linear_shape* shape, tr_real* a,
                       size_t a_length, tr_real* b, size_t b_length) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_linearize(sim, work, columns, shape, a, a_length, b, b_length)
                         : status;
}

tr_status tr_linearize_and_step(tr_sim* sim, tr_work* work, tr_real dt, int32_t columns,
                                tr_linear_shape* shape, tr_real* a, size_t a_length, tr_real* b,
                                size_t b_length) {
  const tr_status status = processor_status();
  return status == TR_OK
             ? checked::tr_linearize_and_step(sim, work, dt, columns, shape, a, a_length, b, b_length)
             : status;
}

tr_status tr_linearize_and_step_exponential(tr_sim* sim, tr_work* work, tr_real dt,
                                            const tr_real* control_rates, int32_t columns,
                                            tr_linear_shape* shape, tr_real* a, size_t a_length, tr_real* b,
                                            size_t b_length) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_linearize_and_step_exponential(sim, work, dt, control_rates, columns,
                                                                      shape, a, a_length, b, b_length)
                         : status;
}

tr_status tr_rigid_model(tr_work* work, const tr_linear_shape* shape, const tr_real* a, size_t a_length,
                         const tr_real* b, size_t b_length, tr_linear_shape* reduced_shape,
                         tr_real* reduced_a, size_t reduced_a_length, tr_real* reduced_b,
                         size_t reduced_b_length) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_rigid_model(work, shape, a, a_length, b, b_length, reduced_shape,
                                                   reduced_a, reduced_a_length, reduced_b, reduced_b_length)
                         : status;
}

tr_status tr_eigenvalues(tr_work* work, const tr_real* a, size_t n, tr_real* real, tr_real* imag,
                         size_t length) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_eigenvalues(work, a, n, real, imag, length) : status;
}

tr_status tr_modes(tr_work* work, const tr_linear_shape* shape, const tr_real* a, size_t a_length,
                   tr_mode* modes, size_t capacity, size_t* count) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_modes(work, shape, a, a_length, modes, capacity, count) : status;
}

tr_status tr_get_configuration(const tr_sim* sim, tr_configuration* configuration) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_get_configuration(sim, configuration) : status;
}

tr_status tr_set_configuration(tr_sim* sim, const tr_configuration* configuration) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_set_configuration(sim, configuration) : status;
}

tr_status tr_default_environment(tr_environment* environment) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_default_environment(environment) : status;
}

tr_status tr_set_environment(tr_sim* sim, const tr_environment* environment) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_set_environment(sim, environment) : status;
}

tr_status tr_set_loads(tr_sim* sim, const tr_load* loads, size_t count) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_set_loads(sim, loads, count) : status;
}

tr_status tr_step_with_outputs(tr_sim* sim, tr_work* work, tr_real dt, tr_outputs* outputs) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_step_with_outputs(sim, work, dt, outputs) : status;
}

tr_status tr_saturate_controls(tr_sim* sim, const tr_real* controls, size_t length, uint32_t* clipped) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_saturate_controls(sim, controls, length, clipped) : status;
}

tr_status tr_last_fault(const tr_sim* sim, tr_fault* fault) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_last_fault(sim, fault) : status;
}

tr_status tr_get_flags(const tr_sim* sim, uint32_t* flags) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_get_flags(sim, flags) : status;
}

tr_status tr_get_mass(const tr_sim* sim, tr_mass* mass) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_get_mass(sim, mass) : status;
}

tr_status tr_motion_at(const tr_sim* sim, const tr_real station_m[3], tr_motion* motion) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_motion_at(sim, station_m, motion) : status;
}

tr_status tr_air_data_at(const tr_sim* sim, const tr_real station_m[3], tr_air_data* air) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_air_data_at(sim, station_m, air) : status;
}

tr_status tr_directional(const tr_sim* sim, tr_work* work, const tr_real* dx, const tr_real* du,
                         tr_real* dxdot, tr_outputs* doutputs) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_directional(sim, work, dx, du, dxdot, doutputs) : status;
}

tr_status tr_directional_inputs(const tr_sim* sim, tr_work* work, const tr_real* dx, const tr_real* du,
                                tr_real* dxdot, tr_outputs* doutputs) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_directional_inputs(sim, work, dx, du, dxdot, doutputs) : status;
}

tr_status tr_linearize_outputs(const tr_sim* sim, tr_work* work, int32_t columns, tr_real* c, size_t c_length,
                               tr_real* d, size_t d_length) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_linearize_outputs(sim, work, columns, c, c_length, d, d_length)
                         : status;
}

tr_status tr_default_systems(tr_systems* systems) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_default_systems(systems) : status;
}

tr_status tr_get_systems(const tr_sim* sim, tr_systems* systems) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_get_systems(sim, systems) : status;
}

tr_status tr_set_systems(tr_sim* sim, const tr_systems* systems) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_set_systems(sim, systems) : status;
}
