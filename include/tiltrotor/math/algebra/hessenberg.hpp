// Hessenberg form: Q^T A Q with zeros below the first subdiagonal, by Householder reflections.
//
// One reflection I - tau v v^T acts from both sides at once:
//   A <- A - tau v w^T - p v^T,   w = A^T v,  p = tau (A v) - tau^2 (v^T A v) v,
// so each step reads the rows of A once to form w and A v and once to update: two passes instead of four.
#pragma once

#include <cmath>

#include "tiltrotor/math/algebra/matrix.hpp"
#include "tiltrotor/math/scalar.hpp"

namespace tiltrotor {

template <class R, int N>
struct HessenbergWorkspace {
  alignas(64) R v[lane_ceil<R>(N)];
  alignas(64) R w[lane_ceil<R>(N)];
  R p[N];
};

namespace hessenberg_detail {

// v and tau of the reflection that takes column k, rows k+1..high of `h`, to its first entry, which is
// returned. v is zero outside these rows. tau is zero when there is nothing to annihilate.
template <class R, int N>
inline R reflector(const PaddedSquare<R, N>& h, int k, int high, R* v, R& tau) {
  for (int i = 0; i < lane_ceil<R>(N); ++i) v[i] = R(0);
  R largest = R(0);
  for (int i = k + 2; i <= high; ++i) {
    const R size = std::fabs(h(i, k));
    largest = size > largest ? size : largest;
  }
  const R first = h(k + 1, k);
  tau = R(0);
  if (largest == R(0)) return first;
  largest = std::fabs(first) > largest ? std::fabs(first) : largest;
  R square = R(0);
  for (int i = k + 1; i <= high; ++i) {
    v[i] = h(i, k) / largest;
    square += v[i] * v[i];
  }
  const R norm = tiltrotor::sqrt(square);
  const R head = std::fabs(v[k + 1]) + norm;
  tau = R(1) / (norm * head);
  v[k + 1] = first < R(0) ? -head : head;
  return (first < R(0) ? norm : -norm) * largest;
}

}  // namespace hessenberg_detail

// Reduces rows and columns low..high of `h`; what lies outside is upper triangular and takes part in the
// update. With kWithBasis, `basis` becomes Q^T, row by row.
template <bool kWithBasis, class R, int N>
inline void hessenberg(Matrix<R, N, lane_ceil<R>(N)>& h, int n, int low, int high,
                       Matrix<R, N, lane_ceil<R>(N)>& basis, HessenbergWorkspace<R, N>& work) {
  const int end = lane_ceil<R>(n);
  if constexpr (kWithBasis) {
    set_zero(basis);
    for (int i = 0; i < n; ++i) basis(i, i) = R(1);
  }
  for (int k = low; k + 2 <= high; ++k) {
    R tau = R(0);
    const R head = hessenberg_detail::reflector<R, N>(h, k, high, work.v, tau);
    if (tau != R(0)) {
      const int begin = lane_floor<R>(k + 1);
      const int v_end = lane_ceil<R>(high + 1);
      for (int c = begin; c < end; ++c) work.w[c] = R(0);
      R v_a_v = R(0);
      const int top = kWithBasis ? 0 : low;
      for (int i = top; i <= high; ++i) work.p[i] = padded::dot(work.v, h.row(i), begin, v_end);
      for (int i = k + 1; i <= high; ++i) {
        padded::add_scaled(work.v[i], h.row(i), work.w, begin, end);
        v_a_v += work.v[i] * work.p[i];
      }
      for (int i = top; i <= k; ++i) padded::add_scaled(-tau * work.p[i], work.v, h.row(i), begin, v_end);
      for (int i = k + 1; i <= high; ++i) {
        const R p = tau * (work.p[i] - tau * v_a_v * work.v[i]);
        padded::add_scaled(-p, work.v, -tau * work.v[i], work.w, h.row(i), begin, end);
      }
      if constexpr (kWithBasis) {
        for (int c = 0; c < end; ++c) work.w[c] = R(0);
        for (int i = k + 1; i <= high; ++i) padded::add_scaled(work.v[i], basis.row(i), work.w, 0, end);
        for (int i = k + 1; i <= high; ++i)
          padded::add_scaled(-tau * work.v[i], work.w, basis.row(i), 0, end);
      }
    }
    h(k + 1, k) = head;
    for (int i = k + 2; i <= high; ++i) h(i, k) = R(0);
  }
}

}  // namespace tiltrotor
