// Eigenvectors and condition numbers, also where there are too few of them. Expected values: biorthogonality, exact
// similarity transforms, Jordan blocks, two by two by hand.
#include "eigen_bench.hpp"

using namespace eigen_bench;

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
