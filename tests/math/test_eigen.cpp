// Eigenvalues and eigenvectors. Expected values: closed forms (rotations, companion, Toeplitz, Jordan,
// Clement and circulant matrices), invariants (trace, |A v - lambda v|), exact similarity transforms.
#include "tiltrotor/math/algebra/eigen.hpp"

#include <algorithm>
#include <complex>
#include <random>
#include <vector>

#include "check.hpp"
#include "tiltrotor/math/algebra/lu.hpp"

using namespace tiltrotor;
using Cplx = std::complex<double>;

namespace {

constexpr double kEps = 2.220446049250313e-16;
constexpr double kPiHere = 3.14159265358979323846;
const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();

template <class R, int N>
void fill_random(Matrix<R, N, N>& a, int n, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  fill(a, std::numeric_limits<R>::quiet_NaN());  // nothing beyond n may be read
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) a(i, j) = static_cast<R>(normal(generator));
}

template <class R, int N>
double norm(const Matrix<R, N, N>& a, int n) {
  double square = 0.0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) square += static_cast<double>(a(i, j)) * static_cast<double>(a(i, j));
  return std::sqrt(square);
}

template <class R, int N>
Cplx eigenvalue(const Eigenvalues<R, N>& values, int k) {
  return {static_cast<double>(values.real[k]), static_cast<double>(values.imag[k])};
}
template <class R>
Cplx number(ComplexEntry<R> z) {
  return {static_cast<double>(z.real), static_cast<double>(z.imag)};
}

// Largest distance from an expected eigenvalue to its partner, each computed one used once.
template <class R, int N>
double distance(const Eigenvalues<R, N>& values, const std::vector<Cplx>& expected, bool relative = false) {
  std::vector<Cplx> left;
  for (int k = 0; k < values.size; ++k) left.push_back(eigenvalue(values, k));
  double worst = left.size() == expected.size() ? 0.0 : kInfinity;
  for (Cplx z : expected) {
    auto nearest = left.begin();
    for (auto it = left.begin(); it != left.end(); ++it)
      if (!(std::abs(*it - z) >= std::abs(*nearest - z))) nearest = it;
    const double error = std::abs(*nearest - z) / (relative ? std::abs(z) : 1.0);
    worst = error <= worst ? worst : error;  // keeps NaN
    left.erase(nearest);
  }
  return worst;
}

// Largest of |A v - lambda v|, |A^T conj(w) - lambda conj(w)|, over |A|; checks unit length and pair order on
// the way.
template <class R, int N>
double residual(const Matrix<R, N, N>& a, int n, const Eigensystem<R, N>& system, double tolerance) {
  double worst = 0.0;
  const double size = std::max(norm(a, n), 1e-300);
  for (int k = 0; k < n; ++k) {
    const Cplx lambda = eigenvalue(system.values, k);
    double right_square = 0.0, left_square = 0.0, v_square = 0.0, w_square = 0.0;
    for (int i = 0; i < n; ++i) {
      const Cplx v_i = number(right_entry(system, i, k)), w_i = number(left_entry(system, i, k));
      Cplx right = -lambda * v_i, left = -lambda * std::conj(w_i);
      for (int j = 0; j < n; ++j) {
        right += static_cast<double>(a(i, j)) * number(right_entry(system, j, k));
        left += static_cast<double>(a(j, i)) * std::conj(number(left_entry(system, j, k)));
      }
      right_square += std::norm(right / size);
      left_square += std::norm(left / size);
      v_square += std::norm(v_i);
      w_square += std::norm(w_i);
    }
    CHECK_NEAR(v_square, 1.0, tolerance);
    CHECK_NEAR(w_square, 1.0, tolerance);
    if (system.values.imag[k] > R(0)) CHECK_EQ(system.values.imag[k + 1], -system.values.imag[k]);
    const double here = std::sqrt(std::max(right_square, left_square));
    worst = here <= worst ? worst : here;
  }
  return worst;
}

template <class R, int N>
struct Bench {  // everything a test needs, static because of its size
  Matrix<R, N, N> a;
  EigenWorkspace<R, N> work;
  Eigenvalues<R, N> values;
  Eigensystem<R, N> system;
};
Bench<double, 31> bench;
Bench<float, 24> bench_float;

// Both routes on bench.a against known eigenvalues, and the residual of the vectors.
void check_known(int n, const std::vector<Cplx>& expected, double tolerance) {
  CHECK(eigenvalues(bench.a, n, bench.work, bench.values) == Status::ok);
  CHECK(eigensystem(bench.a, n, bench.work, bench.system) == Status::ok);
  CHECK_EQ(bench.values.converged, n);
  CHECK_LE(distance(bench.values, expected), tolerance);
  CHECK_LE(distance(bench.system.values, expected), tolerance);
  CHECK_LT(residual(bench.a, n, bench.system, 1e-12), 1e-13);
}

}  // namespace

TEST(eigen_orders_one_and_two) {
  bench.a(0, 0) = -3.5;
  check_known(1, {-3.5}, 0.0);
  CHECK_EQ(bench.system.condition[0], 1.0);
  set_zero(bench.a);  // rotation by 30 degrees
  bench.a(0, 0) = bench.a(1, 1) = std::cos(kPiHere / 6);
  bench.a(0, 1) = -0.5;
  bench.a(1, 0) = 0.5;
  check_known(2, {std::polar(1.0, kPiHere / 6), std::polar(1.0, -kPiHere / 6)}, 1e-15);
  bench.a(0, 0) = 1.0, bench.a(0, 1) = 2.0, bench.a(1, 0) = 3.0, bench.a(1, 1) = 2.0;
  check_known(2, {4.0, -1.0}, 1e-15);
  bench.a(0, 0) = 0.0, bench.a(0, 1) = -1e-10, bench.a(1, 0) = 1e10, bench.a(1, 1) = 0.0;
  check_known(2, {Cplx(0, 1), Cplx(0, -1)}, 1e-15);
}

TEST(eigen_random_matrices_every_size) {  // residuals, trace, and the two routes against each other
  for (int n = 1; n <= 31; ++n)
    for (unsigned seed = 0; seed < 4; ++seed) {
      fill_random(bench.a, n, seed);
      CHECK(eigenvalues(bench.a, n, bench.work, bench.values) == Status::ok);
      CHECK(eigensystem(bench.a, n, bench.work, bench.system) == Status::ok);
      CHECK_LT(residual(bench.a, n, bench.system, 1e-13), 1e-13);
      std::vector<Cplx> other;
      Cplx trace = 0.0, square = 0.0;
      double exact_trace = 0.0, exact_square = 0.0;
      for (int k = 0; k < n; ++k) {
        other.push_back(eigenvalue(bench.system.values, k));
        trace += eigenvalue(bench.values, k);
        square += eigenvalue(bench.values, k) * eigenvalue(bench.values, k);
        exact_trace += bench.a(k, k);
        for (int j = 0; j < n; ++j) exact_square += bench.a(k, j) * bench.a(j, k);  // trace of A^2
      }
      CHECK_NEAR(trace, exact_trace, 1e-12);
      CHECK_NEAR(square, exact_square, 1e-11);
      CHECK_LT(distance(bench.values, other), 1e-10);
    }
}

TEST(eigen_product_is_the_determinant) {  // determinant from the pivots of LU
  static LU<double, 31> lu;
  fill_random(bench.a, 12, 77);
  CHECK(eigenvalues(bench.a, 12, bench.work, bench.values) == Status::ok);
  CHECK(lu_factor(bench.a, 12, lu) == Status::ok);
  Cplx product = 1.0;
  double determinant = 1.0;
  for (int k = 0; k < 12; ++k) {
    product *= eigenvalue(bench.values, k);
    determinant /= lu.inverse_pivot[k];
  }
  CHECK_REL(std::abs(product), std::fabs(determinant), 1e-12);
}

TEST(eigen_symmetric_toeplitz) {  // tridiagonal (1, -2, 1): -2 + 2 cos(k pi / (n + 1)), all conditions 1
  const int n = 31;
  std::vector<Cplx> expected;
  set_zero(bench.a);
  for (int i = 0; i < n; ++i) {
    bench.a(i, i) = -2.0;
    if (i > 0) bench.a(i, i - 1) = bench.a(i - 1, i) = 1.0;
    expected.emplace_back(-2.0 + 2.0 * std::cos((i + 1) * kPiHere / (n + 1)));
  }
  check_known(n, expected, 2e-14);
  for (int k = 0; k < n; ++k) CHECK_NEAR(bench.system.condition[k], 1.0, 1e-12);
}

TEST(eigen_clement) {  // tridiagonal, super k, sub n - k: eigenvalues -(n-1), -(n-3), ..., n-1
  const int n = 14;
  std::vector<Cplx> expected;
  set_zero(bench.a);
  for (int i = 0; i < n; ++i) {
    if (i > 0) {
      bench.a(i - 1, i) = i;
      bench.a(i, i - 1) = n - i;
    }
    expected.emplace_back(n - 1 - 2.0 * i);
  }
  check_known(n, expected, 1e-12);
}

TEST(eigen_cyclic_permutation) {  // the roots of unity: all shifts fail on it without exceptional ones
  for (int n : {3, 4, 8, 17, 31}) {
    std::vector<Cplx> expected;
    set_zero(bench.a);
    for (int i = 0; i < n; ++i) {
      bench.a((i + 1) % n, i) = 1.0;
      expected.push_back(std::polar(1.0, 2.0 * kPiHere * i / n));
    }
    check_known(n, expected, 1e-14);
  }
}

TEST(eigen_companion_matrix) {  // (z - 1)(z - 2)(z - 3)(z^2 + 2 z + 5)
  const double polynomial[5] = {-30.0, 43.0, -18.0, 4.0,
                                -4.0};  // z^5 - 4 z^4 + 4 z^3 - 18 z^2 + 43 z - 30 by hand
  set_zero(bench.a);
  for (int i = 0; i < 5; ++i) {
    if (i > 0) bench.a(i, i - 1) = 1.0;
    bench.a(i, 4) = -polynomial[i];
  }
  CHECK(eigenvalues(bench.a, 5, bench.work, bench.values) == Status::ok);
  for (int k = 0; k < 5; ++k) {  // every eigenvalue is a root of the polynomial
    const Cplx z = eigenvalue(bench.values, k);
    Cplx p = 1.0;
    for (int i = 4; i >= 0; --i) p = p * z + polynomial[i];
    CHECK_NEAR(p, Cplx(0.0), 1e-11);
  }
}

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

TEST(eigen_participation_does_not_see_units) {  // the same exact scaling leaves |v_i w_i| / |w^H v| alone
  const int n = 9;
  double before[9][9];
  fill_random(bench.a, n, 3);
  for (int scaled = 0; scaled < 2; ++scaled) {
    CHECK(eigensystem(bench.a, n, bench.work, bench.system) == Status::ok);
    for (int k = 0; k < n; ++k) {
      const int place =
          static_cast<int>(std::count_if(bench.system.values.real, bench.system.values.real + n,
                                         [&](double x) { return x < bench.system.values.real[k] - 1e-9; }));
      for (int i = 0; i < n; ++i) {
        const double p = participation(bench.system, i, k);
        if (scaled == 0)
          before[place][i] = p;
        else
          CHECK_NEAR(p, before[place][i], 1e-11);
      }
    }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) bench.a(i, j) *= std::exp2(4.0 * (i - j));
  }
}

TEST(eigen_left_and_right_vectors_are_biorthogonal) {  // w_k^H v_m = 0 for k != m; its size at k = m is 1 /
                                                       // condition
  const int n = 12;
  fill_random(bench.a, n, 8);
  CHECK(eigensystem(bench.a, n, bench.work, bench.system) == Status::ok);
  for (int k = 0; k < n; ++k)
    for (int m = 0; m < n; ++m) {
      Cplx product = 0.0;
      for (int i = 0; i < n; ++i)
        product +=
            std::conj(number(left_entry(bench.system, i, k))) * number(right_entry(bench.system, i, m));
      if (k == m)
        CHECK_REL(std::abs(product), 1.0 / bench.system.condition[k], 1e-12);
      else
        CHECK_NEAR(product, Cplx(0.0), 1e-13);
    }
}

TEST(eigen_condition_number_by_hand) {  // [1 c; 0 2]: v = (1 0), w = (1 -c) normalised: condition sqrt(1 +
                                        // c^2)
  set_zero(bench.a);
  bench.a(0, 0) = 1.0, bench.a(0, 1) = 40.0, bench.a(1, 1) = 2.0;
  CHECK(eigensystem(bench.a, 2, bench.work, bench.system) == Status::ok);
  for (int k = 0; k < 2; ++k) CHECK_REL(bench.system.condition[k], std::sqrt(1601.0), 1e-13);
}

TEST(eigen_zero_and_identity) {
  for (double value : {0.0, 1.0, -1e-320, 1e308}) {
    set_zero(bench.a);
    for (int i = 0; i < 31; ++i) bench.a(i, i) = value;
    CHECK(eigensystem(bench.a, 31, bench.work, bench.system) == Status::ok);
    CHECK_EQ(bench.system.values.sweeps, 0);
    for (int k = 0; k < 31; ++k) {
      CHECK_EQ(bench.system.values.real[k], value);
      CHECK_EQ(bench.system.values.imag[k], 0.0);
      CHECK_EQ(bench.system.condition[k], 1.0);
    }
  }
}

TEST(eigen_permuted_triangular) {  // balancing reads the diagonal off: exact, and no sweep
  const int n = 23;
  std::vector<Cplx> expected;
  std::vector<int> order(n);
  std::mt19937 generator(9);
  for (int i = 0; i < n; ++i) order[static_cast<unsigned>(i)] = i;
  std::shuffle(order.begin(), order.end(), generator);
  set_zero(bench.a);
  for (int i = 0; i < n; ++i) {
    expected.emplace_back(1.0 + i * i);
    for (int j = i; j < n; ++j)
      bench.a(order[static_cast<unsigned>(i)], order[static_cast<unsigned>(j)]) =
          i == j ? 1.0 + i * i : 0.1 * (i - j);
  }
  check_known(n, expected, 0.0);
  CHECK_EQ(bench.values.sweeps, 0);
}

TEST(eigen_isolated_states_around_a_block) {  // a heading and a position: zero columns give exact zeros
  const int n = 10;
  fill_random(bench.a, n, 21);
  for (int i = 0; i < n; ++i) bench.a(i, 3) = bench.a(i, 7) = 0.0;
  for (int j = 0; j < n; ++j) bench.a(5, j) = j == 5 ? -2.0 : 0.0;
  CHECK(eigensystem(bench.a, n, bench.work, bench.system) == Status::ok);
  CHECK_LT(residual(bench.a, n, bench.system, 1e-13), 1e-14);
  CHECK_EQ(std::count(bench.system.values.real, bench.system.values.real + n, 0.0), 2);
  CHECK_EQ(std::count(bench.system.values.real, bench.system.values.real + n, -2.0), 1);
}

TEST(eigen_jordan_block) {  // defective: perturbed by eps^(1/n) at most, conditions say so
  for (int n : {2, 5, 12, 31}) {
    set_zero(bench.a);
    for (int i = 0; i < n; ++i) {
      bench.a(i, i) = 2.0;
      if (i > 0) bench.a(i, i - 1) = 1.0;  // lower triangular: read off by the permutation
    }
    CHECK(eigensystem(bench.a, n, bench.work, bench.system) == Status::ok);
    for (int k = 0; k < n; ++k) {
      CHECK_EQ(bench.system.values.real[k], 2.0);
      CHECK_LT(1e15, bench.system.condition[k]);
    }
    CHECK_LT(residual(bench.a, n, bench.system, 1e-13), 1e-14);
  }
}

TEST(eigen_jordan_block_hidden_by_a_similarity) {  // the same behind a reflection, which rounding perturbs
  const int n = 6;
  static Matrix<double, 31, 31> h, t, jordan;
  set_zero(jordan);
  for (int i = 0; i < 31; ++i)
    for (int j = 0; j < 31; ++j) h(i, j) = i < n && j < n ? (i == j ? 1.0 : 0.0) - 2.0 / n : 0.0;
  for (int i = 0; i < n; ++i) {
    jordan(i, i) = -1.0;
    if (i > 0) jordan(i - 1, i) = 1.0;
  }
  multiply(h, jordan, t);
  multiply(t, h, bench.a);
  CHECK(eigensystem(bench.a, n, bench.work, bench.system) == Status::ok);
  for (int k = 0; k < n; ++k) {
    CHECK_NEAR(eigenvalue(bench.system.values, k), Cplx(-1.0), 2.0 * std::pow(10.0 * kEps, 1.0 / n));
    CHECK_LT(1e10, bench.system.condition[k]);
  }
  CHECK_LT(residual(bench.a, n, bench.system, 1e-13), 1e-13);
}

TEST(eigen_repeated_pairs) {  // Jordan block of the pair +-2i, and a diagonalisable double pair
  for (double coupling : {1.0, 0.0}) {
    set_zero(bench.a);
    for (int b = 0; b < 4; b += 2) {
      bench.a(b, b + 1) = 2.0;
      bench.a(b + 1, b) = -2.0;
    }
    bench.a(0, 2) = bench.a(1, 3) = coupling;
    CHECK(eigensystem(bench.a, 4, bench.work, bench.system) == Status::ok);
    const Cplx pair(0.0, 2.0);
    CHECK_LT(distance(bench.system.values, {pair, pair, std::conj(pair), std::conj(pair)}), 1e-7);
    CHECK_LT(residual(bench.a, 4, bench.system, 1e-13), 1e-14);
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

TEST(eigen_sweeps_stay_few) {  // about two per eigenvalue; the limit is 30
  int most = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    fill_random(bench.a, 24, seed);
    if (seed % 3 == 1)  // sparse, with zero blocks and repeated entries
      for (int i = 0; i < 24; ++i)
        for (int j = 0; j < 24; ++j) bench.a(i, j) = std::round(0.7 * bench.a(i, j));
    CHECK(eigenvalues(bench.a, 24, bench.work, bench.values) == Status::ok);
    most = std::max(most, bench.values.sweeps);
  }
  CHECK_LT(most, 3 * 24);
}

TEST(eigen_float) {  // single precision against double precision of the same entries
  for (int n : {1, 2, 5, 12, 17, 24}) {
    fill_random(bench_float.a, n, 5);
    fill(bench.a, kNan);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) bench.a(i, j) = static_cast<double>(bench_float.a(i, j));
    CHECK(eigenvalues(bench.a, n, bench.work, bench.values) == Status::ok);
    std::vector<Cplx> expected;
    for (int k = 0; k < n; ++k) expected.push_back(eigenvalue(bench.values, k));
    CHECK(eigenvalues(bench_float.a, n, bench_float.work, bench_float.values) == Status::ok);
    CHECK_LT(distance(bench_float.values, expected), 1e-4);
    CHECK(eigensystem(bench_float.a, n, bench_float.work, bench_float.system) == Status::ok);
    CHECK_LT(residual(bench_float.a, n, bench_float.system, 1e-5), 1e-5);
  }
}

TEST(eigen_same_bits_every_time) {  // what was in the workspace before does not matter
  fill_random(bench.a, 23, 6);
  CHECK(eigensystem(bench.a, 23, bench.work, bench.system) == Status::ok);
  static Eigensystem<double, 31> again;
  fill(bench.work.schur, kNan);
  fill(bench.work.basis, kNan);
  fill(bench.work.solution, kNan);
  fill(bench.work.reverse, kNan);
  CHECK(eigensystem(bench.a, 23, bench.work, again) == Status::ok);
  for (int k = 0; k < 23; ++k) {
    CHECK_EQ(again.values.real[k], bench.system.values.real[k]);
    CHECK_EQ(again.values.imag[k], bench.system.values.imag[k]);
    for (int i = 0; i < 23; ++i) CHECK_EQ(again.left(i, k), bench.system.left(i, k));
  }
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
