// The C interface: the aircraft, its controls, its state and what follows from them.
#include <cmath>

#include "library/c_memory.hpp"
#include "library/c_words.hpp"
#include "library/processor.hpp"
#include "tiltrotor/model/aircraft_data.hpp"

namespace tiltrotor::c_interface {

namespace {

using Setup = FlightSetup<R>;

static_assert(int{TR_STATES} == state_count && int{TR_CONTROLS} == control_count);
static_assert(int{TR_ROLL} == ix_roll && int{TR_ROTOR_RIGHT} == ix_rotor_right &&
              int{TR_ROTOR_LEFT} == ix_rotor_left && int{TR_DOWNWASH} == ix_downwash &&
              int{TR_CONING_LEFT} == ix_coning_left && int{TR_NORTH} == ix_position);
static_assert(int{TR_PEDAL} == iu_pedal && int{TR_ELEVATOR} == iu_elevator && int{TR_GUST_U} == iu_gust);

struct Range {
  R low, high;
};
Range control_range(std::size_t control) {
  constexpr Range collective = {R(-0.35), R(1.4)};
  constexpr Range stick = {R(-4.8), R(4.8)};
  constexpr Range pedal = {R(-2.5), R(2.5)};
  constexpr Range increment = {R(-0.5), R(0.5)};
  constexpr Range gust = {R(-50), R(50)};
  if (control == TR_COLLECTIVE) return collective;
  if (control <= TR_LAT_STICK) return stick;
  if (control == TR_PEDAL) return pedal;
  return control < TR_GUST_U ? increment : gust;
}

constexpr R kLargestControl = R(100);  // of a restored state: trims beyond the stops included

bool in_bounds(const tr_state& state) {
  for (int i = 0; i < TR_STATES; ++i)
    if (!(std::fabs(state.x[i]) <= response_detail::state_bound<R>(i))) return false;
  for (const R u : state.u)
    if (!(std::fabs(u) <= kLargestControl)) return false;
  return state.time_s >= 0;
}

bool choice(Options& options, const tr_setup& setup) {
  if (setup.grid != TR_GRID_REALTIME && setup.grid != TR_GRID_SPECIFICATION) return false;
  if (setup.tables != TR_TABLES_SMOOTH && setup.tables != TR_TABLES_LINEAR) return false;
  if (setup.coning_states != 0 && setup.coning_states != 1) return false;
  options.grid = setup.grid == TR_GRID_REALTIME ? BladeGrid::realtime : BladeGrid::specification;
  options.tables = setup.tables == TR_TABLES_SMOOTH ? Interpolation::c1 : Interpolation::linear;
  options.coning_states = setup.coning_states == 1;
  options.position_states = true;
  return true;
}

}  // namespace

}  // namespace tiltrotor::c_interface

using namespace tiltrotor;
using namespace tiltrotor::c_interface;

tr_status tr_default_setup(tr_setup* setup, uint32_t version, int32_t aircraft, tr_real mast_deg) {
  if (version != TR_API_VERSION) return TR_WRONG_VERSION;
  if (!processor_runs(kInstructions) || !rounds_once_to_nearest<R>()) return TR_BAD_ARITHMETIC;
  if (setup == nullptr || aircraft != TR_XV15) return TR_BAD_ARGUMENT;
  if (!detail::within(mast_deg, R(0), R(90))) return TR_OUT_OF_RANGE;
  const Setup defaults = flight_setup(aircraft_data<R>(), mast_deg);
  setup->aircraft = aircraft;
  setup->grid = TR_GRID_REALTIME;
  setup->tables = TR_TABLES_SMOOTH;
  setup->coning_states = 0;
  setup->mast_deg = mast_deg;
  setup->flap_deg = defaults.flap_deg;
  setup->altitude_m = defaults.altitude;
  setup->mass_kg = defaults.mass;
  setup->rotor_radps = defaults.rotor_speed;
  setup->cg_station_m = defaults.sl_cg;
  return TR_OK;
}

tr_status tr_init(tr_sim* sim, uint32_t version, const tr_setup* setup) {
  if (sim == nullptr) return TR_BAD_ARGUMENT;
  // The size of what lies behind the pointer depends on the version: nothing is touched before it is known.
  if (version != TR_API_VERSION) return TR_WRONG_VERSION;
  if (!processor_runs(kInstructions)) return TR_BAD_ARITHMETIC;
  Sim& s = *::new (static_cast<void*>(sim->reserved)) Sim;
  s.mark = 0;
  if (setup == nullptr || setup->aircraft != TR_XV15) return TR_BAD_ARGUMENT;
  const Aircraft<R>& aircraft = aircraft_data<R>();
  if (!detail::within(setup->mast_deg, R(0), R(90))) return TR_OUT_OF_RANGE;
  Setup wanted = flight_setup(aircraft, setup->mast_deg);
  wanted.flap_deg = setup->flap_deg;
  wanted.altitude = setup->altitude_m;
  wanted.mass = setup->mass_kg;
  wanted.rotor_speed = setup->rotor_radps;
  wanted.sl_cg = setup->cg_station_m;
  if (!choice(wanted.options, *setup)) return TR_BAD_ARGUMENT;
  const Status status = prepare(aircraft, wanted, s.configuration);
  if (status != Status::ok) return translated(status);
  s.x = State<R>{};
  s.u = Controls<R>{};
  s.time = 0;
  s.steps = 0;
  s.mark = kMark;
  return TR_OK;
}

size_t tr_sim_size(void) { return sizeof(Sim); }
size_t tr_work_size(void) { return kWorkBytes; }

tr_status tr_set_controls(tr_sim* sim, const tr_real* controls, size_t length) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (controls == nullptr || length < 1 || length > TR_CONTROLS) return TR_BAD_ARGUMENT;
  if (!all_finite(controls, length)) return TR_NOT_FINITE;
  for (std::size_t j = 0; j < length; ++j) {
    const Range range = control_range(j);
    if (!detail::within(controls[j], range.low, range.high)) return TR_OUT_OF_RANGE;
  }
  Sim& s = *opened(sim);
  R u[control_count];
  pack(s.u, u);
  for (std::size_t j = 0; j < length; ++j) u[j] = controls[j];
  unpack(u, s.u);
  return TR_OK;
}

tr_status tr_get_state(const tr_sim* sim, tr_state* state) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (state == nullptr) return TR_BAD_ARGUMENT;
  const Sim& s = *opened(sim);
  state->time_s = s.time;
  state->steps = s.steps;
  pack(s.x, state->x);
  pack(s.u, state->u);
  return TR_OK;
}

tr_status tr_set_state(tr_sim* sim, const tr_state* state) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (state == nullptr) return TR_BAD_ARGUMENT;
  if (!is_finite(state->time_s) || !all_finite(state->x, TR_STATES) || !all_finite(state->u, TR_CONTROLS))
    return TR_NOT_FINITE;
  if (!in_bounds(*state)) return TR_OUT_OF_RANGE;
  Sim& s = *opened(sim);
  s.time = state->time_s;
  s.steps = state->steps;
  unpack(state->x, s.x);
  unpack(state->u, s.u);
  return TR_OK;
}

tr_status tr_derivative(const tr_sim* sim, tr_real* rates, size_t length) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (rates == nullptr) return TR_BAD_ARGUMENT;
  if (length < TR_STATES) return TR_SHORT_BUFFER;
  const Sim& s = *opened(sim);
  State<R> xdot;
  derivative(s.configuration, s.x, s.u, xdot);
  pack(xdot, rates);
  return all_finite(rates, TR_STATES) ? TR_OK : TR_NOT_FINITE;
}

tr_status tr_get_outputs(const tr_sim* sim, tr_outputs* outputs) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (outputs == nullptr) return TR_BAD_ARGUMENT;
  const Sim& s = *opened(sim);
  const Configuration<R>& c = s.configuration;
  Evaluation<R> e;
  evaluate(c, s.x, s.u, e);
  const BladeControls<R> blades = mix_controls(c, s.u, s.x.velocity - s.u.gust);

  tr_outputs& o = *outputs;
  const Vec3<R>& v = s.x.velocity;
  const R airspeed = std::sqrt(dot(v, v));
  o.time_s = s.time;
  o.airspeed_mps = airspeed;
  o.angle_of_attack_rad = airspeed > R(0) ? atan2(v.z, v.x) : R(0);
  o.sideslip_rad = airspeed > R(0) ? atan2(v.y, std::sqrt(v.x * v.x + v.z * v.z)) : R(0);
  Vec3<R> force{};
  for (const Loads<R>& loads : e.loads.component) force = force + loads.force;
  const R per_mass = R(1) / c.mass.mass;
  o.specific_force_mps2[0] = force.x * per_mass;
  o.specific_force_mps2[1] = force.y * per_mass;
  o.specific_force_mps2[2] = force.z * per_mass;
  o.load_factor = -(force.z * per_mass) / kGravity<R>;
  o.climb_rate_mps = -e.rates.position.z;
  for (int side = 0; side < 2; ++side) {
    const RotorLoads<R>& rotor = e.rotor[side].loads;
    const RotorState<R>& x = s.x.rotor[side];
    o.thrust_n[side] = std::sqrt(dot(rotor.force, rotor.force));
    o.torque_nm[side] = rotor.torque;
    o.power_w[side] = rotor.torque * c.setup.rotor_speed;
    o.collective_rad[side] = blades.collective[side];
    o.long_cyclic_rad[side] = blades.long_cyclic[side];
    o.gimbal_tilt_rad[side] = std::sqrt(x.b1c * x.b1c + x.b1s * x.b1s);
  }
  o.elevator_rad = blades.elevator;
  o.aileron_rad = blades.aileron;
  o.rudder_rad = blades.rudder;
  const bool finite = is_finite(o.load_factor) && is_finite(o.power_w[0]) && is_finite(o.power_w[1]) &&
                      all_finite(o.specific_force_mps2, 3);
  return finite ? TR_OK : TR_NOT_FINITE;
}
