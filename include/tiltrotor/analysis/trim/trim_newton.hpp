// The equations of trim, solved.
#pragma once

#include "tiltrotor/analysis/trim/trim_equations.hpp"
#include "tiltrotor/analysis/trim/trim_limits.hpp"
#include "tiltrotor/math/newton.hpp"

namespace tiltrotor {

template <class R, class Policy = DefaultDifferentiation>
struct TrimWorkspace : NewtonWorkspace<R, kMaxTrimUnknowns> {
  static constexpr int kDirections = kModelDirections;  // one width of dual numbers for trim and linear model
  using Seeded = typename Policy::template Scalar<R, kDirections>;
  typename Policy::template Workspace<R, kDirections, kMaxTrimUnknowns, kMaxTrimUnknowns> differentiation;
  ModelWorkspaces<R, Seeded> model;
  TrimEquations<R> equations;
  R first_z[kMaxTrimUnknowns];  // where the cold start ended
  int engines;                  // of TrimOptions
  Evaluation<R> evaluation;
};

namespace trim_solver {

// Largest scaled residual of a converged trim. In single precision the rounding of the loads sets it.
template <class R>
constexpr R tolerance() {
  const R wanted = R(1e-10);
  const R rounding = R(100) * std::numeric_limits<R>::epsilon();
  return wanted > rounding ? wanted : rounding;
}

template <class R>
struct NewtonOutcome {
  TrimStatus status;  // ok, not_converged, singular or not_finite; of from_less_weight() rotor_stall too
  R residual;         // largest
  int worst;          // its equation
};

constexpr TrimStatus trim_status(Status status) {
  return status == Status::ok              ? TrimStatus::ok
         : status == Status::not_converged ? TrimStatus::not_converged
         : status == Status::singular      ? TrimStatus::singular
                                           : TrimStatus::not_finite;
}

// The equations of trim as newton() wants them.
template <class R, class Policy>
struct TrimProblem {
  static constexpr bool kJacobianIsCheap = Policy::kJacobianIsCheap;
  static constexpr bool kStopsUphill = true;

  const Configuration<R>& c;
  const SteadyFlight<R>& flight;
  TrimWorkspace<R, Policy>& work;
  bool symmetric = false;  // where the Jacobian is

  void values(const R* z, R* residual) {
    trim_residuals(c, flight, work.equations, work.model.template of<R>(), PlainInputs<R>{z},
                   PlainOutputs<R>{residual});
  }
  void jacobian(const R* z, R* residual, Matrix<R, kMaxTrimUnknowns, kMaxTrimUnknowns>& slopes) {
    const int n = work.equations.count;
    R scale[kMaxTrimUnknowns];
    for (int j = 0; j < n; ++j) scale[j] = work.equations.row[j].scale;
    const auto residuals = [this](const auto& at, auto&& output) {
      using T = typename std::remove_reference_t<decltype(at)>::T;
      trim_residuals(c, flight, work.equations, work.model.template of<T>(), at, output);
    };
    Policy::jacobian(
        residuals, {n, n, z, scale, residual}, work.differentiation,
        [&slopes](int i, int j, int count, const R* slope) { copy_row(slope, count, slopes.row(i) + j); });
    symmetric = is_symmetric(work.equations, z, residual);
  }
  // The whole step shortened, its direction kept, until no unknown moves by more than its limit. In symmetric flight
  // its lateral part is rounding and goes: the rotors stay alike to the bit, and one of them is asked (local_response.hpp).
  void limit_step(R* step) const {
    const TrimEquations<R>& equations = work.equations;
    if (symmetric) make_symmetric(equations, step);
    R factor = R(1);
    for (int j = 0; j < equations.count; ++j) {
      const R limit = equations.row[j].step_limit;
      const R size = std::fabs(step[j]);
      if (limit > R(0) && size * factor > limit) factor = limit / size;
    }
    for (int j = 0; j < equations.count; ++j) step[j] *= factor;
  }
  bool permits(const R* z) const { return has_attitude(flight, z[kRollRow], z[kPitchRow]); }
};

// Newton from work.z, which holds the best point found when it returns: an attitude that the flight may have,
// if the start was one.
template <class R, class Policy>
NewtonOutcome<R> newton(const Configuration<R>& c, const SteadyFlight<R>& flight,
                        TrimWorkspace<R, Policy>& work, int max_iterations, int& iterations) {
  const int n = work.equations.count;
  TrimProblem<R, Policy> problem{c, flight, work};
  for (int j = 0; j < n; ++j)
    if (!is_finite(work.z[j])) return {TrimStatus::not_finite, std::numeric_limits<R>::infinity(), j};
  if (!problem.permits(work.z)) return {TrimStatus::not_converged, std::numeric_limits<R>::infinity(), 0};
  const NewtonResult<R> found =
      tiltrotor::newton(problem, n, tolerance<R>(), {max_iterations}, work, iterations);
  return {trim_status(found.status), found.residual, found.worst};
}

}  // namespace trim_solver

}  // namespace tiltrotor
