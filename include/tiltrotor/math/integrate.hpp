// One step of an initial value problem x' = f(t, x): explicit Runge-Kutta (RK3, RK4) and Rosenbrock (RODAS3).
//
// The right side is a callable  Status f(R t, const R* x, R* xdot).  A step replaces x[n] only when every
// evaluation returned ok and the result is finite; otherwise it returns the reason and x stays as it was.
// `known` is f(t, x) when the caller has it already, nullptr when not: every method begins with it.
#pragma once

#include "tiltrotor/math/algebra/lu.hpp"
#include "tiltrotor/math/algebra/matrix.hpp"
#include "tiltrotor/math/status.hpp"

namespace tiltrotor {

template <class R, int N>
struct RungeKuttaWorkspace {
  R slope[4][N];
  R stage[N];
};

template <class R, int N>
struct RosenbrockWorkspace {
  Matrix<R, N, N> system;  // 1/(gamma dt) I - J
  LU<R, N> lu;
  R increment[4][N];
  R slope[N];
  R stage[N];
};

// What a step starts from: n states x at t, which become those at t + dt when the step succeeds.
template <class R>
struct IntegrationStep {
  R t, dt;
  R* x;
  int n;
  const R* known = nullptr;       // f(t, x) where it is at hand: saves its evaluation
  const R* time_slope = nullptr;  // df/dt[n] at (t, x), for RODAS3
  R* error = nullptr;             // of RODAS3: receives the difference to the embedded solution of order 2
};

namespace step_parts {

template <class R>
inline bool vector_finite(const R* x, int n) {
  for (int i = 0; i < n; ++i)
    if (!is_finite(x[i])) return false;
  return true;
}

template <class R>
inline Status accept(const R* candidate, int n, R* x) {
  if (!vector_finite(candidate, n)) return Status::not_finite;
  for (int i = 0; i < n; ++i) x[i] = candidate[i];
  return Status::ok;
}

template <class R>
inline Status startable(R t, R dt, const R* x, int n, int most) {
  if (n < 1 || n > most) return Status::bad_argument;
  return is_finite(t) && is_finite(dt) && vector_finite(x, n) ? Status::ok : Status::not_finite;
}

// f at the beginning of the step.
template <class R, class RightSide>
inline Status first_slope(RightSide&& f, R t, const R* x, int n, const R* known, R* slope) {
  if (known == nullptr) return f(t, x, slope);
  for (int i = 0; i < n; ++i) slope[i] = known[i];
  return vector_finite(slope, n) ? Status::ok : Status::not_finite;
}

}  // namespace step_parts

// Kutta's method of order 3, three evaluations of f, from t to t + dt.
// Status: that of f; not_finite; bad_argument (n outside 1..N).
template <class R, int N, class RightSide>
inline Status rk3_step(RightSide&& f, const IntegrationStep<R>& step, RungeKuttaWorkspace<R, N>& work) {
  const R t = step.t, dt = step.dt;
  R* const x = step.x;
  const int n = step.n;
  Status status = step_parts::startable(t, dt, x, n, N);
  if (status != Status::ok) return status;
  status = step_parts::first_slope(f, t, static_cast<const R*>(x), n, step.known, work.slope[0]);
  if (status != Status::ok) return status;
  for (int i = 0; i < n; ++i) work.stage[i] = x[i] + R(0.5) * dt * work.slope[0][i];
  status = f(t + R(0.5) * dt, static_cast<const R*>(work.stage), static_cast<R*>(work.slope[1]));
  if (status != Status::ok) return status;
  for (int i = 0; i < n; ++i) work.stage[i] = x[i] + dt * (R(2) * work.slope[1][i] - work.slope[0][i]);
  status = f(t + dt, static_cast<const R*>(work.stage), static_cast<R*>(work.slope[2]));
  if (status != Status::ok) return status;
  for (int i = 0; i < n; ++i)
    work.stage[i] = x[i] + dt / R(6) * (work.slope[0][i] + R(4) * work.slope[1][i] + work.slope[2][i]);
  return step_parts::accept(work.stage, n, x);
}

// The classical method of order 4, four evaluations of f, from t to t + dt.
// Status: that of f; not_finite; bad_argument (n outside 1..N).
template <class R, int N, class RightSide>
inline Status rk4_step(RightSide&& f, const IntegrationStep<R>& step, RungeKuttaWorkspace<R, N>& work) {
  const R t = step.t, dt = step.dt;
  R* const x = step.x;
  const int n = step.n;
  Status status = step_parts::startable(t, dt, x, n, N);
  if (status != Status::ok) return status;
  status = step_parts::first_slope(f, t, static_cast<const R*>(x), n, step.known, work.slope[0]);
  if (status != Status::ok) return status;
  const R node[4] = {R(0), R(0.5), R(0.5), R(1)};
  for (int s = 1; s < 4; ++s) {
    for (int i = 0; i < n; ++i) work.stage[i] = x[i] + node[s] * dt * work.slope[s - 1][i];
    status = f(t + node[s] * dt, static_cast<const R*>(work.stage), static_cast<R*>(work.slope[s]));
    if (status != Status::ok) return status;
  }
  for (int i = 0; i < n; ++i) {
    const R middle = work.slope[1][i] + work.slope[2][i];
    work.stage[i] = x[i] + dt / R(6) * (work.slope[0][i] + R(2) * middle + work.slope[3][i]);
  }
  return step_parts::accept(work.stage, n, x);
}

// RODAS3: four stages, order 3, L-stable, stiffly accurate, gamma = 1/2 (Sandu et al., Atmospheric
// Environment 31, 1997), in the form whose linear systems are (I / (gamma dt) - J) u_i = right side; three
// evaluations of f, one LU factorisation and four solutions per step.
//
// `jacobian` is df/dx at (t, x); the order needs it exact. Without `step.time_slope` f must not depend on t: leaving it
// out for a right side that does lowers the order to 1, and 2 at best.
// Status: that of f; singular; not_finite; bad_argument (n outside 1..N, dt = 0). `step.error` is written only
// with ok.
template <class R, int N, class RightSide>
inline Status rodas3_step(RightSide&& f, const Matrix<R, N, N>& jacobian, const IntegrationStep<R>& step,
                          RosenbrockWorkspace<R, N>& work) {
  const R t = step.t, dt = step.dt;
  R* const x = step.x;
  const int n = step.n;
  constexpr R kDiagonal = R(2);  // 1 / gamma
  constexpr R kNode[4] = {R(0), R(0), R(1), R(1)};
  constexpr R kTimeSlope[4] = {R(0.5), R(1.5), R(0), R(0)};
  constexpr R kStage[4][3] = {{R(0), R(0), R(0)}, {R(0), R(0), R(0)}, {R(2), R(0), R(0)}, {R(2), R(0), R(1)}};
  constexpr R kCoupling[4][3] = {
      {R(0), R(0), R(0)}, {R(4), R(0), R(0)}, {R(1), R(-1), R(0)}, {R(1), R(-1), R(-8) / R(3)}};
  constexpr R kWeight[4] = {R(2), R(0), R(1), R(1)};
  // The embedded solution leaves out the last increment, which is therefore the error estimate.

  if (dt == R(0)) return Status::bad_argument;
  Status status = step_parts::startable(t, dt, x, n, N);
  if (status != Status::ok) return status;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) work.system(i, j) = -jacobian(i, j);
    work.system(i, i) += kDiagonal / dt;
  }
  status = lu_factor(work.system, n, work.lu);
  if (status != Status::ok) return status;

  for (int s = 0; s < 4; ++s) {
    if (s == 0) {
      status = step_parts::first_slope(f, t, static_cast<const R*>(x), n, step.known, work.slope);
    } else if (s > 1) {  // the second stage shares the point of the first
      for (int i = 0; i < n; ++i) {
        work.stage[i] = x[i];
        for (int p = 0; p < s; ++p) work.stage[i] += kStage[s][p] * work.increment[p][i];
      }
      status = f(t + kNode[s] * dt, static_cast<const R*>(work.stage), static_cast<R*>(work.slope));
    }
    if (status != Status::ok) return status;
    R* u = work.increment[s];
    for (int i = 0; i < n; ++i) {
      R coupled = R(0);
      for (int p = 0; p < s; ++p) coupled += kCoupling[s][p] * work.increment[p][i];
      u[i] = work.slope[i] + coupled / dt;
      if (step.time_slope != nullptr) u[i] += kTimeSlope[s] * dt * step.time_slope[i];
    }
    status = lu_solve(work.lu, u);
    if (status != Status::ok) return status;
  }
  for (int i = 0; i < n; ++i) {
    work.stage[i] = x[i];
    for (int p = 0; p < 4; ++p) work.stage[i] += kWeight[p] * work.increment[p][i];
  }
  status = step_parts::accept(work.stage, n, x);
  if (status == Status::ok && step.error != nullptr)
    for (int i = 0; i < n; ++i) step.error[i] = work.increment[3][i];
  return status;
}

}  // namespace tiltrotor
