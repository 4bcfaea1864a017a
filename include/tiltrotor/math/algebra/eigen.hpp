// Eigenvalues and right and left eigenvectors of a real nonsymmetric matrix, in fixed memory and bounded
// time.
//
//   balance (balance.hpp) -> Hessenberg form (hessenberg.hpp) -> double-shift QR to the real Schur form
//   (francis.hpp) -> eigenvectors by back substitution (eigenvectors.hpp)
//
// Every step is backward stable: a computed eigenvalue is exact for a matrix within a few eps |A| of the
// balanced one. How far an eigenvalue itself may move is `condition` times that; a defective one has no
// finite condition.
//
// Range: any finite matrix. Eigenvalues that the permutation isolates (of a diagonal or triangular matrix, in
// any order of the states: all) are its entries, bit for bit, whatever the size of the others. An eigenvalue
// beyond the range of numbers is not_finite.

#pragma once

#include <cmath>
#include <limits>

#include "tiltrotor/math/algebra/balance.hpp"
#include "tiltrotor/math/algebra/eigenvectors.hpp"
#include "tiltrotor/math/algebra/francis.hpp"
#include "tiltrotor/math/algebra/hessenberg.hpp"
#include "tiltrotor/math/algebra/matrix.hpp"
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

// Work areas, placed by the caller; their contents mean nothing between calls. Of eigenvalues alone:
template <class R, int N>
struct EigenvalueWorkspace {
  PaddedSquare<R, N> schur;           // A, then its Hessenberg form, then its Schur form
  Balance<R, N> balance;              // how A was balanced
  HessenbergWorkspace<R, N> scratch;  // vectors of the reduction
};

// Of eigenvectors too.
template <class R, int N>
struct EigenWorkspace : EigenvalueWorkspace<R, N> {
  PaddedSquare<R, N> basis;     // transposed Schur basis
  PaddedSquare<R, N> reverse;   // Schur form mirrored at its antidiagonal
  PaddedSquare<R, N> solution;  // eigenvectors of the Schur form
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

// Copies A with zeros beside it.
template <class R, int N>
inline void load(const Matrix<R, N, N>& a, int n, PaddedSquare<R, N>& h) {
  for (int i = 0; i < n; ++i) {
    R* to = h.row(i);
    for (int j = 0; j < n; ++j) to[j] = a(i, j);
    for (int j = n; j < h.kStride; ++j) to[j] = R(0);
  }
}

// The entries of the active block, or all others.
enum class Part { active, others };
template <class R, int N, class Visit>
inline void each_entry(PaddedSquare<R, N>& h, int n, const Balance<R, N>& b, Part part, Visit&& visit) {
  for (int i = 0; i < n; ++i) {
    const bool within = i >= b.low && i <= b.high;
    const int begin = within ? b.low : n, end = within ? b.high + 1 : n;  // columns of the block in this row
    if (part == Part::active)
      for (int j = begin; j < end; ++j) visit(h(i, j));
    else {
      for (int j = 0; j < begin; ++j) visit(h(i, j));
      for (int j = end; j < n; ++j) visit(h(i, j));
    }
  }
}

// Binary exponent of the largest of them; the smallest exponent there is when all are zero.
template <class R, int N>
inline int exponent_of(PaddedSquare<R, N>& h, int n, const Balance<R, N>& b, Part part) {
  R largest = R(0);
  each_entry<R, N>(h, n, b, part, [&](R x) { largest = larger_of(std::fabs(x), largest); });
  int exponent = 0;
  std::frexp(largest, &exponent);
  return largest > R(0) ? exponent : std::numeric_limits<R>::min_exponent;
}

template <class R, int N>
inline void times_power_of_2(PaddedSquare<R, N>& h, int n, const Balance<R, N>& b, Part part, int exponent) {
  if (exponent == 0) return;
  each_entry<R, N>(h, n, b, part, [&](R& x) { x = std::ldexp(x, exponent); });
}

// Exponents between which fourth powers (sweeps), and products with growing vectors, are safe numbers.
template <class R>
inline constexpr int kSmallestExponent = -std::numeric_limits<R>::max_exponent / 16;
template <class R>
inline constexpr int kSweepExponent = std::numeric_limits<R>::max_exponent / 5;
template <class R>
inline constexpr int kVectorExponent = std::numeric_limits<R>::max_exponent * 7 / 16;

// Multiplies a Schur form whose active block is that of A times 2^-exponent by one power of two, which brings
// all of it into the range that is safe for vectors.
template <class R, int N>
inline void scale_for_vectors(PaddedSquare<R, N>& h, int n, const Balance<R, N>& b, int exponent) {
  const int largest = larger_of(exponent_of<R, N>(h, n, b, Part::active) + exponent,
                                exponent_of<R, N>(h, n, b, Part::others));
  int shift = 0;
  if (largest > kVectorExponent<R>) shift = kVectorExponent<R> - largest;
  if (largest < kSmallestExponent<R>) shift = -largest;
  times_power_of_2<R, N>(h, n, b, Part::active, exponent + shift);
  times_power_of_2<R, N>(h, n, b, Part::others, shift);
}

// Balanced Schur form in work.schur, its transposed basis in `basis` where that is wanted (another matrix is then not
// touched), eigenvalues of A in `values`. The active block goes through the
// sweeps times a power of two where its size is not safe; what the permutation isolates are entries of A. The
// Schur form is that of A, again times a power of two where its size is not safe.
template <bool kWithBasis, class R, int N>
inline Status schur(const Matrix<R, N, N>& a, int n, EigenvalueWorkspace<R, N>& work,
                    PaddedSquare<R, N>& basis, Eigenvalues<R, N>& values) {
  values.size = n;
  set_nan(values);
  if (n < 1 || n > N) return Status::bad_argument;
  if (!all_finite(a, n, n)) return Status::not_finite;

  load(a, n, work.schur);
  const Balance<R, N>& b = work.balance;
  isolate(work.schur, n, work.balance);
  const int size = exponent_of<R, N>(work.schur, n, b, Part::active);
  const int exponent = size > kSweepExponent<R> || size < kSmallestExponent<R> ? size : 0;
  times_power_of_2<R, N>(work.schur, n, b, Part::active, -exponent);
  equalise(work.schur, n, work.balance);
  hessenberg<kWithBasis>(work.schur, n, b.low, b.high, basis, work.scratch);
  const FrancisResult outcome =
      francis<kWithBasis>(work.schur, n, b.low, b.high, basis, values.real, values.imag);
  values.converged = outcome.converged;
  values.sweeps = outcome.sweeps;
  bool finite = true;
  for (int k = b.low; k <= b.high && exponent != 0; ++k) {
    values.real[k] = std::ldexp(values.real[k], exponent);
    values.imag[k] = std::ldexp(values.imag[k], exponent);
    finite &= is_finite(values.real[k]);
    finite &= is_finite(values.imag[k]);
  }
  if constexpr (kWithBasis) scale_for_vectors<R, N>(work.schur, n, b, exponent);
  if (outcome.converged < n) return Status::not_converged;
  return finite ? Status::ok : Status::not_finite;
}

}  // namespace eigen_detail

// Eigenvalues of the leading n x n part of `a`.
// Status: ok; not_finite (NaN or infinity in `a`: detected
// first, all outputs NaN; or an eigenvalue exceeds the range of numbers); not_converged (the eigenvalues not
// found are NaN); bad_argument (n outside 1..N). Cost: about 8 n^3 multiplications, at most 30 n QR sweeps.
template <class R, int N>
Status eigenvalues(const Matrix<R, N, N>& a, int n, EigenvalueWorkspace<R, N>& work,
                   Eigenvalues<R, N>& values) {
  return eigen_detail::schur<false, R, N>(a, n, work, work.schur, values);
}

// The same with right and left eigenvectors and condition numbers; unless ok, vectors and conditions are NaN.
// Also not_finite: vectors that exceed the range of numbers, of entries that differ by more than it.
// Cost: about 25 n^3 multiplications.
template <class R, int N>
Status eigensystem(const Matrix<R, N, N>& a, int n, EigenWorkspace<R, N>& work, Eigensystem<R, N>& system) {
  const Status status = eigen_detail::schur<true, R, N>(a, n, work, work.basis, system.values);
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
  if (all_finite(system.right, n, n) && all_finite(system.left, n, n)) return Status::ok;
  eigen_detail::set_nan(system);
  return Status::not_finite;
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
