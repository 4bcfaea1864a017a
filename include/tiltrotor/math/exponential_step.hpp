// One step of x' = f(t, x) by the exponential of its Jacobian J: the linear model about the beginning of the step,
// solved as far as numbers go.
//
//   x(t + dt) = x + dt phi1(dt J) f + dt^2 phi2(dt J) df/dt,   phi1(z) = (e^z - 1)/z,  phi2(z) = (e^z - 1 - z)/z^2
//
// The exponential Rosenbrock-Euler method: Hochbruck and Ostermann, Exponential integrators, Acta Numerica 19 (2010)
// 209. Order 2, exact for linear f; stable at any dt wherever the linear model is. No evaluation of f beyond the one at
// the beginning.
//
// The series of both functions are one recursion, and the step is cut into equal parts with |h J| <= 1, in the largest
// column sum after the states are scaled: the linear model is solved from part to part, J and f stay. What the series
// leaves out is then below 1/18! (1 + 1/19 + ..) = 1.7e-16 of its first term in each part.
#pragma once

#include "tiltrotor/math/integrate.hpp"

namespace tiltrotor {

inline constexpr int kExponentialTerms = 16;   // after the first
inline constexpr int kExponentialParts = 256;  // at most: |dt J| = 256

template <class R, int N>
struct ExponentialWorkspace {
  static constexpr int kPadded = lane_ceil<R>(N);
  alignas(64) R term[kPadded];
  alignas(64) R moved[kPadded];  // since the beginning of the step
  R next[N];
};

// |J| above. scale[i]: the size of state i.
template <class R, int N>
R scaled_norm(const Matrix<R, N, N>& jacobian, const R* scale, int n) {
  R norm = R(0);
  for (int j = 0; j < n; ++j) {
    R sum = R(0);
    for (int i = 0; i < n; ++i) sum += std::fabs(jacobian(i, j)) * scale[j] / scale[i];
    norm = larger_of(norm, sum);
  }
  return norm;
}

// `step.known`: f at the beginning, required; `step.time_slope`: df/dt there, or nullptr. `jacobian`: padding zero.
// Status: ok; not_finite; bad_argument (n outside 1..N, no f); out_of_range (more than kExponentialParts parts). x is
// replaced with ok alone. Cost: 16 products with J a part.
template <class R, int N>
Status exponential_step(const Matrix<R, N, N>& jacobian, const R* scale, const IntegrationStep<R>& step,
                        ExponentialWorkspace<R, N>& work) {
  const int n = step.n;
  const Status possible = step_parts::startable(step.t, step.dt, step.x, n, N);
  if (possible != Status::ok) return possible;
  if (step.known == nullptr) return Status::bad_argument;
  const R whole = std::fabs(step.dt) * scaled_norm(jacobian, scale, n);
  if (!is_finite(whole)) return Status::not_finite;
  if (!(whole <= static_cast<R>(kExponentialParts))) return Status::out_of_range;
  const int parts = whole > R(1) ? static_cast<int>(std::ceil(whole)) : 1;
  const R h = step.dt / static_cast<R>(parts);

  const auto product = [&](const R* x, int i) {
    R sum = R(0);
    if constexpr (Matrix<R, N, N>::kPadded) {
      sum = padded::dot(jacobian.row(i), x, 0, lane_ceil<R>(n));
    } else {
      for (int j = 0; j < n; ++j) sum += jacobian(i, j) * x[j];
    }
    return sum;
  };
  const auto time_slope = [&](int i) { return step.time_slope == nullptr ? R(0) : step.time_slope[i]; };
  for (int i = 0; i < work.kPadded; ++i) work.term[i] = work.moved[i] = R(0);
  for (int part = 0; part < parts; ++part) {
    const R since = static_cast<R>(part) * h;
    for (int i = 0; i < n; ++i)
      work.next[i] = h * (step.known[i] + product(work.moved, i) + since * time_slope(i));
    for (int k = 0;; ++k) {
      for (int i = 0; i < n; ++i) {
        work.term[i] = work.next[i];
        work.moved[i] += work.next[i];
      }
      if (k == kExponentialTerms) break;
      const R factor = h / static_cast<R>(k + 2);
      for (int i = 0; i < n; ++i)
        work.next[i] = factor * (product(work.term, i) + (k == 0 ? h * time_slope(i) : R(0)));
    }
  }
  for (int i = 0; i < n; ++i) work.next[i] = step.x[i] + work.moved[i];
  return step_parts::accept(work.next, n, step.x);
}

}  // namespace tiltrotor
