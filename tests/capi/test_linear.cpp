// The C interface: linear models and what is done with them.
// Expected: the two calls for the one, and the header's text.
#include "capi/flying.hpp"

using namespace capi;

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
