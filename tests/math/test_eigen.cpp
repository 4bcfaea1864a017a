// Eigenvalues of matrices that are known. Expected values: closed forms (rotations, companion, Toeplitz, Clement and
// circulant matrices), invariants (trace, determinant, |A v - lambda v|).
#include "tiltrotor/math/algebra/lu.hpp"

#include "eigen_bench.hpp"

using namespace eigen_bench;

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
