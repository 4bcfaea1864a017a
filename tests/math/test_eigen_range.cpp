// Eigenvalues of entries of very different size, near the ends of the range of numbers and beyond it. Expected values:
// exact scaling by powers of two, perturbation theory, the statuses of the contract.
#include "eigen_bench.hpp"

using namespace eigen_bench;

TEST(eigen_badly_scaled) {  // D A D^-1 with D = 1..1e12 powers of two: the eigenvalues of A to 1e-12
  for (int n : {5, 9, 12, 23, 31})
    for (unsigned seed = 0; seed < 5; ++seed) {
      fill_random(bench.a, n, seed + 100);
      CHECK(eigenvalues(bench.a, n, bench.work, bench.values) == Status::ok);
      std::vector<Cplx> expected;
      for (int k = 0; k < n; ++k) expected.push_back(eigenvalue(bench.values, k));
      const auto exponent = [&](int i) { return std::round(i * std::log2(1e12) / (n - 1)); };
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) bench.a(i, j) *= std::exp2(exponent(i) - exponent(j));  // exact
      CHECK(eigenvalues(bench.a, n, bench.work, bench.values) == Status::ok);
      CHECK(eigensystem(bench.a, n, bench.work, bench.system) == Status::ok);
      CHECK_LT(distance(bench.values, expected, true), 1e-12);
      CHECK_LT(distance(bench.system.values, expected, true), 1e-12);
    }
}

TEST(eigen_entries_near_overflow_and_underflow) {  // the same eigenvalues times a power of two, exactly
  const int n = 9;
  fill_random(bench.a, n, 12);
  CHECK(eigenvalues(bench.a, n, bench.work, bench.values) == Status::ok);
  std::vector<Cplx> expected;
  for (int k = 0; k < n; ++k) expected.push_back(eigenvalue(bench.values, k));
  for (int exponent : {1015, 600, -600, -900}) {
    fill_random(bench.a, n, 12);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) bench.a(i, j) = std::ldexp(bench.a(i, j), exponent);
    CHECK(eigensystem(bench.a, n, bench.work, bench.system) == Status::ok);
    for (int k = 0; k < n; ++k) {
      bench.system.values.real[k] = std::ldexp(bench.system.values.real[k], -exponent);
      bench.system.values.imag[k] = std::ldexp(bench.system.values.imag[k], -exponent);
    }
    CHECK_LT(distance(bench.system.values, expected), 1e-13);
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      bench.a(i, j) = std::numeric_limits<double>::max();  // eigenvalue n max overflows
  CHECK(eigenvalues(bench.a, n, bench.work, bench.values) == Status::not_finite);
}

TEST(eigen_graded_matrix) {  // entries from 1 to 1e-200: finite, converged, largest eigenvalue accurate
  const int n = 11;
  set_zero(bench.a);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) bench.a(i, j) = std::pow(10.0, -10.0 * (i + j)) * (i == j ? 2.0 : 1.0);
  CHECK(eigensystem(bench.a, n, bench.work, bench.system) == Status::ok);
  CHECK_LT(residual(bench.a, n, bench.system, 1e-12), 1e-14);
  const double largest = *std::max_element(bench.system.values.real, bench.system.values.real + n);
  CHECK_REL(largest, 2.0, 1e-14);  // first-order correction 1e-20
}

TEST(eigen_refuses_nonfinite_input_and_leaves_nothing_stale) {
  for (double bad : {kNan, kInfinity, -kInfinity})
    for (int place : {0, 7, 30}) {
      fill_random(bench.a, 31, 1);
      CHECK(eigensystem(bench.a, 31, bench.work, bench.system) == Status::ok);
      bench.a(place, 30 - place) = bad;
      CHECK(eigenvalues(bench.a, 31, bench.work, bench.values) == Status::not_finite);
      CHECK(eigensystem(bench.a, 31, bench.work, bench.system) == Status::not_finite);
      CHECK_EQ(bench.values.converged, 0);
      for (int k = 0; k < 31; ++k) {
        CHECK(std::isnan(bench.values.real[k]) && std::isnan(bench.values.imag[k]));
        CHECK(std::isnan(bench.system.values.real[k]) && std::isnan(bench.system.condition[k]));
        CHECK(std::isnan(bench.system.right(30, k)) && std::isnan(bench.system.left(0, k)));
      }
    }
  CHECK(eigenvalues(bench.a, 0, bench.work, bench.values) == Status::bad_argument);
  CHECK(eigenvalues(bench.a, 32, bench.work, bench.values) == Status::bad_argument);
  CHECK(std::isnan(bench.values.real[0]));
}

// A skew matrix of the largest numbers has the pair +-i sqrt(3) times them, beyond the range, and a real root
// of zero.
TEST(eigen_pair_beyond_the_range) {
  const double size = std::numeric_limits<double>::max();
  const double rows[3][3] = {{0, size, -size}, {-size, 0, size}, {size, -size, 0}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) bench.a(i, j) = rows[i][j];
  CHECK(eigenvalues(bench.a, 3, bench.work, bench.values) == Status::not_finite);
  for (int k = 0; k < 3; ++k) CHECK_NEAR(bench.values.real[k] / size, 0.0, 1e-15);
}

// Entries that lie further apart than numbers reach: vectors, or those of the transpose, that cannot be written.
TEST(eigen_vectors_beyond_the_range_are_refused) {
  const double rows[3][3] = {{0x1p+63, 0x1p+766, -0x1p-808}, {0, 0x1p+241, 0}, {-0x1p+177, 0, 0x1p-108}};
  for (const bool transposed : {false, true}) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) bench.a(i, j) = transposed ? rows[j][i] : rows[i][j];
    CHECK(eigensystem(bench.a, 3, bench.work, bench.system) == Status::not_finite);
    for (int k = 0; k < 3; ++k)
      CHECK(std::isnan(bench.system.right(0, k)) && std::isnan(bench.system.left(2, k)));
  }
}

// Below the smallest normal number there is no unit to sweep in: such a block is what it is to that number.
TEST(eigen_subnormal_blocks_count_as_zero) {
  const double least = std::numeric_limits<double>::min();
  for (const double size : {0.01 * least, 0.3 * least})
    for (const int below : {1, 2}) {
      set_zero(bench.a);
      bench.a(0, 0) = bench.a(1, 1) = -1;
      bench.a(0, 1) = 3;
      bench.a(1, 0) = -3;
      for (int i = 2; i < 2 + below; ++i) bench.a(i, i + 1) = size * (i - 1), bench.a(i + 1, i) = -size;
      CHECK(eigensystem(bench.a, 3 + below, bench.work, bench.system) == Status::ok);
      int pair = 0, near_zero = 0;
      for (int k = 0; k < 3 + below; ++k) {
        const Cplx root = eigenvalue(bench.system.values, k);
        pair += std::abs(root - Cplx(-1, 3)) < 1e-15 || std::abs(root - Cplx(-1, -3)) < 1e-15;
        near_zero += std::abs(root) <= 4 * least;
        CHECK(std::isfinite(bench.system.right(0, k)) && std::isfinite(bench.system.left(0, k)));
      }
      CHECK(pair == 2 && near_zero == 1 + below);
    }
}
