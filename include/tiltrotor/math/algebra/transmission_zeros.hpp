// Transmission zeros of one input to one output: s with det [A - s I, b; c, d] = 0, as generalised eigenvalues.
//
// While d is zero the output's place is taken by its rate: an orthogonal change of states makes c = (0 .. 0 g), the last
// state leaves, its row of [A b] is the next [c d], and the gain gets the factor g (Emami-Naeini and Van Dooren,
// Automatica 18, 1982). No zero at infinity is left then; a reflection of the columns that makes [c d] = (0 .. 0 g)
// leaves a regular pencil (generalised_eigenvalues.hpp).
#pragma once

#include "tiltrotor/math/algebra/generalised_eigenvalues.hpp"

namespace tiltrotor {

// x' = A x + b u, y = c x + d u.
template <class R, int N>
struct Channel {
  int states;
  Matrix<R, N, N> a;
  R b[N], c[N];
  R d;
};

template <class R, int N>
struct ZerosWorkspace {
  Channel<R, N> left;
  Matrix<R, N, N> e;
};

namespace zeros_detail {

// The reflection 1 - tau v v^T that takes x[n] to (0 .. 0 g); x becomes v. Nothing to do: tau is zero.
template <class R>
R reflect_to_last(R* x, int n, R& tau) {
  R size = R(0), others = R(0);
  for (int i = 0; i < n; ++i) size = larger_of(size, std::fabs(x[i]));
  for (int i = 0; i + 1 < n; ++i) others = larger_of(others, std::fabs(x[i]));
  tau = R(0);
  if (others == R(0)) return x[n - 1];
  R square = R(0);
  for (int i = 0; i < n; ++i) {
    x[i] /= size;
    square += x[i] * x[i];
  }
  const R norm = tiltrotor::sqrt(square), head = std::fabs(x[n - 1]) + norm;
  const bool negative = x[n - 1] < R(0);
  x[n - 1] = negative ? -head : head;
  tau = R(1) / (norm * head);
  return (negative ? norm : -norm) * size;
}

template <class R>
R dot(const R* x, const R* y, int n) {
  R sum = R(0);
  for (int i = 0; i < n; ++i) sum += x[i] * y[i];
  return sum;
}

}  // namespace zeros_detail

// y/u = gain prod(s - zero)/prod(s - pole); a gain of zero: the input does not reach the output, there are no zeros.
// What cannot be told from the rounding of the largest entry of A or b counts as nothing. The zeros of parts of A that
// the input does not reach, or the output not see, are among them. States are best balanced (balance.hpp).
// Status: those of generalised_eigenvalues(). Cost: about 100 n^3 multiplications.
template <class R, int N>
Status transmission_zeros(const Channel<R, N>& channel, ZerosWorkspace<R, N>& work, Eigenvalues<R, N>& zeros,
                          R& gain) {
  namespace z = zeros_detail;
  Channel<R, N>& s = work.left;
  s = channel;
  int n = s.states;
  zeros.size = zeros.converged = zeros.sweeps = 0;
  gain = R(0);
  if (n < 0 || n > N) return Status::bad_argument;
  R largest_a = R(0), largest_b = R(0), product = R(1);
  for (int i = 0; i < n; ++i) {
    largest_b = larger_of(largest_b, std::fabs(s.b[i]));
    for (int j = 0; j < n; ++j) largest_a = larger_of(largest_a, std::fabs(s.a(i, j)));
  }
  const R rounding = R(8) * static_cast<R>(n + 1) * std::numeric_limits<R>::epsilon();
  R least_d = R(0), least_c = R(0);  // what was given is given
  R turned = R(1);                   // how far rounding turns the direction of c, over that of A
  while (std::fabs(s.d) <= least_d) {
    R size = R(0);
    for (int i = 0; i < n; ++i) size = larger_of(size, std::fabs(s.c[i]));
    if (!is_finite(size)) return Status::not_finite;
    if (size <= least_c) return Status::ok;
    if (least_c > R(0)) turned = larger_of(turned, largest_a / size);
    R tau;
    product *= z::reflect_to_last(s.c, n, tau);
    if (tau != R(0)) {
      for (int i = 0; i < n; ++i) {
        const R along = tau * z::dot(s.a.row(i), s.c, n);
        for (int j = 0; j < n; ++j) s.a(i, j) -= along * s.c[j];
      }
      for (int j = 0; j < n; ++j) {
        R along = R(0);
        for (int i = 0; i < n; ++i) along += s.a(i, j) * s.c[i];
        for (int i = 0; i < n; ++i) s.a(i, j) -= tau * along * s.c[i];
      }
      const R along = tau * z::dot(s.b, s.c, n);
      for (int i = 0; i < n; ++i) s.b[i] -= along * s.c[i];
    }
    --n;
    for (int j = 0; j < n; ++j) s.c[j] = s.a(n, j);
    s.d = s.b[n];
    least_d = rounding * largest_b * turned;
    least_c = rounding * largest_a;
  }
  gain = product * s.d;
  if (n == 0) return Status::ok;
  R v[N + 1], tau;
  for (int i = 0; i < n; ++i) v[i] = s.c[i];
  v[n] = s.d;
  (void)z::reflect_to_last(v, n + 1, tau);
  for (int i = 0; i < n; ++i) {
    const R along = tau * (z::dot(s.a.row(i), v, n) + s.b[i] * v[n]);
    for (int j = 0; j < n; ++j) {
      s.a(i, j) -= along * v[j];
      work.e(i, j) = R(i == j) - tau * v[i] * v[j];
    }
  }
  return generalised_eigenvalues(s.a, work.e, n, zeros);
}

}  // namespace tiltrotor
