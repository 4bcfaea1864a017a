// Lanes of partials: vector and portable form give the same bits; operations against scalar loops; layout.
#include "tiltrotor/math/differentiation/lanes.hpp"

#include <cstddef>
#include <cstdint>
#include <random>

#include "check.hpp"
#include "lane_program.hpp"
#include "tiltrotor/math/differentiation/dual.hpp"

using namespace tiltrotor;

namespace {

template <class R>
void check_same_bits(const std::vector<R>& vectors, const std::vector<R>& portable) {
  CHECK_LT(std::size_t{0}, vectors.size());
  if (!CHECK_EQ(vectors.size(), portable.size())) return;
  for (std::size_t i = 0; i < vectors.size(); ++i) CHECK(vectors[i] == portable[i]);
}

template <class R, int N>
void check_operations() {
  using P = Partials<R, N>;
  static_assert(P::kPadded >= N && P::kPadded % P::kWidth == 0 && P::kPadded - N < P::kWidth);
  static_assert((P::kWidth & (P::kWidth - 1)) == 0, "a power of two");
  static_assert(P::kWidth == 1 || P::kWidth * static_cast<int>(sizeof(R)) <= kVectorBytes);
  static_assert(sizeof(P) == static_cast<std::size_t>(P::kPadded) * sizeof(R), "no gaps between lanes");
  std::mt19937 engine(lane_program::kSeed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  P a = P::zero();
  P b = P::zero();
  R plain_a[N];
  R plain_b[N];
  for (int j = 0; j < N; ++j) {
    CHECK_EQ(a.get(j), R(0));
    a.set(j, plain_a[j] = static_cast<R>(uniform(engine)));
    b.set(j, plain_b[j] = static_cast<R>(uniform(engine)));
  }
  const R s = static_cast<R>(0.37);
  const R t = static_cast<R>(-1.91);
  const P sum = a + b;
  const P difference = a - b;
  const P scale = scaled(s, a);
  const P both = combined(s, a, t, b);
  R row[N];
  sum.copy_to(row);
  for (int j = 0; j < N; ++j) {
    CHECK(a.get(j) == plain_a[j]);
    CHECK(sum.get(j) == plain_a[j] + plain_b[j]);
    CHECK(row[j] == sum.get(j));
    CHECK(sum.row()[j] == sum.get(j));
    CHECK(difference.get(j) == plain_a[j] - plain_b[j]);
    CHECK(scale.get(j) == s * plain_a[j]);
    const R left = s * plain_a[j];
    const R right = t * plain_b[j];
    CHECK(both.get(j) == left + right);
  }
}

}  // namespace

TEST(lanes_portable_form_gives_the_same_bits) {
  NOTE("seed " << lane_program::kSeed);
  check_same_bits(lane_program::results<Dual<double, 1>, double, 1>(), portable_lane_results(1));
  check_same_bits(lane_program::results<Dual<double, 3>, double, 3>(), portable_lane_results(3));
  check_same_bits(lane_program::results<Dual<double, 8>, double, 8>(), portable_lane_results(8));
  check_same_bits(lane_program::results<Dual<double, 31>, double, 31>(), portable_lane_results(31));
  check_same_bits(lane_program::results<Dual<float, 5>, float, 5>(), portable_lane_results_float(5));
  check_same_bits(lane_program::results<Dual<float, 16>, float, 16>(), portable_lane_results_float(16));
}

TEST(lanes_operations_against_scalar_loops) {
  check_operations<double, 1>();
  check_operations<double, 2>();
  check_operations<double, 3>();
  check_operations<double, 5>();
  check_operations<double, 8>();
  check_operations<double, 9>();
  check_operations<double, 16>();
  check_operations<double, 31>();
  check_operations<double, 32>();
  check_operations<float, 1>();
  check_operations<float, 3>();
  check_operations<float, 7>();
  check_operations<float, 31>();
}

TEST(lanes_width_fits_the_count) {
  CHECK_EQ(lane_width<double>(1), 1);
  const int widest = kWidestLanes<double>;
  CHECK_EQ(lane_width<double>(1000), widest);
  for (int count = 1; count <= 64; ++count) {
    const int width = lane_width<double>(count);
    CHECK_LE(width, widest);
    CHECK(width >= count || width == widest);
    CHECK(width == 1 || width / 2 < count);  // no wider than needed
  }
}

TEST(lanes_are_aligned) {
  Dual<double, 31> x[2] = {Dual<double, 31>(1.0), Dual<double, 31>(2.0)};
  const std::size_t alignment = static_cast<std::size_t>(Partials<double, 31>::kWidth) * sizeof(double);
  for (const auto& y : x) CHECK_EQ(reinterpret_cast<std::uintptr_t>(&y.d) % alignment, std::uintptr_t{0});
}
