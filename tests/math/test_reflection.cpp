// The reflections of a sweep in whole vectors, bit for bit against their formula written out number by number.
#include "tiltrotor/math/algebra/reflection.hpp"

#include <cstring>
#include <random>

#include "check.hpp"

using namespace tiltrotor;

namespace {

constexpr int kSize = 11;  // neither a multiple of four nor of eight

template <class R>
using Square = PaddedSquare<R, kSize>;

// H - g (H v) v^T and H - g v (v^T H) for v in places k .. k+2, entry by entry in the order the header promises.
template <class R>
void reflect_columns_by_numbers(const Reflection<R>& p, Square<R>& h, int k, int begin, int last) {
  for (int i = begin; i <= last; ++i) {
    const R s = p.v0 * h(i, k) + p.v1 * h(i, k + 1) + p.v2 * h(i, k + 2);
    h(i, k) -= p.g * p.v0 * s;
    h(i, k + 1) -= p.g * p.v1 * s;
    h(i, k + 2) -= p.g * p.v2 * s;
  }
}
template <class R>
void reflect_rows_by_numbers(const Reflection<R>& p, Square<R>& h, int k, int begin, int end) {
  for (int j = begin; j < end; ++j) {
    const R s = p.v0 * h(k, j) + p.v1 * h(k + 1, j) + p.v2 * h(k + 2, j);
    h(k, j) -= p.g * p.v0 * s;
    h(k + 1, j) -= p.g * p.v1 * s;
    h(k + 2, j) -= p.g * p.v2 * s;
  }
}

template <class R>
void fill(Square<R>& h, std::mt19937& random) {
  std::uniform_real_distribution<R> entry(-1, 1);
  for (int i = 0; i < kSize; ++i)
    for (int j = 0; j < kSize; ++j) h(i, j) = i > j + 3 ? R(0) : entry(random);
}

template <class R>
bool equal_bits(const Square<R>& a, const Square<R>& b) {
  bool equal = true;
  for (int i = 0; i < kSize; ++i) equal = equal && std::memcmp(a.row(i), b.row(i), sizeof(R) * kSize) == 0;
  return equal;
}

template <class R>
void check_columns() {
  std::mt19937 random(1);
  std::uniform_real_distribution<R> number(-1, 1);
  Square<R> h{}, expected{};
  for (int k = 0; k + 3 <= kSize; ++k)
    for (int begin = 0; begin < kSize; ++begin)
      for (int last = begin - 1; last < kSize; ++last) {
        fill(h, random);
        expected = h;
        const Reflection<R> p = {number(random), number(random), number(random), number(random), R(0)};
        reflecting::reflect_three_columns<R, kSize>(p, h, k, begin, last);
        reflect_columns_by_numbers(p, expected, k, begin, last);
        CHECK(equal_bits(h, expected));
      }
}

// A step of a sweep over a block high up, low down and over all of the matrix.
template <class R>
void check_step() {
  std::mt19937 random(2);
  std::uniform_real_distribution<R> number(-1, 1);
  Square<R> h{}, expected{};
  for (int low = 0; low + 4 <= kSize; ++low)
    for (int k = low; k + 4 <= kSize; ++k) {
      fill(h, random);
      expected = h;
      const Reflection<R> p = {number(random), number(random), number(random), number(random), R(0)};
      const R left = number(random);
      const auto next = reflecting::reflect_both<R, kSize>(p, h, k, k > low ? &left : nullptr,
                                                           reflecting::group_ceil<R>(kSize), low);
      // Left of column k whole groups are reflected as well: nothing stands there in a sweep but column k-1.
      reflect_rows_by_numbers(p, expected, k, reflecting::group_floor<R>(k), kSize);
      if (k > low) {
        expected(k, k - 1) = left;
        expected(k + 1, k - 1) = expected(k + 2, k - 1) = R(0);
      }
      reflect_columns_by_numbers(p, expected, k, low, k + 3);
      CHECK(equal_bits(h, expected));
      CHECK_EQ(next.x, expected(k + 1, k));
      CHECK_EQ(next.y, expected(k + 2, k));
      CHECK_EQ(next.z, expected(k + 3, k));
    }
}

}  // namespace

TEST(eigen_reflected_columns_are_their_formula_bit_for_bit) {
  check_columns<double>();
  check_columns<float>();
}

TEST(eigen_step_of_a_sweep_is_its_formula_bit_for_bit) {
  check_step<double>();
  check_step<float>();
}
