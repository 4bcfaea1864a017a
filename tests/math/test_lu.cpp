// LU. Expected values: componentwise backward error (Oettli and Prager), known inverses, known condition
// numbers.
#include "tiltrotor/math/algebra/lu.hpp"

#include <algorithm>
#include <random>

#include "check.hpp"

using namespace tiltrotor;

namespace {

template <class R, int N>
void fill_random(Matrix<R, N, N>& a, int n, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) a(i, j) = static_cast<R>(uniform(generator));
}

// max |A x - b|_i / (|A| |x| + |b|)_i: a backward stable solution keeps it near eps.
template <class R, int N>
double backward_error(const Matrix<R, N, N>& a, int n, const R* x, const R* b, bool transposed = false) {
  double worst = 0.0;
  for (int i = 0; i < n; ++i) {
    double residual = -static_cast<double>(b[i]), size = std::fabs(static_cast<double>(b[i]));
    for (int j = 0; j < n; ++j) {
      const double term = static_cast<double>(transposed ? a(j, i) : a(i, j)) * static_cast<double>(x[j]);
      residual += term;
      size += std::fabs(term);
    }
    worst = std::fmax(worst, std::fabs(residual) / size);
  }
  return worst;
}

template <class R, int N>
void check_all_sizes(double tolerance) {
  static Matrix<R, N, N> a;
  static LU<R, N> lu;
  for (int n = 1; n <= N; ++n) {
    fill(a, std::numeric_limits<R>::quiet_NaN());  // nothing beyond n may be read
    fill_random(a, n, static_cast<unsigned>(n));
    R b[N], x[N], y[N];
    for (int i = 0; i < n; ++i) b[i] = x[i] = y[i] = static_cast<R>(std::cos(i * 1.7));
    CHECK(lu_factor(a, n, lu) == Status::ok);
    CHECK(lu_solve(lu, x) == Status::ok);
    lu_detail::substitute_transposed(lu, y);
    CHECK_LT((backward_error<R, N>(a, n, x, b)), tolerance);
    CHECK_LT((backward_error<R, N>(a, n, y, b, true)), tolerance);
  }
}

// Of the solutions in the first `columns` of X for the right sides in those of B.
template <int N, int M>
double largest_backward_error(const Matrix<double, N, N>& a, int n, const Matrix<double, N, M>& x,
                              const Matrix<double, N, M>& b, int columns) {
  double largest = 0;
  for (int j = 0; j < columns; ++j) {
    double solution[N], right[N];
    for (int i = 0; i < n; ++i) {
      solution[i] = x(i, j);
      right[i] = b(i, j);
    }
    largest = std::max(largest, backward_error<double, N>(a, n, solution, right));
  }
  return largest;
}

}  // namespace

TEST(lu_backward_error_every_size) {
  check_all_sizes<double, 33>(1e-13);
  check_all_sizes<double, 7>(1e-14);
  check_all_sizes<double, 16>(1e-13);  // whole groups of lanes
  check_all_sizes<float, 31>(3e-5);
}

TEST(lu_pivots_a_zero_diagonal) {  // the cyclic permutation: x is b shifted
  static Matrix<double, 12, 12> a;
  static LU<double, 12> lu;
  set_zero(a);
  double x[12];
  for (int i = 0; i < 12; ++i) {
    a(i, (i + 1) % 12) = 1.0;
    x[i] = i;
  }
  CHECK(lu_factor(a, 12, lu) == Status::ok);
  CHECK(lu_solve(lu, x) == Status::ok);
  for (int i = 0; i < 12; ++i) CHECK_EQ(x[(i + 1) % 12], i);
  CHECK_EQ(lu_reciprocal_condition(lu), 1.0);
}

TEST(lu_pivots_a_tiny_diagonal) {  // [1e-20 1; 1 1] x = [1 2]: without pivoting the answer is [0 1]
  const Matrix<double, 2, 2> a = {{1e-20, 1.0, 1.0, 1.0}};
  LU<double, 2> lu;
  double x[2] = {1.0, 2.0};
  CHECK(lu_factor(a, 2, lu) == Status::ok);
  CHECK(lu_solve(lu, x) == Status::ok);
  CHECK_NEAR(x[0], 1.0, 1e-15);
  CHECK_NEAR(x[1], 1.0, 1e-15);
}

TEST(lu_several_right_sides_give_the_inverse) {  // inverse of the 6 x 6 Hilbert matrix: integers known in
                                                 // closed form
  static Matrix<double, 6, 6> hilbert, unit = identity<double, 6>(), inverse;
  static LU<double, 6> lu;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) hilbert(i, j) = 1.0 / (i + j + 1);
  CHECK(lu_factor(hilbert, 6, lu) == Status::ok);
  CHECK(lu_solve(lu, unit, 6, inverse) == Status::ok);
  CHECK_REL(inverse(0, 0), 36.0, 1e-8);
  CHECK_REL(inverse(0, 5), -2772.0, 1e-8);
  CHECK_REL(inverse(4, 4), 4410000.0, 1e-8);
  CHECK_REL(inverse(5, 5), 698544.0, 1e-8);
}

// Of those that X has room for: its other columns become zero in the n rows, which are all that is written.
TEST(lu_few_right_sides_of_many_columns) {
  static Matrix<double, 12, 12> a;
  static Matrix<double, 12, 24> b, x;
  static LU<double, 12> lu;
  fill_random(a, 9, 7);
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 24; ++j) b(i, j) = std::cos(i + 3.0 * j);
  fill(x, 5.0);
  CHECK(lu_factor(a, 9, lu) == Status::ok);
  CHECK(lu_solve(lu, b, 2, x) == Status::ok);
  CHECK_LT(largest_backward_error(a, 9, x, b, 2), 1e-13);
  for (int i = 0; i < 12; ++i)
    for (int j = 2; j < 24; ++j) CHECK_EQ(x(i, j), i < 9 ? 0.0 : 5.0);
}

TEST(lu_several_right_sides_agree_with_one) {
  static Matrix<double, 31, 31> a;
  static Matrix<double, 31, 11> b, x;
  static LU<double, 31> lu;
  fill_random(a, 23, 4);
  fill(b, 0.0);
  for (int i = 0; i < 23; ++i)
    for (int j = 0; j < 11; ++j) b(i, j) = std::sin(i + 5.0 * j);
  CHECK(lu_factor(a, 23, lu) == Status::ok);
  CHECK(lu_solve(lu, b, 11, x) == Status::ok);
  CHECK_LT(largest_backward_error(a, 23, x, b, 11), 1e-13);
}

TEST(lu_condition_of_hilbert_matrices) {  // 1-norm condition numbers from the exact inverses
  const double known[9] = {
      0, 1.0, 27.0, 748.0, 28375.0, 943656.0, 29070279.0, 985194889.71984, 33872791095.0};
  static Matrix<double, 10, 10> hilbert;
  static LU<double, 10> lu;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) hilbert(i, j) = 1.0 / (i + j + 1);
  for (int n = 1; n <= 8; ++n) {
    CHECK(lu_factor(hilbert, n, lu) == Status::ok);
    CHECK_REL(1.0 / lu_reciprocal_condition(lu), known[n], 1e-5);
  }
}

TEST(lu_condition_is_a_lower_bound_within_three) {  // against the inverse formed column by column
  static Matrix<double, 20, 20> a, unit = identity<double, 20>(), inverse;
  static LU<double, 20> lu;
  for (unsigned seed = 0; seed < 50; ++seed) {
    fill_random(a, 20, seed);
    CHECK(lu_factor(a, 20, lu) == Status::ok);
    CHECK(lu_solve(lu, unit, 20, inverse) == Status::ok);
    double norm = 0.0, inverse_norm = 0.0;
    for (int j = 0; j < 20; ++j) {
      double sum = 0.0, inverse_sum = 0.0;
      for (int i = 0; i < 20; ++i) {
        sum += std::fabs(a(i, j));
        inverse_sum += std::fabs(inverse(i, j));
      }
      norm = std::fmax(norm, sum);
      inverse_norm = std::fmax(inverse_norm, inverse_sum);
    }
    const double ratio = norm * inverse_norm * lu_reciprocal_condition(lu);
    CHECK_LE(1.0 - 1e-9, ratio);
    CHECK_LT(ratio, 3.0);
  }
}

TEST(lu_refuses_what_it_cannot_solve) {
  static Matrix<double, 9, 9> a;
  static LU<double, 9> lu;
  double x[9] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
  set_zero(a);
  CHECK(lu_factor(a, 9, lu) == Status::singular);
  CHECK(lu_solve(lu, x) == Status::bad_argument);
  CHECK_EQ(x[3], 1.0);
  CHECK_EQ(lu_reciprocal_condition(lu), 0.0);
  fill_random(a, 9, 1);
  for (int j = 0; j < 9; ++j) a(8, j) = 2.0 * a(2, j);  // proportional rows, exact in binary
  CHECK(lu_factor(a, 9, lu) == Status::singular);
  fill_random(a, 9, 1);
  a(5, 7) = std::numeric_limits<double>::quiet_NaN();
  CHECK(lu_factor(a, 9, lu) == Status::not_finite);
  CHECK(lu_factor(a, 5, lu) == Status::ok);  // the bad entry lies outside
  a(5, 7) = std::numeric_limits<double>::infinity();
  CHECK(lu_factor(a, 9, lu) == Status::not_finite);
  CHECK(lu_factor(a, 0, lu) == Status::bad_argument);
  CHECK(lu_factor(a, 10, lu) == Status::bad_argument);
  CHECK(lu_factor(identity<double, 9>(), 9, lu) == Status::ok);
  x[4] = std::numeric_limits<double>::infinity();
  CHECK(lu_solve(lu, x) == Status::not_finite);
  CHECK(std::isnan(x[0]));
}

TEST(lu_survives_extreme_scales) {
  static Matrix<double, 5, 5> a;
  static LU<double, 5> lu;
  set_zero(a);
  double x[5];
  for (int i = 0; i < 5; ++i) {
    a(i, i) = std::pow(10.0, 60.0 * i - 120.0);
    x[i] = a(i, i);
  }
  CHECK(lu_factor(a, 5, lu) == Status::ok);
  CHECK(lu_solve(lu, x) == Status::ok);
  for (double solution : x) CHECK_REL(solution, 1.0, 1e-15);
  CHECK_REL(lu_reciprocal_condition(lu), 1e-240, 1e-12);
}

TEST(lu_every_solution_refuses_factors_and_columns_that_are_none) {
  static LU<double, 4> lu;
  static Matrix<double, 4, 2> b, x;
  double y[4] = {1, 2, 3, 4};
  CHECK(lu_factor(identity<double, 4>(), 4, lu) == Status::ok);
  CHECK(lu_solve(lu, y) == Status::ok);
  CHECK_EQ(y[3], 4.0);
  CHECK_EQ(lu_reciprocal_condition(lu), 1.0);
  for (const int columns : {-1, 3}) CHECK(lu_solve(lu, b, columns, x) == Status::bad_argument);
  b(2, 1) = std::numeric_limits<double>::infinity();
  CHECK(lu_solve(lu, b, 2, x) == Status::not_finite);
  for (int i = 0; i < 4; ++i) CHECK(std::isnan(x(i, 0)) && std::isnan(x(i, 1)));
  CHECK(lu_solve(lu, b, 1, x) == Status::ok);  // the bad column is not asked for
  for (const int size : {-1, 0, 5}) {
    lu.size = size;
    CHECK(lu_solve(lu, y) == Status::bad_argument);
    x(0, 0) = 7;
    CHECK(lu_solve(lu, b, 1, x) == Status::bad_argument);
    CHECK_EQ(x(0, 0), 0.0);
    CHECK_EQ(lu_reciprocal_condition(lu), 0.0);
  }
  for (int i = 0; i < 4; ++i) CHECK_EQ(y[i], i + 1.0);
}

// By hand: the inverse of [e 1/e; 0 e] holds -1/e^3, of diag(e, 1/e) the condition number is 1/e^2.
TEST(lu_condition_beyond_the_range_is_zero) {
  static LU<double, 2> lu;
  static Matrix<double, 2, 2> a;
  const double e = std::ldexp(1.0, -600);
  set_zero(a);
  a(0, 0) = a(1, 1) = e;
  a(0, 1) = 1 / e;
  CHECK(lu_factor(a, 2, lu) == Status::ok);
  CHECK_EQ(lu_reciprocal_condition(lu), 0.0);
  a(0, 1) = 0;
  a(1, 1) = 1 / e;
  CHECK(lu_factor(a, 2, lu) == Status::ok);
  CHECK_EQ(lu_reciprocal_condition(lu), 0.0);
}

// Gradient ascent that climbs one column at a time: column k of the inverse is g^k (h_k + 0.9 h_(k-1)) with
// rows of a Hadamard matrix, so that the gradient at each sees the next alone; partners of the opposite sign
// keep the start from seeing the last. Five steps are all it may take; what it has found by then is a lower
// bound.
TEST(lu_condition_stops_after_its_steps) {
  constexpr int n = 16;
  static Matrix<double, n, n> inverse, unit, a;
  static LU<double, n> lu;
  const auto hadamard = [](int i, int j) {
    int bits = 0;
    for (int both = i & j; both != 0; both &= both - 1) ++bits;
    return bits % 2 == 0 ? 1.0 : -1.0;
  };
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n / 2; ++k) {
      const double column = std::ldexp(hadamard(i, k) + (k > 0 ? 0.9 * hadamard(i, k - 1) : 0), k);
      inverse(i, k) = column;
      inverse(i, n / 2 + k) = (k == 0 ? 1 : -0.999999) * column + 1e-3 * hadamard(i, n / 2 + k);
    }
  }
  unit = identity<double, n>();
  CHECK(lu_factor(inverse, n, lu) == Status::ok);
  CHECK(lu_solve(lu, unit, n, a) == Status::ok);
  CHECK(lu_factor(a, n, lu) == Status::ok);
  const auto sum = [&](const Matrix<double, n, n>& m, int j) {
    double size = 0;
    for (int i = 0; i < n; ++i) size += std::abs(m(i, j));
    return size;
  };
  double norm = 0, inverse_norm = 0;
  for (int j = 0; j < n; ++j) {
    norm = std::fmax(norm, sum(a, j));
    inverse_norm = std::fmax(inverse_norm, sum(inverse, j));
  }
  const double found = 1 / (lu_reciprocal_condition(lu) * norm);
  CHECK_LE(found, inverse_norm * (1 + 1e-9));
  CHECK_LE(sum(inverse, 4) * (1 - 1e-9), found);
  NOTE("norm of the inverse " << inverse_norm << ", found " << found);
}

// Wilkinson's matrix doubles its last column with every elimination: past the largest number with the last
// one, while every pivot before it is 1.
TEST(lu_growth_beyond_the_range_is_not_finite) {
  static Matrix<double, 3, 3> a;
  static LU<double, 3> lu;
  for (double size : {std::numeric_limits<double>::max() / 3.2, 1e300}) {
    const double rows[3][3] = {{1, 0, size}, {-1, 1, size}, {-1, -1, size}};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) a(i, j) = rows[i][j];
    CHECK(lu_factor(a, 3, lu) == (size > 1e307 ? Status::not_finite : Status::ok));
    CHECK_EQ(lu.size, size > 1e307 ? 0 : 3);
  }
}
