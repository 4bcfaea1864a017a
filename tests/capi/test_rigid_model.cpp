// The C interface: the model of the rigid body alone. Expected: roots and steady response of the full model.
#include <algorithm>
#include <complex>

#include "capi/flying.hpp"
#include "tiltrotor/math/algebra/lu.hpp"

using namespace capi;
using namespace tiltrotor;

namespace {

struct Model {
  tr_linear_shape shape;
  std::vector<tr_real> a = std::vector<tr_real>(max_states * max_states);
  std::vector<tr_real> b = std::vector<tr_real>(max_states * TR_INPUTS);
};

Model model_of(const tr_sim& sim, tr_work* work) {
  Model m;
  CHECK_EQ(tr_linearize(&sim, work, TR_INCEPTORS, &m.shape, m.a.data(), m.a.size(), m.b.data(), m.b.size()),
           TR_OK);
  return m;
}
Model reduced(const Model& of, tr_work* work) {
  Model m;
  CHECK_EQ(tr_rigid_model(work, &of.shape, of.a.data(), of.a.size(), of.b.data(), of.b.size(), &m.shape,
                          m.a.data(), m.a.size(), m.b.data(), m.b.size()),
           TR_OK);
  return m;
}
std::vector<std::complex<tr_real>> roots(const Model& m, tr_work* work) {
  tr_real real[TR_MAX_LINEAR_STATES], imag[TR_MAX_LINEAR_STATES];
  const auto n = static_cast<std::size_t>(m.shape.states);
  CHECK_EQ(tr_eigenvalues(work, m.a.data(), n, real, imag, max_states), TR_OK);
  std::vector<std::complex<tr_real>> found(n);
  for (std::size_t i = 0; i < n; ++i) found[i] = {real[i], imag[i]};
  return found;
}

// A^-1 B of the rows of a model, in double precision.
std::vector<double> steady(const Model& m) {
  constexpr int kMost = TR_MAX_LINEAR_STATES;
  static Matrix<double, kMost, kMost> a;
  static LU<double, kMost> lu;
  const int n = m.shape.states;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) a(i, j) = static_cast<double>(m.a[static_cast<std::size_t>(i * n + j)]);
  CHECK(lu_factor(a, n, lu) == Status::ok);
  std::vector<double> of_stick(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i)
    of_stick[static_cast<std::size_t>(i)] =
        static_cast<double>(m.b[static_cast<std::size_t>(i * m.shape.controls + 1)]);
  CHECK(lu_solve(lu, of_stick.data()) == Status::ok);
  return of_stick;
}

}  // namespace

// Every root of the eight has one of the full model within 7 per cent of its size; the answer at rest is the same.
TEST(capi_rigid_model_has_the_slow_roots) {
  const auto work = new_work();
  const double flights[][2] = {{0, 40}, {30, 50}, {60, 70}, {90, 80}, {90, 110}};
  for (const auto& flight : flights) {
    const Model full = model_of(trimmed_sim(tr_real(flight[0]), tr_real(flight[1])), work.get());
    const Model slow = reduced(full, work.get());
    CHECK_EQ(slow.shape.states, 8);
    CHECK_EQ(slow.shape.controls, full.shape.controls);
    const auto all = roots(full, work.get());
    tr_real worst = 0;
    for (const std::complex<tr_real>& root : roots(slow, work.get())) {
      tr_real nearest = 1;
      for (const std::complex<tr_real>& other : all)
        nearest = std::min(nearest, std::abs(root - other) / std::max(std::abs(other), tr_real(0.05)));
      worst = std::max(worst, nearest);
    }
    NOTE("mast " << flight[0] << ", " << flight[1] << " m/s: worst root off by " << worst);
    CHECK_LT(worst, tr_real(0.07));
    if (sizeof(tr_real) < sizeof(double)) continue;
    const std::vector<double> of_full = steady(full), of_slow = steady(slow);
    double largest = 0;
    for (std::size_t i = 0; i < 8; ++i) largest = std::max(largest, std::abs(of_full[i]));
    for (std::size_t i = 0; i < 8; ++i) CHECK_NEAR(of_slow[i], of_full[i], 1e-9 * largest);
    tr_mode modes[8];
    std::size_t count = 0;
    CHECK_EQ(tr_modes(work.get(), &slow.shape, slow.a.data(), slow.a.size(), modes, 8, &count), TR_OK);
    CHECK(count >= 4 && count <= 8);
  }
}

TEST(capi_rigid_model_in_place_and_refused) {
  const auto work = new_work();
  const Model full = model_of(trimmed_sim(30, 50), work.get());
  const Model slow = reduced(full, work.get());
  Model m = full;
  CHECK_EQ(tr_rigid_model(work.get(), &m.shape, m.a.data(), m.a.size(), nullptr, 0, &m.shape, m.a.data(), 64,
                          nullptr, 0),
           TR_OK);
  CHECK(std::equal(m.a.begin(), m.a.begin() + 64, slow.a.begin()));
  m = full;
  tr_linear_shape shape;
  CHECK_EQ(tr_rigid_model(work.get(), &m.shape, m.a.data(), m.a.size(), nullptr, 0, &shape, m.a.data(), 63,
                          nullptr, 0),
           TR_SHORT_BUFFER);
  CHECK_EQ(shape.states, 8);
  CHECK_EQ(tr_rigid_model(work.get(), &m.shape, m.a.data(), 23 * 23 - 1, nullptr, 0, &shape, m.a.data(), 64,
                          nullptr, 0),
           TR_SHORT_BUFFER);
  CHECK_EQ(tr_rigid_model(work.get(), &m.shape, m.a.data(), m.a.size(), nullptr, 0, nullptr, m.a.data(), 64,
                          nullptr, 0),
           TR_BAD_ARGUMENT);
  std::swap(m.shape.state[0], m.shape.state[1]);
  CHECK_EQ(tr_rigid_model(work.get(), &m.shape, m.a.data(), m.a.size(), nullptr, 0, &shape, m.a.data(), 64,
                          nullptr, 0),
           TR_BAD_ARGUMENT);
  m = full;
  m.a[3] = kNan;
  CHECK_EQ(tr_rigid_model(work.get(), &m.shape, m.a.data(), m.a.size(), nullptr, 0, &shape, m.a.data(), 64,
                          nullptr, 0),
           TR_NOT_FINITE);
}
