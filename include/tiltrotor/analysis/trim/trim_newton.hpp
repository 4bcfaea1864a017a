// Damped Newton iteration on the equations of trim.
#pragma once

#include <type_traits>

#include "tiltrotor/analysis/trim/trim_equations.hpp"
#include "tiltrotor/analysis/trim/trim_limits.hpp"
#include "tiltrotor/math/algebra/lu.hpp"

namespace tiltrotor {

template <class R, class Policy = DefaultDifferentiation>
struct TrimWorkspace {
  static constexpr int kDirections =
      kMaxTrimUnknowns < kModelDirections ? kMaxTrimUnknowns : kModelDirections;
  using Seeded = typename Policy::template Scalar<R, kDirections>;
  typename Policy::template Workspace<R, kDirections, kMaxTrimUnknowns, kMaxTrimUnknowns> differentiation;
  ModelWorkspaces<R, Seeded> model;
  TrimEquations<R> equations;
  Matrix<R, kMaxTrimUnknowns, kMaxTrimUnknowns> jacobian;
  LU<R, kMaxTrimUnknowns> lu;
  R z[kMaxTrimUnknowns];        // current unknowns
  R first_z[kMaxTrimUnknowns];  // where the cold start ended
  R trial[kMaxTrimUnknowns];
  R step[kMaxTrimUnknowns];
  R residual[kMaxTrimUnknowns];
  R trial_residual[kMaxTrimUnknowns];
  Evaluation<R> evaluation;
};

namespace trim_detail {

// Largest scaled residual of a converged trim. In single precision the rounding of the loads sets it.
template <class R>
constexpr R tolerance() {
  const R wanted = R(1e-10);
  const R rounding = R(100) * std::numeric_limits<R>::epsilon();
  return wanted > rounding ? wanted : rounding;
}

inline constexpr int kHalvings = 12;

template <class R>
struct NewtonOutcome {
  TrimStatus status;  // ok, not_converged, singular or not_finite; of from_less_weight() rotor_stall too
  R residual;         // largest
  int worst;          // its equation
};

// Largest entry by size, and where; NaN counts as infinite.
template <class R>
NewtonOutcome<R> largest(const R* residual, int n) {
  NewtonOutcome<R> found{TrimStatus::not_converged, R(0), 0};
  for (int i = 0; i < n; ++i) {
    const R size = std::fabs(residual[i]);
    if (!is_finite(size)) return {TrimStatus::not_finite, std::numeric_limits<R>::infinity(), i};
    if (size > found.residual) {
      found.residual = size;
      found.worst = i;
    }
  }
  if (found.residual < tolerance<R>()) found.status = TrimStatus::ok;
  return found;
}

template <class R>
R square_norm(const R* residual, int n) {
  R sum = R(0);
  for (int i = 0; i < n; ++i) sum += residual[i] * residual[i];
  return sum;
}

// The whole step shortened, its direction kept, until no unknown moves by more than its limit.
template <class R>
void limit_step(const TrimEquations<R>& equations, R* step) {
  R factor = R(1);
  for (int j = 0; j < equations.count; ++j) {
    const R limit = equations.row[j].step_limit;
    const R size = std::fabs(step[j]);
    if (limit > R(0) && size * factor > limit) factor = limit / size;
  }
  for (int j = 0; j < equations.count; ++j) step[j] *= factor;
}

// Below this residual the next step is expected to be the last.
template <class R>
inline constexpr R kNearlyConverged = R(1e-4);

// Newton from work.z, which holds the best point found when it returns: an attitude that the flight may have,
// if the start was one.
template <class R, class Policy>
NewtonOutcome<R> newton(const Configuration<R>& c, const SteadyFlight<R>& flight,
                        TrimWorkspace<R, Policy>& work, int max_iterations, int& iterations) {
  const int n = work.equations.count;
  const auto residuals = [&](const auto* z, auto* residual) {
    using T = std::remove_reference_t<decltype(*residual)>;
    trim_residuals(c, flight, work.equations, work.model.template of<T>(), z, residual);
  };
  R scale[kMaxTrimUnknowns];
  for (int j = 0; j < n; ++j) scale[j] = work.equations.row[j].scale;
  const auto differentiate = [&](const R* z, R* residual) {
    Policy::jacobian(residuals, n, n, z, scale, residual, work.differentiation,
                     [&work](int i, int j, R slope) { work.jacobian(i, j) = slope; });
  };

  for (int j = 0; j < n; ++j)
    if (!is_finite(work.z[j])) return {TrimStatus::not_finite, std::numeric_limits<R>::infinity(), j};
  if (!has_attitude(flight, work.z[kRollRow], work.z[kPitchRow]))
    return {TrimStatus::not_converged, std::numeric_limits<R>::infinity(), 0};
  differentiate(work.z, work.residual);
  bool differentiated = true;  // the Jacobian is that of work.z
  NewtonOutcome<R> outcome = largest(work.residual, n);
  for (int k = 0; k < max_iterations && outcome.status == TrimStatus::not_converged; ++k) {
    if (!differentiated) differentiate(work.z, work.residual);
    for (int i = 0; i < n; ++i) work.step[i] = -work.residual[i];
    if (lu_factor(work.jacobian, n, work.lu) != Status::ok || lu_solve(work.lu, work.step) != Status::ok) {
      outcome.status = TrimStatus::singular;
      return outcome;
    }
    limit_step(work.equations, work.step);

    // Mostly the whole step is accepted, and the next one needs the Jacobian there: it costs two to four
    // times the residuals, which come with it.
    const bool at_once =
        Policy::kJacobianIsCheap && outcome.residual > kNearlyConverged<R> && k + 1 < max_iterations;
    const R before = square_norm(work.residual, n);
    R length = R(1);
    bool accepted = false;
    for (int halving = 0; halving <= kHalvings && !accepted; ++halving) {
      for (int j = 0; j < n; ++j) work.trial[j] = work.z[j] + length * work.step[j];
      length *= R(0.5);
      differentiated = at_once && halving == 0;
      if (!has_attitude(flight, work.trial[kRollRow], work.trial[kPitchRow])) continue;
      if (differentiated) {
        differentiate(work.trial, work.trial_residual);
      } else {
        residuals(static_cast<const R*>(work.trial), work.trial_residual);
      }
      accepted = square_norm(work.trial_residual, n) < before;  // false for NaN
    }
    if (!accepted) return outcome;
    ++iterations;
    for (int j = 0; j < n; ++j) {
      work.z[j] = work.trial[j];
      work.residual[j] = work.trial_residual[j];
    }
    outcome = largest(work.residual, n);
  }
  return outcome;
}

}  // namespace trim_detail

}  // namespace tiltrotor
