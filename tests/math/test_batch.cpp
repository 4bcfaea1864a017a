// Packs: each lane gives the bits of the plain number, with vector types and with portable lanes.
#include "tiltrotor/math/differentiation/batch.hpp"

#include "batch_program.hpp"
#include "check.hpp"

std::vector<double> portable_pack_results();
std::vector<float> portable_pack_results_float();

namespace {

using namespace tiltrotor;

// The same numbers one by one.
template <class R>
std::vector<R> scalar_results() {
  using D = Dual<R, 2>;
  const pack_program::SampleTable<R> sample;
  std::vector<R> out;
  for (const Interpolation mode : {Interpolation::c1, Interpolation::linear}) {
    for (int i = 0; i < pack_program::kPoints; ++i) {
      const R a = pack_program::first<R>(i);
      const R b = pack_program::second<R>(i);
      const D f = pack_program::formula(sample, mode, D::variable(a, 0), D::variable(b, 1));
      for (const R x : {pack_program::formula(sample, mode, a, b), f.v, f.d.get(0), f.d.get(1)})
        out.push_back(x);
    }
  }
  return out;
}

// Bits of the values, and of the slopes.
template <class R>
void check_same_bits(const std::vector<R>& packs, const std::vector<R>& others) {
  if (!CHECK_EQ(packs.size(), others.size())) return;
  for (std::size_t i = 0; i < packs.size(); ++i) {
    if (!CHECK(packs[i] == others[i])) NOTE("number " << i << ": " << packs[i] << " and " << others[i]);
  }
}

TEST(pack_gives_the_bits_of_plain_numbers) {
  check_same_bits(pack_program::pack_results<double>(), scalar_results<double>());
  check_same_bits(pack_program::pack_results<float>(), scalar_results<float>());
}

TEST(pack_portable_form_gives_the_same_bits) {
  check_same_bits(pack_program::pack_results<double>(), portable_pack_results());
  check_same_bits(pack_program::pack_results<float>(), portable_pack_results_float());
}

TEST(pack_value_of_dual_is_the_plain_value) {
  const std::vector<double> results = pack_program::pack_results<double>();
  for (std::size_t i = 0; i < results.size(); i += 4) CHECK(results[i] == results[i + 1]);
}

TEST(pack_chooses_lane_by_lane) {
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

TEST(pack_compares_lane_by_lane) {
  check_comparisons<double>();
  check_comparisons<float>();
}
