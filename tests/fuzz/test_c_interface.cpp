// Any calls of the C interface, in any order, with any numbers. Two aircraft share a work area; a third
// stands by and must never change. A call that fails leaves its aircraft and its outputs alone; one that
// succeeds returns numbers.
// Expected: the header's contract.
#include <cmath>

#include "capi/same_aircraft.hpp"
#include "fuzz/change_conditions.hpp"
#include "fuzz/change_systems.hpp"
#include "fuzz/read_sensors.hpp"
#include "fuzz/target.hpp"
#include "tiltrotor/tiltrotor.h"

namespace {

constexpr int kCalls = 40;
constexpr std::size_t kSquare = TR_MAX_LINEAR_STATES * TR_MAX_LINEAR_STATES;
constexpr tr_real kUntouched = 12345.678;

struct Workspace {
  tr_sim sim[2];
  tr_sim bystander;
  tr_work work;
  tr_real a[kSquare + 1];
  tr_real b[TR_MAX_LINEAR_STATES * TR_INPUTS + 1];
  tr_linear_shape shape;
  tr_mode modes[TR_MAX_LINEAR_STATES];
  bool linear_model;  // a, b and shape belong together
};

bool all_finite(const tr_real* x, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    if (!std::isfinite(x[i])) return false;
  return true;
}

bool known(tr_status status) { return status >= TR_OK && status < TR_STATUS_COUNT; }

tr_setup any_setup(fuzz::Bytes& in) {
  tr_setup setup;
  const double masts[] = {0, 30, 90};
  REQUIRE(tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), masts[in.below(3)]) == TR_OK);
  tr_real* const number[] = {&setup.mast_deg, &setup.flap_deg,    &setup.altitude_m,
                             &setup.mass_kg,  &setup.rotor_radps, &setup.cg_station_m};
  std::int32_t* const word[] = {&setup.aircraft, &setup.grid, &setup.tables, &setup.coning_states};
  for (int changes = in.below(4); changes > 0; --changes) {
    if (in.below(2) == 0)
      *number[in.below(6)] = in.number();
    else
      *word[in.below(4)] = in.byte() - 2;
  }
  return setup;
}

tr_state any_state(const tr_sim& sim, fuzz::Bytes& in) {
  tr_state state{};
  if (tr_get_state(&sim, &state) != TR_OK) state = tr_state{};
  for (int changes = in.below(8); changes > 0; --changes) {
    const int place = in.below(TR_STATES + TR_CONTROLS + 6);
    double* const sum[] = {&state.time_s,        &state.roll_rad,      &state.yaw_rad,
                           &state.position_m[0], &state.position_m[1], &state.position_m[2]};
    double* const number = place < TR_STATES                 ? &state.x[place]
                           : place < TR_STATES + TR_CONTROLS ? &state.u[place - TR_STATES]
                                                             : sum[place - TR_STATES - TR_CONTROLS];
    *number = in.number();
  }
  return state;
}

void fly(tr_sim& sim, Workspace& workspace, fuzz::Bytes& in) {
  tr_real controls[TR_CONTROLS + 4] = {};
  const std::size_t length = in.byte() % (sizeof controls / sizeof *controls);
  for (std::size_t j = 0; j < length; ++j) controls[j] = in.number();
  (void)tr_set_controls(&sim, controls, length);
  tr_state before{};
  const bool ready = tr_get_state(&sim, &before) == TR_OK;
  const tr_real dt = in.below(3) == 0 ? in.number() : 0.01;
  const tr_status status = tr_step(&sim, &workspace.work, dt);
  REQUIRE(known(status) && (ready || status == TR_NOT_INITIALIZED));
  tr_state after{};
  if (status == TR_OK)
    REQUIRE(tr_get_state(&sim, &after) == TR_OK && all_finite(after.x, TR_STATES) &&
            after.steps == before.steps + 1);
}

// Saves one aircraft, perhaps changes the bytes, and loads them into another. A change is found.
void save_and_load(const tr_sim& from, tr_sim& to, fuzz::Bytes& in) {
  unsigned char bytes[TR_SAVED_SIZE + 1];
  std::memset(bytes, 0x5a, sizeof bytes);
  std::size_t used = 0;
  const std::size_t capacity = in.below(4) == 0 ? 4 * in.byte() : std::size_t{TR_SAVED_SIZE};
  const tr_status status = tr_save(&from, bytes, capacity, &used);
  REQUIRE(known(status) && bytes[capacity] == 0x5a && used <= TR_SAVED_SIZE);
  if (status == TR_SHORT_BUFFER) REQUIRE(used > capacity && bytes[0] == 0x5a);
  unsigned char good[sizeof bytes];
  std::memcpy(good, bytes, sizeof bytes);
  for (int changes = in.below(4); changes > 0; --changes) bytes[4 * in.byte() + in.below(4)] = in.byte();
  const std::size_t length = in.below(4) == 0 ? 4 * in.byte() : std::size_t{TR_SAVED_SIZE};
  const tr_sim before = to;
  const tr_status loaded = tr_load_saved(&to, TR_API_VERSION, bytes, length);
  REQUIRE(known(loaded));
  if (loaded != TR_OK) REQUIRE(std::memcmp(&to, &before, sizeof to) == 0);
  const bool whole = status == TR_OK && length >= used && std::memcmp(bytes, good, used) == 0;
  REQUIRE((loaded == TR_OK) == whole);
  if (!whole) return;
  std::size_t again = 0;
  REQUIRE(tr_save(&to, bytes, sizeof bytes, &again) == TR_OK && again == used &&
          std::memcmp(bytes, good, used) == 0);
}

void read(const tr_sim& sim, fuzz::Bytes& in) {
  tr_real rates[TR_STATES + 1];
  for (tr_real& x : rates) x = kUntouched;
  const std::size_t length = in.below(2) == 0 ? std::size_t{TR_STATES} : in.byte();
  const tr_status status = tr_derivative(&sim, rates, length);
  if (status == TR_OK) REQUIRE(all_finite(rates, TR_STATES));
  if (status != TR_OK && status != TR_NOT_FINITE) REQUIRE(rates[0] == kUntouched);
  REQUIRE(rates[TR_STATES] == kUntouched);
  tr_outputs outputs;
  if (tr_get_outputs(&sim, &outputs) == TR_OK)
    REQUIRE(std::isfinite(outputs.load_factor) && all_finite(outputs.power_w, 2) &&
            std::isfinite(outputs.airspeed_mps));
}

// Controls beyond their stops, a step with outputs, and everything that is read.
void measure(tr_sim& sim, fuzz::Bytes& in) {
  static tr_work work;
  tr_real controls[TR_CONTROLS + 4] = {};
  const std::size_t length = in.byte() % (sizeof controls / sizeof *controls);
  for (std::size_t j = 0; j < length; ++j) controls[j] = in.number();
  std::uint32_t bits = 0;
  const tr_status held = tr_saturate_controls(&sim, controls, length, &bits);
  REQUIRE(known(held) && (held == TR_OK || bits == 0) && bits < (1u << TR_CONTROLS));
  tr_fault fault;
  if (tr_last_fault(&sim, &fault) == TR_OK)
    REQUIRE(fault.status >= TR_OK && fault.status < TR_STATUS_COUNT && fault.state >= -1 &&
            fault.state < TR_STATES && fault.control >= -1 && fault.control < TR_CONTROLS);
  tr_outputs outputs;
  REQUIRE(known(tr_step_with_outputs(&sim, &work, in.number(), &outputs)));
  const tr_status flagged = tr_get_flags(&sim, &bits);
  if (flagged == TR_OK) REQUIRE(bits < 2 * TR_BELOW_GROUND);
  tr_mass mass;
  if (tr_get_mass(&sim, &mass) == TR_OK) REQUIRE(mass.mass_kg > 0 && all_finite(mass.cg_m, 3));
  const tr_real station[3] = {in.number(), in.number(), in.number()};
  tr_motion motion;
  if (tr_motion_at(&sim, station, &motion) == TR_OK)
    REQUIRE(all_finite(motion.specific_force_mps2, 3) && all_finite(motion.quaternion, 4));
  tr_air_data air;
  if (tr_air_data_at(&sim, station, &air) == TR_OK)
    REQUIRE(air.static_pa > 0 && air.impact_pa >= 0 && std::isfinite(air.cas_mps) &&
            std::isfinite(air.beta_rad));
}

void differentiate_outputs(const tr_sim& sim, Workspace& workspace, fuzz::Bytes& in) {
  constexpr std::size_t most = TR_OUTPUTS * TR_MAX_LINEAR_STATES, most_d = TR_OUTPUTS * TR_INPUTS;
  tr_real c[most + 1], d[most_d + 1], dx[TR_STATES] = {}, du[TR_INPUTS] = {};
  c[most] = d[most_d] = kUntouched;
  const std::size_t c_length = in.below(3) > 0 ? most : 4 * in.byte() % most;
  const std::size_t d_length = in.below(3) > 0 ? most_d : in.byte();
  REQUIRE(known(tr_linearize_outputs(&sim, &workspace.work, in.below(6), c, c_length, d, d_length)));
  for (int changes = in.below(4); changes > 0; --changes) {
    dx[in.below(TR_STATES)] = in.number();
    du[in.below(TR_INPUTS)] = in.number();
  }
  tr_real rates[TR_STATES + 1];
  rates[TR_STATES] = kUntouched;
  tr_outputs outputs;
  const tr_status status = in.below(2) == 0
                               ? tr_directional(&sim, &workspace.work, dx, du, rates, &outputs)
                               : tr_directional_inputs(&sim, &workspace.work, dx, du, rates, &outputs);
  REQUIRE(known(status) && (status != TR_OK || all_finite(rates, TR_STATES)));
  REQUIRE(c[most] == kUntouched && d[most_d] == kUntouched && rates[TR_STATES] == kUntouched);
}

void trim(tr_sim& sim, Workspace& workspace, fuzz::Bytes& in) {
  const double speeds[] = {0, 40, 80};
  tr_flight flight = {speeds[in.below(3)], 0, 0, 0};
  tr_real* const number[] = {&flight.speed_mps, &flight.climb_rad, &flight.turn_rate_radps,
                             &flight.sideslip_rad};
  for (int changes = in.below(3); changes > 0; --changes) *number[in.below(4)] = in.number();
  tr_trim_result result{};
  const tr_status status = tr_trim(&sim, &workspace.work, &flight, in.below(2) == 0 ? &result : nullptr);
  REQUIRE(known(status) && std::memchr(result.text, 0, sizeof result.text) != nullptr);
  const bool trimmed = status == TR_OK || status == TR_WING_STALL || status == TR_CONTROL_LIMIT ||
                       status == TR_FLAP_LIMIT || status == TR_VORTEX_RING_STATE ||
                       status == TR_POWER_LIMIT || status == TR_TORQUE_LIMIT;
  if (!trimmed) return;
  tr_real rates[TR_STATES];
  REQUIRE(tr_derivative(&sim, rates, TR_STATES) == TR_OK);
  for (int i = TR_U; i <= TR_R; ++i) REQUIRE(std::fabs(rates[i]) < 1e-6);
}

void linearize(tr_sim& sim, Workspace& workspace, fuzz::Bytes& in) {
  const std::size_t a_length = in.below(3) > 0 ? kSquare : 4 * in.byte();
  const std::size_t b_length = in.below(3) > 0 ? sizeof workspace.b / sizeof *workspace.b - 1 : in.byte();
  workspace.a[kSquare] = workspace.b[sizeof workspace.b / sizeof *workspace.b - 1] = kUntouched;
  const std::size_t kind = in.below(3);
  tr_real control_rates[TR_INPUTS];
  for (tr_real& rate : control_rates) rate = kind == 2 ? in.number() : 0;
  const tr_status status =
      kind == 2
          ? tr_linearize_and_step_exponential(&sim, &workspace.work, in.number(), control_rates, in.below(6),
                                              &workspace.shape, workspace.a, a_length, workspace.b, b_length)
      : kind == 0 ? tr_linearize(&sim, &workspace.work, in.below(6), &workspace.shape, workspace.a, a_length,
                                 workspace.b, b_length)
                  : tr_linearize_and_step(&sim, &workspace.work, in.number(), in.below(6), &workspace.shape,
                                          workspace.a, a_length, workspace.b, b_length);
  REQUIRE(known(status));
  workspace.linear_model = status == TR_OK;
  if (status == TR_OK) {
    const auto n = static_cast<std::size_t>(workspace.shape.states);
    REQUIRE(all_finite(workspace.a, n * n) &&
            all_finite(workspace.b, n * static_cast<std::size_t>(workspace.shape.controls)));
  }
  REQUIRE(workspace.a[kSquare] == kUntouched);
}

void find_modes(Workspace& workspace, fuzz::Bytes& in) {
  if (!workspace.linear_model) {  // a shape and a matrix of anything
    workspace.shape.states = in.byte();
    for (int& state : workspace.shape.state) state = in.byte() % 32 - 1;
    for (tr_real& x : workspace.a) x = in.number();
  }
  for (int changes = in.below(3); changes > 0; --changes) workspace.a[in.byte()] = in.number();
  const std::size_t capacity = in.below(2) == 0 ? TR_MAX_LINEAR_STATES : in.byte() % TR_MAX_LINEAR_STATES;
  std::size_t count = 0;
  if (in.below(4) == 0)
    REQUIRE(known(tr_rigid_model(&workspace.work, &workspace.shape, workspace.a, kSquare, nullptr, 0,
                                 &workspace.shape, workspace.a, kSquare, nullptr, 0)));
  const tr_status status =
      tr_modes(&workspace.work, &workspace.shape, workspace.a, kSquare, workspace.modes, capacity, &count);
  REQUIRE(known(status) && count <= TR_MAX_LINEAR_STATES);
  if (status != TR_OK) return;
  REQUIRE(count <= capacity);
  for (std::size_t k = 0; k < count; ++k)
    REQUIRE(std::isfinite(workspace.modes[k].real) && workspace.modes[k].imag >= 0 &&
            std::memchr(workspace.modes[k].name, 0, sizeof workspace.modes[k].name) != nullptr);
}

void find_eigenvalues(Workspace& workspace, fuzz::Bytes& in) {
  const std::size_t n = in.byte() % (TR_MAX_LINEAR_STATES + 3u);
  tr_real matrix[kSquare];
  for (std::size_t i = 0; i < kSquare; ++i) matrix[i] = i < n * n ? in.number() : 0;
  tr_real real[TR_MAX_LINEAR_STATES];
  tr_real imag[TR_MAX_LINEAR_STATES];
  const tr_status status = tr_eigenvalues(
      &workspace.work, matrix, n, real, imag,
      in.below(4) == 0 ? in.byte() % (TR_MAX_LINEAR_STATES + 1u) : unsigned{TR_MAX_LINEAR_STATES});
  REQUIRE(known(status));
  if (status == TR_OK) REQUIRE(all_finite(real, n) && all_finite(imag, n));
}

void call_with_nothing(tr_sim& chosen, fuzz::Bytes& in) {
  tr_sim* const sim = in.below(2) == 0 ? nullptr : &chosen;
  REQUIRE(tr_init(nullptr, in.raw<std::uint32_t>(), nullptr) != TR_OK);
  REQUIRE(tr_set_controls(sim, nullptr, in.byte()) != TR_OK && tr_step(sim, nullptr, 0.01) != TR_OK);
  REQUIRE(tr_get_state(sim, nullptr) != TR_OK && tr_set_state(sim, nullptr) != TR_OK);
  REQUIRE(tr_save(sim, nullptr, in.byte(), nullptr) != TR_OK);
  REQUIRE(tr_load_saved(sim, TR_API_VERSION, nullptr, in.byte()) != TR_OK);
  REQUIRE(tr_derivative(sim, nullptr, in.byte()) != TR_OK && tr_get_outputs(sim, nullptr) != TR_OK);
  REQUIRE(tr_trim(sim, nullptr, nullptr, nullptr) != TR_OK);
  REQUIRE(tr_linearize(sim, nullptr, 1, nullptr, nullptr, 0, nullptr, 0) != TR_OK);
  REQUIRE(tr_eigenvalues(nullptr, nullptr, in.byte(), nullptr, nullptr, 0) != TR_OK);
  REQUIRE(tr_modes(nullptr, nullptr, nullptr, 0, nullptr, 0, nullptr) != TR_OK);
  REQUIRE(tr_check_setup(nullptr, TR_API_VERSION, nullptr, in.byte()) != TR_OK);
  REQUIRE(tr_check_systems(nullptr, TR_API_VERSION, nullptr, in.byte()) != TR_OK);
  REQUIRE(tr_check_environment(nullptr, TR_API_VERSION, nullptr, in.byte()) != TR_OK);
  REQUIRE(tr_check_configuration(nullptr, TR_API_VERSION, nullptr, in.byte()) != TR_OK);
  REQUIRE(tr_hash(nullptr, in.byte(), nullptr) != TR_OK);
  REQUIRE(tr_step_with_outputs(sim, nullptr, 0.01, nullptr) != TR_OK && tr_get_flags(sim, nullptr) != TR_OK);
  REQUIRE(tr_saturate_controls(sim, nullptr, in.byte(), nullptr) != TR_OK);
  REQUIRE(tr_last_fault(sim, nullptr) != TR_OK && tr_get_mass(sim, nullptr) != TR_OK);
  REQUIRE(tr_motion_at(sim, nullptr, nullptr) != TR_OK && tr_air_data_at(sim, nullptr, nullptr) != TR_OK);
  REQUIRE(tr_geodetic_at(nullptr, nullptr, nullptr) != TR_OK && tr_step_lag(nullptr, 0, 0) != TR_OK);
  REQUIRE(tr_radio_height_at(sim, nullptr, nullptr) != TR_OK && tr_read_imu(sim, nullptr, 0) != TR_OK);
  REQUIRE(tr_read_air_probe(sim, nullptr, 0, nullptr) != TR_OK);
  REQUIRE(tr_wheel_heights(sim, nullptr, nullptr, nullptr) != TR_OK);
  REQUIRE(tr_get_range(nullptr, nullptr, nullptr) != TR_OK);
  REQUIRE(tr_directional(sim, nullptr, nullptr, nullptr, nullptr, nullptr) != TR_OK);
  REQUIRE(tr_directional_inputs(sim, nullptr, nullptr, nullptr, nullptr, nullptr) != TR_OK);
  REQUIRE(tr_get_configuration(sim, nullptr) != TR_OK && tr_set_configuration(sim, nullptr) != TR_OK);
  REQUIRE(tr_default_environment(nullptr) != TR_OK && tr_set_environment(sim, nullptr) != TR_OK);
  REQUIRE(tr_set_loads(sim, nullptr, 1) != TR_OK);
  REQUIRE(tr_default_systems(nullptr) != TR_OK && tr_get_systems(sim, nullptr) != TR_OK);
  REQUIRE(tr_set_systems(sim, nullptr) != TR_OK);
  REQUIRE(tr_linearize_outputs(sim, nullptr, 1, nullptr, 0, nullptr, 0) != TR_OK);
  const auto number = in.raw<std::int32_t>();
  REQUIRE(tr_aircraft_at(number) >= 0 && tr_aircraft_name(number) != nullptr &&
          tr_aircraft_description(number) != nullptr);
  REQUIRE(tr_status_word(number) != nullptr && tr_status_text(number) != nullptr &&
          tr_state_name(number) != nullptr && tr_state_unit(number) != nullptr &&
          tr_control_name(number) != nullptr && tr_control_unit(number) != nullptr);
}

}  // namespace

FUZZ_TARGET(c_interface) {
  static Workspace workspace;
  fuzz::Bytes in(data, size);
  std::memset(&workspace, in.byte(), sizeof workspace);
  workspace.linear_model = false;
  std::memset(workspace.sim, 0, sizeof workspace.sim);
  tr_setup setup;
  REQUIRE(tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), 60) == TR_OK);
  REQUIRE(tr_init(&workspace.bystander, TR_API_VERSION, &setup) == TR_OK);
  const tr_sim bystander = workspace.bystander;

  int trims = 0;
  for (int call = 0; call < kCalls && !in.empty(); ++call) {
    tr_sim& sim = workspace.sim[in.below(2)];
    const tr_sim other = workspace.sim[&sim == workspace.sim ? 1 : 0];
    const tr_sim before = sim;
    switch (in.below(14)) {
      case 0: {
        setup = any_setup(in);
        const std::uint32_t version = in.below(8) == 0 ? in.raw<std::uint32_t>() : TR_API_VERSION;
        const tr_status status = tr_init(&sim, version, &setup);
        char line[100];
        REQUIRE(tr_check_setup(&setup, version, line, in.byte() % sizeof line) == status);
        if (status == TR_WRONG_VERSION) REQUIRE(std::memcmp(&sim, &before, sizeof sim) == 0);
        tr_state state;
        if (status == TR_BAD_ARGUMENT || status == TR_OUT_OF_RANGE)
          REQUIRE(tr_get_state(&sim, &state) == TR_NOT_INITIALIZED);
        break;
      }
      case 1:
      case 2:
        fly(sim, workspace, in);
        break;
      case 3: {
        const tr_state state = any_state(sim, in);
        const tr_status status = tr_set_state(&sim, &state);
        if (status != TR_OK) REQUIRE(capi::same_but_for_the_fault(sim, before));
        tr_state set{};
        if (status == TR_OK) REQUIRE(tr_get_state(&sim, &set) == TR_OK && tr_set_state(&sim, &set) == TR_OK);
        break;
      }
      case 4:
        read(sim, in);
        break;
      case 5:
        if (++trims <= 2) trim(sim, workspace, in);
        break;
      case 6:
        linearize(sim, workspace, in);
        break;
      case 7:
        find_modes(workspace, in);
        break;
      case 8:
        find_eigenvalues(workspace, in);
        break;
      case 9:
        save_and_load(other, sim, in);
        break;
      case 10:
        measure(sim, in);
        read_sensors(sim, in);
        break;
      case 11:
        differentiate_outputs(sim, workspace, in);
        break;
      case 12:
        fuzz::change_conditions(sim, in);
        change_systems(sim, in);
        break;
      default:
        call_with_nothing(sim, in);
    }
    REQUIRE(std::memcmp(&other, &workspace.sim[&sim == workspace.sim ? 1 : 0], sizeof other) == 0);
    REQUIRE(std::memcmp(&bystander, &workspace.bystander, sizeof bystander) == 0);
  }
}
