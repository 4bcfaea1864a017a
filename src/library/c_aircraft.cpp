// The C interface: the aircraft, its state and its rates.
#include <cmath>
#include <limits>

#include "library/c_fault.hpp"
#include "library/c_state.hpp"
#include "library/c_systems.hpp"
#include "library/c_words.hpp"
#include "tiltrotor/model/preparation.hpp"
#include "tiltrotor/model/setup/setup_explanation.hpp"
#include "tiltrotor/model/variables/control_range.hpp"

namespace tiltrotor::c_interface {

namespace {

// The enumerators of the header against the table of states and of controls.
constexpr State<int> kPlaces = {
    {TR_U, TR_V, TR_W},
    {TR_P, TR_Q, TR_R},
    TR_ROLL,
    TR_PITCH,
    TR_YAW,
    {{TR_ROTOR_RIGHT + TR_B1C, TR_ROTOR_RIGHT + TR_B1S, TR_ROTOR_RIGHT + TR_B1C_RATE,
      TR_ROTOR_RIGHT + TR_B1S_RATE, TR_ROTOR_RIGHT + TR_MEAN_INFLOW, TR_ROTOR_RIGHT + TR_COSINE_INFLOW,
      TR_ROTOR_RIGHT + TR_SINE_INFLOW},
     {TR_ROTOR_LEFT + TR_B1C, TR_ROTOR_LEFT + TR_B1S, TR_ROTOR_LEFT + TR_B1C_RATE,
      TR_ROTOR_LEFT + TR_B1S_RATE, TR_ROTOR_LEFT + TR_MEAN_INFLOW, TR_ROTOR_LEFT + TR_COSINE_INFLOW,
      TR_ROTOR_LEFT + TR_SINE_INFLOW}},
    TR_DOWNWASH,
    {{TR_CONING_RIGHT, TR_CONING_RIGHT + 1}, {TR_CONING_LEFT, TR_CONING_LEFT + 1}},
    {TR_NORTH, TR_EAST, TR_DOWN}};
constexpr Controls<int> kControlPlaces = {
    TR_COLLECTIVE,  TR_LONG_STICK,      TR_LAT_STICK,        TR_PEDAL,
    TR_LONG_CYCLIC, TR_DIFF_COLLECTIVE, TR_DIFF_LONG_CYCLIC, TR_ELEVATOR,
    TR_AILERON,     TR_RUDDER,          TR_LATERAL_CYCLIC,   {TR_GUST_U, TR_GUST_V, TR_GUST_W}};
template <template <class> class Shape>
constexpr bool are_in_order(const Shape<int>& places) {
  int next = 0;
  bool right_place = true;
  Shape<int>::describe(places, [&](const int& place, const Variable&) { right_place &= place == next++; });
  return right_place;
}
static_assert(int{TR_MAST} == state_count && int{TR_CONTROLS} == control_count);
static_assert(are_in_order(kPlaces) && are_in_order(kControlPlaces));

TILTROTOR_NOINLINE bool in_bound(int state, R x) {
  return std::fabs(x) <= static_cast<R>(vehicle_variable(state).facts().bound);
}

constexpr std::size_t kLongestLine = 1000;

// A library holds one aircraft.
bool compiled_in(int32_t aircraft) { return aircraft == aircraft_identity().id; }

bool mast_in_range(R mast_deg) {
  const Bounds<R> range = setup_range(aircraft_data<R>(), SetupField::mast_deg);
  return is_within(mast_deg, range.low, range.high);
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

tr_status wanted_setup(const tr_setup& setup, FlightSetup<R>& wanted) {
  if (!compiled_in(setup.aircraft)) return TR_BAD_ARGUMENT;
  if (!mast_in_range(setup.mast_deg)) return TR_OUT_OF_RANGE;
  wanted = flight_setup(aircraft_data<R>(), setup.mast_deg);
  wanted.flap_deg = setup.flap_deg;
  wanted.altitude = setup.altitude_m;
  wanted.mass = setup.mass_kg;
  wanted.rotor_speed = setup.rotor_radps;
  wanted.sl_cg = setup.cg_station_m;
  return choice(wanted.options, setup) ? TR_OK : TR_BAD_ARGUMENT;
}

tr_setup setup_of(const FlightSetup<R>& setup) {
  const Options& o = setup.options;
  tr_setup found;
  found.aircraft = aircraft_identity().id;
  found.grid = o.grid == BladeGrid::realtime ? TR_GRID_REALTIME : TR_GRID_SPECIFICATION;
  found.tables = o.tables == Interpolation::c1 ? TR_TABLES_SMOOTH : TR_TABLES_LINEAR;
  found.coning_states = o.coning_states ? 1 : 0;
  found.mast_deg = setup.mast_deg;
  found.flap_deg = setup.flap_deg;
  found.altitude_m = setup.altitude;
  found.mass_kg = setup.mass;
  found.rotor_radps = setup.rotor_speed;
  found.cg_station_m = setup.sl_cg;
  return found;
}

tr_status make(const FlightSetup<R>& setup, tr_sim* sim) {
  if (first_out_of_range(aircraft_data<R>(), setup).field != SetupField::none) return TR_OUT_OF_RANGE;
  // In place: a stack may have no room for a second one.
  Sim& s = *::new (static_cast<void*>(sim->reserved)) Sim;
  s.mark = 0;
  const Status status = prepare(aircraft_data<R>(), setup, s.configuration);
  if (status != Status::ok) return translated(status);
  s.configuration.aircraft = nullptr;
  s.x = State<R>{};
  s.travel = Travel{};
  s.u = Controls<R>{};
  s.time = 0;
  s.steps = 0;
  s.air = {false, R(0), std::numeric_limits<R>::infinity()};
  reset_systems(s);
  s.fault = no_fault();
  s.mark = kMark;
  return TR_OK;
}

StateCheck check_state(const tr_state& state) {
  const int bad_state = first_not_finite(state.x, TR_STATES);
  const int bad_control = first_not_finite(state.u, TR_CONTROLS);
  if (bad_state != kNone || bad_control != kNone || !is_finite(state.time_s))
    return {TR_NOT_FINITE, bad_state, bad_control};
  for (int i = 0; i < TR_STATES; ++i)
    if (!in_bound(i, state.x[i])) return {TR_OUT_OF_RANGE, i, kNone};
  if (state.x[TR_GEAR] < R(0)) return {TR_OUT_OF_RANGE, TR_GEAR, kNone};
  for (int j = 0; j < TR_CONTROLS; ++j)
    if (!(std::fabs(state.u[j]) <= kLargestControl<R>)) return {TR_OUT_OF_RANGE, kNone, j};
  const bool in_time = state.time_s >= 0 && state.time_s <= kLongestFlight && state.steps <= kMostSteps;
  return {in_time ? TR_OK : TR_OUT_OF_RANGE, kNone, kNone};
}

void get_state(const Sim& s, tr_state& state) {
  state.time_s = s.time;
  state.steps = s.steps;
  flatten(s.x, state.x);
  flatten(s.systems.state, state.x + state_count);
  flatten(s.u, state.u);
  const double* sum = s.travel.sum;
  state.roll_rad = *sum++;
  state.yaw_rad = *sum++;
  for (double& position : state.position_m) position = *sum++;
}

void put_state(const tr_state& state, Sim& s) {
  s.time = state.time_s;
  s.steps = state.steps;
  unflatten(state.x, s.x);
  unflatten(state.u, s.u);
  put_system_states(state.x + state_count, s);
  const double* north = state.position_m;
  s.travel = {{state.roll_rad, state.yaw_rad, north[0], north[1], north[2]}};
  follow(s.x, s.travel);
}

}  // namespace tiltrotor::c_interface

namespace tiltrotor::c_interface::checked {

tr_status tr_default_setup(tr_setup* setup, uint32_t version, int32_t aircraft, tr_real mast_deg) {
  if (version != TR_API_VERSION) return TR_WRONG_VERSION;
  if (!is_ieee_arithmetic<R>()) return TR_BAD_ARITHMETIC;
  if (setup == nullptr || !compiled_in(aircraft)) return TR_BAD_ARGUMENT;
  if (!mast_in_range(mast_deg)) return TR_OUT_OF_RANGE;
  const FlightSetup<R> defaults = flight_setup(aircraft_data<R>(), mast_deg);
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
  (::new (static_cast<void*>(sim->reserved)) Sim)->mark = 0;
  if (setup == nullptr) return TR_BAD_ARGUMENT;
  FlightSetup<R> wanted;
  const tr_status status = wanted_setup(*setup, wanted);
  return status == TR_OK ? make(wanted, sim) : status;
}

tr_status tr_check_setup(const tr_setup* setup, uint32_t version, char* text, size_t length) {
  if (text != nullptr && length > 0) text[0] = '\0';
  if (version != TR_API_VERSION) return TR_WRONG_VERSION;
  if (!is_ieee_arithmetic<R>()) return TR_BAD_ARITHMETIC;
  if (setup == nullptr || (text == nullptr && length > 0)) return TR_BAD_ARGUMENT;
  FlightSetup<R> wanted{};
  const tr_status possible = wanted_setup(*setup, wanted);
  if (possible == TR_BAD_ARGUMENT) return possible;
  wanted.mast_deg = setup->mast_deg;
  const SetupFault<R> fault = first_out_of_range(aircraft_data<R>(), wanted);
  explain(fault, text, static_cast<int>(length < kLongestLine ? length : kLongestLine));
  return fault.field == SetupField::none ? TR_OK : TR_OUT_OF_RANGE;
}

tr_status tr_get_state(const tr_sim* sim, tr_state* state) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (state == nullptr) return TR_BAD_ARGUMENT;
  get_state(*opened(sim), *state);
  return TR_OK;
}

tr_status tr_set_state(tr_sim* sim, const tr_state* state) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  Sim& s = *opened(sim);
  if (state == nullptr) return noted(s, TR_BAD_ARGUMENT);
  const StateCheck found = check_state(*state);
  if (found.status != TR_OK) return noted(s, found.status, found.state, found.control);
  tr_state before;
  get_state(s, before);
  put_state(*state, s);
  int blamed = TR_DOWN;
  const tr_status with_systems = follow_systems(s, &blamed);
  const tr_status in_air = with_systems == TR_OK ? follow_air(s) : with_systems;
  if (in_air == TR_OK) return TR_OK;
  put_state(before, s);
  follow_systems(s);
  return noted(s, in_air, blamed);
}

tr_status tr_derivative(const tr_sim* sim, tr_real* rates, size_t length) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (rates == nullptr) return TR_BAD_ARGUMENT;
  if (length < TR_STATES) return TR_SHORT_BUFFER;
  Configuration<R> copy;
  Found found;
  evaluate(*opened(sim), copy, found);
  flatten_rates(found, rates);
  return all_finite(rates, TR_STATES) ? TR_OK : TR_NOT_FINITE;
}

}  // namespace tiltrotor::c_interface::checked

int32_t tr_aircraft_at(int32_t place) { return place == 0 ? tiltrotor::aircraft_identity().id : 0; }
const char* tr_aircraft_name(int32_t aircraft) {
  return tiltrotor::c_interface::compiled_in(aircraft) ? tiltrotor::aircraft_identity().name : "unknown";
}
const char* tr_aircraft_description(int32_t aircraft) {
  return tiltrotor::c_interface::compiled_in(aircraft) ? tiltrotor::aircraft_identity().description : "";
}

size_t tr_sim_size(void) { return sizeof(tiltrotor::c_interface::Sim); }
size_t tr_work_size(void) {
  namespace c = tiltrotor::c_interface;
  size_t most = c::kOwnWorkBytes;
  for (const size_t bytes : {c::kSystemModelWorkBytes, c::kSystemOutputsWorkBytes, c::kRigidModelWorkBytes})
    most = bytes > most ? bytes : most;
  return most;
}
