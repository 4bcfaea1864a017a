// Balancing: permutation and powers of two that bring a matrix near to equal row and column norms.
//
// A P D = P D B: first a permutation P collects eigenvalues that can be read off (a row or column without
// off-diagonal entries), which leaves an active block low..high; then a diagonal D of powers of two, exact in
// binary arithmetic, equalises row and column sums of that block (Osborne's iteration). Eigenvalues are
// unchanged; eigenvectors of A are P D times those of B. Without it, a matrix whose states have mixed units
// (metres, radians, newtons) loses its small eigenvalues to rounding of the large entries.
#pragma once

#include <cmath>

#include "tiltrotor/math/algebra/matrix.hpp"

namespace tiltrotor {

template <class R, int N>
struct Balance {
  R scale[N];     // diagonal of D, ones outside low..high
  int swap[N];    // row and column exchanged with each place outside low..high
  int low, high;  // active block, inclusive
};

namespace balance_detail {

template <class R, int N>
inline void exchange(PaddedSquare<R, N>& a, int n, int i, int j) {
  if (i == j) return;
  for (int k = 0; k < n; ++k) {
    const R x = a(i, k);
    a(i, k) = a(j, k);
    a(j, k) = x;
  }
  for (int k = 0; k < n; ++k) {
    const R x = a(k, i);
    a(k, i) = a(k, j);
    a(k, j) = x;
  }
}

template <class R, int N>
inline bool row_isolated(const PaddedSquare<R, N>& a, int i, int low, int high) {
  for (int j = low; j <= high; ++j)
    if (j != i && a(i, j) != R(0)) return false;
  return true;
}

template <class R, int N>
inline bool column_isolated(const PaddedSquare<R, N>& a, int j, int low, int high) {
  for (int i = low; i <= high; ++i)
    if (i != j && a(i, j) != R(0)) return false;
  return true;
}

// Each found eigenvalue shrinks the block by one, hence at most n passes of either kind.
template <class R, int N>
inline void permute(PaddedSquare<R, N>& a, int n, Balance<R, N>& b) {
  b.low = 0;
  for (b.high = n - 1; b.high > 0; --b.high) {
    int i = b.high;
    while (i >= 0 && !row_isolated<R, N>(a, i, 0, b.high)) --i;
    if (i < 0) break;
    exchange<R, N>(a, n, i, b.high);
    b.swap[b.high] = i;
  }
  for (; b.low < b.high; ++b.low) {
    int j = b.low;
    while (j <= b.high && !column_isolated<R, N>(a, j, b.low, b.high)) ++j;
    if (j > b.high) break;
    exchange<R, N>(a, n, j, b.low);
    b.swap[b.low] = j;
  }
}

// A change by the nearest power of two pays when it lowers the sum of the two norms by 5 %, which is the case
// from this ratio of the norms on: with factor 2, 2 c + r/2 < 0.95 (c + r).
template <class R>
inline bool unequal(R column, R row) {
  constexpr R kRatio = R(2.4);
  return (row > kRatio * column || column > kRatio * row) && row > R(0) && column > R(0);
}

// One pass over the block in order, each index scaled with the norms as they then are. Returns whether any
// was.
template <class R, int N>
inline bool scale_once(PaddedSquare<R, N>& a, int n, Balance<R, N>& b) {
  constexpr int kLargestExponent = std::numeric_limits<R>::max_exponent / 2;
  bool scaled = false;
  for (int i = b.low; i <= b.high; ++i) {
    R column = R(0), row = R(0);
    for (int j = b.low; j <= b.high; ++j) {
      if (j == i) continue;
      column += std::fabs(a(j, i));
      row += std::fabs(a(i, j));
    }
    if (!unequal(column, row)) continue;
    int column_exponent = 0, row_exponent = 0;
    std::frexp(column, &column_exponent);
    std::frexp(row, &row_exponent);
    const int difference = row_exponent - column_exponent;
    int exponent = (difference + (difference > 0 ? 1 : -1)) / 2;
    int total = 0;
    std::frexp(b.scale[i], &total);
    if (total + exponent > kLargestExponent || total + exponent < -kLargestExponent) continue;
    const R factor = std::ldexp(R(1), exponent);
    const R inverse = std::ldexp(R(1), -exponent);
    if (column * factor + row * inverse >= R(0.95) * (column + row)) continue;
    scaled = true;
    b.scale[i] *= factor;
    for (int j = b.low; j < n; ++j) a(i, j) *= inverse;
    for (int j = 0; j <= b.high; ++j) a(j, i) *= factor;
  }
  return scaled;
}

}  // namespace balance_detail

// The permutation alone: exact, whatever the size of the entries.
template <class R, int N>
inline void isolate(Matrix<R, N, lane_ceil<R>(N)>& a, int n, Balance<R, N>& b) {
  for (int i = 0; i < N; ++i) {
    b.scale[i] = R(1);
    b.swap[i] = i;
  }
  balance_detail::permute<R, N>(a, n, b);
}

inline constexpr int kBalanceSweeps = 24;

// Powers of two on the active block of an isolated matrix.
template <class R, int N>
inline void equalise(Matrix<R, N, lane_ceil<R>(N)>& a, int n, Balance<R, N>& b) {
  for (int sweep = 0; sweep < kBalanceSweeps && balance_detail::scale_once<R, N>(a, n, b); ++sweep) {
  }
}

// Balances the leading n x n part of `a` in place. Bounded: n permutation passes, kBalanceSweeps scaling
// sweeps; a matrix still unbalanced then is only less well scaled.
template <class R, int N>
inline void balance(Matrix<R, N, lane_ceil<R>(N)>& a, int n, Balance<R, N>& b) {
  isolate(a, n, b);
  equalise(a, n, b);
}

// Takes the rows of a matrix of eigenvectors back to the states of A: right vectors are multiplied by P D,
// left vectors by P D^-1.
template <class R, int N>
inline void undo_balance(const Balance<R, N>& b, int n, bool left, Matrix<R, N, lane_ceil<R>(N)>& vectors) {
  const int end = lane_ceil<R>(n);
  for (int i = b.low; i <= b.high; ++i) {
    const R factor = left ? R(1) / b.scale[i] : b.scale[i];
    R* x = vectors.row(i);
    if (factor != R(1))
      for (int c = 0; c < end; ++c) x[c] *= factor;
  }
  const auto swap_rows = [&](int i, int j) {
    if (i == j) return;
    R* x = vectors.row(i);
    R* y = vectors.row(j);
    for (int c = 0; c < end; ++c) {
      const R held = x[c];
      x[c] = y[c];
      y[c] = held;
    }
  };
  for (int i = b.low - 1; i >= 0; --i) swap_rows(i, b.swap[i]);
  for (int i = b.high + 1; i < n; ++i) swap_rows(i, b.swap[i]);
}

}  // namespace tiltrotor
