/* Names for the linker of a library in single precision; tiltrotor.h includes it. */
#ifndef TILTROTOR_SINGLE_PRECISION_NAMES_H
#define TILTROTOR_SINGLE_PRECISION_NAMES_H

#define tr_default_setup tr_default_setup_single
#define tr_init tr_init_single
#define tr_check_setup tr_check_setup_single
#define tr_aircraft_at tr_aircraft_at_single
#define tr_aircraft_name tr_aircraft_name_single
#define tr_aircraft_description tr_aircraft_description_single
#define tr_trim tr_trim_single
#define tr_step tr_step_single
#define tr_sim_size tr_sim_size_single
#define tr_work_size tr_work_size_single
#define tr_set_controls tr_set_controls_single
#define tr_get_state tr_get_state_single
#define tr_set_state tr_set_state_single
#define tr_derivative tr_derivative_single
#define tr_get_outputs tr_get_outputs_single
#define tr_linearize tr_linearize_single
#define tr_linearize_and_step tr_linearize_and_step_single
#define tr_status_word tr_status_word_single
#define tr_status_text tr_status_text_single
#define tr_state_name tr_state_name_single
#define tr_state_unit tr_state_unit_single
#define tr_control_name tr_control_name_single
#define tr_control_unit tr_control_unit_single
#define tr_version tr_version_single
#define tr_save tr_save_single
#define tr_load_saved tr_load_saved_single

#endif
