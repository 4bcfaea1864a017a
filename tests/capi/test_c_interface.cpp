// The C interface: every error is found and leaves the outputs alone, results are those of the C++ analyses
// bit for bit, a copied struct replays exactly, and aircraft do not disturb each other.
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "check.hpp"
#include "tiltrotor/analysis/instances.hpp"
#include "tiltrotor/model/aircraft_data.hpp"
#include "tiltrotor/tiltrotor.h"

namespace {

constexpr tr_real kNan = std::numeric_limits<tr_real>::quiet_NaN();
constexpr tr_real kInfinity = std::numeric_limits<tr_real>::infinity();
constexpr tr_real dt = tr_real(0.005);
constexpr std::size_t max_states = TR_MAX_LINEAR_STATES;

std::unique_ptr<tr_work> new_work() {
  auto work = std::make_unique<tr_work>();
  std::memset(work.get(), 0xff, sizeof *work);  // its content must not matter: NaN everywhere
  return work;
}

tr_setup setup_at(tr_real mast_deg) {
  tr_setup setup;
  CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION, TR_XV15, mast_deg), TR_OK);
  return setup;
}

tr_sim sim_at(tr_real mast_deg) {
  const tr_setup setup = setup_at(mast_deg);
  tr_sim sim;
  std::memset(&sim, 0xff, sizeof sim);
  CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK);
  return sim;
}

tr_sim trimmed_sim(tr_real mast_deg, tr_real speed) {
  tr_sim sim = sim_at(mast_deg);
  const auto work = new_work();
  const tr_flight flight = {speed, 0, 0, 0};
  tr_trim_result result;
  const tr_status status = tr_trim(&sim, work.get(), &flight, &result);
  if (!CHECK_EQ(status, TR_OK)) NOTE(result.text);
  return sim;
}

tr_state state_of(const tr_sim& sim) {
  tr_state state;
  std::memset(&state, 0, sizeof state);
  CHECK_EQ(tr_get_state(&sim, &state), TR_OK);
  return state;
}

template <class S>
bool same_bits(const S& a, const S& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

// A flight with moving controls; the state after every step.
class Flight {
 public:
  explicit Flight(const tr_sim& sim) : sim_(sim), first_(state_of(sim)), work_(new_work()) {}
  void step(int k) {
    tr_real u[4];
    std::memcpy(u, first_.u, sizeof u);
    u[TR_COLLECTIVE] += tr_real(0.005) * tr_real((k / 20) % 2);
    u[TR_LONG_STICK] += tr_real(0.01) * tr_real(k % 7 - 3);
    u[TR_LAT_STICK] += tr_real(0.01) * tr_real(k % 5 - 2);
    CHECK_EQ(tr_set_controls(&sim_, u, 4), TR_OK);
    CHECK_EQ(tr_step(&sim_, work_.get(), dt), TR_OK);
    states_.push_back(state_of(sim_));
  }
  void disturb_work() { work_ = new_work(); }
  const std::vector<tr_state>& states() const { return states_; }
  const tr_sim& sim() const { return sim_; }

 private:
  tr_sim sim_;
  tr_state first_;
  std::unique_ptr<tr_work> work_;
  std::vector<tr_state> states_;
};

bool same_flight(const Flight& a, const Flight& b) {
  if (a.states().size() != b.states().size()) return false;
  for (std::size_t k = 0; k < a.states().size(); ++k)
    if (!same_bits(a.states()[k], b.states()[k])) return false;
  return true;
}

}  // namespace

TEST(capi_sizes) {
  CHECK_LE(tr_sim_size(), sizeof(tr_sim));
  CHECK_LE(tr_work_size(), sizeof(tr_work));
  NOTE("tr_sim uses " << tr_sim_size() << " of " << sizeof(tr_sim) << " bytes, tr_work " << tr_work_size()
                      << " of " << sizeof(tr_work));
}

TEST(capi_words) {
  for (int status = 0; status < TR_STATUS_COUNT; ++status) {
    CHECK(std::strlen(tr_status_word(status)) > 0);
    CHECK(std::strcmp(tr_status_word(status), "unknown") != 0);
    CHECK(std::strlen(tr_status_text(status)) > 0);
  }
  for (const int status : {-1, int{TR_STATUS_COUNT}, 1000000}) {
    CHECK_EQ(std::string(tr_status_word(status)), "unknown");
    CHECK_EQ(std::string(tr_status_text(status)), "");
  }
  CHECK_EQ(std::string(tr_state_name(TR_PITCH)), "theta");
  CHECK_EQ(std::string(tr_state_unit(TR_DOWN)), "m");
  CHECK_EQ(std::string(tr_control_name(TR_PEDAL)), "pedal");
  CHECK_EQ(std::string(tr_control_unit(TR_GUST_W)), "m/s");
  for (const int index : {-1, int{TR_STATES}}) CHECK_EQ(std::string(tr_state_name(index)), "unknown");
  for (const int index : {-1, int{TR_CONTROLS}}) CHECK_EQ(std::string(tr_control_unit(index)), "");
  CHECK(std::strlen(tr_version()) >= 5);
}

TEST(capi_setup_errors) {
  tr_setup setup;
  std::memset(&setup, 0x5a, sizeof setup);
  const tr_setup before = setup;
  CHECK_EQ(tr_default_setup(nullptr, TR_API_VERSION, TR_XV15, 0), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION + 1, TR_XV15, 0), TR_WRONG_VERSION);
  CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION, 2, 0), TR_BAD_ARGUMENT);
  for (const tr_real mast : {tr_real(-1), tr_real(90.5), kNan, kInfinity})
    CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION, TR_XV15, mast), TR_OUT_OF_RANGE);
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
  const std::size_t room = max_states * max_states;
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
      tr_linearize_and_step(nullptr, work.get(), dt, TR_INCEPTORS, &shape, numbers, room, nullptr, 0),
      tr_linearize_and_step(&sim, nullptr, dt, TR_INCEPTORS, &shape, numbers, room, nullptr, 0),
      tr_linearize_and_step(&sim, work.get(), dt, TR_INCEPTORS, nullptr, numbers, room, nullptr, 0),
      tr_linearize_and_step(&sim, work.get(), dt, TR_INCEPTORS, &shape, nullptr, room, nullptr, 0),
      tr_linearize_and_step(&sim, work.get(), dt, 0, &shape, numbers, room, nullptr, 0),
      tr_get_state(nullptr, &state),
      tr_get_state(&sim, nullptr),
      tr_set_state(nullptr, &state),
      tr_set_state(&sim, nullptr),
      tr_derivative(nullptr, numbers, room),
      tr_derivative(&sim, nullptr, TR_STATES),
      tr_get_outputs(&sim, nullptr),
      tr_get_outputs(nullptr, nullptr),
      tr_trim(nullptr, work.get(), &flight, nullptr),
      tr_trim(&sim, nullptr, &flight, nullptr),
      tr_trim(&sim, work.get(), nullptr, nullptr),
      tr_linearize(nullptr, work.get(), TR_INCEPTORS, &shape, numbers, room, nullptr, 0),
      tr_linearize(&sim, nullptr, TR_INCEPTORS, &shape, numbers, room, nullptr, 0),
      tr_linearize(&sim, work.get(), TR_INCEPTORS, nullptr, numbers, room, nullptr, 0),
      tr_linearize(&sim, work.get(), TR_INCEPTORS, &shape, nullptr, room, nullptr, 0),
      tr_linearize(&sim, work.get(), TR_INCEPTORS, &shape, numbers, room, nullptr, room),
      tr_linearize(&sim, work.get(), 0, &shape, numbers, room, nullptr, 0),
      tr_linearize(&sim, work.get(), 99, &shape, numbers, room, nullptr, 0),
      tr_eigenvalues(nullptr, numbers, 2, numbers, numbers, 2),
      tr_eigenvalues(work.get(), nullptr, 2, numbers, numbers, 2),
      tr_eigenvalues(work.get(), numbers, 2, nullptr, numbers, 2),
      tr_eigenvalues(work.get(), numbers, 2, numbers, nullptr, 2),
      tr_modes(nullptr, &shape, numbers, room, modes, 27, &count),
      tr_modes(work.get(), nullptr, numbers, room, modes, 27, &count),
      tr_modes(work.get(), &shape, nullptr, room, modes, 27, &count),
      tr_modes(work.get(), &shape, numbers, room, nullptr, 27, &count),
      tr_modes(work.get(), &shape, numbers, room, modes, 27, nullptr),
      tr_hash(nullptr, 1, &hash),
      tr_hash(numbers, 1, nullptr)};
  for (const tr_status status : statuses) CHECK_EQ(status, TR_BAD_ARGUMENT);
  CHECK(same_bits(sim, before));
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
  CHECK(same_bits(sim, before));
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
  CHECK(same_bits(sim, before));
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
  CHECK(same_bits(sim, before));
}

// One call or two: the same model and the same flight, bit for bit, by either order of the method.
TEST(capi_linearize_and_step_is_both) {
  for (const tr_real step : {dt, tr_real(0.015)}) {
    tr_sim joint = trimmed_sim(30, 50);
    tr_sim apart = joint;
    const auto work = new_work();
    const tr_real u[] = {tr_real(0.25), tr_real(0.5), tr_real(0.3)};
    CHECK_EQ(tr_set_controls(&joint, u, 3), TR_OK);
    CHECK_EQ(tr_set_controls(&apart, u, 3), TR_OK);
    tr_linear_shape shape, other_shape;
    std::vector<tr_real> a(max_states * max_states), b(max_states * TR_CONTROLS), other_a(a), other_b(b);
    for (int k = 0; k < 20; ++k) {
      CHECK_EQ(tr_linearize_and_step(&joint, work.get(), step, TR_BLADE_CONTROLS, &shape, a.data(), a.size(),
                                     b.data(), b.size()),
               TR_OK);
      CHECK_EQ(tr_linearize(&apart, work.get(), TR_BLADE_CONTROLS, &other_shape, other_a.data(),
                            other_a.size(), other_b.data(), other_b.size()),
               TR_OK);
      CHECK_EQ(tr_step(&apart, work.get(), step), TR_OK);
      CHECK(a == other_a && b == other_b);
    }
    CHECK_EQ(shape.controls, other_shape.controls);
    CHECK(same_bits(state_of(joint), state_of(apart)));
    CHECK_LT(tr_real(1e-4), std::abs(state_of(joint).x[TR_ROLL]));
  }
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
    const bool unbounded = i == TR_YAW || (i >= TR_NORTH && i < TR_STATES);
    number = tr_real(1e6);
    if (!unbounded) CHECK_EQ(tr_set_state(&sim, &bad), TR_OUT_OF_RANGE);
  }
  tr_state bad = good;
  bad.time_s = -1;
  CHECK_EQ(tr_set_state(&sim, &bad), TR_OUT_OF_RANGE);
  bad.time_s = std::numeric_limits<double>::quiet_NaN();
  CHECK_EQ(tr_set_state(&sim, &bad), TR_NOT_FINITE);
  CHECK(same_bits(sim, before));
}

TEST(capi_bad_flights_leave_the_aircraft_alone) {
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
  // Euler angles end where the nose points straight up.
  tr_sim sim = trimmed_sim(0, 20);
  const auto work = new_work();
  tr_state state = state_of(sim);
  state.x[TR_PITCH] = tr_real(1.55);
  state.x[TR_Q] = 2;
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

TEST(capi_short_buffers) {
  const tr_sim sim = trimmed_sim(0, 20);
  const auto work = new_work();
  tr_linear_shape shape;
  CHECK_EQ(tr_linearize(&sim, work.get(), TR_INCEPTORS, &shape, nullptr, 0, nullptr, 0), TR_SHORT_BUFFER);
  CHECK_EQ(shape.states, 23);
  CHECK_EQ(shape.controls, 4);
  const std::size_t n = 23;
  const std::size_t m = 4;
  std::vector<tr_real> a(n * n, 7);
  std::vector<tr_real> b(n * m, 7);
  CHECK_EQ(tr_linearize(&sim, work.get(), TR_INCEPTORS, &shape, a.data(), n * n - 1, b.data(), n * m),
           TR_SHORT_BUFFER);
  CHECK_EQ(tr_linearize(&sim, work.get(), TR_INCEPTORS, &shape, a.data(), n * n, b.data(), n * m - 1),
           TR_SHORT_BUFFER);
  CHECK(a.front() == 7 && a.back() == 7 && b.front() == 7 && b.back() == 7);
  CHECK_EQ(tr_linearize(&sim, work.get(), TR_INCEPTORS, &shape, a.data(), n * n, b.data(), n * m), TR_OK);
  CHECK(a.back() != 7 && b.back() != 7);

  tr_real rates[TR_STATES] = {7};
  CHECK_EQ(tr_derivative(&sim, rates, TR_STATES - 1), TR_SHORT_BUFFER);
  CHECK_EQ(rates[0], 7);
  tr_real real[TR_MAX_LINEAR_STATES] = {7};
  tr_real imag[TR_MAX_LINEAR_STATES] = {7};
  CHECK_EQ(tr_eigenvalues(work.get(), a.data(), n, real, imag, n - 1), TR_SHORT_BUFFER);
  CHECK_EQ(tr_eigenvalues(work.get(), a.data(), 0, real, imag, n), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_eigenvalues(work.get(), a.data(), max_states + 1, real, imag, max_states + 1), TR_BAD_ARGUMENT);
  CHECK_EQ(real[0], 7);

  std::vector<tr_mode> modes(max_states);
  std::size_t count = 0;
  CHECK_EQ(tr_modes(work.get(), &shape, a.data(), n * n - 1, modes.data(), modes.size(), &count),
           TR_SHORT_BUFFER);
  CHECK_EQ(tr_modes(work.get(), &shape, a.data(), n * n, modes.data(), 3, &count), TR_SHORT_BUFFER);
  CHECK(count > 3 && count <= n);
  CHECK_EQ(tr_modes(work.get(), &shape, a.data(), n * n, modes.data(), count, &count), TR_OK);
  for (std::size_t i = 0; i < count; ++i) CHECK(std::strlen(modes[i].name) > 0);
}

TEST(capi_bad_matrices) {
  const tr_sim sim = trimmed_sim(0, 20);
  const auto work = new_work();
  tr_linear_shape shape;
  std::vector<tr_real> a(max_states * max_states);
  CHECK_EQ(tr_linearize(&sim, work.get(), TR_INCEPTORS, &shape, a.data(), a.size(), nullptr, 0), TR_OK);
  std::vector<tr_real> broken = a;
  broken[5] = kNan;
  tr_real real[TR_MAX_LINEAR_STATES];
  tr_real imag[TR_MAX_LINEAR_STATES];
  tr_mode modes[TR_MAX_LINEAR_STATES];
  std::size_t count = 0;
  CHECK_EQ(tr_eigenvalues(work.get(), broken.data(), 23, real, imag, max_states), TR_NOT_FINITE);
  CHECK_EQ(tr_modes(work.get(), &shape, broken.data(), broken.size(), modes, max_states, &count),
           TR_NOT_FINITE);
  const auto with = [&shape](auto&& change) {
    tr_linear_shape changed = shape;
    change(changed);
    return changed;
  };
  const tr_linear_shape bad[] = {with([](tr_linear_shape& s) { s.states = 0; }),
                                 with([](tr_linear_shape& s) { s.states = 28; }),
                                 with([](tr_linear_shape& s) { s.states = -1; }),
                                 with([](tr_linear_shape& s) { s.state[3] = -1; }),
                                 with([](tr_linear_shape& s) { s.state[3] = 1000; }),
                                 with([](tr_linear_shape& s) { s.state[3] = s.state[4]; }),
                                 with([](tr_linear_shape& s) {
                                   s.state[22] = TR_YAW;
                                   s.state[21] = TR_DOWN;
                                 })};
  for (const tr_linear_shape& b : bad)
    CHECK_EQ(tr_modes(work.get(), &b, a.data(), a.size(), modes, max_states, &count), TR_BAD_ARGUMENT);
}

// The same numbers by the C++ analyses.
TEST(capi_agrees_with_the_analyses) {
  using namespace tiltrotor;
  const Aircraft<tr_real>& aircraft = aircraft_data<tr_real>();
  for (const tr_real mast : {tr_real(0), tr_real(30), tr_real(90)}) {
    const tr_real speed = mast < 90 ? tr_real(40) : tr_real(100);
    FlightSetup<tr_real> setup = flight_setup(aircraft, mast);
    setup.options.grid = BladeGrid::realtime;
    setup.options.position_states = true;
    const auto c = std::make_unique<Configuration<tr_real>>();
    CHECK(prepare(aircraft, setup, *c) == Status::ok);
    const auto trim_work = std::make_unique<TrimWorkspace<tr_real>>();
    const auto trimmed = std::make_unique<TrimResult<tr_real>>();
    CHECK(trim(*c, SteadyFlight<tr_real>{speed, 0, 0, 0}, *trim_work, *trimmed) == TrimStatus::ok);
    tr_sim sim = trimmed_sim(mast, speed);
    tr_real x[state_count];
    tr_real u[control_count];
    pack(trimmed->state, x);
    pack(trimmed->controls, u);
    tr_state state = state_of(sim);
    CHECK(std::memcmp(state.x, x, sizeof x) == 0);
    CHECK(std::memcmp(state.u, u, sizeof u) == 0);

    const auto linear_work = std::make_unique<LinearizationWorkspace<tr_real>>();
    const auto model = std::make_unique<LinearModel<tr_real>>();
    CHECK(linearize(*c, trimmed->state, trimmed->controls, kAllControls, *linear_work, *model) == Status::ok);
    const auto work = new_work();
    tr_linear_shape shape;
    std::vector<tr_real> a(max_states * max_states);
    std::vector<tr_real> b(max_states * TR_CONTROLS);
    CHECK_EQ(tr_linearize(&sim, work.get(), TR_ALL_CONTROLS, &shape, a.data(), a.size(), b.data(), b.size()),
             TR_OK);
    CHECK_EQ(shape.states, model->states);
    bool same = true;
    const auto n = static_cast<std::size_t>(model->states);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) same = same && a[i * n + j] == model->a(int(i), int(j));
      for (std::size_t j = 0; j < 14; ++j) same = same && b[i * 14 + j] == model->b(int(i), int(j));
    }
    CHECK(same);
    // The blade controls are some of all controls: the same columns.
    std::vector<tr_real> b_blades(b.size());
    tr_linear_shape blades;
    CHECK_EQ(tr_linearize(&sim, work.get(), TR_BLADE_CONTROLS, &blades, a.data(), a.size(), b_blades.data(),
                          b_blades.size()),
             TR_OK);
    const auto columns = static_cast<std::size_t>(blades.controls);
    CHECK_EQ(columns, static_cast<std::size_t>(kBladeControls.count));
    for (std::size_t j = 0; j < columns; ++j) {
      const auto all = static_cast<std::size_t>(kBladeControls.index[j]);
      for (std::size_t i = 0; i < n; ++i)
        CHECK_REL(b_blades[i * columns + j], b[i * 14 + all], sizeof(tr_real) > 4 ? 1e-12 : 1e-4);
    }
    const auto modes_work = std::make_unique<ModesWorkspace<tr_real>>();
    const auto set = std::make_unique<ModeSet<tr_real>>();
    CHECK(modes(*model, *modes_work, *set) == Status::ok);
    std::vector<tr_mode> found(max_states);
    std::size_t count = 0;
    CHECK_EQ(tr_modes(work.get(), &shape, a.data(), a.size(), found.data(), found.size(), &count), TR_OK);
    CHECK_EQ(count, static_cast<std::size_t>(set->count));
    for (std::size_t i = 0; i < count; ++i) {
      CHECK_EQ(std::string(found[i].name), std::string(set->mode[i].name));
      CHECK_EQ(found[i].real, set->mode[i].real);
    }
    tr_real real[TR_MAX_LINEAR_STATES];
    tr_real imag[TR_MAX_LINEAR_STATES];
    CHECK_EQ(tr_eigenvalues(work.get(), a.data(), n, real, imag, max_states), TR_OK);
    tr_real trace = 0;
    tr_real sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      trace += a[i * n + i];
      sum += real[i];
    }
    CHECK_NEAR(sum, trace, (sizeof(tr_real) == 8 ? 1e-9 : 1e-2) * std::abs(trace));

    tr_outputs outputs;
    CHECK_EQ(tr_get_outputs(&sim, &outputs), TR_OK);
    CHECK_EQ(outputs.thrust_n[0], trimmed->thrust[0]);
    CHECK_EQ(outputs.power_w[1], trimmed->power[1]);
    CHECK_NEAR(outputs.load_factor, trimmed->load_factor, 1e-5);
    CHECK_NEAR(outputs.climb_rate_mps, 0, 1e-3);
    CHECK_NEAR(outputs.airspeed_mps, speed, 1e-4);

    const auto step_work = std::make_unique<SimulationWorkspace<tr_real>>();
    const auto simulation = std::make_unique<Simulation<tr_real>>();
    CHECK(start(*c, trimmed->state, trimmed->controls, dt, Integrator::rk3, *simulation) == Status::ok);
    for (int k = 0; k < 50; ++k) {
      CHECK(advance(*c, *step_work, *simulation) == Status::ok);
      CHECK_EQ(tr_step(&sim, work.get(), dt), TR_OK);
    }
    pack(simulation->state, x);
    state = state_of(sim);
    CHECK(std::memcmp(state.x, x, sizeof x) == 0);
    CHECK_NEAR(state.time_s, 0.25, 1e-7);
    CHECK_EQ(state.steps, 50);
  }
}

TEST(capi_a_copied_struct_replays_bit_for_bit) {
  Flight whole(trimmed_sim(30, 50));
  Flight first(trimmed_sim(30, 50));
  for (int k = 0; k < 200; ++k) whole.step(k);
  for (int k = 0; k < 80; ++k) first.step(k);
  const tr_state snapshot = state_of(first.sim());

  // Restored into another aircraft of the same setup, which has flown something else.
  tr_sim other = trimmed_sim(30, 60);
  CHECK_EQ(tr_step(&other, new_work().get(), dt), TR_OK);
  CHECK_EQ(tr_set_state(&other, &snapshot), TR_OK);
  const tr_state back = state_of(other);
  CHECK(same_bits(back, snapshot));
  const tr_sim copied = first.sim();
  Flight by_copy(copied);
  for (const tr_sim* sim : {static_cast<const tr_sim*>(&other), &copied}) {
    tr_sim s = *sim;
    const auto work = new_work();
    const tr_state start_state = whole.states()[79];
    CHECK(same_bits(state_of(s), start_state));
    for (int k = 80; k < 200; ++k) {
      const tr_state& wanted = whole.states()[static_cast<std::size_t>(k)];
      CHECK_EQ(tr_set_controls(&s, wanted.u, TR_CONTROLS), TR_OK);
      CHECK_EQ(tr_step(&s, work.get(), dt), TR_OK);
      if (!CHECK(same_bits(state_of(s), wanted))) break;
    }
  }
}

TEST(capi_interleaved_aircraft_give_the_same_bits_as_alone) {
  Flight alone_a(trimmed_sim(0, 20));
  Flight alone_b(trimmed_sim(90, 100));
  for (int k = 0; k < 100; ++k) alone_a.step(k);
  for (int k = 0; k < 100; ++k) alone_b.step(k);

  Flight a(trimmed_sim(0, 20));
  Flight b(trimmed_sim(90, 100));
  const auto shared = new_work();
  for (int k = 0; k < 100; ++k) {
    a.step(k);
    if (k % 3 == 0) a.disturb_work();
    // What else runs between the steps, on the same scratch memory, must not be seen.
    tr_sim visitor = sim_at(60);
    const tr_flight flight = {60, 0, 0, 0};
    if (k % 25 == 0) CHECK_EQ(tr_trim(&visitor, shared.get(), &flight, nullptr), TR_OK);
    b.step(k);
    tr_outputs outputs;
    CHECK_EQ(tr_get_outputs(&a.sim(), &outputs), TR_OK);
  }
  CHECK(same_flight(a, alone_a));
  CHECK(same_flight(b, alone_b));
}

TEST(capi_misplaced_work) {
  // The address of the scratch memory does not change a bit: 8, 16, ... 64 bytes beyond a line of the cache.
  std::vector<std::uint64_t> memory(sizeof(tr_work) / 8 + 16);
  tr_sim reference = trimmed_sim(0, 20);
  CHECK_EQ(tr_step(&reference, new_work().get(), dt), TR_OK);
  for (std::size_t shift = 0; shift < 8; ++shift) {
    auto* work = reinterpret_cast<tr_work*>(memory.data() + shift);
    tr_sim sim = sim_at(0);
    const tr_flight flight = {20, 0, 0, 0};
    CHECK_EQ(tr_trim(&sim, work, &flight, nullptr), TR_OK);
    CHECK_EQ(tr_step(&sim, work, dt), TR_OK);
    CHECK(same_bits(state_of(sim), state_of(reference)));
  }
}

TEST(capi_hash) {
  // FNV-1a of the bytes of 1.0 (double 00..f03f, float 0000803f), computed by hand with the published
  // constants.
  std::uint64_t expected = TR_HASH_START;
  const unsigned char tail[] = {0xf0, 0x3f};
  const unsigned char tail_single[] = {0x80, 0x3f};
  for (std::size_t k = 0; k + 2 < sizeof(tr_real); ++k) expected *= 1099511628211u;
  for (const unsigned char byte : sizeof(tr_real) == 8 ? tail : tail_single)
    expected = (expected ^ byte) * 1099511628211u;
  std::uint64_t hash = TR_HASH_START;
  const tr_real one = 1;
  CHECK_EQ(tr_hash(&one, 1, &hash), TR_OK);
  CHECK_EQ(hash, expected);
  CHECK_EQ(tr_hash(nullptr, 0, &hash), TR_OK);
  CHECK_EQ(hash, expected);
}

TEST(slow_capi_a_minute_under_control) {
  // Flight at 200 Hz under an autopilot that holds the trimmed attitude and banks to and fro.
  tr_sim sim = trimmed_sim(0, 40);
  const auto work = new_work();
  const tr_state trimmed = state_of(sim);
  tr_state state = trimmed;
  int errors = 0;
  for (int k = 0; k < 60 * 200 && errors == 0; ++k) {
    tr_real u[4];
    std::memcpy(u, trimmed.u, sizeof u);
    const auto held = [](tr_real x, tr_real low, tr_real high) {
      return x < low ? low : x > high ? high : x;
    };
    const tr_real roll_wanted = tr_real(0.1) * tr_real((k / 4000) % 3 - 1);
    u[TR_COLLECTIVE] +=
        held(tr_real(0.01) * (state.x[TR_W] - trimmed.x[TR_W]), tr_real(-0.05), tr_real(0.05));
    u[TR_LONG_STICK] =
        held(u[TR_LONG_STICK] + 8 * (state.x[TR_PITCH] - trimmed.x[TR_PITCH]) + 5 * state.x[TR_Q],
             tr_real(-4.8), tr_real(4.8));
    u[TR_LAT_STICK] = held(u[TR_LAT_STICK] - 4 * (state.x[TR_ROLL] - roll_wanted) - 3 * state.x[TR_P],
                           tr_real(-4.8), tr_real(4.8));
    u[TR_PEDAL] = held(u[TR_PEDAL] - 2 * state.x[TR_R], tr_real(-2.5), tr_real(2.5));
    if (tr_set_controls(&sim, u, 4) != TR_OK || tr_step(&sim, work.get(), dt) != TR_OK) ++errors;
    if (tr_get_state(&sim, &state) != TR_OK) ++errors;
  }
  CHECK_EQ(errors, 0);
  CHECK_NEAR(state.time_s, 60, 1e-6);
  NOTE("after " << state.time_s << " s: u " << state.x[TR_U] << " m/s, pitch " << state.x[TR_PITCH]
                << " rad, " << state.steps << " steps, " << errors << " errors");
}
