// The C interface: sensors of a rig.
#include "tiltrotor/sensors.h"

#include "library/c_outputs.hpp"
#include "tiltrotor/analysis/flight/air_data.hpp"
#include "tiltrotor/analysis/flight/geodetic.hpp"
#include "tiltrotor/analysis/flight/sensor_lag.hpp"
#include "tiltrotor/systems/landing_gear.hpp"

namespace tiltrotor::c_interface {

namespace {

constexpr double kFarthest = 1e6;                             // m, of a position from the origin of the plane
constexpr double kLowestOrigin = -1e4, kHighestOrigin = 1e5;  // m
constexpr R kLongestLag = 100, kLongestWait = 100;            // s

tr_status check_place(const tr_geodetic& origin, const double* position) {
  const double numbers[] = {origin.latitude_rad, origin.longitude_rad, origin.height_m,
                            position[0],         position[1],          position[2]};
  for (const double number : numbers)
    if (!is_finite(number)) return TR_NOT_FINITE;
  bool inside = std::fabs(origin.latitude_rad) <= 0.5 * kPi<double> &&
                std::fabs(origin.longitude_rad) <= kPi<double> &&
                is_within(origin.height_m, kLowestOrigin, kHighestOrigin);
  for (int k = 0; k < 3; ++k) inside = inside && std::fabs(position[k]) <= kFarthest;
  return inside ? TR_OK : TR_OUT_OF_RANGE;
}

// Vertical, of a point at an arm from the CG.
R height_of_point(const Sim& s, const Vec3<R>& arm) {
  const State<R> x = evaluated_state(s);
  const Rotation<R> to_body = earth_to_body(EulerAngles<R>{x.roll, x.pitch, x.yaw});
  return s.air.ground_down - (x.position.z + to_body.apply_inverse(arm).z);
}

// Lowest points of the extended wheels: stations, in the order of Strut.
struct Wheels {
  R station[strut_count][3];
};
Wheels extended_wheels() {
  const GearTables<R>& gear = aircraft_data<R>().gear;
  const R of_main = extended_waterline(gear, gear.main), of_nose = extended_waterline(gear, gear.nose);
  return {{{gear.nose.sl, gear.nose.bl, of_nose},
           {gear.main.sl, gear.main.bl, of_main},
           {gear.main.sl, -gear.main.bl, of_main}}};
}

R height_of_wheels(const Sim& s) {
  const Wheels wheels = extended_wheels();
  R least = height_of_point(s, arm_to(s, wheels.station[0]));
  for (int k = 1; k < strut_count; ++k)
    least = smaller_of(least, height_of_point(s, arm_to(s, wheels.station[k])));
  return least;
}

// Heights along a direction of states. Masts and fuel that are states move the CG.
void slopes_of_wheels(const Sim& s, const R* dx, R (&slope)[strut_count]) {
  using D = Dual<R, 1>;
  const Aircraft<R>& aircraft = aircraft_data<R>();
  const FlightSetup<R>& setup = s.configuration.setup;
  const SystemSwitches& on = s.systems.vehicle.on;
  const auto along = [](R number, R by) {
    D moved(number);
    moved.d.set(0, by);
    return moved;
  };
  const State<R> x = evaluated_state(s);
  const D mast = along(s.configuration.mast, on.conversion ? dx[TR_MAST] : R(0));
  const D mass = along(setup.mass, on.engines ? -dx[TR_FUEL] : R(0));
  const MassProperties<D> m = mass_properties(aircraft, D(mast * kDegPerRad<R>), sine_and_cosine(mast), mass,
                                              D(setup.sl_cg), D(setup.wl_cg), setup.options);
  const Rotation<D> to_body = earth_to_body(
      EulerAngles<D>{along(x.roll, dx[TR_ROLL]), along(x.pitch, dx[TR_PITCH]), along(x.yaw, dx[TR_YAW])});
  const Wheels wheels = extended_wheels();
  for (int k = 0; k < strut_count; ++k) {
    const R* const at = wheels.station[k];
    slope[k] = -dx[TR_DOWN] - to_body.apply_inverse(station_arm(m, at[0], at[1], at[2])).z.d.get(0);
  }
}

tr_status step(tr_lag& lag, R input, R dt) {
  const bool begins = lag.begun == 0;
  const R remembered[] = {begins ? R(0) : lag.reading, begins ? R(0) : lag.input};
  if (!is_finite(lag.time_constant_s) || !is_finite(input) || !is_finite(dt) || !all_finite(remembered, 2))
    return TR_NOT_FINITE;
  if (!is_within(lag.time_constant_s, R(0), kLongestLag) || !is_within(dt, R(0), kLongestWait))
    return TR_OUT_OF_RANGE;
  const R reading = begins ? input : lagged(lag.time_constant_s, lag.input, lag.reading, input, dt);
  if (!is_finite(reading)) return TR_NOT_FINITE;
  lag = {lag.time_constant_s, reading, input, 1};
  return TR_OK;
}

// The lags of an instrument, all or none.
struct Reading {
  tr_lag* lag;
  R input;
};
template <std::size_t N>
tr_status step_all(const Reading (&readings)[N], R dt) {
  tr_lag stepped[N];
  for (std::size_t k = 0; k < N; ++k) {
    stepped[k] = *readings[k].lag;
    const tr_status status = step(stepped[k], readings[k].input, dt);
    if (status != TR_OK) return status;
  }
  for (std::size_t k = 0; k < N; ++k) *readings[k].lag = stepped[k];
  return TR_OK;
}

}  // namespace

}  // namespace tiltrotor::c_interface

namespace tiltrotor::c_interface::checked {

tr_status tr_geodetic_at(const tr_geodetic* origin, const double position_m[3], tr_geodetic* place) {
  if (origin == nullptr || position_m == nullptr || place == nullptr) return TR_BAD_ARGUMENT;
  if (!is_ieee_arithmetic<double>()) return TR_BAD_ARITHMETIC;
  const tr_status possible = check_place(*origin, position_m);
  if (possible != TR_OK) return possible;
  const GeodeticPlace<double> from = {origin->latitude_rad, origin->longitude_rad, origin->height_m};
  const GeodeticPlace<double> at =
      geodetic_place(from, Vec3<double>{position_m[0], position_m[1], position_m[2]});
  *place = {at.latitude, at.longitude, at.height};
  return TR_OK;
}

tr_status tr_radio_height_at(const tr_sim* sim, const tr_real station_m[3], tr_real* height_m) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  const R reference[3] = {};
  const tr_status possible = check_station(station_m == nullptr ? reference : station_m, height_m);
  if (possible != TR_OK) return possible;
  const Sim& s = *opened(sim);
  *height_m = station_m == nullptr ? height_of_wheels(s) : height_of_point(s, arm_to(s, station_m));
  return TR_OK;
}

tr_status tr_wheel_heights(const tr_sim* sim, const tr_real* dx, tr_real height_m[3], tr_real dheight_m[3]) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (height_m == nullptr || (dx == nullptr) != (dheight_m == nullptr)) return TR_BAD_ARGUMENT;
  if (dx != nullptr && !all_finite(dx, TR_STATES)) return TR_NOT_FINITE;
  const Sim& s = *opened(sim);
  const Wheels wheels = extended_wheels();
  R slope[strut_count] = {};
  if (dx != nullptr) slopes_of_wheels(s, dx, slope);
  for (int k = 0; k < strut_count; ++k) {
    height_m[k] = height_of_point(s, arm_to(s, wheels.station[k]));
    if (dx != nullptr) dheight_m[k] = slope[k];
  }
  return TR_OK;
}

tr_status tr_step_lag(tr_lag* lag, tr_real input, tr_real dt_s) {
  if (lag == nullptr) return TR_BAD_ARGUMENT;
  if (!is_ieee_arithmetic<R>()) return TR_BAD_ARITHMETIC;
  return step(*lag, input, dt_s);
}

tr_status tr_read_imu(const tr_sim* sim, tr_imu* imu, tr_real dt_s) {
  if (imu == nullptr) return TR_BAD_ARGUMENT;
  tr_motion motion;
  const tr_status found = ::tr_motion_at(sim, imu->station_m, &motion);
  if (found != TR_OK) return found;
  tr_lag* const force = imu->specific_force_mps2;
  tr_lag* const rate = imu->rates_radps;
  const Reading readings[] = {{&force[0], motion.specific_force_mps2[0]}, {&rate[0], motion.rates_radps[0]},
                              {&force[1], motion.specific_force_mps2[1]}, {&rate[1], motion.rates_radps[1]},
                              {&force[2], motion.specific_force_mps2[2]}, {&rate[2], motion.rates_radps[2]}};
  return step_all(readings, dt_s);
}

tr_status tr_read_air_probe(const tr_sim* sim, tr_air_probe* probe, tr_real dt_s, tr_air_data* indicated) {
  if (probe == nullptr || indicated == nullptr) return TR_BAD_ARGUMENT;
  tr_air_data air;
  const tr_status found = ::tr_air_data_at(sim, probe->station_m, &air);
  if (found != TR_OK) return found;
  tr_air_probe read = *probe;
  const Reading readings[] = {{&read.static_pa, air.static_pa},
                              {&read.impact_pa, air.impact_pa},
                              {&read.alpha_rad, air.alpha_rad},
                              {&read.beta_rad, air.beta_rad}};
  const tr_status status = step_all(readings, dt_s);
  if (status != TR_OK) return status;
  const AirData<R> d = indicated_air_data(opened(sim)->configuration.air, read.static_pa.reading,
                                          larger_of(read.impact_pa.reading, R(0)));
  if (!is_finite(d.mach) || !is_finite(d.calibrated)) return TR_NOT_FINITE;
  *probe = read;
  *indicated = {d.static_pressure,      d.impact_pressure,    d.true_airspeed, d.calibrated, d.mach,
                read.alpha_rad.reading, read.beta_rad.reading};
  return TR_OK;
}

}  // namespace tiltrotor::c_interface::checked
