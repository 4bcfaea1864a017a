// Aircraft of the C interface for its tests: made, trimmed, flown.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

#include "check.hpp"
#include "tiltrotor/tiltrotor.h"

namespace capi {

inline constexpr tr_real kNan = std::numeric_limits<tr_real>::quiet_NaN();
inline constexpr tr_real kInfinity = std::numeric_limits<tr_real>::infinity();
inline constexpr tr_real dt = tr_real(0.005);
inline constexpr std::size_t max_states = TR_MAX_LINEAR_STATES;

inline std::unique_ptr<tr_work> new_work() {
  auto work = std::make_unique<tr_work>();
  std::memset(work.get(), 0xff, sizeof *work);  // its content must not matter: NaN everywhere
  return work;
}

inline tr_setup setup_at(tr_real mast_deg) {
  tr_setup setup;
  CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), mast_deg), TR_OK);
  return setup;
}

inline tr_sim sim_at(tr_real mast_deg) {
  const tr_setup setup = setup_at(mast_deg);
  tr_sim sim;
  std::memset(&sim, 0xff, sizeof sim);
  CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK);
  return sim;
}

inline tr_sim trimmed_sim(tr_real mast_deg, tr_real speed) {
  tr_sim sim = sim_at(mast_deg);
  const auto work = new_work();
  const tr_flight flight = {speed, 0, 0, 0};
  tr_trim_result result;
  const tr_status status = tr_trim(&sim, work.get(), &flight, &result);
  if (!CHECK_EQ(status, TR_OK)) NOTE(result.text);
  return sim;
}

inline tr_state state_of(const tr_sim& sim) {
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

inline bool same_flight(const Flight& a, const Flight& b) {
  if (a.states().size() != b.states().size()) return false;
  for (std::size_t k = 0; k < a.states().size(); ++k)
    if (!same_bits(a.states()[k], b.states()[k])) return false;
  return true;
}

// Flies on with moving controls; a hash of everything on the way. Continues where another process stopped.
inline std::uint64_t flown_on(tr_sim& sim, int steps) {
  const auto work = new_work();
  const tr_state begin = state_of(sim);
  std::uint64_t hash = TR_HASH_START;
  tr_real a[max_states * max_states];
  for (int k = 0; k < steps; ++k) {
    tr_real u[3];
    std::memcpy(u, begin.u, sizeof u);
    u[TR_LONG_STICK] += tr_real(0.02) * tr_real(k % 5 - 2);
    u[TR_LAT_STICK] += tr_real(0.1) * tr_real(k / 8 % 3 - 1);
    CHECK_EQ(tr_set_controls(&sim, u, 3), TR_OK);
    tr_linear_shape shape;
    const bool with_model = k % 20 == 7;
    const tr_status status = with_model ? tr_linearize_and_step(&sim, work.get(), dt, TR_INCEPTORS, &shape, a,
                                                                max_states * max_states, nullptr, 0)
                                        : tr_step(&sim, work.get(), dt);
    CHECK_EQ(status, TR_OK);
    const tr_state state = state_of(sim);
    CHECK_EQ(tr_hash(state.x, TR_STATES, &hash), TR_OK);
    if (with_model) CHECK_EQ(tr_hash(a, static_cast<std::size_t>(shape.states * shape.states), &hash), TR_OK);
  }
  tr_outputs outputs;
  CHECK_EQ(tr_get_outputs(&sim, &outputs), TR_OK);
  CHECK_EQ(tr_hash(outputs.thrust_n, 2, &hash), TR_OK);
  return hash;
}

}  // namespace capi
