// The C interface: what instruments read.
#include "library/c_outputs.hpp"

#include "library/c_fault.hpp"
#include "library/c_words.hpp"
#include "tiltrotor/analysis/flight/air_data.hpp"
#include "tiltrotor/analysis/flight/station_motion.hpp"
#include "tiltrotor/analysis/flight/table_edge.hpp"
#include "tiltrotor/model/variables/control_range.hpp"

namespace tiltrotor::c_interface {

tr_status outputs_here(Configuration<R>& c, const Sim& s, tr_outputs& outputs, Found& found) {
  evaluate(s, c, found);
  Instruments<R> read;
  read_instruments(c, evaluated_state(s), found.steps, found.rates, read);
  R readings[kReadings];
  flatten(read, readings);
  put_outputs(s.time, readings, outputs);
  return all_finite(readings, kReadings) ? TR_OK : TR_NOT_FINITE;
}

namespace {

void put(const Vec3<R>& v, R (&array)[3]) { flatten(v, array); }

std::uint32_t flag_of(TrimLimit limit) {
  switch (limit) {
    case TrimLimit::descent_right:
    case TrimLimit::descent_left:
      return TR_VORTEX_RING;
    case TrimLimit::long_stick:
    case TrimLimit::lat_stick:
    case TrimLimit::pedal:
    case TrimLimit::elevator:
    case TrimLimit::aileron:
    case TrimLimit::rudder:
      return TR_SATURATED;
    case TrimLimit::gimbal_right:
    case TrimLimit::gimbal_left:
      return TR_AT_GIMBAL_STOP;
    case TrimLimit::power:
    case TrimLimit::windmill_power:
      return TR_OVER_POWER;
    case TrimLimit::torque_right:
    case TrimLimit::torque_left:
      return TR_OVER_TORQUE;
    case TrimLimit::none:
    case TrimLimit::wing_angle:
    case TrimLimit::count:
      break;
  }
  return 0;
}

// A command at the end of its range or beyond.
bool at_a_stop(const Aircraft<R>& aircraft, const Controls<R>& controls) {
  R u[control_count];
  flatten(controls, u);
  for (int j = 0; j < control_count; ++j) {
    const Bounds<R> range = control_range(aircraft, j);
    const bool commanded = kControlVariables[j].kind != VariableKind::gust;
    if (commanded && (u[j] <= range.low || u[j] >= range.high)) return true;
  }
  return false;
}

}  // namespace

}  // namespace tiltrotor::c_interface

namespace tiltrotor::c_interface::checked {

tr_status tr_get_outputs(const tr_sim* sim, tr_outputs* outputs) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (outputs == nullptr) return TR_BAD_ARGUMENT;
  Configuration<R> copy;
  Found found;
  return outputs_here(copy, *opened(sim), *outputs, found);
}

tr_status tr_last_fault(const tr_sim* sim, tr_fault* fault) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (fault == nullptr) return TR_BAD_ARGUMENT;
  *fault = opened(sim)->fault;
  return TR_OK;
}

tr_status tr_get_flags(const tr_sim* sim, uint32_t* flags) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (flags == nullptr) return TR_BAD_ARGUMENT;
  const Sim& s = *opened(sim);
  Configuration<R> copy;
  Configuration<R>& c = copy;
  const State<R> x = evaluated_state(s);
  Found all;
  evaluate(s, c, all);
  const DerivativeSteps<R>& found = all.steps;
  bool finite = true;
  State<R>::each(all.rates, [&finite](R rate) { finite = finite && is_finite(rate); });
  if (!finite) return TR_NOT_FINITE;
  // Stall of the wing has no flag: asked at rest, where the aircraft does not rest on it.
  const LimitCheck<R> check =
      check_limits(c, R(0), R(0), x, s.u, found.controls, found.rotor, engines_that_run(s));
  std::uint32_t set = at_a_stop(*c.aircraft, s.u) ? std::uint32_t{TR_SATURATED} : 0;
  for (int k = 0; k < check.count; ++k) set |= flag_of(check.exceeded[k].limit);
  if (is_beyond_tables(c, x, found.velocity_b, found.controls)) set |= TR_TABLE_EDGE;
  if (all.weight_on_wheels > R(0)) set |= TR_ON_GROUND;
  if (s.x.position.z > s.air.ground_down) set |= TR_BELOW_GROUND;
  *flags = set;
  return TR_OK;
}

tr_status tr_get_mass(const tr_sim* sim, tr_mass* mass) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (mass == nullptr) return TR_BAD_ARGUMENT;
  const MassProperties<R>& m = opened(sim)->configuration.mass;
  *mass = {m.mass, {m.sl_cg, 0, m.wl_cg}, {m.inertia.xx, m.inertia.yy, m.inertia.zz, m.inertia.xz}};
  return TR_OK;
}

tr_status tr_motion_at(const tr_sim* sim, const tr_real station_m[3], tr_motion* motion) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  const tr_status possible = check_station(station_m, motion);
  if (possible != TR_OK) return possible;
  const Sim& s = *opened(sim);
  Configuration<R> copy;
  Configuration<R>& c = copy;
  const State<R> x = evaluated_state(s);
  Found all;
  evaluate(s, c, all);
  const DerivativeSteps<R>& found = all.steps;
  const State<R>& rates = all.rates;

  const Vec3<R> arm = arm_to(s, station_m);
  const EulerAngles<R> attitude = {x.roll, x.pitch, x.yaw};
  const Rotation<R> to_body = earth_to_body(attitude);
  const Vec3<R> velocity = velocity_at(x.velocity, c.mass.nacelles, x.rates, arm);
  const Vec3<R> specific = R(R(1) / c.mass.mass) * found.total.force;
  tr_motion& m = *motion;
  put(x.position + to_body.apply_inverse(arm), m.position_m);
  put(to_body.apply_inverse(velocity) + wind_there(s, s.systems.vehicle, c.around.wind_n),
      m.velocity_ned_mps);
  put(velocity - s.u.gust, m.velocity_air_mps);
  put(specific_force_at(specific, c.mass.nacelles, x.rates, rates.rates, arm), m.specific_force_mps2);
  put(x.rates, m.rates_radps);
  put(rates.rates, m.acceleration_radps2);
  const Quaternion<R> q = quaternion(attitude);
  const R turn[] = {q.scalar, q.x, q.y, q.z};
  for (int k = 0; k < 4; ++k) m.quaternion[k] = turn[k];
  return all_finite(m.specific_force_mps2, 3) && all_finite(m.acceleration_radps2, 3) ? TR_OK : TR_NOT_FINITE;
}

tr_status tr_air_data_at(const tr_sim* sim, const tr_real station_m[3], tr_air_data* air) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  const tr_status possible = check_station(station_m, air);
  if (possible != TR_OK) return possible;
  const Sim& s = *opened(sim);
  const Vec3<R> arm = arm_to(s, station_m);
  const Vec3<R> v =
      velocity_at(s.x.velocity, s.configuration.mass.nacelles, s.x.rates, arm) - s.u.gust - gust_at(s, arm);
  const AirData<R> d = air_data(s.configuration.air, v);
  *air = {d.static_pressure, d.impact_pressure, d.true_airspeed, d.calibrated, d.mach,
          d.angle_of_attack, d.sideslip};
  return TR_OK;
}

}  // namespace tiltrotor::c_interface::checked
