// The C interface: every error is found and leaves the outputs and the aircraft alone.
// Expected: the header's text.
#include "capi/flying.hpp"
#include "capi/same_aircraft.hpp"

using namespace capi;

TEST(capi_setup_errors) {
  tr_setup setup;
  std::memset(&setup, 0x5a, sizeof setup);
  const tr_setup before = setup;
  CHECK_EQ(tr_default_setup(nullptr, TR_API_VERSION, tr_aircraft_at(0), 0), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION + 1, tr_aircraft_at(0), 0), TR_WRONG_VERSION);
  CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0) + 1, 0), TR_BAD_ARGUMENT);
  for (const tr_real mast : {tr_real(-1), tr_real(90.5), kNan, kInfinity})
    CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), mast), TR_OUT_OF_RANGE);
  CHECK(same_bits(setup, before));
}

TEST(capi_init_errors) {
  const tr_setup good = setup_at(30);
  tr_sim sim;
  std::memset(&sim, 0x5a, sizeof sim);
  const tr_sim before = sim;
  CHECK_EQ(tr_init(nullptr, TR_API_VERSION, &good), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_init(&sim, TR_API_VERSION ^ 0xc, &good), TR_WRONG_VERSION);  // the other precision
  CHECK(same_bits(sim, before));
  CHECK_EQ(tr_init(&sim, TR_API_VERSION, nullptr), TR_BAD_ARGUMENT);

  const auto with = [&good](auto&& change) {
    tr_setup setup = good;
    change(setup);
    return setup;
  };
  const tr_setup unknown[] = {with([](tr_setup& s) { s.aircraft = 0; }),
                              with([](tr_setup& s) { s.grid = 0; }), with([](tr_setup& s) { s.tables = 9; }),
                              with([](tr_setup& s) { s.coning_states = 2; })};
  for (const tr_setup& setup : unknown) {
    sim = sim_at(0);
    CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_BAD_ARGUMENT);
    tr_state state;
    CHECK_EQ(tr_get_state(&sim, &state), TR_NOT_INITIALIZED);
  }
  tr_real tr_setup::*const numbers[] = {&tr_setup::mast_deg, &tr_setup::flap_deg,    &tr_setup::altitude_m,
                                        &tr_setup::mass_kg,  &tr_setup::rotor_radps, &tr_setup::cg_station_m};
  for (const auto number : numbers) {
    for (const tr_real bad : {kNan, kInfinity, -kInfinity, tr_real(-1000), tr_real(20000)}) {
      tr_setup setup = good;
      setup.*number = bad;
      sim = sim_at(0);
      CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OUT_OF_RANGE);
      CHECK_EQ(tr_step(&sim, new_work().get(), dt), TR_NOT_INITIALIZED);
    }
  }
}

TEST(capi_calls_before_init) {
  for (const int byte : {0x00, 0x5a, 0xff}) {
    tr_sim sim;
    std::memset(&sim, byte, sizeof sim);
    const tr_sim before = sim;
    const auto work = new_work();
    const tr_flight flight = {40, 0, 0, 0};
    tr_real numbers[max_states * max_states] = {};
    tr_state state{};
    tr_outputs outputs;
    tr_linear_shape shape;
    CHECK_EQ(tr_set_controls(&sim, numbers, 4), TR_NOT_INITIALIZED);
    CHECK_EQ(tr_step(&sim, work.get(), dt), TR_NOT_INITIALIZED);
    CHECK_EQ(tr_get_state(&sim, &state), TR_NOT_INITIALIZED);
    CHECK_EQ(tr_set_state(&sim, &state), TR_NOT_INITIALIZED);
    std::size_t used = 7;
    CHECK_EQ(tr_save(&sim, numbers, sizeof numbers, &used), TR_NOT_INITIALIZED);
    CHECK_EQ(used, 7);
    CHECK_EQ(tr_derivative(&sim, numbers, TR_STATES), TR_NOT_INITIALIZED);
    CHECK_EQ(tr_get_outputs(&sim, &outputs), TR_NOT_INITIALIZED);
    CHECK_EQ(tr_trim(&sim, work.get(), &flight, nullptr), TR_NOT_INITIALIZED);
    CHECK_EQ(
        tr_linearize(&sim, work.get(), TR_INCEPTORS, &shape, numbers, max_states * max_states, nullptr, 0),
        TR_NOT_INITIALIZED);
    CHECK_EQ(tr_linearize_and_step(&sim, work.get(), dt, TR_INCEPTORS, &shape, numbers,
                                   max_states * max_states, nullptr, 0),
             TR_NOT_INITIALIZED);
    CHECK(same_bits(sim, before));
  }
}

TEST(capi_null_pointers) {
  tr_sim sim = trimmed_sim(0, 20);
  const tr_sim before = sim;
  const auto work = new_work();
  const tr_flight flight = {40, 0, 0, 0};
  tr_real numbers[max_states * max_states] = {};
  const std::size_t capacity = max_states * max_states;
  tr_state state{};
  tr_linear_shape shape;
  tr_mode modes[TR_MAX_LINEAR_STATES];
  std::size_t count = 0;
  std::uint64_t hash = TR_HASH_START;
  const tr_status statuses[] = {
      tr_set_controls(nullptr, numbers, 4),
      tr_set_controls(&sim, nullptr, 4),
      tr_step(nullptr, work.get(), dt),
      tr_step(&sim, nullptr, dt),
      tr_linearize_and_step(nullptr, work.get(), dt, TR_INCEPTORS, &shape, numbers, capacity, nullptr, 0),
      tr_linearize_and_step(&sim, nullptr, dt, TR_INCEPTORS, &shape, numbers, capacity, nullptr, 0),
      tr_linearize_and_step(&sim, work.get(), dt, TR_INCEPTORS, nullptr, numbers, capacity, nullptr, 0),
      tr_linearize_and_step(&sim, work.get(), dt, TR_INCEPTORS, &shape, nullptr, capacity, nullptr, 0),
      tr_linearize_and_step(&sim, work.get(), dt, 0, &shape, numbers, capacity, nullptr, 0),
      tr_get_state(nullptr, &state),
      tr_get_state(&sim, nullptr),
      tr_set_state(nullptr, &state),
      tr_set_state(&sim, nullptr),
      tr_save(nullptr, numbers, sizeof numbers, &count),
      tr_save(&sim, nullptr, sizeof numbers, &count),
      tr_save(&sim, numbers, sizeof numbers, nullptr),
      tr_load_saved(nullptr, TR_API_VERSION, numbers, sizeof numbers),
      tr_load_saved(&sim, TR_API_VERSION, nullptr, sizeof numbers),
      tr_derivative(nullptr, numbers, capacity),
      tr_derivative(&sim, nullptr, TR_STATES),
      tr_get_outputs(&sim, nullptr),
      tr_get_outputs(nullptr, nullptr),
      tr_trim(nullptr, work.get(), &flight, nullptr),
      tr_trim(&sim, nullptr, &flight, nullptr),
      tr_trim(&sim, work.get(), nullptr, nullptr),
      tr_linearize(nullptr, work.get(), TR_INCEPTORS, &shape, numbers, capacity, nullptr, 0),
      tr_linearize(&sim, nullptr, TR_INCEPTORS, &shape, numbers, capacity, nullptr, 0),
      tr_linearize(&sim, work.get(), TR_INCEPTORS, nullptr, numbers, capacity, nullptr, 0),
      tr_linearize(&sim, work.get(), TR_INCEPTORS, &shape, nullptr, capacity, nullptr, 0),
      tr_linearize(&sim, work.get(), TR_INCEPTORS, &shape, numbers, capacity, nullptr, capacity),
      tr_linearize(&sim, work.get(), 0, &shape, numbers, capacity, nullptr, 0),
      tr_linearize(&sim, work.get(), 99, &shape, numbers, capacity, nullptr, 0),
      tr_eigenvalues(nullptr, numbers, 2, numbers, numbers, 2),
      tr_eigenvalues(work.get(), nullptr, 2, numbers, numbers, 2),
      tr_eigenvalues(work.get(), numbers, 2, nullptr, numbers, 2),
      tr_eigenvalues(work.get(), numbers, 2, numbers, nullptr, 2),
      tr_modes(nullptr, &shape, numbers, capacity, modes, 27, &count),
      tr_modes(work.get(), nullptr, numbers, capacity, modes, 27, &count),
      tr_modes(work.get(), &shape, nullptr, capacity, modes, 27, &count),
      tr_modes(work.get(), &shape, numbers, capacity, nullptr, 27, &count),
      tr_modes(work.get(), &shape, numbers, capacity, modes, 27, nullptr),
      tr_hash(nullptr, 1, &hash),
      tr_hash(numbers, 1, nullptr)};
  for (const tr_status status : statuses) CHECK_EQ(status, TR_BAD_ARGUMENT);
  CHECK(same_but_for_the_fault(sim, before));
  CHECK_EQ(hash, TR_HASH_START);
}

TEST(capi_bad_controls_set_nothing) {
  tr_sim sim = trimmed_sim(0, 20);
  const tr_sim before = sim;
  const tr_real limits[TR_CONTROLS] = {
      tr_real(1.4), tr_real(4.8), tr_real(4.8), tr_real(2.5), tr_real(0.5), tr_real(0.5), tr_real(0.5),
      tr_real(0.5), tr_real(0.5), tr_real(0.5), tr_real(0.5), 50,           50,           50};
  for (std::size_t j = 0; j < TR_CONTROLS; ++j) {
    tr_real u[TR_CONTROLS] = {tr_real(0.1), tr_real(0.1)};
    for (const tr_real bad : {kNan, kInfinity, -kInfinity}) {
      u[j] = bad;
      CHECK_EQ(tr_set_controls(&sim, u, TR_CONTROLS), TR_NOT_FINITE);
    }
    for (const tr_real factor : {tr_real(-1.01), tr_real(1.01)}) {
      u[j] = factor * limits[j];
      CHECK_EQ(tr_set_controls(&sim, u, TR_CONTROLS), TR_OUT_OF_RANGE);
    }
  }
  const tr_real u[TR_CONTROLS + 1] = {};
  CHECK_EQ(tr_set_controls(&sim, u, 0), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_set_controls(&sim, u, TR_CONTROLS + 1), TR_BAD_ARGUMENT);
  CHECK(same_but_for_the_fault(sim, before));
  CHECK_EQ(tr_set_controls(&sim, limits, TR_CONTROLS), TR_OK);
  const tr_state state = state_of(sim);
  CHECK(std::memcmp(state.u, limits, sizeof limits) == 0);
}

TEST(capi_bad_steps_move_nothing) {
  tr_sim sim = trimmed_sim(0, 20);
  const tr_sim before = sim;
  const auto work = new_work();
  for (const tr_real bad : {kNan, kInfinity, -kInfinity})
    CHECK_EQ(tr_step(&sim, work.get(), bad), TR_NOT_FINITE);
  for (const tr_real bad : {tr_real(0), -tr_real(0), tr_real(-0.005), tr_real(0.0201), tr_real(1e30)})
    CHECK_EQ(tr_step(&sim, work.get(), bad), TR_OUT_OF_RANGE);
  CHECK(same_but_for_the_fault(sim, before));
  tr_linear_shape shape;
  tr_real a[max_states * max_states] = {7};
  CHECK_EQ(tr_linearize_and_step(&sim, work.get(), kNan, TR_INCEPTORS, &shape, a, max_states * max_states,
                                 nullptr, 0),
           TR_NOT_FINITE);
  CHECK_EQ(tr_linearize_and_step(&sim, work.get(), 1, TR_INCEPTORS, &shape, a, max_states * max_states,
                                 nullptr, 0),
           TR_OUT_OF_RANGE);
  CHECK_EQ(tr_linearize_and_step(&sim, work.get(), dt, TR_INCEPTORS, &shape, a, 5, nullptr, 0),
           TR_SHORT_BUFFER);
  CHECK_EQ(a[0], 7);
  CHECK(same_but_for_the_fault(sim, before));
}

TEST(capi_restore_errors) {
  tr_sim sim = trimmed_sim(0, 20);
  const tr_sim before = sim;
  const tr_state good = state_of(sim);
  for (std::size_t i = 0; i < TR_STATES + TR_CONTROLS; ++i) {
    tr_state bad = good;
    tr_real& number = i < TR_STATES ? bad.x[i] : bad.u[i - TR_STATES];
    number = kNan;
    CHECK_EQ(tr_set_state(&sim, &bad), TR_NOT_FINITE);
    number = -kInfinity;
    CHECK_EQ(tr_set_state(&sim, &bad), TR_NOT_FINITE);
    for (const tr_real far : {tr_real(1.1e9), -std::numeric_limits<tr_real>::max()}) {
      number = far;
      CHECK_EQ(tr_set_state(&sim, &bad), TR_OUT_OF_RANGE);
    }
  }
  tr_state bad = good;
  bad.time_s = -1;
  CHECK_EQ(tr_set_state(&sim, &bad), TR_OUT_OF_RANGE);
  bad.time_s = std::numeric_limits<double>::quiet_NaN();
  CHECK_EQ(tr_set_state(&sim, &bad), TR_NOT_FINITE);
  CHECK(same_but_for_the_fault(sim, before));
}

TEST_OF_XV15(capi_bad_flights_leave_the_aircraft_alone) {
  tr_sim sim = trimmed_sim(0, 20);
  const tr_sim before = sim;
  const auto work = new_work();
  const tr_flight bad[] = {{kNan, 0, 0, 0}, {20, kNan, 0, 0},    {20, 0, kNan, 0}, {20, 0, 0, kNan},
                           {-1, 0, 0, 0},   {151, 0, 0, 0},      {20, -2, 0, 0},   {20, 0, kInfinity, 0},
                           {20, 0, 0, 2},   {kInfinity, 0, 0, 0}};
  for (const tr_flight& flight : bad) {
    tr_trim_result result;
    result.text[0] = '\0';
    const bool finite = std::isfinite(flight.speed_mps) && std::isfinite(flight.climb_rad) &&
                        std::isfinite(flight.turn_rate_radps) && std::isfinite(flight.sideslip_rad);
    CHECK_EQ(tr_trim(&sim, work.get(), &flight, &result), finite ? TR_OUT_OF_RANGE : TR_NOT_FINITE);
    CHECK(std::strlen(result.text) > 0);
    CHECK(same_bits(sim, before));
  }
  // Beyond a limit: the aircraft takes the trim, and the status names the kind of limit.
  const auto beyond = [&work](tr_real mast_deg, const tr_flight& flight, const char* words) {
    tr_sim limited = sim_at(mast_deg);
    tr_trim_result result;
    const tr_status status = tr_trim(&limited, work.get(), &flight, &result);
    CHECK(std::strstr(result.text, words) != nullptr);
    return status;
  };
  CHECK_EQ(beyond(30, {24, 0, 0, 0}, "wing angle of attack"), TR_WING_STALL);
  CHECK_EQ(beyond(0, {40, 0, 0, tr_real(0.35)}, "pedal"), TR_CONTROL_LIMIT);
  // In thin air the rotors stall before they carry the weight: the aircraft stays as it was.
  tr_setup setup = setup_at(0);
  setup.altitude_m = 3500;
  tr_sim high;
  CHECK_EQ(tr_init(&high, TR_API_VERSION, &setup), TR_OK);
  const tr_sim high_before = high;
  const tr_flight slow = {6, 0, 0, 0};
  tr_trim_result stalled;
  CHECK_EQ(tr_trim(&high, work.get(), &slow, &stalled), TR_ROTOR_STALL);
  CHECK(std::strstr(stalled.text, "the aircraft carries at most") != nullptr);
  CHECK(same_bits(high, high_before));
  // 140 m/s in helicopter mode: no trim, or one beyond a limit; never a crash, always a reason.
  const tr_flight fast = {140, 0, 0, 0};
  tr_trim_result result;
  const tr_status status = tr_trim(&sim, work.get(), &fast, &result);
  CHECK(status != TR_OK);
  NOTE("140 m/s at mast 0: " << tr_status_word(status) << ", " << result.text);
}

TEST(capi_divergence_is_reported) {
  // A place is told to 1e9 m.
  tr_sim sim = trimmed_sim(0, 20);
  const auto work = new_work();
  tr_state state = state_of(sim);
  state.position_m[0] = sizeof(tr_real) == 8 ? 1e9 - 1 : 1e9;
  state.x[TR_NORTH] = tr_real(state.position_m[0]);
  CHECK_EQ(tr_set_state(&sim, &state), TR_OK);
  tr_status status = TR_OK;
  tr_state before{};
  for (int k = 0; k < 100 && status == TR_OK; ++k) {
    before = state_of(sim);
    status = tr_step(&sim, work.get(), dt);
  }
  CHECK_EQ(status, TR_OUT_OF_RANGE);
  CHECK(same_bits(state_of(sim), before));
  CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OUT_OF_RANGE);
}
