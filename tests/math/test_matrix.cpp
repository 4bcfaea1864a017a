// Matrix, its padding, and the status words. Expected values: by hand, and algebraic identities.
#include "tiltrotor/math/algebra/matrix.hpp"

#include <cstdint>
#include <cstring>
#include <limits>

#include "check.hpp"
#include "tiltrotor/math/status.hpp"

using namespace tiltrotor;

TEST(matrix_padding_and_alignment) {
  CHECK_EQ((Matrix<double, 3, 3>::kStride), 3);
  CHECK_EQ((Matrix<double, 31, 31>::kStride), 32);
  CHECK_EQ((Matrix<double, 9, 9>::kStride), 16);
  CHECK_EQ((Matrix<float, 9, 9>::kStride), 9);
  CHECK_EQ((Matrix<float, 31, 31>::kStride), 32);
  CHECK_EQ(sizeof(Matrix<double, 3, 3>), 9 * sizeof(double));
  static Matrix<double, 9, 9> a;
  for (int i = 0; i < 9; ++i) CHECK_EQ(reinterpret_cast<std::uintptr_t>(a.row(i)) % 64, 0u);
}

TEST(matrix_is_a_plain_aggregate) {
  CHECK(std::is_aggregate<Matrix<double, 9, 9>>::value);
  CHECK(std::is_trivially_copyable<Matrix<double, 9, 9>>::value);
  constexpr Matrix<double, 2, 2> a = {{1.0, 2.0, 3.0, 4.0}};
  CHECK_EQ(a(0, 1), 2.0);
  CHECK_EQ(a(1, 0), 3.0);
}

TEST(matrix_product_by_hand) {
  const Matrix<double, 2, 3> a = {{1, 2, 3, 4, 5, 6}};
  const Matrix<double, 3, 2> b = {{7, 8, 9, 10, 11, 12}};
  Matrix<double, 2, 2> c;
  multiply(a, b, c);
  CHECK_EQ(c(0, 0), 58.0);
  CHECK_EQ(c(0, 1), 64.0);
  CHECK_EQ(c(1, 0), 139.0);
  CHECK_EQ(c(1, 1), 154.0);
  const double x[3] = {1.0, 0.0, -1.0};
  double y[2];
  multiply(a, x, y);
  CHECK_EQ(y[0], -2.0);
  CHECK_EQ(y[1], -2.0);
}

TEST(matrix_transpose_of_a_product) {  // (A B)^T = B^T A^T
  Matrix<double, 9, 11> a{};
  Matrix<double, 11, 10> b{};
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 11; ++j) a(i, j) = i * 3 - j;
  for (int i = 0; i < 11; ++i)
    for (int j = 0; j < 10; ++j) b(i, j) = (i * j) % 7 - 3;
  Matrix<double, 11, 9> at{};
  Matrix<double, 10, 11> bt{};
  for (int k = 0; k < 11; ++k) {
    for (int i = 0; i < 9; ++i) at(k, i) = a(i, k);
    for (int j = 0; j < 10; ++j) bt(j, k) = b(k, j);
  }
  Matrix<double, 9, 10> ab;
  Matrix<double, 10, 9> ba;
  multiply(a, b, ab);
  multiply(bt, at, ba);
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 10; ++j) CHECK_EQ(ab(i, j), ba(j, i));
}

TEST(matrix_identity_and_padding_stay_zero) {
  Matrix<double, 9, 9> a;
  fill(a, 5.0);
  Matrix<double, 9, 9> c;
  fill(c, 1.0);
  multiply(a, identity<double, 9>(), c);
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) CHECK_EQ(c(i, j), 5.0);
    for (int j = 9; j < c.kStride; ++j) CHECK_EQ(a.row(i)[j] + c.row(i)[j], 0.0);
  }
}

TEST(matrix_finds_every_nonfinite_entry) {
  const double bad[3] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                         -std::numeric_limits<double>::infinity()};
  Matrix<double, 11, 11> a;
  for (double x : bad)
    for (int i = 0; i < 11; ++i)
      for (int j = 0; j < 11; ++j) {
        fill(a, std::numeric_limits<double>::max());
        CHECK(all_finite(a, 11, 11));
        a(i, j) = x;
        CHECK(!all_finite(a, 11, 11));
        CHECK_EQ(all_finite(a, i, 11), true);
        CHECK_EQ(all_finite(a, 11, j), true);
      }
}

TEST(status_has_a_word_and_a_text) {
  CHECK_EQ(status_word(Status::ok), "ok");
  CHECK_EQ(status_word(Status::not_converged), "not_converged");
  CHECK_EQ(status_word(Status::singular), "singular");
  CHECK_EQ(status_word(Status::not_finite), "not_finite");
  CHECK_EQ(status_word(Status::out_of_range), "out_of_range");
  CHECK_EQ(status_word(Status::bad_argument), "bad_argument");
  CHECK_EQ(status_word(static_cast<Status>(250)), "unknown");
  CHECK_EQ(status_text(static_cast<Status>(250)), "not a status of this library");
  for (unsigned char k = 0; k < static_cast<unsigned char>(Status::count); ++k)
    CHECK(std::strlen(status_text(static_cast<Status>(k))) > 10);
}
