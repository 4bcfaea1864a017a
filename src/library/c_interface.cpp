// The C interface (tiltrotor.h) on top of the analyses: checks of every argument, and translation of types.
#include "tiltrotor/tiltrotor.h"

#include <cstdint>
#include <cstring>
#include <new>
#include <type_traits>

#include "tiltrotor/analysis/instances.hpp"
#include "tiltrotor/model/aircraft_data.hpp"

namespace tiltrotor {

namespace {

using R = tr_real;
using Setup = FlightSetup<R>;

static_assert(int{TR_STATES} == state_count && int{TR_CONTROLS} == control_count);
static_assert(int{TR_ROLL} == ix_roll && int{TR_ROTOR_RIGHT} == ix_rotor_right &&
              int{TR_ROTOR_LEFT} == ix_rotor_left && int{TR_DOWNWASH} == ix_downwash &&
              int{TR_CONING_LEFT} == ix_coning_left && int{TR_NORTH} == ix_position);
static_assert(int{TR_PEDAL} == iu_pedal && int{TR_ELEVATOR} == iu_elevator && int{TR_GUST_U} == iu_gust);
static_assert(int{TR_MAX_LINEAR_STATES} == kMaxLinearStates);

// ---- memory of the caller ----

constexpr std::uint32_t kMark = 0x54520000u + TR_API_VERSION;  // "TR"

struct Sim {
  std::uint32_t mark;  // kMark once initialised
  Configuration<R> configuration;
  State<R> x;
  Controls<R> u;
  double time;
  std::uint64_t steps;
};
static_assert(sizeof(Sim) <= sizeof(tr_sim) && alignof(Sim) <= alignof(tr_sim));
static_assert(std::is_trivially_copyable_v<Sim>, "a snapshot is a copy of the bytes");

// One group of members at a time. The explicit integrator needs no Jacobian, hence the small workspace of
// NumDiff.
struct StepRoom {
  SimulationWorkspace<R, NumDiff> workspace;
  Simulation<R> simulation;
};
struct TrimRoom {
  TrimWorkspace<R> workspace;
  TrimResult<R> result;
};
struct LinearRoom {
  LinearizationWorkspace<R> workspace;
  LinearModel<R> model;
};
struct EigenRoom {
  EigenWorkspace<R, kMaxLinearStates> workspace;
  Matrix<R, kMaxLinearStates, kMaxLinearStates> a;
  Eigenvalues<R, kMaxLinearStates> values;
};
struct ModesRoom {
  ModesWorkspace<R> workspace;
  LinearModel<R> model;
  ModeSet<R> set;
};
constexpr std::size_t kWorkAlignment = 64;

constexpr std::size_t larger(std::size_t a, std::size_t b) { return a > b ? a : b; }
constexpr std::size_t kWorkBytes =
    larger(larger(sizeof(StepRoom), sizeof(TrimRoom)),
           larger(sizeof(LinearRoom), larger(sizeof(EigenRoom), sizeof(ModesRoom)))) +
    kWorkAlignment - alignof(tr_work);
static_assert(kWorkBytes <= sizeof(tr_work));

// A room of uninitialised memory on the first aligned address.
template <class Room>
Room& place(tr_work* work) {
  static_assert(alignof(Room) <= kWorkAlignment && std::is_trivially_destructible_v<Room>);
  const auto address = reinterpret_cast<std::uintptr_t>(work);
  const std::uintptr_t aligned = (address + kWorkAlignment - 1) / kWorkAlignment * kWorkAlignment;
  return *::new (reinterpret_cast<void*>(aligned)) Room;
}

Sim* opened(tr_sim* sim) { return std::launder(reinterpret_cast<Sim*>(sim->reserved)); }
const Sim* opened(const tr_sim* sim) { return std::launder(reinterpret_cast<const Sim*>(sim->reserved)); }

tr_status check(const tr_sim* sim) {
  if (sim == nullptr) return TR_BAD_ARGUMENT;
  return opened(sim)->mark == kMark ? TR_OK : TR_NOT_INITIALIZED;
}

// ---- words ----

tr_status translated(Status status) {
  switch (status) {
    case Status::ok:
      return TR_OK;
    case Status::not_converged:
      return TR_NOT_CONVERGED;
    case Status::singular:
      return TR_SINGULAR;
    case Status::not_finite:
      return TR_NOT_FINITE;
    case Status::out_of_range:
      return TR_OUT_OF_RANGE;
    case Status::bad_argument:
    case Status::count:
      break;
  }
  return TR_BAD_ARGUMENT;
}

tr_status translated(TrimStatus status) {
  switch (status) {
    case TrimStatus::ok:
      return TR_OK;
    case TrimStatus::wing_stall:
      return TR_WING_STALL;
    case TrimStatus::control_limit:
      return TR_CONTROL_LIMIT;
    case TrimStatus::flap_limit:
      return TR_FLAP_LIMIT;
    case TrimStatus::rotor_stall:
      return TR_ROTOR_STALL;
    case TrimStatus::not_converged:
      return TR_NOT_CONVERGED;
    case TrimStatus::singular:
      return TR_SINGULAR;
    case TrimStatus::not_finite:
      return TR_NOT_FINITE;
    case TrimStatus::out_of_range:
    case TrimStatus::count:
      break;
  }
  return TR_OUT_OF_RANGE;
}

struct StatusWords {
  const char* word;
  const char* text;
};
constexpr StatusWords kWords[] = {
    {"ok", "the result is valid"},
    {"not_converged", "the iteration reached its limit before its tolerance"},
    {"singular", "a matrix that must be inverted is singular"},
    {"not_finite", "a NaN or an infinity was met in the input or arose in the computation"},
    {"out_of_range", "an input, or the state after a step, lies outside the range of the model"},
    {"bad_argument", "a null pointer, an unknown choice or an impossible size"},
    {"short_buffer", "an array is too short for the result"},
    {"wrong_version", "the program was compiled for another version or precision of the library"},
    {"not_initialized", "tr_init has not succeeded on this aircraft"},
    {"wing_stall", "trimmed, but the wing is past its stall"},
    {"control_limit", "trimmed, but a control is beyond its stop"},
    {"flap_limit", "trimmed, but a gimbal is beyond its stop"},
    {"rotor_stall", "no trim: the rotors stall before they carry the weight"},
};
static_assert(sizeof(kWords) / sizeof(kWords[0]) == TR_STATUS_COUNT, "one row per status");

// ---- checks ----

bool all_finite(const R* numbers, std::size_t length) {
  for (std::size_t i = 0; i < length; ++i)
    if (!is_finite(numbers[i])) return false;
  return true;
}

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

constexpr R kLongestStep = R(0.02);    // s; the progressing flapping mode sets it,
constexpr R kLongestOfRk3 = R(0.01);   // and this
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

// nullptr for an unknown choice.
const ControlSet* control_set(std::int32_t columns) {
  switch (columns) {
    case TR_INCEPTORS:
      return &kInceptors;
    case TR_BLADE_CONTROLS:
      return &kBladeControls;
    case TR_ALL_CONTROLS:
      return &kAllControls;
    default:
      return nullptr;
  }
}

// A shape that tr_linearize can have made: the model is then safe to work on.
bool plausible(const tr_linear_shape& shape) {
  if (shape.states < kRigidStates || shape.states > kMaxLinearStates) return false;
  bool seen[state_count] = {};
  for (int i = 0; i < shape.states; ++i) {
    const int state = shape.state[i];
    if (state < 0 || state >= ix_position || seen[state]) return false;
    seen[state] = true;
  }
  for (int i = ix_rotor_right; i < ix_rotor_left; ++i)
    if (seen[i] != seen[i + (ix_rotor_left - ix_rotor_right)]) return false;
  return seen[ix_coning_right] == seen[ix_coning_left] &&
         seen[ix_coning_right + 1] == seen[ix_coning_left + 1];
}

constexpr std::size_t entries(int rows, int columns) {
  return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
}

// ---- what two functions share ----

tr_status check_step(const tr_work* work, R dt) {
  if (work == nullptr) return TR_BAD_ARGUMENT;
  if (!is_finite(dt)) return TR_NOT_FINITE;
  return dt > R(0) && dt <= kLongestStep ? TR_OK : TR_OUT_OF_RANGE;
}

// One step; `xdot`: the rates at its beginning, or nullptr.
tr_status step(Sim& s, tr_work* work, R dt, const R* xdot) {
  StepRoom& room = place<StepRoom>(work);
  const Integrator integrator = dt <= kLongestOfRk3 ? Integrator::rk3 : Integrator::rk4;
  // The model does not depend on time: every step begins a simulation of its own, and time is counted here.
  const Status started = start(s.configuration, s.x, s.u, dt, integrator, room.simulation);
  if (started != Status::ok) return translated(started);
  const Status advanced = advance(s.configuration, room.workspace, room.simulation, xdot);
  if (advanced != Status::ok) return translated(advanced);
  s.x = room.simulation.state;
  s.time += static_cast<double>(dt);
  ++s.steps;
  return TR_OK;
}

// The arrays of a caller for A and B.
struct LinearArrays {
  R* a;
  std::size_t a_length;
  R* b;
  std::size_t b_length;
};

// The linear model at the present state, and the rates there.
tr_status linearize_here(const Sim& s, tr_work* work, std::int32_t columns, tr_linear_shape* shape,
                         const LinearArrays& to, R* xdot) {
  const ControlSet* set = control_set(columns);
  if (work == nullptr || shape == nullptr || set == nullptr) return TR_BAD_ARGUMENT;
  LinearRoom& room = place<LinearRoom>(work);
  LinearModel<R>& model = room.model;
  linear_states(s.configuration.setup.options, model);
  shape->states = model.states;
  shape->controls = set->count;
  for (int i = 0; i < kMaxLinearStates; ++i) shape->state[i] = i < model.states ? model.state[i] : -1;
  for (int j = 0; j < control_count; ++j) shape->control[j] = j < set->count ? set->index[j] : -1;
  const bool wants_b = to.b != nullptr || to.b_length > 0;
  const bool b_fits = !wants_b || to.b_length >= entries(model.states, set->count);
  if (to.a_length < entries(model.states, model.states) || !b_fits) return TR_SHORT_BUFFER;
  if (to.a == nullptr || (wants_b && to.b == nullptr)) return TR_BAD_ARGUMENT;

  const Status status = linearize(s.configuration, s.x, s.u, *set, room.workspace, model);
  if (status != Status::ok && status != Status::not_finite) return translated(status);
  R* a = to.a;
  R* b = to.b;
  for (int i = 0; i < model.states; ++i) {
    for (int j = 0; j < model.states; ++j) *a++ = model.a(i, j);
    for (int j = 0; wants_b && j < set->count; ++j) *b++ = model.b(i, j);
  }
  for (int i = 0; i < state_count; ++i) xdot[i] = model.xdot[i];
  return translated(status);
}

}  // namespace

}  // namespace tiltrotor

using namespace tiltrotor;

// ---- the aircraft ----

tr_status tr_default_setup(tr_setup* setup, uint32_t version, int32_t aircraft, tr_real mast_deg) {
  if (version != TR_API_VERSION) return TR_WRONG_VERSION;
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

// ---- flying ----

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

tr_status tr_step(tr_sim* sim, tr_work* work, tr_real dt) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  const tr_status possible = check_step(work, dt);
  if (possible != TR_OK) return possible;
  return step(*opened(sim), work, dt, nullptr);
}

tr_status tr_linearize_and_step(tr_sim* sim, tr_work* work, tr_real dt, int32_t columns,
                                tr_linear_shape* shape, tr_real* a, size_t a_length, tr_real* b,
                                size_t b_length) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  const tr_status possible = check_step(work, dt);
  if (possible != TR_OK) return possible;
  R xdot[state_count];
  const tr_status linear =
      linearize_here(*opened(sim), work, columns, shape, {a, a_length, b, b_length}, xdot);
  return linear == TR_OK ? step(*opened(sim), work, dt, xdot) : linear;
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

// ---- trim ----

tr_status tr_trim(tr_sim* sim, tr_work* work, const tr_flight* flight, tr_trim_result* result) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  if (work == nullptr || flight == nullptr) return TR_BAD_ARGUMENT;
  Sim& s = *opened(sim);
  TrimRoom& room = place<TrimRoom>(work);
  const SteadyFlight<R> wanted = {flight->speed_mps, flight->climb_rad, flight->turn_rate_radps,
                                  flight->sideslip_rad};
  const TrimStatus status = trim(s.configuration, wanted, room.workspace, room.result);
  if (result != nullptr) {
    result->iterations = room.result.iterations;
    result->attempts = room.result.attempts;
    result->residual = room.result.residual;
    explain(room.result, result->text, static_cast<int>(sizeof result->text));
  }
  if (is_trimmed(status)) {
    s.x = room.result.state;
    s.u = room.result.controls;
    s.time = 0;
    s.steps = 0;
  }
  return translated(status);
}

// ---- linear model and modes ----

tr_status tr_linearize(const tr_sim* sim, tr_work* work, int32_t columns, tr_linear_shape* shape, tr_real* a,
                       size_t a_length, tr_real* b, size_t b_length) {
  const tr_status ready = check(sim);
  if (ready != TR_OK) return ready;
  R xdot[state_count];
  return linearize_here(*opened(sim), work, columns, shape, {a, a_length, b, b_length}, xdot);
}

tr_status tr_eigenvalues(tr_work* work, const tr_real* a, size_t n, tr_real* real, tr_real* imag,
                         size_t length) {
  if (work == nullptr || a == nullptr || real == nullptr || imag == nullptr) return TR_BAD_ARGUMENT;
  if (n < 1 || n > kMaxLinearStates) return TR_BAD_ARGUMENT;
  if (length < n) return TR_SHORT_BUFFER;
  EigenRoom& room = place<EigenRoom>(work);
  const int order = static_cast<int>(n);
  set_zero(room.a);
  for (int i = 0; i < order; ++i)
    for (int j = 0; j < order; ++j) room.a(i, j) = *a++;
  const Status status = eigenvalues(room.a, order, room.workspace, room.values);
  if (status != Status::ok && status != Status::not_converged) return translated(status);
  for (int i = 0; i < order; ++i) {
    real[i] = room.values.real[i];
    imag[i] = room.values.imag[i];
  }
  return translated(status);
}

tr_status tr_modes(tr_work* work, const tr_linear_shape* shape, const tr_real* a, size_t a_length,
                   tr_mode* modes, size_t capacity, size_t* count) {
  if (work == nullptr || shape == nullptr || a == nullptr || modes == nullptr || count == nullptr)
    return TR_BAD_ARGUMENT;
  if (!plausible(*shape)) return TR_BAD_ARGUMENT;
  if (a_length < entries(shape->states, shape->states)) return TR_SHORT_BUFFER;
  ModesRoom& room = place<ModesRoom>(work);
  LinearModel<R>& model = room.model;
  clear(model);
  model.states = shape->states;
  for (int i = 0; i < model.states; ++i) {
    model.state[i] = shape->state[i];
    for (int j = 0; j < model.states; ++j) model.a(i, j) = *a++;
  }
  const Status status = tiltrotor::modes(model, room.workspace, room.set);
  if (status != Status::ok) return translated(status);
  *count = static_cast<std::size_t>(room.set.count);
  if (capacity < *count) return TR_SHORT_BUFFER;
  for (int i = 0; i < room.set.count; ++i) {
    const Mode<R>& mode = room.set.mode[i];
    static_assert(sizeof(modes->name) == sizeof(mode.name));
    modes[i].real = mode.real;
    modes[i].imag = mode.imag;
    modes[i].frequency_radps = mode.frequency;
    modes[i].damping_ratio = mode.damping_ratio;
    modes[i].time_to_half_s = mode.time_to_half;
    std::memcpy(modes[i].name, mode.name, sizeof mode.name);
  }
  return TR_OK;
}

// ---- words and hashes ----

const char* tr_status_word(int32_t status) {
  const auto place = static_cast<unsigned>(status);
  return place < TR_STATUS_COUNT ? kWords[place].word : "unknown";
}
const char* tr_status_text(int32_t status) {
  const auto place = static_cast<unsigned>(status);
  return place < TR_STATUS_COUNT ? kWords[place].text : "";
}
const char* tr_state_name(int32_t index) {
  return index >= 0 && index < TR_STATES ? kStateNames[index].name : "unknown";
}
const char* tr_state_unit(int32_t index) {
  return index >= 0 && index < TR_STATES ? kStateNames[index].unit : "";
}
const char* tr_control_name(int32_t index) {
  return index >= 0 && index < TR_CONTROLS ? kControlNames[index].name : "unknown";
}
const char* tr_control_unit(int32_t index) {
  return index >= 0 && index < TR_CONTROLS ? kControlNames[index].unit : "";
}
const char* tr_version(void) { return TILTROTOR_VERSION; }

tr_status tr_hash(const tr_real* numbers, size_t length, uint64_t* hash) {
  if (hash == nullptr || (numbers == nullptr && length > 0)) return TR_BAD_ARGUMENT;
  using Bits = std::conditional_t<sizeof(R) == 8, std::uint64_t, std::uint32_t>;
  constexpr std::uint64_t prime = 1099511628211u;
  std::uint64_t h = *hash;
  for (std::size_t i = 0; i < length; ++i) {
    Bits bits;
    std::memcpy(&bits, &numbers[i], sizeof bits);
    for (unsigned k = 0; k < sizeof bits; ++k) h = (h ^ ((bits >> (8 * k)) & 0xffu)) * prime;
  }
  *hash = h;
  return TR_OK;
}
