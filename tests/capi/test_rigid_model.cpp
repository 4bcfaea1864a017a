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

// With governor, actuators and augmentation: their states stay, rotors and downwash go; every slow root of the full model has
// one, the answer at rest is the same.
TEST(capi_rigid_model_keeps_the_states_of_systems) {
  const auto work = new_work();
  for (const double mast : {0.0, 30.0, 90.0}) {
    tr_sim sim = trimmed_sim(tr_real(mast), tr_real(40 + mast / 2));
    tr_systems systems;
    CHECK_EQ(tr_get_systems(&sim, &systems), TR_OK);
    systems.governor = TR_GOVERNOR_PI;
    systems.actuators = systems.scas = 1;
    CHECK_EQ(tr_set_systems(&sim, &systems), TR_OK);
    const Model full = model_of(sim, work.get());
    const Model slow = reduced(full, work.get());
    Model place = full;
    const auto square = static_cast<std::size_t>(slow.shape.states * slow.shape.states);
    CHECK_EQ(
        tr_rigid_model(work.get(), &place.shape, place.a.data(), place.a.size(), place.b.data(),
                       place.b.size(), &place.shape, place.a.data(), square, place.b.data(), place.b.size()),
        TR_OK);
    CHECK(
        std::equal(place.a.begin(), place.a.begin() + slow.shape.states * slow.shape.states, slow.a.begin()));
    CHECK(std::equal(place.b.begin(), place.b.begin() + slow.shape.states * slow.shape.controls,
                     slow.b.begin()));
    tr_linear_shape needed;
    CHECK_EQ(tr_rigid_model(work.get(), &full.shape, full.a.data(), full.a.size(), nullptr, 0, &needed,
                            place.a.data(), square - 1, nullptr, 0),
             TR_SHORT_BUFFER);
    CHECK_EQ(needed.states, slow.shape.states);
    std::vector<int> kept;
    const auto in_full = [&full](int state) {
      return std::find(full.shape.state, full.shape.state + full.shape.states, state) - full.shape.state;
    };
    for (int i = 0; i < full.shape.states; ++i) {
      const int state = full.shape.state[i];
      const bool of_rotor = state >= TR_ROTOR_RIGHT && state < TR_ROTOR_LEFT + 7;
      if (!of_rotor && state != TR_DOWNWASH) kept.push_back(state);
    }
    CHECK_EQ(static_cast<int>(kept.size()), full.shape.states - 15);
    CHECK(std::equal(kept.begin(), kept.end(), slow.shape.state, slow.shape.state + slow.shape.states));
    CHECK_EQ(slow.shape.controls, full.shape.controls);
    const auto known = roots(slow, work.get());
    tr_real worst = 0;
    int count = 0;
    for (const std::complex<tr_real>& root : roots(full, work.get())) {
      if (std::abs(root) > tr_real(2.5)) continue;
      tr_real nearest = 1;
      for (const std::complex<tr_real>& other : known)
        nearest = std::min(nearest, std::abs(root - other) / std::max(std::abs(root), tr_real(0.05)));
      worst = std::max(worst, nearest);
      ++count;
    }
    NOTE("mast " << mast << ": " << count << " slow roots of " << full.shape.states << ", worst off by "
                 << worst);
    CHECK(count > 5);
    CHECK_LT(worst, tr_real(0.07));
    if (sizeof(tr_real) < sizeof(double)) continue;
    const std::vector<double> of_full = steady(full), of_slow = steady(slow);
    double largest = 0;
    for (const int state : kept)
      largest = std::max(largest, std::abs(of_full[static_cast<std::size_t>(in_full(state))]));
    for (std::size_t i = 0; i < kept.size(); ++i)
      CHECK_NEAR(of_slow[i], of_full[static_cast<std::size_t>(in_full(kept[i]))], 1e-9 * largest);
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
