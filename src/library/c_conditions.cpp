// The C interface: what may change in flight beside state and controls.
#include <cmath>
#include <limits>

#include "library/c_ranges.hpp"
#include "library/c_state.hpp"
#include "library/c_systems.hpp"
#include "library/c_words.hpp"
#include "tiltrotor/analysis/flight/attitude.hpp"

namespace tiltrotor::c_interface {

namespace {

constexpr R kFarthestStation = R(1000);  // m

Vec3<R> vector(const R (&v)[3]) { return {v[0], v[1], v[2]}; }
void list(const Vec3<R>& v, R (&to)[3]) {
  to[0] = v.x;
  to[1] = v.y;
  to[2] = v.z;
}
bool within(const Vec3<R>& v, R most) {
  return std::fabs(v.x) <= most && std::fabs(v.y) <= most && std::fabs(v.z) <= most;
}

// The sum of loads, its moment about the origin of the stations. Stations count aft and up, body axes forward and
// down.
tr_status total_of(const tr_load* loads, std::size_t count, Loads<R>& total) {
  total = Loads<R>{};
  for (std::size_t k = 0; k < count; ++k) {
    const tr_load& load = loads[k];
    if (!all_finite(load.station_m, 3) || !all_finite(load.force_n, 3) || !all_finite(load.moment_nm, 3))
      return TR_NOT_FINITE;
    if (!within(vector(load.station_m), kFarthestStation)) return TR_OUT_OF_RANGE;
    const Vec3<R> arm_b = {-load.station_m[0], load.station_m[1], -load.station_m[2]};
    total = total + force_at(arm_b, vector(load.force_n));
    total.moment = total.moment + vector(load.moment_nm);
  }
  return within_limits(total) ? TR_OK : TR_OUT_OF_RANGE;
}

tr_status put_around(const Surroundings<R>& around, const AirOrigin& air, Sim& s) {
  Configuration<R> c;
  equipped(s, c);
  c.around = around;
  ConfigurationSetting<R> setting = c.setup;
  if (air.follows) setting.altitude = air.altitude - s.x.position.z;
  const Status status = reconfigure(setting, c);
  if (status != Status::ok) return translated(status);
  keep(c, s);
  s.air = air;
  s.systems.vehicle.air_follows = air.follows;
  s.systems.vehicle.altitude_origin = air.altitude;
  s.systems.vehicle.ground = {air.ground_down, R(0), R(0)};
  return TR_OK;
}

void get_configuration(const Sim& s, tr_configuration& to) {
  const FlightSetup<R>& setup = s.configuration.setup;
  to.mast_deg = setup.mast_deg;
  to.mast_rate_radps = setup.mast_rate;
  to.mast_acceleration_radps2 = setup.mast_acceleration;
  to.flap_deg = setup.flap_deg;
  to.rotor_radps = setup.rotor_speed;
  to.rotor_acceleration_radps2 = setup.rotor_acceleration;
  to.mass_kg = setup.mass;
  to.cg_station_m = setup.sl_cg;
  to.cg_waterline_m = setup.wl_cg;
}

tr_status put_configuration(const tr_configuration& from, Sim& s) {
  const R numbers[] = {from.mast_deg, from.mast_rate_radps, from.mast_acceleration_radps2,
                       from.flap_deg, from.rotor_radps,     from.rotor_acceleration_radps2,
                       from.mass_kg,  from.cg_station_m,    from.cg_waterline_m};
  if (!all_finite(numbers, sizeof numbers / sizeof numbers[0])) return TR_NOT_FINITE;
  Configuration<R> c;
  equipped(s, c);
  ConfigurationSetting<R> setting = c.setup;
  setting.mast_deg = from.mast_deg;
  setting.mast_rate = from.mast_rate_radps;
  setting.mast_acceleration = from.mast_acceleration_radps2;
  setting.flap_deg = from.flap_deg;
  setting.rotor_speed = from.rotor_radps;
  setting.rotor_acceleration = from.rotor_acceleration_radps2;
  setting.mass = from.mass_kg;
  setting.sl_cg = from.cg_station_m;
  setting.wl_cg = from.cg_waterline_m;
  State<R> x = s.x;
  const Status status = change_configuration(setting, c, x);
  if (status != Status::ok) return translated(status);
  R flat[state_count];
  flatten(x, flat);
  for (int i = 0; i < state_count; ++i)
    if (!(std::fabs(flat[i]) <= state_bound<R>(i))) return TR_OUT_OF_RANGE;
  s.x = x;
  keep(c, s);
  follow_configuration(s);
  return TR_OK;
}

}  // namespace

void keep(const Configuration<R>& c, Sim& s) {
  s.configuration = c;
  s.configuration.aircraft = nullptr;
}

bool within_limits(const Loads<R>& outside) {
  const LimitTables<R>& limits = aircraft_data<R>().limits;
  return within(outside.force, limits.outside_force) && within(outside.moment, limits.outside_moment);
}

void get_environment(const Sim& s, tr_environment& to) {
  const Surroundings<R>& around = s.configuration.around;
  list(around.wind_n, to.wind_mps);
  list(around.rotor_gust_b[right], to.gust_mps[TR_AT_RIGHT_ROTOR]);
  list(around.rotor_gust_b[left], to.gust_mps[TR_AT_LEFT_ROTOR]);
  list(around.wing_gust_b, to.gust_mps[TR_AT_WING]);
  list(around.tail_gust_b, to.gust_mps[TR_AT_TAIL]);
  list(around.gust_rates_b, to.gust_rates_radps);
  to.altitude_origin_m = s.air.altitude;
  to.temperature_offset_k = around.warmer;
  to.pressure_ratio = R(1) + around.pressure_above;
  to.ground_down_m = s.air.ground_down;
}

tr_status put_environment(const tr_environment& e, bool follows, Sim& s) {
  const tr_status possible = check_environment(e);
  if (possible != TR_OK) return possible;
  Surroundings<R> around = s.configuration.around;
  around.wind_n = vector(e.wind_mps);
  around.rotor_gust_b[right] = vector(e.gust_mps[TR_AT_RIGHT_ROTOR]);
  around.rotor_gust_b[left] = vector(e.gust_mps[TR_AT_LEFT_ROTOR]);
  around.wing_gust_b = vector(e.gust_mps[TR_AT_WING]);
  around.tail_gust_b = vector(e.gust_mps[TR_AT_TAIL]);
  around.gust_rates_b = vector(e.gust_rates_radps);
  around.warmer = e.temperature_offset_k;
  around.pressure_above = e.pressure_ratio - R(1);
  return put_around(around, {follows, e.altitude_origin_m, e.ground_down_m}, s);
}

tr_status put_loads(const Loads<R>& total, Sim& s) {
  Surroundings<R> around = s.configuration.around;
  around.outside = total;
  return put_around(around, s.air, s);
}

tr_status follow_air(Sim& s) { return s.air.follows ? put_around(s.configuration.around, s.air, s) : TR_OK; }

}  // namespace tiltrotor::c_interface

namespace tiltrotor::c_interface::checked {

tr_status tr_get_configuration(const tr_sim* sim, tr_configuration* configuration) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (configuration == nullptr) return TR_BAD_ARGUMENT;
  get_configuration(*opened(sim), *configuration);
  return TR_OK;
}

tr_status tr_set_configuration(tr_sim* sim, const tr_configuration* configuration) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (configuration == nullptr) return TR_BAD_ARGUMENT;
  return put_configuration(*configuration, *opened(sim));
}

tr_status tr_default_environment(tr_environment* environment) {
  if (environment == nullptr) return TR_BAD_ARGUMENT;
  *environment = tr_environment{};
  environment->pressure_ratio = R(1);
  environment->ground_down_m = std::numeric_limits<R>::infinity();
  return TR_OK;
}

tr_status tr_set_environment(tr_sim* sim, const tr_environment* environment) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (environment == nullptr) return TR_BAD_ARGUMENT;
  Sim& s = *opened(sim);
  // The velocity over the ground stays, that relative to the air that drifts changes.
  const tr_status acceptable = check_environment(*environment);
  if (acceptable != TR_OK) return acceptable;
  const Vehicle<R>& before = s.systems.vehicle;
  Vehicle<R> after = before;
  after.ground = {environment->ground_down_m, R(0), R(0)};
  Vec3<R> velocity;
  const Vec3<R> change_n = wind_there(s, after, vector(environment->wind_mps)) -
                           wind_there(s, before, s.configuration.around.wind_n);
  if (!keep_over_ground(s, change_n, velocity)) return TR_OUT_OF_RANGE;
  const tr_status status = put_environment(*environment, true, s);
  if (status == TR_OK) s.x.velocity = velocity;
  return status;
}

tr_status tr_set_loads(tr_sim* sim, const tr_load* loads, size_t count) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if ((loads == nullptr && count > 0) || count > TR_MOST_LOADS) return TR_BAD_ARGUMENT;
  Loads<R> total;
  const tr_status possible = total_of(loads, count, total);
  return possible == TR_OK ? put_loads(total, *opened(sim)) : possible;
}

}  // namespace tiltrotor::c_interface::checked
