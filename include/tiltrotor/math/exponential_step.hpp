// One step of x' = f(t, x) by the exponential of its Jacobian J: the linear model about the beginning of the step,
// solved as far as numbers go.
//
//   x(t + dt) = x + dt phi1(dt J) f + dt^2 phi2(dt J) df/dt,   phi1(z) = (e^z - 1)/z,  phi2(z) = (e^z - 1 - z)/z^2
//
// The exponential Rosenbrock-Euler method: Hochbruck and Ostermann, Exponential integrators, Acta Numerica 19 (2010)
// 209. Order 2, exact for linear f; stable at any dt wherever the linear model is. No evaluation of f beyond the one at
// the beginning.
//
// The series of both functions are one recursion, sum_k (h J)^k h f / (k + 1)!, cut after m terms beyond the first. For
// any sizes w > 0 of the states let |v| = max_i |v_i| / w_i and z = max_i sum_j |h J_ij| w_j / w_i. Then |h J v| <= z |v|,
// and what either series leaves out is below
//
//   max(z, 2) z^m / (m + 2)! (1 + z / (m + 3) + (z / (m + 3))^2 + ..)   of its first term,
//
// which m brings below the spacing of numbers. The w that makes z smallest is the Perron vector of |J|, z then its
// spectral radius (Collatz and Wielandt): each pass w <- |J| w goes there from the sizes given and never makes z larger.
// A step with z above 5 is cut into equal parts, so that terms no larger than e^5 / 5 of the first cancel: the linear
// model is solved from part to part, J and f stay.
#pragma once

#include "tiltrotor/math/integrate.hpp"

namespace tiltrotor {

inline constexpr int kExponentialScalings = 2;       // passes w <- |J| w
inline constexpr int kLargestExponentialPart = 5;    // z of a part
inline constexpr int kLargestExponentialStep = 256;  // z of a step

template <class R, int N>
struct ExponentialWorkspace {
  static constexpr int kPadded = lane_ceil<R>(N);
  Matrix<R, kPadded, kPadded> columns;  // J by columns: no sum of a product runs across lanes
  alignas(64) R known[kPadded];         // f
  alignas(64) R ramp[kPadded];          // df/dt
  alignas(64) R term[kPadded];
  alignas(64) R moved[kPadded];  // since the beginning of the step
  alignas(64) R next[kPadded];
};

namespace exponential_detail {

// y = J x or |J| x, x[kPadded]. Two columns at a time; there is an even number of them, as of lanes.
template <bool kSizes, class R, int N>
void product(const Matrix<R, N, N>& columns, int n, const R* x, R* y) {
  const auto entry = [&columns](int i, int j) { return kSizes ? std::fabs(columns(j, i)) : columns(j, i); };
  R sum[N] = {};
  for (int j = 0; j < n; j += 2)
    for (int i = 0; i < N; ++i) sum[i] += entry(i, j) * x[j] + entry(i, j + 1) * x[j + 1];
  for (int i = 0; i < N; ++i) y[i] = sum[i];
}

// z / h. w[kPadded] begins as the sizes of the states, zero beyond n.
template <class R, int N>
R scaled_norm(const Matrix<R, N, N>& columns, int n, R* w, R* product_with_sizes) {
  constexpr R kKept = R(1) / R(1024);  // of w in each pass: also states on which nothing acts keep a size
  for (int pass = 0;; ++pass) {
    product<true>(columns, n, w, product_with_sizes);
    R norm = R(0);
    for (int i = 0; i < n; ++i) norm = larger_of(norm, product_with_sizes[i] / w[i]);
    if (pass == kExponentialScalings || !(norm > R(0))) return norm;
    const R inverse = R(1) / norm;
    for (int i = 0; i < n; ++i) w[i] = inverse * product_with_sizes[i] + kKept * w[i];
  }
}

}  // namespace exponential_detail

// m above: terms after the first at z, which is at most kLargestExponentialPart; at most 33 (21 in single precision).
template <class R>
int exponential_terms(R z) {
  R left_out = larger_of(z, R(2)) / R(2);
  int m = 0;
  while (left_out > std::numeric_limits<R>::epsilon() * (R(1) - z / static_cast<R>(m + 3))) {
    ++m;
    left_out *= z / static_cast<R>(m + 2);
  }
  return m;
}

// `step.known`: f at the beginning, required; `step.time_slope`: df/dt there, or nullptr. scale[i]: the size of state i.
// Status: ok; not_finite; bad_argument (n outside 1..N, no f); out_of_range (z above kLargestExponentialStep). x is
// replaced with ok alone. Cost: for each part m + 1 products with J, 52 parts at most; three more for z.
template <class R, int N>
Status exponential_step(const Matrix<R, N, N>& jacobian, const R* scale, const IntegrationStep<R>& step,
                        ExponentialWorkspace<R, N>& work) {
  using namespace exponential_detail;
  const int n = step.n;
  const Status possible = step_parts::startable(step.t, step.dt, step.x, n, N);
  if (possible != Status::ok) return possible;
  if (step.known == nullptr) return Status::bad_argument;
  set_zero(work.columns);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) work.columns(j, i) = jacobian(i, j);
  for (int i = 0; i < work.kPadded; ++i) {
    work.known[i] = i < n ? step.known[i] : R(0);
    work.ramp[i] = i < n && step.time_slope != nullptr ? step.time_slope[i] : R(0);
    work.moved[i] = R(0);
    work.term[i] = i < n ? scale[i] : R(0);
  }
  const R whole = std::fabs(step.dt) * scaled_norm(work.columns, n, work.term, work.next);
  if (!is_finite(whole)) return Status::not_finite;
  if (!(whole <= static_cast<R>(kLargestExponentialStep))) return Status::out_of_range;
  constexpr R kLargest = static_cast<R>(kLargestExponentialPart);
  const int parts = whole > kLargest ? static_cast<int>(std::ceil(whole / kLargest)) : 1;
  const R h = step.dt / static_cast<R>(parts);
  const int terms = exponential_terms(whole / static_cast<R>(parts));

  for (int part = 0; part < parts; ++part) {
    const R since = static_cast<R>(part) * h;
    product<false>(work.columns, n, work.moved, work.next);
    for (int i = 0; i < work.kPadded; ++i)
      work.term[i] = h * (work.known[i] + work.next[i] + since * work.ramp[i]);
    for (int i = 0; i < work.kPadded; ++i) work.moved[i] += work.term[i];
    for (int k = 1; k <= terms; ++k) {
      const R factor = h / static_cast<R>(k + 1), ramp = k == 1 ? h : R(0);
      product<false>(work.columns, n, work.term, work.next);
      for (int i = 0; i < work.kPadded; ++i) work.term[i] = factor * (work.next[i] + ramp * work.ramp[i]);
      for (int i = 0; i < work.kPadded; ++i) work.moved[i] += work.term[i];
    }
  }
  for (int i = 0; i < n; ++i) work.next[i] = step.x[i] + work.moved[i];
  return step_parts::accept(work.next, n, step.x);
}

}  // namespace tiltrotor
