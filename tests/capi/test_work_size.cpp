// The C interface: no call writes beyond tr_work_size(), whatever systems are on. Expected: a pattern laid there before stays.
#include <algorithm>
#include <new>
#include <vector>

#include "capi/flying.hpp"

using namespace capi;

namespace {

constexpr unsigned char kPattern = 0xa5;

void lay_pattern(tr_work* work) { std::memset(work, kPattern, sizeof *work); }

// Bytes from the beginning to the last that was written.
std::size_t written(const tr_work* work) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(work);
  std::size_t end = sizeof *work;
  while (end > 0 && bytes[end - 1] == kPattern) --end;
  return end;
}

// Every call that takes a work area. The exponential step is one without systems.
std::size_t written_by_all(tr_sim sim, tr_work* work, bool has_systems) {
  static tr_real a[max_states * max_states], b[max_states * TR_INPUTS], c[TR_OUTPUTS * max_states];
  tr_real dx[TR_STATES] = {1}, du[TR_INPUTS] = {0, 1}, dxdot[TR_STATES], real[max_states], imag[max_states];
  tr_linear_shape shape;
  tr_outputs outputs;
  tr_mode modes[max_states];
  std::size_t count = 0;
  lay_pattern(work);
  CHECK_EQ(tr_step(&sim, work, dt), TR_OK);
  CHECK_EQ(tr_step_with_outputs(&sim, work, dt, &outputs), TR_OK);
  CHECK_EQ(tr_directional(&sim, work, dx, du, dxdot, &outputs), TR_OK);
  CHECK_EQ(tr_directional_inputs(&sim, work, dx, du, dxdot, &outputs), TR_OK);
  CHECK_EQ(tr_linearize_outputs(&sim, work, TR_ALL_INPUTS, c, TR_OUTPUTS * max_states, nullptr, 0), TR_OK);
  CHECK_EQ(
      tr_linearize_and_step(&sim, work, dt, TR_INCEPTORS, &shape, a, max_states * max_states, nullptr, 0),
      TR_OK);
  if (!has_systems)
    CHECK_EQ(tr_linearize_and_step_exponential(&sim, work, dt, nullptr, TR_INCEPTORS, &shape, a,
                                               max_states * max_states, b, max_states * TR_INPUTS),
             TR_OK);
  CHECK_EQ(
      tr_linearize(&sim, work, TR_ALL_INPUTS, &shape, a, max_states * max_states, b, max_states * TR_INPUTS),
      TR_OK);
  CHECK_EQ(tr_eigenvalues(work, a, static_cast<std::size_t>(shape.states), real, imag, max_states), TR_OK);
  CHECK_EQ(tr_modes(work, &shape, a, max_states * max_states, modes, max_states, &count), TR_OK);
  CHECK_EQ(tr_rigid_model(work, &shape, a, max_states * max_states, b, max_states * TR_INPUTS, &shape, a,
                          max_states * max_states, b, max_states * TR_INPUTS),
           TR_OK);
  const tr_flight flight = {50, 0, 0, 0};
  CHECK_EQ(tr_trim(&sim, work, &flight, nullptr), TR_OK);
  return written(work);
}

}  // namespace

// The work area stands where it may and no better, 8 bytes beyond an address that vectors like.
TEST(capi_work_size_covers_every_call) {
  std::vector<std::uint64_t> room(sizeof(tr_work) / 8 + 16);
  const std::size_t words = reinterpret_cast<std::uintptr_t>(room.data()) % 64 / 8;
  auto* const work = ::new (static_cast<void*>(room.data() + (words == 0 ? 1 : 9 - words))) tr_work;
  CHECK_EQ(reinterpret_cast<std::uintptr_t>(work) % 64, 8u);
  tr_sim sim = trimmed_sim(30, 50);
  const std::size_t bare = written_by_all(sim, work, false);
  tr_systems systems;
  CHECK_EQ(tr_get_systems(&sim, &systems), TR_OK);
  systems.governor = TR_GOVERNOR_PI;
  systems.conversion = systems.engines = systems.actuators = systems.scas = systems.gear = 1;
  CHECK_EQ(tr_set_systems(&sim, &systems), TR_OK);
  const std::size_t equipped = written_by_all(sim, work, true);
  NOTE(bare << " bytes written, with systems " << equipped << ", of " << tr_work_size());
  CHECK_LE(std::max(bare, equipped), tr_work_size());
  CHECK(equipped > tr_work_size() * 3 / 4);
}
