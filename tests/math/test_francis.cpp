// The QR iteration itself, without balancing: blocks of two in closed form, and where it ends.
#include "tiltrotor/math/algebra/eigen.hpp"

#include <complex>
#include <limits>

#include "check.hpp"

using namespace tiltrotor;
using Cplx = std::complex<double>;

namespace {
const double kNan = std::numeric_limits<double>::quiet_NaN();
}  // namespace

// Half of the smallest normal number's exponent and half of the digits on top: 2^-484 in double, 2^-50 in
// single precision, so that the square of a larger one is a normal number with all its digits.
TEST(eigen_negligible_size_has_a_normal_square) {
  double size = tiltrotor::francis_detail::negligible_size<double>();
  CHECK_EQ(size, std::ldexp(1.0, -484));
  float small = tiltrotor::francis_detail::negligible_size<float>();
  CHECK_EQ(small, std::ldexp(1.0f, -50));
  CHECK_LT(std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon(), size * size * 4);
}

namespace {

using Block = PaddedSquare<double, 3>;

// Eigenvalues of a block of two by francis() itself, without balancing, and the Schur form it leaves.
void check_block(double a, double b, double c, double d, Cplx first, Cplx second) {
  const double entry[2][2] = {{a, b}, {c, d}};
  Block h{}, basis{};
  for (int i = 0; i < 2; ++i) {
    basis(i, i) = 1;
    for (int j = 0; j < 2; ++j) h(i, j) = entry[i][j];
  }
  double real[3], imag[3];
  const FrancisResult outcome = francis<true, double, 3>(h, 2, 0, 1, basis, real, imag);
  CHECK_EQ(outcome.converged, 2);
  CHECK_EQ(Cplx(real[0], imag[0]), first);
  CHECK_EQ(Cplx(real[1], imag[1]), second);
  for (int i = 0; i < 2; ++i) {  // rows of the transposed basis q: q A q^T = h
    for (int j = 0; j < 2; ++j) {
      double product = 0;
      for (int k = 0; k < 2; ++k)
        for (int l = 0; l < 2; ++l) product += basis(i, k) * entry[k][l] * basis(j, l);
      CHECK_NEAR(h(i, j), product, 1e-15);
    }
  }
}

}  // namespace

// Blocks with an eigenvalue twice: below the diagonal alone, and nothing at all.
TEST(eigen_blocks_with_one_eigenvalue_twice) {
  check_block(2, 0, 1, 2, 2.0, 2.0);
  check_block(0, 0, 0, 0, 0.0, 0.0);
  check_block(3, 1, -1, 1, 2.0, 2.0);
  Block h{}, basis{};  // split off as a pair all the same: nothing turns and nothing is divided by zero
  double real[3], imag[3];
  basis(0, 0) = basis(1, 1) = 1;
  h(0, 0) = h(1, 1) = 7;
  francis_detail::split_pair<true, double, 3>(h, 2, 0, basis, real, imag);
  CHECK(real[0] == 7 && real[1] == 7 && imag[0] == 0 && imag[1] == 0);
  h(0, 0) = h(1, 1) = 0;
  francis_detail::split_pair<true, double, 3>(h, 2, 0, basis, real, imag);
  CHECK(real[0] == 0 && real[1] == 0 && imag[0] == 0 && imag[1] == 0);
  CHECK(basis(0, 0) == 1 && basis(0, 1) == 0 && basis(1, 0) == 0 && basis(1, 1) == 1);
}

// No number ever becomes small against another: what cannot converge ends after 30 sweeps an eigenvalue.
TEST(eigen_sweeps_end_where_nothing_converges) {
  Block h{}, basis{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) h(i, j) = kNan;
  double real[3] = {5, 5, 5}, imag[3] = {5, 5, 5};
  const FrancisResult outcome = francis<false, double, 3>(h, 3, 0, 2, basis, real, imag);
  CHECK_EQ(outcome.converged, 0);
  CHECK_EQ(outcome.sweeps, 30 * 3);
  for (int k = 0; k < 3; ++k) CHECK(real[k] == 5 && imag[k] == 5);
}

// (x, y) with squares that vanish and y below the rounding of x: already where a reflection would take it.
TEST(eigen_reflection_of_a_tiny_column) {
  const auto p = francis_detail::reflection(1e-200, 1e-300, 0.0);
  CHECK(p.g == 0 && p.head == 1e-200);
  const auto q = francis_detail::reflection(3e-200, 4e-200, 0.0);  // length 5e-200
  CHECK_REL(std::fabs(q.head), 5e-200, 1e-15);
  double a[8] = {3e-200}, b[8] = {4e-200};
  reflecting::reflect_rows(q, a, b, 0, 8);
  CHECK_REL(a[0], q.head, 1e-15);
  CHECK_NEAR(b[0], 0.0, 1e-215);
}

// A pair whose product is below the smallest number has no frequency left: vectors all the same.
TEST(eigen_vectors_of_a_pair_that_vanishes) {
  Block t{}, x{};
  t(0, 1) = -1e-200;
  t(1, 0) = 1e-140;
  t(2, 2) = 1;
  t(0, 2) = t(1, 2) = 0.5;
  solve_triangular_eigenvectors<double, 3>(t, 3, x);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) CHECK(std::isfinite(x(i, j)));
  // The real eigenvalue 1 is not concerned: (1 - t) x = 0 has x = (0.5, 0.5, 1) to rounding.
  CHECK_NEAR(x(0, 2) / x(2, 2), 0.5, 1e-15);
  CHECK_NEAR(x(1, 2) / x(2, 2), 0.5, 1e-15);
}
