// Eigenvalues whatever the size of the entries: closed forms of blocks and
// diagonals, and exact scaling by powers of two.
#include "tiltrotor/math/algebra/eigen.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "check.hpp"

using namespace tiltrotor;

namespace {

constexpr int kOrder = 12;
Matrix<double, kOrder, kOrder> matrix;
EigenWorkspace<double, kOrder> work;
Eigenvalues<double, kOrder> values;
Eigensystem<double, kOrder> values_and_vectors;

// Both routes; the eigenvalues of the second are left in `values`.
void solve(int n) {
  CHECK(eigenvalues(matrix, n, work, values) == Status::ok);
  std::vector<double> first(values.real, values.real + n);
  CHECK(eigensystem(matrix, n, work, values_and_vectors) == Status::ok);
  values = values_and_vectors.values;
  for (int k = 0; k < n; ++k) {
    CHECK(std::isfinite(first[static_cast<std::size_t>(k)]));
    for (int i = 0; i < n; ++i)
      CHECK(std::isfinite(right_entry(values_and_vectors, i, k).real) &&
            std::isfinite(left_entry(values_and_vectors, i, k).imag));
  }
}

// Whether a + bi is among the eigenvalues, to a relative 1e-14.
bool found(int n, double real, double imag) {
  const double size = std::max(std::fabs(real), std::fabs(imag));
  for (int k = 0; k < n; ++k) {
    const double error = std::max(std::fabs(values.real[k] - real), std::fabs(values.imag[k] - imag));
    if (error <= 1e-14 * size) return true;
  }
  return false;
}

void put_rotation(int i, int j, double real, double imag) {
  matrix(i, i) = matrix(j, j) = real;
  matrix(i, j) = imag;
  matrix(j, i) = -imag;
}

// Entries within one binade, so that a power of two scales them exactly down to
// the subnormal numbers' edge.
void fill_random(int n, unsigned seed, int exponent) {
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> whole(-1000, 1000);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) matrix(i, j) = std::ldexp(whole(generator), exponent - 10);
}

}  // namespace

TEST(eigen_diagonal_keeps_every_bit) {
  const std::vector<double> diagonals[] = {
      {1e20, 3e-305}, {3e-305, 1e20, -7e-310, 1e308}, {5e-324, 1, -1e-300, 1e300}, {1.7e308, 2e-308}};
  for (const std::vector<double>& diagonal : diagonals) {
    const int n = static_cast<int>(diagonal.size());
    set_zero(matrix);
    for (int i = 0; i < n; ++i) matrix(i, i) = diagonal[static_cast<std::size_t>(i)];
    solve(n);
    for (double x : diagonal) CHECK_EQ(std::count(values.real, values.real + n, x), 1);
    // The same above a triangle of moderate entries.
    for (int i = 0; i < n; ++i)
      for (int j = i + 1; j < n; ++j) matrix(i, j) = 0.5;
    CHECK(eigenvalues(matrix, n, work, values) == Status::ok);
    for (double x : diagonal) CHECK_EQ(std::count(values.real, values.real + n, x), 1);
  }
}

// Rotations of very different size side by side, in either order.
TEST(eigen_blocks_of_every_size_side_by_side) {
  const double sizes[] = {1e140, 1, 1e-100};
  const int places[][6] = {{0, 1, 2, 3, 4, 5}, {4, 5, 0, 1, 2, 3}, {5, 4, 2, 3, 1, 0}};
  for (const auto& place : places) {
    set_zero(matrix);
    for (int k = 0; k < 3; ++k) put_rotation(place[2 * k], place[2 * k + 1], -0.5 * sizes[k], 2 * sizes[k]);
    solve(6);
    for (double size : sizes) {
      CHECK(found(6, -0.5 * size, 2 * size));
      CHECK(found(6, -0.5 * size, -2 * size));
    }
  }
  for (const double small : {1e-150, 1e-200, 1e-290}) {  // a pair beside a usual one, and a pair alone
    set_zero(matrix);
    put_rotation(0, 1, -1, 3);
    put_rotation(2, 3, -0.5 * small, 2 * small);
    solve(4);
    CHECK(found(4, -1, 3));
    CHECK(found(4, -0.5 * small, 2 * small));
    put_rotation(0, 1, -0.5 * small, 2 * small);
    solve(2);
    CHECK(found(2, -0.5 * small, 2 * small));
  }
}

// A block of three or more that is split off from a larger one sweeps in its
// own units.
TEST(eigen_small_blocks_have_their_own_units) {
  const int n = 5;
  for (const int exponent : {-300, -500, -700, -900}) {
    fill_random(n, 3, exponent);
    CHECK(eigenvalues(matrix, n, work, values) == Status::ok);
    const Eigenvalues<double, kOrder> alone = values;
    for (int i = 0; i < n; ++i)
      for (int j = n; j < n + 2; ++j) matrix(i, j) = matrix(j, i) = 0;
    put_rotation(n, n + 1, -1, 2);
    solve(n + 2);
    CHECK(found(n + 2, -1, 2));
    for (int k = 0; k < n; ++k) CHECK(found(n + 2, alone.real[k], alone.imag[k]));
  }
}

TEST(eigen_power_of_two_scales_every_eigenvalue) {
  for (int n : {2, 3, 7, 12}) {
    fill_random(n, static_cast<unsigned>(n), 0);
    CHECK(eigenvalues(matrix, n, work, values) == Status::ok);
    const Eigenvalues<double, kOrder> expected = values;
    for (int exponent : {-1000, -700, -400, -65, -20, 20, 100, 204, 205, 500, 900, 1015}) {
      fill_random(n, static_cast<unsigned>(n), exponent);
      solve(n);
      for (int k = 0; k < n; ++k)
        CHECK(found(n, std::ldexp(expected.real[k], exponent), std::ldexp(expected.imag[k], exponent)));
    }
  }
}

TEST(eigen_float_keeps_small_eigenvalues) {
  static Matrix<float, 4, 4> a;
  static EigenWorkspace<float, 4> work;
  static Eigensystem<float, 4> system;
  set_zero(a);
  a(0, 0) = 1e20f;
  a(1, 1) = 3e-38f;
  a(2, 3) = 2e-10f;
  a(3, 2) = -2e-10f;
  CHECK(eigensystem(a, 4, work, system) == Status::ok);
  CHECK_EQ(std::count(system.values.real, system.values.real + 4, 1e20f), 1);
  CHECK_EQ(std::count(system.values.real, system.values.real + 4, 3e-38f), 1);
  CHECK_REL(*std::max_element(system.values.imag, system.values.imag + 4), 2e-10f, 1e-6);
}

// A v = lambda v by products formed in units of the largest entry.
TEST(eigen_vectors_of_large_and_small_matrices) {
  const int n = 7;
  for (int exponent : {-1000, -300, 300, 1000}) {
    fill_random(n, 9, exponent);
    solve(n);
    for (int k = 0; k < n; ++k) {
      const double re = std::ldexp(values.real[k], -exponent), im = std::ldexp(values.imag[k], -exponent);
      for (int i = 0; i < n; ++i) {
        const ComplexEntry<double> v = right_entry(values_and_vectors, i, k);
        double left_re = -(re * v.real - im * v.imag), left_im = -(re * v.imag + im * v.real);
        for (int j = 0; j < n; ++j) {
          const ComplexEntry<double> w = right_entry(values_and_vectors, j, k);
          left_re += std::ldexp(matrix(i, j), -exponent) * w.real;
          left_im += std::ldexp(matrix(i, j), -exponent) * w.imag;
        }
        CHECK_NEAR(left_re, 0, 1e-14);
        CHECK_NEAR(left_im, 0, 1e-14);
      }
    }
  }
}
