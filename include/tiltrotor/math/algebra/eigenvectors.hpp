// Eigenvectors of a real Schur form by back substitution, and their way back to the states of the matrix.
//
// All eigenvectors are solved for at once, row by row from below: the row of the solution matrix holds one
// number per eigenvector (two for a complex pair, real part in the first column), so the inner loops run over
// eigenvectors.
#pragma once

#include <cmath>
#include <limits>

#include "tiltrotor/math/algebra/balance.hpp"
#include "tiltrotor/math/algebra/matrix.hpp"
#include "tiltrotor/math/scalar.hpp"

namespace tiltrotor {

// m(i, j) = t(n-1-j, n-1-i): the transposed matrix with rows and columns in reversed order. Upper triangular
// stays upper triangular; right eigenvectors of the mirror are left ones of `t`, read from the end.
template <class R, int N>
inline void mirror(const Matrix<R, N, lane_ceil<R>(N)>& t, int n, Matrix<R, N, lane_ceil<R>(N)>& m) {
  set_zero(m);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) m(n - 1 - j, n - 1 - i) = t(i, j);
}

namespace eigenvector_detail {

template <class R>
struct Complex {
  R re, im;
};
template <class R>
inline Complex<R> times(Complex<R> a, Complex<R> b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
template <class R>
inline R size_of(Complex<R> a) {
  return larger_of(std::fabs(a.re), std::fabs(a.im));
}
// 1 / a for |a| of at least `smallest`, which replaces a smaller one.
template <class R>
inline Complex<R> reciprocal(Complex<R> a, R smallest) {
  const R size = size_of(a);
  if (size < smallest) return {R(1) / smallest, R(0)};
  const R x = a.re / size, y = a.im / size;
  const R factor = R(1) / (size * (x * x + y * y));
  return {x * factor, -y * factor};
}

// Eigenvectors grow while they are solved for when eigenvalues are close; beyond this size a column is scaled
// down.
template <class R>
inline R large() {
  return R(1) / tiltrotor::sqrt(tiltrotor::sqrt(std::numeric_limits<R>::min()));
}

template <class R, int N>
inline void shrink(PaddedSquare<R, N>& x, int n, int top, int column, int count, R size) {
  if (!(size > large<R>())) return;
  const R factor = R(1) / size;
  for (int i = top; i < n; ++i)
    for (int e = column; e < column + count; ++e) x(i, e) *= factor;
}

// Factor, a power of two, that keeps products of these numbers from vanishing; nearly always 1.
template <class R>
inline R unit_of_pair(R half, R b, R c) {
  const R size = larger_of(std::fabs(half), larger_of(std::fabs(b), std::fabs(c)));
  if (size > R(1) / large<R>() || size < std::numeric_limits<R>::min()) return R(1);
  int exponent = 0;
  std::frexp(size, &exponent);
  return std::ldexp(R(1), -exponent);
}

// x(row, e) = - sum over j > block of t(row, j) x(j, e), all columns from `begin` on.
template <class R, int N>
inline void accumulate(const PaddedSquare<R, N>& t, int row, int block_end, int n, PaddedSquare<R, N>& x) {
  const int end = lane_ceil<R>(n);
  for (int c = lane_floor<R>(block_end); c < end; c += kLane<R>) {
    R sum[kLane<R>] = {};
    const int last = c + kLane<R> < n ? c + kLane<R> + 1 : n;  // x(j, .) is zero left of column j - 1
    for (int j = block_end; j < last; ++j) {
      const R factor = t(row, j);
      const R* from = x.row(j) + c;
      for (int l = 0; l < kLane<R>; ++l) sum[l] -= factor * from[l];
    }
    R* to = x.row(row) + c;
    for (int l = 0; l < kLane<R>; ++l) to[l] = sum[l];
  }
}

}  // namespace eigenvector_detail

// Columns of `x`: eigenvectors of the quasi-triangular `t`, packed, not normalised, zero below their own
// block. An eigenvalue met again further up is moved by eps |t|: a defective matrix gets parallel vectors, no
// division by 0.
template <class R, int N>
inline void solve_triangular_eigenvectors(const Matrix<R, N, lane_ceil<R>(N)>& t, int n,
                                          Matrix<R, N, lane_ceil<R>(N)>& x) {
  using namespace eigenvector_detail;
  R norm = R(0);
  R real[N], imag[N];  // eigenvalues as they stand on the diagonal; imag > 0 at the first place of a pair
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) norm = larger_of(norm, std::fabs(t(i, j)));
  const R smallest = larger_of(norm * std::numeric_limits<R>::epsilon(),
                               std::numeric_limits<R>::min() / std::numeric_limits<R>::epsilon());
  for (int i = 0; i < n; ++i) {
    real[i] = t(i, i);
    imag[i] = R(0);
  }
  for (int i = 0; i + 1 < n; ++i)
    if (t(i + 1, i) != R(0)) {
      const R half = R(0.5) * (t(i, i) - t(i + 1, i + 1));
      const R unit = unit_of_pair(half, t(i, i + 1), t(i + 1, i));
      const R discriminant = -((half * unit) * (half * unit) + (t(i, i + 1) * unit) * (t(i + 1, i) * unit));
      real[i] = real[i + 1] = t(i + 1, i + 1) + half;
      imag[i] = discriminant > R(0) ? tiltrotor::sqrt(discriminant) / unit : R(0);
      imag[i + 1] = -imag[i];
    }
  set_zero(x);
  for (int i = n - 1; i >= 0; --i) {
    const bool pair = i > 0 && t(i, i - 1) != R(0);
    const int top = pair ? i - 1 : i;
    for (int row = top; row <= i; ++row) accumulate<R, N>(t, row, i + 1, n, x);
    if (!pair) {
      x(i, i) = R(1);
      for (int e = i + 1; e < n; ++e) {
        if (imag[e] == R(0)) {
          R d = t(i, i) - real[e];
          if (std::fabs(d) < smallest) d = smallest;
          x(i, e) /= d;
          shrink<R, N>(x, n, i, e, 1, std::fabs(x(i, e)));
        } else {
          const Complex<R> d = reciprocal<R>({t(i, i) - real[e], -imag[e]}, smallest);
          const Complex<R> z = times<R>(d, {x(i, e), x(i, e + 1)});
          x(i, e) = z.re;
          x(i, e + 1) = z.im;
          shrink<R, N>(x, n, i, e, 2, size_of(z));
          ++e;
        }
      }
      continue;
    }
    const R a = t(top, top), b = t(top, i), c = t(i, top), d = t(i, i);
    // Own vector: (b, lambda - a) or (lambda - d, c), whichever divides by the larger entry.
    if (std::fabs(b) >= std::fabs(c)) {
      x(top, top) = R(1);
      x(top, i) = R(0);
      x(i, top) = (real[top] - a) / b;
      x(i, i) = imag[top] / b;
    } else {
      x(top, top) = (real[top] - d) / c;
      x(top, i) = imag[top] / c;
      x(i, top) = R(1);
      x(i, i) = R(0);
    }
    for (int e = i + 1; e < n; ++e) {
      const bool complex = imag[e] != R(0);
      const Complex<R> p = {a - real[e], -imag[e]}, q = {d - real[e], -imag[e]};
      const Complex<R> u = {x(top, e), complex ? x(top, e + 1) : R(0)};
      const Complex<R> v = {x(i, e), complex ? x(i, e + 1) : R(0)};
      const Complex<R> pq = times(p, q);
      const R unit = larger_of(larger_of(std::fabs(b), std::fabs(c)), larger_of(size_of(p), size_of(q)));
      const Complex<R> inverse = reciprocal<R>({(pq.re - b * c) / unit, pq.im / unit}, smallest);
      const Complex<R> qu = times(q, u), pv = times(p, v);
      const Complex<R> first = times<R>(inverse, {(qu.re - b * v.re) / unit, (qu.im - b * v.im) / unit});
      const Complex<R> second = times<R>(inverse, {(pv.re - c * u.re) / unit, (pv.im - c * u.im) / unit});
      x(top, e) = first.re;
      x(i, e) = second.re;
      if (complex) {
        x(top, e + 1) = first.im;
        x(i, e + 1) = second.im;
      }
      shrink<R, N>(x, n, top, e, complex ? 2 : 1, larger_of(size_of(first), size_of(second)));
      if (complex) ++e;
    }
    --i;
  }
}

// Unit 2-norm for every packed column.
template <class R, int N>
inline void normalise(Matrix<R, N, lane_ceil<R>(N)>& vectors, int n, const R* imag) {
  constexpr int kWide = lane_ceil<R>(N);
  const int end = lane_ceil<R>(n);
  alignas(64) R largest[kWide] = {};
  alignas(64) R square[kWide] = {};
  for (int i = 0; i < n; ++i)
    for (int c = 0; c < end; ++c) {
      const R size = std::fabs(vectors(i, c));
      largest[c] = size > largest[c] ? size : largest[c];
    }
  for (int e = 0; e + 1 < n; ++e)
    if (imag[e] > R(0)) largest[e] = largest[e + 1] = larger_of(largest[e], largest[e + 1]);
  for (int c = 0; c < end; ++c) largest[c] = largest[c] > R(0) ? largest[c] : R(1);
  for (int i = 0; i < n; ++i)
    for (int c = 0; c < end; ++c) {
      const R x = vectors(i, c) / largest[c];
      vectors(i, c) = x;
      square[c] += x * x;
    }
  for (int e = 0; e + 1 < n; ++e)
    if (imag[e] > R(0)) square[e] = square[e + 1] = square[e] + square[e + 1];
  for (int c = 0; c < end; ++c) square[c] = square[c] > R(0) ? R(1) / tiltrotor::sqrt(square[c]) : R(0);
  for (int i = 0; i < n; ++i)
    for (int c = 0; c < end; ++c) vectors(i, c) *= square[c];
}

// Right eigenvectors of A = P D (Q T Q^T) D^-1 P^T from those of T: v = P D Q x.
template <class R, int N>
inline void assemble_right(const Matrix<R, N, lane_ceil<R>(N)>& basis, const Matrix<R, N, lane_ceil<R>(N)>& x,
                           int n, const Balance<R, N>& balance, const R* imag,
                           Matrix<R, N, lane_ceil<R>(N)>& right) {
  set_zero(right);
  const int end = lane_ceil<R>(n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)  // x(j, .) is zero left of the block that holds column j
      padded::add_scaled(basis(j, i), x.row(j), right.row(i), lane_floor<R>(j > 0 ? j - 1 : 0), end);
  normalise<R, N>(right, n, imag);
  undo_balance<R, N>(balance, n, false, right);
  normalise<R, N>(right, n, imag);
}

// Left eigenvectors from those of the mirrored T: w = P D^-1 Q y, y read from the end. The solution belongs
// to w^T A = lambda w^T; the conjugate makes it w^H A = lambda w^H.
template <class R, int N>
inline void assemble_left(const Matrix<R, N, lane_ceil<R>(N)>& basis, const Matrix<R, N, lane_ceil<R>(N)>& x,
                          int n, const Balance<R, N>& balance, const R* imag,
                          Matrix<R, N, lane_ceil<R>(N)>& left) {
  set_zero(left);
  const int end = lane_ceil<R>(n);
  alignas(64) R sum[lane_ceil<R>(N)];
  for (int i = 0; i < n; ++i) {
    for (int c = 0; c < end; ++c) sum[c] = R(0);
    for (int j = 0; j < n; ++j)
      padded::add_scaled(basis(n - 1 - j, i), x.row(j), sum, lane_floor<R>(j > 0 ? j - 1 : 0), end);
    for (int e = 0; e < n; ++e) {
      if (imag[e] > R(0)) {  // the pair e, e+1 stands at n-2-e, n-1-e of the mirror
        left(i, e) = sum[n - 2 - e];
        left(i, e + 1) = -sum[n - 1 - e];
        ++e;
      } else {
        left(i, e) = sum[n - 1 - e];
      }
    }
  }
  normalise<R, N>(left, n, imag);
  undo_balance<R, N>(balance, n, true, left);
  normalise<R, N>(left, n, imag);
}

// 1 / |w^H v| for vectors of unit length; at most 1 / the smallest normal number.
template <class R, int N>
inline void eigenvalue_conditions(const Matrix<R, N, lane_ceil<R>(N)>& right,
                                  const Matrix<R, N, lane_ceil<R>(N)>& left, int n, const R* imag,
                                  R (&condition)[N]) {
  for (int e = 0; e < n; ++e) {
    R real_part = R(0), imag_part = R(0);
    if (imag[e] > R(0)) {
      for (int i = 0; i < n; ++i) {
        const R a = right(i, e), b = right(i, e + 1), c = left(i, e), d = left(i, e + 1);
        real_part += a * c + b * d;
        imag_part += b * c + a * -d;  // a sum as above: no fused operation
      }
    } else {
      for (int i = 0; i < n; ++i) real_part += right(i, e) * left(i, e);
    }
    const R product = tiltrotor::sqrt(real_part * real_part + imag_part * imag_part);
    condition[e] = R(1) / larger_of(product, std::numeric_limits<R>::min());
    if (imag[e] > R(0)) {
      condition[e + 1] = condition[e];
      ++e;
    }
  }
  for (int e = n; e < N; ++e) condition[e] = std::numeric_limits<R>::quiet_NaN();
}

}  // namespace tiltrotor
