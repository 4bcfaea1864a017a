// The transfer function of one input to one output: poles, zeros, gain, and its value at any s.
//
//   transfer_function(channel, work, f);
//   std::complex<double> g = response(f, {0, omega}, work_of_response);
//
// Values come from the states themselves, in Hessenberg form (Laub, IEEE Trans. AC-26, 1981), not from the roots.
#pragma once

#include <complex>
#include <utility>

#include "tiltrotor/math/algebra/transmission_zeros.hpp"

namespace tiltrotor {

template <class R, int N>
struct TransferFunction {
  int states;
  PaddedSquare<R, N> a;  // of Hessenberg form
  R b[N], c[N], d;
  Eigenvalues<R, N> poles, zeros;
  R gain;  // y/u = gain prod(s - zero)/prod(s - pole); zero: the input does not reach the output
};

template <class R, int N>
struct TransferFunctionWorkspace {
  Channel<R, N> balanced;
  PaddedSquare<R, N> basis;
  Balance<R, N> balance;
  HessenbergWorkspace<R, N> reflections;
  EigenvalueWorkspace<R, N> eigen;
  ZerosWorkspace<R, N> zeros;
  Eigenvalues<R, N> closed;  // poles of a closed loop
};

// Status: ok; those of eigenvalues() and transmission_zeros(). Cost: about 120 n^3 multiplications.
template <class R, int N>
Status transfer_function(const Channel<R, N>& channel, TransferFunctionWorkspace<R, N>& work,
                         TransferFunction<R, N>& out) {
  const int n = out.states = channel.states;
  out.poles.size = out.zeros.size = 0;
  out.gain = out.d = channel.d;
  if (n < 0 || n > N) return Status::bad_argument;
  if (n == 0) return Status::ok;
  const Status status = eigenvalues(channel.a, n, work.eigen, out.poles);
  if (status != Status::ok) return status;
  // States in units of their own: A becomes D^-1 A D, D of powers of two.
  set_zero(out.a);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) out.a(i, j) = channel.a(i, j);
  Balance<R, N>& balance = work.balance;
  for (int i = 0; i < N; ++i) balance.scale[i] = R(1);
  balance.low = 0;
  balance.high = n - 1;
  equalise(out.a, n, balance);
  Channel<R, N>& b = work.balanced;
  b.states = n;
  b.d = channel.d;
  for (int i = 0; i < n; ++i) {
    b.b[i] = channel.b[i] / balance.scale[i];
    b.c[i] = channel.c[i] * balance.scale[i];
    for (int j = 0; j < n; ++j) b.a(i, j) = out.a(i, j);
  }
  const Status found = transmission_zeros(b, work.zeros, out.zeros, out.gain);
  hessenberg<true>(out.a, n, 0, n - 1, work.basis, work.reflections);
  for (int i = 0; i < n; ++i) {
    out.b[i] = out.c[i] = R(0);
    for (int j = 0; j < n; ++j) {
      out.b[i] += work.basis(i, j) * b.b[j];
      out.c[i] += work.basis(i, j) * b.c[j];
    }
  }
  return found;
}

template <class R, int N>
struct ResponseWorkspace {
  std::complex<R> upper[N][N];  // of the elimination
  std::complex<R> row[N], below[N], x[N];
};

// y(s)/u(s); not finite at a pole. Cost: n^2 complex multiplications.
template <class R, int N>
std::complex<R> response(const TransferFunction<R, N>& f, std::complex<R> s, ResponseWorkspace<R, N>& work) {
  using C = std::complex<R>;
  const int n = f.states;
  C y(f.d);
  if (n == 0) return y;
  // (s I - A) x = b from above; `row` and `right`: what is left of the row that is next.
  auto& [upper, row, below, x] = work;
  const auto load = [&](int i, int first, C* to) {
    for (int j = first; j < n; ++j) to[j] = C(-f.a(i, j));
    to[i] += s;
  };
  load(0, 0, row);
  C right(f.b[0]);
  for (int k = 0; k < n; ++k) {
    C right_below;
    if (k + 1 < n) {
      load(k + 1, k, below);
      right_below = C(f.b[k + 1]);
      if (std::abs(below[k]) > std::abs(row[k])) {
        for (int j = k; j < n; ++j) std::swap(below[j], row[j]);
        std::swap(right_below, right);
      }
    }
    for (int j = k; j < n; ++j) upper[k][j] = row[j];
    x[k] = right;
    if (k + 1 == n) break;
    const C factor = below[k] / row[k];
    for (int j = k + 1; j < n; ++j) row[j] = below[j] - factor * row[j];
    right = right_below - factor * right;
  }
  for (int k = n - 1; k >= 0; --k) {
    for (int j = k + 1; j < n; ++j) x[k] -= upper[k][j] * x[j];
    x[k] /= upper[k][k];
    y += f.c[k] * x[k];
  }
  return y;
}

namespace transfer_detail {

// Argument of i omega - root, without a jump over omega > 0.
template <class R>
R argument(R omega, R real, R imag) {
  const R y = omega - imag;
  return real > R(0) ? kPi<R> - std::atan2(y, real) : std::atan2(y, -real);
}

template <class R, int N>
R phase_of_roots(const TransferFunction<R, N>& f, R omega) {
  R phase = f.gain < R(0) ? kPi<R> : R(0);
  for (int k = 0; k < f.zeros.size; ++k) phase += argument(omega, f.zeros.real[k], f.zeros.imag[k]);
  for (int k = 0; k < f.poles.size; ++k) phase -= argument(omega, f.poles.real[k], f.poles.imag[k]);
  return phase;
}

}  // namespace transfer_detail

// The angle nearest to another that differs by whole turns, rad.
template <class R>
R nearest_turn(R angle, R to) {
  return angle + R(2) * kPi<R> * std::round((to - angle) / (R(2) * kPi<R>));
}

// Phase of a response at i omega, rad, continuous over all omega > 0 whatever steps are taken: the roots say how often it
// has turned. As omega goes to zero it lies between -pi and pi.
template <class R, int N>
R continuous_phase(const TransferFunction<R, N>& f, R omega, std::complex<R> value) {
  constexpr R kSlow = R(1e-6);  // rad/s: no root of an aircraft is slower but at zero
  const R start = transfer_detail::phase_of_roots(f, kSlow);
  return nearest_turn(std::arg(value),
                      transfer_detail::phase_of_roots(f, omega) + nearest_turn(start, R(0)) - start);
}

}  // namespace tiltrotor
