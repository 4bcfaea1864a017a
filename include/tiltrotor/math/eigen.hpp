// Eigenvalues and right and left eigenvectors of a real nonsymmetric matrix, in fixed memory and bounded
// time.
//
//   balance (balance.hpp) -> Hessenberg form (hessenberg.hpp) -> double-shift QR to the real Schur form
//   (francis.hpp) -> eigenvectors by back substitution (eigenvectors.hpp)
//
// Every step is backward stable: a computed eigenvalue is exact for a matrix within a few eps |A| of the
// balanced one. How far an eigenvalue itself may move is `condition` times that; a defective one has no
// finite condition.
#pragma once

#include <cmath>
#include <limits>

#include "tiltrotor/math/balance.hpp"
#include "tiltrotor/math/eigenvectors.hpp"
#include "tiltrotor/math/francis.hpp"
#include "tiltrotor/math/hessenberg.hpp"
#include "tiltrotor/math/matrix.hpp"
#include "tiltrotor/math/scalar.hpp"
#include "tiltrotor/math/status.hpp"

namespace tiltrotor {

// A complex pair stands in neighbouring places, positive imaginary part first. No other order is promised.
template <class R, int N>
struct Eigenvalues {
  R real[N];
  R imag[N];
  int size;       // order of the matrix
  int converged;  // eigenvalues found; the others are NaN
  int sweeps;     // QR sweeps used
};

template <class R>
struct ComplexEntry {
  R real, imag;
};

// Vectors have unit 2-norm. Packed in columns: a real eigenvalue k has its vector in column k; a pair k, k+1
// shares columns k (real part) and k+1 (imaginary part) for the eigenvalue with positive imaginary part, the
// vectors of the other one are the conjugates. right_entry() and left_entry() unpack.
template <class R, int N>
struct Eigensystem {
  Eigenvalues<R, N> values;
  PaddedSquare<R, N> right;  // A v = lambda v
  PaddedSquare<R, N> left;   // w^H A = lambda w^H
  R condition[N];            // 1 / |w^H v|: shift of the eigenvalue per |dA|; huge at a defective eigenvalue
};

// Work area, placed by the caller; its contents mean nothing between calls.
template <class R, int N>
struct EigenWorkspace {
  PaddedSquare<R, N> schur;           // A, then its Hessenberg form, then its Schur form
  PaddedSquare<R, N> basis;           // transposed Schur basis
  PaddedSquare<R, N> reverse;         // Schur form mirrored at its antidiagonal
  PaddedSquare<R, N> solution;        // eigenvectors of the Schur form
  Balance<R, N> balance;              // how A was balanced
  HessenbergWorkspace<R, N> scratch;  // vectors of the reduction
};

namespace eigen_detail {

template <class R, int N>
inline void set_nan(Eigenvalues<R, N>& values) {
  for (int k = 0; k < N; ++k) values.real[k] = values.imag[k] = std::numeric_limits<R>::quiet_NaN();
  values.converged = 0;
  values.sweeps = 0;
}

template <class R, int N>
inline void set_nan(Eigensystem<R, N>& system) {
  const R nan = std::numeric_limits<R>::quiet_NaN();
  for (R& x : system.right.entry) x = nan;
  for (R& x : system.left.entry) x = nan;
  for (R& x : system.condition) x = nan;
}

// Copies A with zeros beside it. When the squares of its entries might overflow or vanish it is scaled by a
// power of two, whose exponent is returned for the way back.
template <class R, int N>
inline int load(const Matrix<R, N, N>& a, int n, PaddedSquare<R, N>& h) {
  R largest = R(0);
  for (int i = 0; i < n; ++i) {
    R* to = h.row(i);
    for (int j = 0; j < n; ++j) {
      to[j] = a(i, j);
      const R size = std::fabs(to[j]);
      largest = size > largest ? size : largest;
    }
    for (int j = n; j < h.kStride; ++j) to[j] = R(0);
  }
  constexpr int kSafeExponent = std::numeric_limits<R>::max_exponent / 16;
  int exponent = 0;
  std::frexp(largest, &exponent);
  if (exponent > -kSafeExponent && exponent < kSafeExponent) return 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) h(i, j) = std::ldexp(h(i, j), -exponent);
  return exponent;
}

// Balanced Schur form in workspace.schur, eigenvalues of A in `values`.
template <bool kWithBasis, class R, int N>
inline Status schur(const Matrix<R, N, N>& a, int n, EigenWorkspace<R, N>& work, Eigenvalues<R, N>& values) {
  values.size = n;
  set_nan(values);
  if (n < 1 || n > N) return Status::bad_argument;
  if (!all_finite(a, n, n)) return Status::not_finite;

  const int exponent = load(a, n, work.schur);
  balance(work.schur, n, work.balance);
  hessenberg<kWithBasis>(work.schur, n, work.balance.low, work.balance.high, work.basis, work.scratch);
  const FrancisResult outcome = francis<kWithBasis>(work.schur, n, work.balance.low, work.balance.high,
                                                    work.basis, values.real, values.imag);
  values.converged = outcome.converged;
  values.sweeps = outcome.sweeps;
  bool finite = true;
  for (int k = 0; k < n && exponent != 0; ++k) {
    values.real[k] = std::ldexp(values.real[k], exponent);
    values.imag[k] = std::ldexp(values.imag[k], exponent);
    finite = finite && is_finite(values.real[k]) && is_finite(values.imag[k]);
  }
  if (outcome.converged < n) return Status::not_converged;
  return finite ? Status::ok : Status::not_finite;
}

}  // namespace eigen_detail

// Eigenvalues of the leading n x n part of `a`.
// Status: ok; not_finite (NaN or infinity in `a`: detected first, all outputs NaN); not_converged (the
// eigenvalues not found are NaN); bad_argument (n outside 1..N). Cost: about 8 n^3 multiplications, at most
// 30 n QR sweeps.
template <class R, int N>
inline Status eigenvalues(const Matrix<R, N, N>& a, int n, EigenWorkspace<R, N>& work,
                          Eigenvalues<R, N>& values) {
  return eigen_detail::schur<false>(a, n, work, values);
}

// The same with right and left eigenvectors and condition numbers; unless ok, vectors and conditions are NaN.
// Cost: about 25 n^3 multiplications.
template <class R, int N>
inline Status eigensystem(const Matrix<R, N, N>& a, int n, EigenWorkspace<R, N>& work,
                          Eigensystem<R, N>& system) {
  const Status status = eigen_detail::schur<true>(a, n, work, system.values);
  if (status != Status::ok) {
    eigen_detail::set_nan(system);
    return status;
  }
  // Left eigenvectors of T are right eigenvectors of T mirrored at its antidiagonal, in reversed order.
  mirror(work.schur, n, work.reverse);
  solve_triangular_eigenvectors(work.schur, n, work.solution);
  assemble_right(work.basis, work.solution, n, work.balance, system.values.imag, system.right);
  solve_triangular_eigenvectors(work.reverse, n, work.solution);
  assemble_left(work.basis, work.solution, n, work.balance, system.values.imag, system.left);
  eigenvalue_conditions(system.right, system.left, n, system.values.imag, system.condition);
  return Status::ok;
}

// Component i of the right (left) eigenvector of eigenvalue k.
template <class R, int N>
inline ComplexEntry<R> packed_entry(const PaddedSquare<R, N>& vectors, const Eigenvalues<R, N>& values, int i,
                                    int k) {
  if (values.imag[k] > R(0)) return {vectors(i, k), vectors(i, k + 1)};
  if (values.imag[k] < R(0)) return {vectors(i, k - 1), -vectors(i, k)};
  return {vectors(i, k), R(0)};
}
template <class R, int N>
inline ComplexEntry<R> right_entry(const Eigensystem<R, N>& system, int i, int k) {
  return packed_entry<R, N>(system.right, system.values, i, k);
}
template <class R, int N>
inline ComplexEntry<R> left_entry(const Eigensystem<R, N>& system, int i, int k) {
  return packed_entry<R, N>(system.left, system.values, i, k);
}

// Participation of state i in mode k: |v_i w_i| / |w^H v|, independent of the units of the states.
template <class R, int N>
inline R participation(const Eigensystem<R, N>& system, int i, int k) {
  const ComplexEntry<R> v = right_entry(system, i, k);
  const ComplexEntry<R> w = left_entry(system, i, k);
  const R square = (v.real * v.real + v.imag * v.imag) * (w.real * w.real + w.imag * w.imag);
  return tiltrotor::sqrt(square) * system.condition[k];
}

}  // namespace tiltrotor
