// Damped Newton iteration for F(z) = 0 in a few unknowns: the step of the linearised equations, shortened by the
// problem, then halved until it leads downhill.
//
//   struct Problem {                                 // what is solved, on R = double or float
//     static constexpr bool kJacobianIsCheap;        // it costs a few values of F, and brings F along
//     static constexpr bool kStopsUphill;            // where no length leads downhill: stop, or go on shortest
//     void values(const R* z, R* f);
//     void jacobian(const R* z, R* f, Matrix<R, N, N>& j);  // f and dF/dz, with the bits of values()
//     void limit_step(R* step);
//     bool permits(const R* z);                      // whether F has a meaning there
//   };
#pragma once

#include <cmath>
#include <limits>

#include "tiltrotor/math/algebra/lu.hpp"

namespace tiltrotor {

// Memory of an iteration, placed by the caller.
template <class R, int N>
struct NewtonWorkspace {
  Matrix<R, N, N> jacobian;
  LU<R, N> lu;
  R z[N];  // the unknowns
  R trial[N];
  R step[N];
  R residual[N];  // F(z)
  R trial_residual[N];
};

template <class R>
struct NewtonResult {
  Status status;  // ok, not_converged, singular, not_finite
  R residual;     // largest
  int worst;      // its equation
};

struct NewtonLimits {
  int iterations;
  int halvings = 12;
};

// Largest entry by size, and where; NaN counts as infinite. ok below the tolerance.
template <class R>
NewtonResult<R> largest_residual(const R* residual, int n, R tolerance) {
  NewtonResult<R> found{Status::not_converged, R(0), 0};
  for (int i = 0; i < n; ++i) {
    const R size = std::fabs(residual[i]);
    if (!is_finite(size)) return {Status::not_finite, std::numeric_limits<R>::infinity(), i};
    if (size > found.residual) {
      found.residual = size;
      found.worst = i;
    }
  }
  if (found.residual < tolerance) found.status = Status::ok;
  return found;
}

template <class R>
R sum_of_squares(const R* x, int n) {
  R sum = R(0);
  for (int i = 0; i < n; ++i) sum += x[i] * x[i];
  return sum;
}

// Below this residual the next step is expected to be the last.
template <class R>
inline constexpr R kNearlyConverged = R(1e-4);

// From work.z, n unknowns, where F must have a meaning; there stands in the end the point that the outcome is of.
// `iterations` counts the steps done. Cost: a Jacobian each and one more, and up to 1 + halvings values.
template <class Problem, class R, int N>
NewtonResult<R> newton(Problem& problem, int n, R tolerance, NewtonLimits limits, NewtonWorkspace<R, N>& work,
                       int& iterations) {
  problem.jacobian(work.z, work.residual, work.jacobian);
  bool differentiated = true;  // the Jacobian is that of work.z
  NewtonResult<R> outcome = largest_residual(work.residual, n, tolerance);
  for (int k = 0; k < limits.iterations && outcome.status == Status::not_converged; ++k) {
    if (!differentiated) problem.jacobian(work.z, work.residual, work.jacobian);
    for (int i = 0; i < n; ++i) work.step[i] = -work.residual[i];
    if (lu_factor(work.jacobian, n, work.lu) != Status::ok || lu_solve(work.lu, work.step) != Status::ok) {
      outcome.status = Status::singular;
      return outcome;
    }
    problem.limit_step(work.step);

    // Mostly the whole step is accepted, and the next one needs the Jacobian there: it costs two to four times the
    // values, which come with it.
    const bool at_once =
        Problem::kJacobianIsCheap && outcome.residual > kNearlyConverged<R> && k + 1 < limits.iterations;
    const R before = sum_of_squares(work.residual, n);
    R length = R(1);
    bool accepted = false;
    for (int halving = 0; halving <= limits.halvings && !accepted; ++halving) {
      for (int j = 0; j < n; ++j) work.trial[j] = work.z[j] + length * work.step[j];
      length *= R(0.5);
      differentiated = at_once && halving == 0;
      if (!problem.permits(work.trial)) continue;
      if (differentiated) {
        problem.jacobian(work.trial, work.trial_residual, work.jacobian);
      } else {
        problem.values(work.trial, work.trial_residual);
      }
      accepted = sum_of_squares(work.trial_residual, n) < before;  // false for NaN
    }
    if (!accepted && Problem::kStopsUphill) return outcome;
    ++iterations;
    for (int j = 0; j < n; ++j) {
      work.z[j] = work.trial[j];
      work.residual[j] = work.trial_residual[j];
    }
    outcome = largest_residual(work.residual, n, tolerance);
  }
  return outcome;
}

}  // namespace tiltrotor
