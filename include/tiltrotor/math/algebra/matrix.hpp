// Matrix: fixed size, row-major, in place, and the few loops over padded rows that the solvers share.
//
// A matrix at least one 64-byte group wide has its rows padded to whole groups and aligned to 64 bytes, so
// that a loop over a row runs in whole vector registers without a remainder. Padding is zero from `Matrix<R,
// m, n> a{}` on; every function here keeps it zero and no result depends on it.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include "tiltrotor/math/arithmetic.hpp"

namespace tiltrotor {

// Numbers per 64-byte group: 8 doubles, 16 floats.
template <class R>
inline constexpr int kLane = static_cast<int>(64 / sizeof(R));

// The smallest whole number of groups that holds `n` numbers, and the start of the group that holds index
// `i`.
template <class R>
constexpr int lane_ceil(int n) {
  return (n + kLane<R> - 1) / kLane<R> * kLane<R>;
}
template <class R>
constexpr int lane_floor(int i) {
  return i / kLane<R> * kLane<R>;
}

template <class R, int Rows, int Cols>
struct Matrix {
  static_assert(Rows > 0 && Cols > 0, "a matrix has at least one row and one column");
  static constexpr int kCols = Cols;
  static constexpr bool kPadded = Cols >= kLane<R>;
  static constexpr int kStride = kPadded ? lane_ceil<R>(Cols) : Cols;

  alignas(kPadded ? 64 : alignof(R)) R entry[static_cast<unsigned>(Rows * kStride)];

  constexpr R& operator()(int i, int j) { return entry[i * kStride + j]; }
  constexpr const R& operator()(int i, int j) const { return entry[i * kStride + j]; }
  constexpr R* row(int i) { return entry + i * kStride; }
  constexpr const R* row(int i) const { return entry + i * kStride; }
};

// A square work area for `n <= N` whose rows are padded whatever N is.
template <class R, int N>
using PaddedSquare = Matrix<R, N, lane_ceil<R>(N)>;

// `count` numbers of a row; they do not overlap.
template <class R>
void copy_row(const R* from, int count, R* to) {
  std::memcpy(to, from, sizeof(R) * static_cast<std::size_t>(count));
}

template <class R, int Rows, int Cols>
constexpr void fill(Matrix<R, Rows, Cols>& a, R value) {
  for (int i = 0; i < Rows; ++i) {
    for (int j = 0; j < Cols; ++j) a(i, j) = value;
    for (int j = Cols; j < a.kStride; ++j) a(i, j) = R(0);
  }
}

template <class R, int Rows, int Cols>
constexpr void set_zero(Matrix<R, Rows, Cols>& a) {
  for (R& x : a.entry) x = R(0);
}

template <class R, int N>
constexpr Matrix<R, N, N> identity() {
  Matrix<R, N, N> a{};
  for (int i = 0; i < N; ++i) a(i, i) = R(1);
  return a;
}

// c = a b. `c` is another matrix than `a` and `b`.
template <class R, int Rows, int Inner, int Cols>
constexpr void multiply(const Matrix<R, Rows, Inner>& a, const Matrix<R, Inner, Cols>& b,
                        Matrix<R, Rows, Cols>& c) {
  set_zero(c);
  for (int i = 0; i < Rows; ++i)
    for (int k = 0; k < Inner; ++k) {
      const R factor = a(i, k);
      for (int j = 0; j < Cols; ++j) c(i, j) += factor * b(k, j);
    }
}

// y = a x, x[Cols], y[Rows]; `y` is another array than `x`.
template <class R, int Rows, int Cols>
constexpr void multiply(const Matrix<R, Rows, Cols>& a, const R* x, R* y) {
  for (int i = 0; i < Rows; ++i) {
    R sum = R(0);
    for (int j = 0; j < Cols; ++j) sum += a(i, j) * x[j];
    y[i] = sum;
  }
}

// Plain comparisons: the library's fmax and fmin are calls on many targets because of their rule for NaN.
template <class R>
constexpr R larger_of(R a, R b) {
  return a > b ? a : b;
}
template <class R>
constexpr R smaller_of(R a, R b) {
  return a < b ? a : b;
}

template <class R>
inline bool is_finite(R x) {
  return std::fabs(x) <= std::numeric_limits<R>::max();
}

// True when the leading rows x cols part holds neither NaN nor infinity.
template <class R, int Rows, int Cols>
inline bool all_finite(const Matrix<R, Rows, Cols>& a, int rows, int cols) {
  R poison = R(0);  // x * 0 is 0 for every finite x and NaN otherwise
  R lane[kLane<R>] = {};
  for (int i = 0; i < rows; ++i) {
    const R* x = a.row(i);
    int j = 0;
    for (; j + kLane<R> <= cols; j += kLane<R>)
      for (int l = 0; l < kLane<R>; ++l) lane[l] += x[j + l] * R(0);
    for (; j < cols; ++j) poison += x[j] * R(0);
  }
  for (int l = 0; l < kLane<R>; ++l) poison += lane[l];
  return poison == R(0);
}

namespace padded {

// Loops over whole groups [begin, end) of padded rows; begin and end are multiples of kLane<R>.

// y += factor x
template <class R>
inline void add_scaled(R factor, const R* __restrict x, R* __restrict y, int begin, int end) {
  for (int c = begin; c < end; c += kLane<R>)
    for (int l = 0; l < kLane<R>; ++l) y[c + l] += factor * x[c + l];
}

// y += factor_u u + factor_v v
template <class R>
inline void add_scaled(R factor_u, const R* __restrict u, R factor_v, const R* __restrict v, R* __restrict y,
                       int begin, int end) {
  for (int c = begin; c < end; c += kLane<R>)
    for (int l = 0; l < kLane<R>; ++l) y[c + l] += factor_u * u[c + l] + factor_v * v[c + l];
}

// Scalar product, summed lane by lane and then pairwise: one fixed order on every machine.
template <class R>
inline R dot(const R* __restrict x, const R* __restrict y, int begin, int end) {
  R sum[kLane<R>] = {};
  for (int c = begin; c < end; c += kLane<R>)
    for (int l = 0; l < kLane<R>; ++l) sum[l] += x[c + l] * y[c + l];
  for (int width = kLane<R> / 2; width > 0; width /= 2)
    for (int l = 0; l < width; ++l) sum[l] += sum[l + width];
  return sum[0];
}

}  // namespace padded

}  // namespace tiltrotor
