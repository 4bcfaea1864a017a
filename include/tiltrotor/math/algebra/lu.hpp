// LU factorisation with partial pivoting, solution of linear systems, and an estimate of the condition
// number.
//
// Rows are exchanged by index only: they stay where they are and `row` lists them in the order of
// elimination.
#pragma once

#include <cmath>
#include <cstring>
#include <limits>

#include "tiltrotor/math/algebra/matrix.hpp"
#include "tiltrotor/math/differentiation/lanes.hpp"
#include "tiltrotor/math/status.hpp"

namespace tiltrotor {

// The factors of the leading `size` x `size` part of a matrix: P A = L U. Placed by the caller.
template <class R, int N>
struct LU {
  // Row row[k] belongs to step k: `lower` holds L left of column k (ones on the diagonal not stored), `upper`
  // U from column k on. Apart because a narrow store followed by a wide load of the same place stalls most
  // processors.
  PaddedSquare<R, N> lower, upper;
  R inverse_pivot[N];
  int row[N];
  int size;
  R norm1;  // 1-norm of A
};

namespace lu_detail {

// The row with the largest entry of a column, found so far.
template <class R>
struct Pivot {
  int place;
  R size;

  void offer(int candidate, R entry) {
    const R candidate_size = std::fabs(entry);
    place = candidate_size > size ? candidate : place;
    size = candidate_size > size ? candidate_size : size;
  }
};

// Eliminates the columns of one group of lanes after another, so that every inner loop runs over whole vectors of the
// target and their number is a constant to the compiler, which would unroll a short loop over numbers before it sees
// lanes in it. The search for the next pivot runs along with the elimination.
template <int kGroup, class R, int N>
inline bool eliminate_groups(LU<R, N>& lu, Pivot<R> pivot) {
  constexpr int kBegin = kGroup * kLane<R>;
  if constexpr (kBegin < N) {
    constexpr int kWidth = kWidestLanes<R>;
    constexpr int kVectors = (N - kBegin + kWidth - 1) / kWidth;
    using Vector = typename LaneType<R, kWidth>::type;
    const int n = lu.size;
    const int last = kBegin + kLane<R> < n ? kBegin + kLane<R> : n;
    for (int k = kBegin; k < last; ++k) {
      if (!(pivot.size >= std::numeric_limits<R>::min())) return false;  // also when all are NaN
      const int pivot_row = lu.row[pivot.place];
      lu.row[pivot.place] = lu.row[k];
      lu.row[k] = pivot_row;
      const R inverse = R(1) / lu.upper(pivot_row, k);
      lu.inverse_pivot[k] = inverse;
      Vector from[kVectors];
      const R* const pivots = lu.upper.row(pivot_row) + kBegin;
      for (int v = 0; v < kVectors; ++v) std::memcpy(&from[v], pivots + v * kWidth, sizeof from[v]);
      const int here = k - kBegin;
      pivot = {k + 1, R(-1)};
      for (int i = k + 1; i < n; ++i) {
        const int row = lu.row[i];
        R* to = lu.upper.row(row) + kBegin;
        const R multiplier = to[here] * inverse;
        lu.lower(row, k) = multiplier;
        for (int v = 0; v < kVectors; ++v) {
          Vector whole;
          std::memcpy(&whole, to + v * kWidth, sizeof whole);
          whole = whole - multiplier * from[v];
          std::memcpy(to + v * kWidth, &whole, sizeof whole);
        }
        pivot.offer(i, to[here + 1]);
      }
    }
    return eliminate_groups<kGroup + 1>(lu, pivot);
  } else {
    return true;
  }
}

// Sum over whole groups [begin, end) of row . x: what the unknowns already found contribute to one row.
template <class R>
inline R known_part(const R* row, const R* x, int begin, int end) {
  return begin < end ? padded::dot(row, x, begin, end) : R(0);
}

// Forward and backward substitution by groups of rows: the unknowns of other groups enter through scalar
// products over whole groups, those of the own group one by one.
template <class R, int N>
inline void substitute(const LU<R, N>& lu, R* x) {
  constexpr int kGroup = kLane<R>;
  const int n = lu.size;
  if (n < 1) return;  // refused before: told to the compiler, which would find rows below that nobody names
  const R* lower[N];
  const R* upper[N];
  alignas(64) R y[lane_ceil<R>(N)] = {};
  for (int i = 0; i < n; ++i) {
    lower[i] = lu.lower.row(lu.row[i]);
    upper[i] = lu.upper.row(lu.row[i]);
  }
  for (int first = 0; first < n; first += kGroup) {
    const int last = first + kGroup < n ? first + kGroup : n;
    R own[kGroup] = {};
    for (int i = first; i < last; ++i) own[i - first] = x[lu.row[i]] - known_part(lower[i], y, 0, first);
    for (int k = first; k < last; ++k) {
      y[k] = own[k - first];
      for (int i = k + 1; i < last; ++i) own[i - first] -= lower[i][k] * own[k - first];
    }
  }
  const int end = lane_ceil<R>(n);
  for (int first = end - kGroup; first >= 0; first -= kGroup) {
    const int last = first + kGroup < n ? first + kGroup : n;
    R own[kGroup] = {};
    for (int i = first; i < last; ++i) own[i - first] = y[i] - known_part(upper[i], y, first + kGroup, end);
    for (int k = last - 1; k >= first; --k) {
      own[k - first] *= lu.inverse_pivot[k];
      y[k] = own[k - first];
      for (int i = first; i < k; ++i) own[i - first] -= upper[i][k] * own[k - first];
    }
  }
  for (int i = 0; i < n; ++i) x[i] = y[i];
}

// The same for A^T x = b, which the estimate of the condition needs.
template <class R, int N>
inline void substitute_transposed(const LU<R, N>& lu, R* x) {
  const int n = lu.size;
  R y[N];
  for (int i = 0; i < n; ++i) y[i] = x[i];
  for (int k = 0; k < n; ++k) {
    const R* u = lu.upper.row(lu.row[k]);
    y[k] *= lu.inverse_pivot[k];
    for (int j = k + 1; j < n; ++j) y[j] -= u[j] * y[k];
  }
  for (int k = n - 1; k >= 0; --k) {
    const R* l = lu.lower.row(lu.row[k]);
    for (int j = 0; j < k; ++j) y[j] -= l[j] * y[k];
  }
  for (int i = 0; i < n; ++i) x[lu.row[i]] = y[i];
}

template <class R>
inline Status finite_or_nan(R* x, int n) {
  bool finite = true;
  for (int i = 0; i < n; ++i) finite &= is_finite(x[i]);
  if (finite) return Status::ok;
  for (int i = 0; i < n; ++i) x[i] = std::numeric_limits<R>::quiet_NaN();
  return Status::not_finite;
}

}  // namespace lu_detail

// Factorises the leading n x n part of `a`.
// Status: ok; not_finite (NaN or infinity in `a`, or overflow); singular (a pivot of zero, or below the
// smallest normal number); bad_argument. Unless ok, `lu.size` is 0 and lu_solve refuses it. A matrix that is
// singular only up to rounding passes: lu_reciprocal_condition() tells. Cost: n^3 / 3 multiplications.
template <class R, int N>
inline Status lu_factor(const Matrix<R, N, N>& a, int n, LU<R, N>& lu) {
  lu.size = 0;
  lu.norm1 = R(0);
  if (n < 1 || n > N) return Status::bad_argument;
  constexpr int kWide = lane_ceil<R>(N);
  alignas(64) R column[kWide] = {};
  for (int i = 0; i < n; ++i) {
    R* to = lu.upper.row(i);
    for (int j = 0; j < n; ++j) {
      to[j] = a(i, j);
      column[j] += std::fabs(to[j]);
    }
    for (int j = n; j < kWide; ++j) to[j] = R(0);
    lu.row[i] = i;
  }
  for (int j = 0; j < n; ++j) {  // a NaN or an infinity anywhere shows in the sum of its column
    if (!is_finite(column[j])) return Status::not_finite;
    lu.norm1 = larger_of(column[j], lu.norm1);
  }
  lu.size = n;
  lu_detail::Pivot<R> first = {0, R(-1)};
  for (int i = 0; i < n; ++i) first.offer(i, a(i, 0));
  const bool regular = lu_detail::eliminate_groups<0>(lu, first);
  const bool finite = all_finite(lu.upper, n, n);
  if (regular && finite) return Status::ok;
  lu.size = 0;
  return finite ? Status::singular : Status::not_finite;
}

// Replaces b[n] by the solution of A x = b. Status: ok; not_finite (x is all NaN); bad_argument (no valid
// factors). Cost: n^2 multiplications.
template <class R, int N>
inline Status lu_solve(const LU<R, N>& lu, R* b) {
  if (lu.size < 1 || lu.size > N) return Status::bad_argument;
  lu_detail::substitute(lu, b);
  return lu_detail::finite_or_nan(b, lu.size);
}

// Solves A X = B for `columns` right sides; X is another matrix than B. Its other columns are zero in the n rows, which are
// all that is written. Status as for one right side; bad_argument: all of X is zero.
template <class R, int N, int M>
inline Status lu_solve(const LU<R, N>& lu, const Matrix<R, N, M>& b, int columns, Matrix<R, N, M>& x) {
  constexpr int kStride = Matrix<R, N, M>::kStride;
  if (lu.size < 1 || lu.size > N || columns < 0 || columns > M) {
    set_zero(x);
    return Status::bad_argument;
  }
  const int n = lu.size, lanes = lane_ceil<R>(columns), used = lanes < kStride ? lanes : kStride;
  for (int i = 0; i < n; ++i) {
    const R* from = b.row(lu.row[i]);
    R* to = x.row(i);
    for (int j = 0; j < columns; ++j) to[j] = from[j];
    for (int j = columns; j < kStride; ++j) to[j] = R(0);
  }
  const auto subtract = [&](int i, R factor, int k) {
    const R* __restrict from = x.row(k);
    R* __restrict to = x.row(i);
    for (int j = 0; j < used; ++j) to[j] -= factor * from[j];
  };
  for (int i = 1; i < n; ++i)
    for (int k = 0; k < i; ++k) subtract(i, lu.lower(lu.row[i], k), k);
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k) subtract(i, lu.upper(lu.row[i], k), k);
    R* to = x.row(i);
    for (int j = 0; j < columns; ++j) to[j] *= lu.inverse_pivot[i];
  }
  if (all_finite(x, n, columns)) return Status::ok;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < columns; ++j) x(i, j) = std::numeric_limits<R>::quiet_NaN();
  return Status::not_finite;
}

inline constexpr int kConditionSteps = 5;

// Estimates 1 / (|A|_1 |A^-1|_1) by Hager's gradient ascent on |A^-1 x|_1 over the unit 1-ball, with Higham's
// alternating vector as a second lower bound. The estimate of |A^-1|_1 is never too large and seldom more
// than three times too small. Right sides are as large as A, by a power of two, so that the size of A does
// not matter. 0 when there are no valid factors or the condition number exceeds about 1e288 (1e35 in float).
// Cost: at most 11 solutions.
template <class R, int N>
inline R lu_reciprocal_condition(const LU<R, N>& lu) {
  const int n = lu.size;
  if (n < 1 || n > N) return R(0);
  R x[N], sign[N];
  R estimate = R(0);
  int unit = -1;
  int exponent = 0;
  std::frexp(lu.norm1, &exponent);
  constexpr int kSafe = std::numeric_limits<R>::max_exponent / 16;  // above the subnormal numbers
  const int least = std::numeric_limits<R>::min_exponent + kSafe;
  const R one = std::ldexp(R(1), exponent > least ? exponent - 1 : least);
  for (int i = 0; i < n; ++i) x[i] = one / static_cast<R>(n);
  for (int step = 0; step < kConditionSteps; ++step) {
    lu_detail::substitute(lu, x);
    R sum = R(0);
    for (int i = 0; i < n; ++i) {
      sum += std::fabs(x[i]);
      sign[i] = x[i] < R(0) ? -one : one;
    }
    if (!is_finite(sum)) return R(0);
    if (sum <= estimate) break;
    estimate = sum;
    lu_detail::substitute_transposed(lu, sign);
    int steepest = 0;
    for (int i = 1; i < n; ++i)
      if (std::fabs(sign[i]) > std::fabs(sign[steepest])) steepest = i;
    if (steepest == unit) break;
    unit = steepest;
    for (int i = 0; i < n; ++i) x[i] = i == unit ? one : R(0);
  }
  for (int i = 0; i < n; ++i) {
    const R size = one * (R(1) + (n > 1 ? static_cast<R>(i) / static_cast<R>(n - 1) : R(0)));
    x[i] = i % 2 == 0 ? size : -size;
  }
  lu_detail::substitute(lu, x);
  R sum = R(0);
  for (int i = 0; i < n; ++i) sum += std::fabs(x[i]);
  estimate = larger_of(estimate, R(2) * sum / (R(3) * static_cast<R>(n)));  // NaN stays
  const R condition = estimate * (lu.norm1 / one);
  return is_finite(condition) && condition > R(0) ? R(1) / condition : R(0);
}

}  // namespace tiltrotor
