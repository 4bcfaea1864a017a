// Balancing by what it promises: A P D = P D B bit for bit, rows and columns of the active block alike in
// size, whatever the size of the entries.
#include "tiltrotor/math/algebra/balance.hpp"

#include <algorithm>
#include <random>

#include "check.hpp"

using namespace tiltrotor;

namespace {

constexpr int kLargest = 11;
using Square = Matrix<double, kLargest, lane_ceil<double>(kLargest)>;

// Entries of magnitude 1 to 4, with a fraction of zeros, in units that spread over 2^+-spread, times 2^size.
Square in_mixed_units(int n, unsigned seed, int zeros_percent, int spread, int size) {
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> percent(0, 99), sign(0, 1), unit(-spread, spread);
  std::uniform_real_distribution<double> magnitude(1, 4);
  int exponent[kLargest];
  for (int& e : exponent) e = unit(generator);
  Square a{};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (percent(generator) < zeros_percent) continue;
      a(i, j) = std::ldexp(sign(generator) == 0 ? -magnitude(generator) : magnitude(generator),
                           size + exponent[i] - exponent[j]);
    }
  }
  return a;
}

// P D of the right vectors, or P D^-1 of the left ones: what becomes of the identity.
Square transformation(const Balance<double, kLargest>& b, int n, bool left) {
  Square t{};
  for (int i = 0; i < n; ++i) t(i, i) = 1;
  undo_balance<double, kLargest>(b, n, left, t);
  return t;
}

// Rows of P D have one entry, a power of two, and so each entry of a product is one product without rounding.
void check_exact(const Square& a, const Square& balanced, const Balance<double, kLargest>& b, int n) {
  const Square pd = transformation(b, n, false);
  const Square left = transformation(b, n, true);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      double before = 0, after = 0, product = 0;
      for (int k = 0; k < n; ++k) {
        before += a(i, k) * pd(k, j);
        after += pd(i, k) * balanced(k, j);
        product += left(k, i) * pd(k, j);
      }
      CHECK_EQ(before, after);
      CHECK_EQ(product, i == j ? 1.0 : 0.0);
    }
  }
}

// Sums of a row and a column of the active block without the diagonal.
struct Sums {
  double row, column;
};
Sums sums(const Square& a, const Balance<double, kLargest>& b, int i) {
  Sums s{0, 0};
  for (int j = b.low; j <= b.high; ++j) {
    if (j == i) continue;
    s.row += std::abs(a(i, j));
    s.column += std::abs(a(j, i));
  }
  return s;
}

}  // namespace

// A power of two more or less would not lower the sum of both by 5 %: with r > c, 2 c + r/2 >= 0.95 (c + r),
// which is r / c <= 1.05 / 0.45; a ratio below 2.4 is not worth asking.
TEST(balance_equalises_rows_and_columns) {
  double worst = 1;
  for (int size : {-300, -60, 0, 60, 300}) {
    for (int n : {2, 3, 7, kLargest}) {
      for (unsigned seed = 0; seed < 12; ++seed) {
        const Square a = in_mixed_units(n, seed, seed % 3 == 0 ? 0 : 30, 20, size);
        Square balanced = a;
        Balance<double, kLargest> b;
        balance<double, kLargest>(balanced, n, b);
        check_exact(a, balanced, b, n);
        for (int i = b.low; i <= b.high && b.low < b.high; ++i) {
          const Sums s = sums(balanced, b, i);
          const double ratio = std::max(s.row, s.column) / std::min(s.row, s.column);
          CHECK_LE(ratio, 2.4);
          worst = std::max(worst, ratio);
        }
      }
    }
  }
  NOTE("largest ratio of the sums of a row and its column " << worst);
}

// A matrix that is triangular after a permutation has no block left, and its diagonal is in place.
TEST(balance_takes_a_triangle_apart) {
  for (int n : {1, 2, 6, kLargest}) {
    int order[kLargest];
    for (int i = 0; i < n; ++i) order[i] = i;
    std::shuffle(order, order + n, std::mt19937(5));
    Square a{};
    for (int i = 0; i < n; ++i)
      for (int j = i; j < n; ++j) a(order[i], order[j]) = 1 + i + 0.25 * j;
    Square balanced = a;
    Balance<double, kLargest> b;
    balance<double, kLargest>(balanced, n, b);
    check_exact(a, balanced, b, n);
    CHECK_EQ(b.low, b.high);
    for (int i = 0; i < n; ++i) {
      CHECK_EQ(b.scale[i], 1.0);
      for (int j = 0; j < i; ++j) CHECK_EQ(balanced(i, j), 0.0);
    }
  }
}

// Factors end at 2^512, the square root of the largest number, above and below; what would need more stays.
TEST(balance_keeps_its_factors_in_range) {
  for (int exponent : {400, 1000}) {
    for (bool upper : {false, true}) {
      Square a{};
      a(0, 1) = std::ldexp(1.0, upper ? exponent : -exponent);
      a(1, 0) = std::ldexp(1.0, upper ? -exponent : exponent);
      Square balanced = a;
      Balance<double, kLargest> b;
      balance<double, kLargest>(balanced, 2, b);
      check_exact(a, balanced, b, 2);
      const double ratio = std::abs(balanced(0, 1) / balanced(1, 0));
      if (exponent == 400) CHECK(0.25 <= ratio && ratio <= 4);
      if (exponent == 1000) CHECK(b.scale[0] == 1 && b.scale[1] == 1);
    }
  }
}

// Scaling can lose a denormal entry: a row or column of zeros is left alone, since nothing would end its
// scaling.
TEST(balance_leaves_rows_and_columns_of_zeros) {
  for (bool row : {false, true}) {
    Square a{};
    for (int k = 1; k < 3; ++k) (row ? a(0, k) : a(k, 0)) = 1e-3;
    a(1, 2) = a(2, 1) = 5;
    Square scaled = a;
    Balance<double, kLargest> b{};
    for (double& s : b.scale) s = 1;
    b.high = 2;
    for (int sweep = 0; sweep < kBalanceSweeps; ++sweep)
      balance_detail::scale_once<double, kLargest>(scaled, 3, b);
    CHECK_EQ(b.scale[0], 1.0);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) CHECK(std::isfinite(scaled(i, j)));
  }
}

// Along a chain of states in ever larger units, scaling spreads by a place or so with every sweep: a long one
// is not done after the sweeps allowed. It is still the same matrix, and nearer to balance than it was.
TEST(balance_stops_after_its_sweeps) {
  constexpr int n = 16;
  using Long = Matrix<double, n, lane_ceil<double>(n)>;
  Long a{};
  for (int i = 0; i + 1 < n; ++i) {
    a(i, i + 1) = std::ldexp(1.0, 16);
    a(i + 1, i) = std::ldexp(1.0, -16);
  }
  Long balanced = a;
  Balance<double, n> b;
  balance<double, n>(balanced, n, b);
  double before = 0, after = 0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      before += std::abs(a(i, j));
      after += std::abs(balanced(i, j));
      CHECK_EQ(b.scale[i] * balanced(i, j), a(i, j) * b.scale[j]);
    }
  }
  CHECK_LT(after, 0.5 * before);
  CHECK(balance_detail::scale_once<double, n>(balanced, n, b));  // there was more to do
}
