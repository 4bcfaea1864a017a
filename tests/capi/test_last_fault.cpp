// tr_last_fault: which call failed, at which state or control, when.
// Expected: the number that was made bad.
#include "capi/flying.hpp"
#include "capi/same_aircraft.hpp"

using namespace capi;

namespace {

tr_fault fault_of(const tr_sim& sim) {
  tr_fault fault;
  std::memset(&fault, 0x5a, sizeof fault);
  CHECK_EQ(tr_last_fault(&sim, &fault), TR_OK);
  return fault;
}

void check_fault(const tr_sim& sim, std::int32_t status, std::int32_t state, std::int32_t control) {
  const tr_fault fault = fault_of(sim);
  CHECK_EQ(fault.status, status);
  CHECK_EQ(fault.state, state);
  CHECK_EQ(fault.control, control);
  CHECK_EQ(fault.time_s, status == TR_OK ? 0 : state_of(sim).time_s);
}

// In flight, so that time is not zero.
tr_sim flying() {
  tr_sim sim = trimmed_sim(0, 20);
  const auto work = new_work();
  for (int k = 0; k < 3; ++k) CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OK);
  return sim;
}

}  // namespace

TEST(capi_fault_names_the_bad_number_of_a_state) {
  tr_sim sim = flying();
  check_fault(sim, TR_OK, -1, -1);
  const tr_state good = state_of(sim);
  for (int i = 0; i < TR_STATES + TR_CONTROLS; ++i) {
    tr_state bad = good;
    const bool is_state = i < TR_STATES;
    tr_real& number = is_state ? bad.x[i] : bad.u[i - TR_STATES];
    const std::int32_t state = is_state ? i : -1, control = is_state ? -1 : i - TR_STATES;
    number = kNan;
    CHECK_EQ(tr_set_state(&sim, &bad), TR_NOT_FINITE);
    check_fault(sim, TR_NOT_FINITE, state, control);
    number = tr_real(1.1e9);
    CHECK_EQ(tr_set_state(&sim, &bad), TR_OUT_OF_RANGE);
    check_fault(sim, TR_OUT_OF_RANGE, state, control);
  }
  tr_state bad = good;
  bad.time_s = -1;
  CHECK_EQ(tr_set_state(&sim, &bad), TR_OUT_OF_RANGE);
  check_fault(sim, TR_OUT_OF_RANGE, -1, -1);
  bad = good;
  bad.x[TR_Q] = kNan;  // the first is named
  bad.x[TR_YAW] = kInfinity;
  bad.u[TR_RUDDER] = kNan;
  CHECK_EQ(tr_set_state(&sim, &bad), TR_NOT_FINITE);
  check_fault(sim, TR_NOT_FINITE, TR_Q, TR_RUDDER);
  CHECK_EQ(tr_set_state(&sim, nullptr), TR_BAD_ARGUMENT);
  check_fault(sim, TR_BAD_ARGUMENT, -1, -1);
}

// A state that leads its configuration out of its range.
TEST(capi_fault_names_the_system_behind_a_configuration) {
  tr_sim sim = flying();
  tr_systems systems;
  CHECK_EQ(tr_get_systems(&sim, &systems), TR_OK);
  systems.conversion = systems.engines = 1;
  systems.governor = TR_GOVERNOR_PI;
  systems.interconnect = 1;
  CHECK_EQ(tr_set_systems(&sim, &systems), TR_OK);
  const tr_state good = state_of(sim);
  const struct {
    std::int32_t state;
    tr_real number;
  } cases[] = {{TR_MAST, tr_real(-0.1)},     {TR_FLAP, tr_real(1.9)},      {TR_ROTOR_SPEED, tr_real(5)},
               {TR_FUEL, tr_real(-1e5)},     {TR_FUEL, tr_real(9e5)},      {TR_MAST_RATE, tr_real(1.9)},
               {TR_TWIST_RATE, tr_real(80)}, {TR_TWIST_RATE, tr_real(-80)}};
  for (const auto& one : cases) {
    tr_state bad = good;
    bad.x[one.state] = one.number;
    CHECK_EQ(tr_set_state(&sim, &bad), TR_OUT_OF_RANGE);
    check_fault(sim, TR_OUT_OF_RANGE, one.state, -1);
    CHECK(same_bits(state_of(sim), good));
  }
}

TEST(capi_fault_names_the_bad_control) {
  tr_sim sim = flying();
  for (int j = 0; j < TR_CONTROLS; ++j) {
    tr_real u[TR_CONTROLS] = {};
    std::uint32_t clipped = 0;
    u[j] = tr_real(60);
    CHECK_EQ(tr_set_controls(&sim, u, TR_CONTROLS), TR_OUT_OF_RANGE);
    check_fault(sim, TR_OUT_OF_RANGE, -1, j);
    u[j] = kInfinity;
    CHECK_EQ(tr_saturate_controls(&sim, u, TR_CONTROLS, &clipped), TR_NOT_FINITE);
    check_fault(sim, TR_NOT_FINITE, -1, j);
    CHECK_EQ(tr_set_controls(&sim, u, 0), TR_BAD_ARGUMENT);
    check_fault(sim, TR_BAD_ARGUMENT, -1, -1);
    u[j] = kNan;
    CHECK_EQ(tr_set_controls(&sim, u, TR_CONTROLS), TR_NOT_FINITE);
    check_fault(sim, TR_NOT_FINITE, -1, j);
  }
}

// North beyond the farthest place: whichever call flies.
TEST(capi_fault_names_the_state_that_diverged) {
  const auto work = new_work();
  for (int call = 0; call < 3; ++call) {
    tr_sim sim = flying();
    tr_state state = state_of(sim);
    state.position_m[0] = sizeof(tr_real) == 8 ? 1e9 - 1 : 1e9;
    state.x[TR_NORTH] = tr_real(state.position_m[0]);
    state.x[TR_YAW] = 0;
    CHECK_EQ(tr_set_state(&sim, &state), TR_OK);
    tr_status status = TR_OK;
    tr_outputs outputs;
    tr_linear_shape shape;
    std::vector<tr_real> a(max_states * max_states);
    for (int k = 0; k < 100 && status == TR_OK; ++k)
      status = call == 0   ? tr_step(&sim, work.get(), dt)
               : call == 1 ? tr_step_with_outputs(&sim, work.get(), dt, &outputs)
                           : tr_linearize_and_step(&sim, work.get(), dt, TR_INCEPTORS, &shape, a.data(),
                                                   a.size(), nullptr, 0);
    CHECK_EQ(status, TR_OUT_OF_RANGE);
    check_fault(sim, TR_OUT_OF_RANGE, TR_NORTH, -1);
    if (sizeof(tr_real) == 8) CHECK_LT(0, fault_of(sim).time_s);
  }
}

TEST(capi_fault_of_a_refused_step) {
  tr_sim sim = flying();
  const auto work = new_work();
  tr_outputs outputs;
  tr_linear_shape shape;
  const auto linearize_and_step = [&](tr_real length, std::int32_t columns) {
    return tr_linearize_and_step(&sim, work.get(), length, columns, &shape, nullptr, 0, nullptr, 0);
  };
  CHECK_EQ(tr_step(&sim, work.get(), kNan), TR_NOT_FINITE);
  check_fault(sim, TR_NOT_FINITE, -1, -1);
  CHECK_EQ(tr_step_with_outputs(&sim, work.get(), 1, &outputs), TR_OUT_OF_RANGE);
  check_fault(sim, TR_OUT_OF_RANGE, -1, -1);
  CHECK_EQ(tr_step(&sim, nullptr, dt), TR_BAD_ARGUMENT);
  check_fault(sim, TR_BAD_ARGUMENT, -1, -1);
  CHECK_EQ(linearize_and_step(dt, TR_INCEPTORS), TR_SHORT_BUFFER);
  check_fault(sim, TR_SHORT_BUFFER, -1, -1);
  CHECK_EQ(linearize_and_step(kNan, TR_INCEPTORS), TR_NOT_FINITE);
  check_fault(sim, TR_NOT_FINITE, -1, -1);
  CHECK_EQ(linearize_and_step(dt, 99), TR_BAD_ARGUMENT);
  check_fault(sim, TR_BAD_ARGUMENT, -1, -1);
}

// What succeeds, and what only reads, leaves it; a new aircraft has none; it belongs to one aircraft.
TEST(capi_fault_stays_until_the_next) {
  tr_sim sim = flying();
  const tr_sim before = sim;
  const auto work = new_work();
  CHECK_EQ(tr_step(&sim, work.get(), 1), TR_OUT_OF_RANGE);
  CHECK(same_but_for_the_fault(sim, before));
  const tr_fault found = fault_of(sim);
  CHECK_EQ(tr_get_state(&sim, nullptr), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_get_outputs(&sim, nullptr), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OK);
  CHECK_EQ(fault_of(sim).status, found.status);
  CHECK_EQ(fault_of(sim).time_s, found.time_s);
  const tr_sim copy = sim;
  CHECK_EQ(fault_of(copy).time_s, found.time_s);
  check_fault(before, TR_OK, -1, -1);

  unsigned char bytes[TR_SAVED_SIZE];
  std::size_t used = 0;
  CHECK_EQ(tr_save(&sim, bytes, sizeof bytes, &used), TR_OK);
  tr_sim loaded;
  CHECK_EQ(tr_load_saved(&loaded, TR_API_VERSION, bytes, used), TR_OK);
  check_fault(loaded, TR_OK, -1, -1);
  const tr_setup setup = setup_at(0);
  CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK);
  check_fault(sim, TR_OK, -1, -1);

  tr_fault fault;
  CHECK_EQ(tr_last_fault(nullptr, &fault), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_last_fault(&sim, nullptr), TR_BAD_ARGUMENT);
  std::memset(&loaded, 0x5a, sizeof loaded);
  CHECK_EQ(tr_last_fault(&loaded, &fault), TR_NOT_INITIALIZED);
}
