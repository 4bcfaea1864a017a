// Packs: each lane gives the bits of the plain number, with vector types and with portable lanes.
#include "tiltrotor/math/differentiation/batch.hpp"

#include "batch_program.hpp"
#include "check.hpp"

std::vector<double> portable_batch_results();
std::vector<float> portable_batch_results_float();

namespace {

using namespace tiltrotor;

// The same numbers one by one.
template <class R>
std::vector<R> scalar_results() {
  using D = Dual<R, 2>;
  const batch_program::SampleTable<R> sample;
  std::vector<R> out;
  for (const Interpolation mode : {Interpolation::c1, Interpolation::linear}) {
    for (int i = 0; i < batch_program::kPoints; ++i) {
      const R a = batch_program::first<R>(i);
      const R b = batch_program::second<R>(i);
      const D f = batch_program::formula(sample, mode, D::variable(a, 0), D::variable(b, 1));
      for (const R x : {batch_program::formula(sample, mode, a, b), f.v, f.d.get(0), f.d.get(1)})
        out.push_back(x);
    }
  }
  return out;
}

// Bits of the values, and of the slopes.
template <class R>
void check_same_bits(const std::vector<R>& batches, const std::vector<R>& others) {
  if (!CHECK_EQ(batches.size(), others.size())) return;
  for (std::size_t i = 0; i < batches.size(); ++i) {
    if (!CHECK(batches[i] == others[i])) NOTE("number " << i << ": " << batches[i] << " and " << others[i]);
  }
}

TEST(batch_gives_the_bits_of_plain_numbers) {
  check_same_bits(batch_program::batch_results<double>(), scalar_results<double>());
  check_same_bits(batch_program::batch_results<float>(), scalar_results<float>());
}

TEST(batch_portable_form_gives_the_same_bits) {
  check_same_bits(batch_program::batch_results<double>(), portable_batch_results());
  check_same_bits(batch_program::batch_results<float>(), portable_batch_results_float());
}

TEST(batch_value_of_dual_is_the_plain_value) {
  const std::vector<double> results = batch_program::batch_results<double>();
  for (std::size_t i = 0; i < results.size(); i += 4) CHECK(results[i] == results[i + 1]);
}

TEST(batch_chooses_lane_by_lane) {
  using P = Batch<double>;
  P x;
  for (int lane = 0; lane < P::kLanes; ++lane) x.set(lane, lane);
  const P y = select(x > P(0.5), P(1), -x);
  for (int lane = 0; lane < P::kLanes; ++lane) CHECK_EQ(y.get(lane), lane > 0 ? 1.0 : 0.0);
  CHECK(any(x < P(0.5)));
  CHECK(!any(x < P(0)));
  CHECK(!any((x < P(0.5)) & (x > P(0.5))));
  CHECK(any((x < P(-1)) | (x >= P(0))));
}

}  // namespace

namespace {

// Comparisons of each lane with what plain numbers say, equal ones and no numbers among them.
template <class R>
void check_comparisons() {
  using P = Batch<R>;
  const R values[] = {
      R(-1), R(0), R(-0.0), R(2), std::numeric_limits<R>::infinity(), std::numeric_limits<R>::quiet_NaN()};
  for (int lane = 0; lane < P::kLanes; ++lane) {
    for (R a : values) {
      for (R b : values) {
        P x(R(1)), y(R(0));  // in the other lanes x is greater
        x.set(lane, a);
        y.set(lane, b);
        const auto truth = [&](const BatchMask<R>& m) { return m.e[lane] != 0; };
        CHECK_EQ(truth(x < y), a < b);
        CHECK_EQ(truth(x <= y), a <= b);
        CHECK_EQ(truth(x > y), a > b);
        CHECK_EQ(truth(x >= y), a >= b);
        CHECK_EQ(truth(x == y), a == b);
        CHECK_EQ(any(x <= y), a <= b);
        CHECK_EQ(truth((x < y) | (x == y)), a <= b);
        CHECK_EQ(truth((x <= y) & (x >= y)), a == b);
      }
    }
  }
}

}  // namespace

TEST(batch_compares_lane_by_lane) {
  check_comparisons<double>();
  check_comparisons<float>();
}
