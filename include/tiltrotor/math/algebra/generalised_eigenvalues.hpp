// Generalised eigenvalues lambda of a real pencil, det(A - lambda E) = 0, in fixed memory and bounded time.
//
//   E to triangular, A to Hessenberg form by rotations -> double-shift QZ steps (Moler and Stewart, SIAM J. Numer.
//   Anal. 10, 1973) to blocks of one and two rows -> their eigenvalues
//
// Every step is orthogonal from both sides: what comes out is exact for a pencil within a few eps of this one. Use
// eigenvalues() (eigen.hpp) where E is the unit matrix.
#pragma once

#include <cmath>
#include <limits>

#include "tiltrotor/math/algebra/eigen.hpp"

namespace tiltrotor {

// Sweeps for each eigenvalue, at most.
inline constexpr int kSweepsOfQz = 30;

namespace qz_detail {

template <class R, int N>
void set_none(Eigenvalues<R, N>& values) {
  for (int k = 0; k < N; ++k) values.real[k] = values.imag[k] = std::numeric_limits<R>::quiet_NaN();
  values.converged = values.sweeps = 0;
}

// Rows (columns) i and j of m become c row_i + s row_j and c row_j - s row_i.
template <class R, int N>
void rotate_rows(Matrix<R, N, N>& m, int i, int j, R c, R s, int n) {
  for (int k = 0; k < n; ++k) {
    const R x = m(i, k), y = m(j, k);
    m(i, k) = c * x + s * y;
    m(j, k) = c * y - s * x;
  }
}
template <class R, int N>
void rotate_columns(Matrix<R, N, N>& m, int i, int j, R c, R s, int n) {
  for (int k = 0; k < n; ++k) {
    const R x = m(k, i), y = m(k, j);
    m(k, i) = c * x + s * y;
    m(k, j) = c * y - s * x;
  }
}

// c x + s y = length, c y - s x = 0.
template <class R>
void rotation(R x, R y, R& c, R& s) {
  const R size = larger_of(std::fabs(x), std::fabs(y));
  c = R(1);
  s = R(0);
  if (y == R(0)) return;
  const R p = x / size, q = y / size;
  const R length = tiltrotor::sqrt(p * p + q * q);
  c = p / length;
  s = q / length;
}

// Rows i and j of both: m(j, column) becomes zero.
template <class R, int N>
void clear_below(const Matrix<R, N, N>& m, int i, int j, int column, int n, Matrix<R, N, N>& a,
                 Matrix<R, N, N>& e) {
  R c, s;
  rotation(m(i, column), m(j, column), c, s);
  rotate_rows(a, i, j, c, s, n);
  rotate_rows(e, i, j, c, s, n);
}
// Columns j and i of both: m(row, j) becomes zero.
template <class R, int N>
void clear_left(const Matrix<R, N, N>& m, int row, int i, int j, int n, Matrix<R, N, N>& a,
                Matrix<R, N, N>& e) {
  R c, s;
  rotation(m(row, i), m(row, j), c, s);
  rotate_columns(a, i, j, c, s, n);
  rotate_columns(e, i, j, c, s, n);
}

template <class R, int N>
R largest(const Matrix<R, N, N>& m, int n) {
  R size = R(0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) size = larger_of(size, std::fabs(m(i, j)));
  return size;
}

// The 2 x 2 block of A E^-1 that ends with row `last`: E is triangular.
template <class R>
struct Block {
  R a, b, c, d;
};
template <class R, int N>
Block<R> trailing(const Matrix<R, N, N>& a, const Matrix<R, N, N>& e, int first, int last) {
  const int m = last, l = last - 1;
  const R before = l > first ? a(l, l - 1) / e(l - 1, l - 1) : R(0);
  Block<R> out;
  out.a = (a(l, l) - (l > first ? before * e(l - 1, l) : R(0))) / e(l, l);
  out.b = (a(l, m) - (l > first ? before * e(l - 1, m) : R(0)) - out.a * e(l, m)) / e(m, m);
  out.c = a(m, l) / e(l, l);
  out.d = (a(m, m) - out.c * e(l, m)) / e(m, m);
  return out;
}

// One implicit double step on rows first..last, at least three, with shifts of this sum and product.
template <class R, int N>
void step(Matrix<R, N, N>& a, Matrix<R, N, N>& e, int n, int first, int last, R sum, R product) {
  const int f = first;
  const R m11 = a(f, f) / e(f, f), m21 = a(f + 1, f) / e(f, f);
  const R m12 = (a(f, f + 1) - m11 * e(f, f + 1)) / e(f + 1, f + 1);
  const R m22 = (a(f + 1, f + 1) - m21 * e(f, f + 1)) / e(f + 1, f + 1);
  const R m32 = a(f + 2, f + 1) / e(f + 1, f + 1);
  R x = m11 * m11 + m12 * m21 - sum * m11 + product;
  R y = m21 * (m11 + m22 - sum);
  R z = m21 * m32;
  for (int k = f; k < last; ++k) {
    const bool three = k + 2 <= last;
    R c, s;
    if (three) {
      rotation(y, z, c, s);
      rotate_rows(a, k + 1, k + 2, c, s, n);
      rotate_rows(e, k + 1, k + 2, c, s, n);
      y = c * y + s * z;
    }
    rotation(x, y, c, s);
    rotate_rows(a, k, k + 1, c, s, n);
    rotate_rows(e, k, k + 1, c, s, n);
    if (k > f) a(k + 1, k - 1) = R(0);
    if (k > f && three) a(k + 2, k - 1) = R(0);
    if (three) {
      clear_left(e, k + 2, k + 1, k, n, a, e);
      clear_left(e, k + 2, k + 2, k + 1, n, a, e);
      e(k + 2, k) = e(k + 2, k + 1) = R(0);
    }
    clear_left(e, k + 1, k + 1, k, n, a, e);
    e(k + 1, k) = R(0);
    if (k + 1 < last) x = a(k + 1, k), y = a(k + 2, k), z = k + 3 <= last ? a(k + 3, k) : R(0);
  }
}

}  // namespace qz_detail

// Of the leading n x n parts of `a` and `e`, which are spent. An eigenvalue at infinity (E singular) comes out beyond
// |A| / (n eps |E|), or not finite. Pairs stand in neighbouring places, positive imaginary part first.
// Status: ok; not_finite (a NaN or an infinity in the pencil); not_converged (what was not found is NaN); bad_argument
// (n outside 1..N). Cost: about 70 n^3 multiplications, at most kSweepsOfQz n steps.
template <class R, int N>
Status generalised_eigenvalues(Matrix<R, N, N>& a, Matrix<R, N, N>& e, int n, Eigenvalues<R, N>& values) {
  namespace d = qz_detail;
  values.size = n;
  qz_detail::set_none(values);
  if (n < 1 || n > N) return Status::bad_argument;
  if (!all_finite(a, n, n) || !all_finite(e, n, n)) return Status::not_finite;
  for (int j = 0; j < n; ++j)
    for (int i = n - 1; i > j; --i) {
      d::clear_below(e, i - 1, i, j, n, a, e);
      e(i, j) = R(0);
    }
  for (int j = 0; j + 2 < n; ++j)
    for (int i = n - 1; i > j + 1; --i) {
      d::clear_below(a, i - 1, i, j, n, a, e);
      a(i, j) = R(0);
      d::clear_left(e, i, i, i - 1, n, a, e);
      e(i, i - 1) = R(0);
    }
  constexpr R eps = std::numeric_limits<R>::epsilon();
  const R small_a = eps * d::largest(a, n), small_e = eps * d::largest(e, n);
  int last = n - 1, sweeps = 0;
  const auto put = [&values](int k, R real, R imag) {
    values.real[k] = real;
    values.imag[k] = imag;
    ++values.converged;
  };
  for (int budget = kSweepsOfQz * n; last >= 0;) {
    // Within the rounding of the pencil no diagonal entry of E is zero.
    for (int k = 0; k <= last; ++k)
      if (std::fabs(e(k, k)) < small_e) e(k, k) = e(k, k) < R(0) ? -small_e : small_e;
    int first = last;
    while (first > 0 && std::fabs(a(first, first - 1)) > small_a) --first;
    if (first > 0) a(first, first - 1) = R(0);
    if (first == last) {
      put(last, a(last, last) / e(last, last), R(0));
      --last;
      sweeps = 0;
      continue;
    }
    const d::Block<R> m = d::trailing(a, e, first, last);
    const R sum = m.a + m.d, product = m.a * m.d - m.b * m.c;
    if (first + 1 == last) {
      const R half = R(0.5) * (m.a - m.d), inside = half * half + m.b * m.c, centre = R(0.5) * sum;
      const R root = tiltrotor::sqrt(std::fabs(inside));
      if (inside < R(0)) {
        put(first, centre, root);
        put(last, centre, -root);
      } else {
        const R far = centre < R(0) ? centre - root : centre + root;
        put(first, far, R(0));
        put(last, far != R(0) ? product / far : R(0), R(0));
      }
      last -= 2;
      sweeps = 0;
      continue;
    }
    if (--budget < 0) return Status::not_converged;
    ++values.sweeps;
    const bool exceptional = ++sweeps % 10 == 0;
    const R shift = std::fabs(m.c) + std::fabs(a(last - 1, last - 2) / e(last - 2, last - 2));
    d::step(a, e, n, first, last, exceptional ? R(1.5) * shift : sum, exceptional ? shift * shift : product);
  }
  return Status::ok;
}

}  // namespace tiltrotor
