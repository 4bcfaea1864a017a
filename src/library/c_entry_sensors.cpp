// The way into the sensors, as c_entry.cpp: a program that calls none links none of them.
#include "library/c_entry.hpp"
#include "tiltrotor/sensors.h"

namespace tiltrotor::c_interface::checked {

decltype(::tr_geodetic_at) tr_geodetic_at;
decltype(::tr_radio_height_at) tr_radio_height_at;
decltype(::tr_wheel_heights) tr_wheel_heights;
decltype(::tr_step_lag) tr_step_lag;
decltype(::tr_read_imu) tr_read_imu;
decltype(::tr_read_air_probe) tr_read_air_probe;

}  // namespace tiltrotor::c_interface::checked

using namespace tiltrotor::c_interface;

namespace {

tr_status processor_status() {
  return entry_status(tiltrotor::compiled_instructions, tiltrotor::processor_instructions());
}

}  // namespace

tr_status tr_geodetic_at(const tr_geodetic* origin, const double position_m[3], tr_geodetic* place) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_geodetic_at(origin, position_m, place) : status;
}

tr_status tr_radio_height_at(const tr_sim* sim, const tr_real station_m[3], tr_real* height_m) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_radio_height_at(sim, station_m, height_m) : status;
}

tr_status tr_wheel_heights(const tr_sim* sim, const tr_real* dx, tr_real height_m[3], tr_real dheight_m[3]) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_wheel_heights(sim, dx, height_m, dheight_m) : status;
}

tr_status tr_step_lag(tr_lag* lag, tr_real input, tr_real dt_s) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_step_lag(lag, input, dt_s) : status;
}

tr_status tr_read_imu(const tr_sim* sim, tr_imu* imu, tr_real dt_s) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_read_imu(sim, imu, dt_s) : status;
}

tr_status tr_read_air_probe(const tr_sim* sim, tr_air_probe* probe, tr_real dt_s, tr_air_data* indicated) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_read_air_probe(sim, probe, dt_s, indicated) : status;
}
