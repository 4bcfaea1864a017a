// Trim: state and controls of a steady flight, by damped Newton iteration on the complete model.
//
//   Configuration<double> c;  prepare(aircraft, flight_setup(aircraft, 30.0), c);
//   SteadyFlight<double> flight{};  flight.speed = 50;
//   static TrimWorkspace<double> work;            // placed by the caller
//   TrimResult<double> result;
//   if (trim(c, flight, work, result) == TrimStatus::ok) ... result.state, result.controls
//
// Unknowns are always the full set: roll, pitch, collective, sticks and pedal, the gimbal tilt and inflow of
// both rotors, the lagged downwash and the coning angles when they are states. Symmetric flight is the
// special case in which half of them agree.
#pragma once

#include <type_traits>

#include "tiltrotor/analysis/trim_equations.hpp"
#include "tiltrotor/analysis/trim_limits.hpp"
#include "tiltrotor/math/lu.hpp"

namespace tiltrotor {

// What came out, with enough to explain it: trim_explanation.hpp makes a sentence of it.
template <class R>
struct TrimResult {
  TrimStatus status;
  int iterations;      // Newton steps in all, first attempt and continuation
  int attempts;        // 1: the cold start converged; more: continuation was used
  R residual;          // largest scaled residual: accelerations over g, angular accelerations over 1 rad/s^2
  int residual_state;  // place in kStateNames of the state whose rate is left over
  SteadyFlightField invalid;  // with out_of_range: the first bad input

  State<R> state;           // yaw and position 0
  Controls<R> controls;     // the four inceptors; increments and gust 0
  BladeControls<R> blades;  // what blades and surfaces see

  R angle_of_attack;       // atan2(w, u), 0 in hover, rad
  R wing_angle_of_attack;  // of the free wing with rotor-induced lift correction, rad
  R sideslip;              // asin(v / V), rad
  R load_factor;           // lift of everything over weight, body axes: -Z / W
  R collective_root;       // mean blade pitch at r = 0, rad
  R thrust[2];             // resultant force of the rotor on its hub, right and left, N
  R power[2];              // shaft power, right and left, W
  R download_fraction;  // force of the rotor wakes on the wing against the thrust, over the rotors' force (at
                        // least a tenth of the weight); 0 where the wing in the wake pulls forward

  TrimLimit limit;             // the first limit exceeded, or none
  R limit_value, limit_bound;  // rad or in
};

template <class R, class Policy = DefaultDifferentiation>
struct TrimWorkspace {
  static constexpr int kDirections =
      kMaxTrimUnknowns < kModelDirections ? kMaxTrimUnknowns : kModelDirections;
  using Seeded = typename Policy::template Scalar<R, kDirections>;
  typename Policy::template Workspace<R, kDirections, kMaxTrimUnknowns, kMaxTrimUnknowns> differentiation;
  ModelRooms<R, Seeded> rooms;
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

inline constexpr int kMaxTrimIterations = 200;

struct TrimOptions {
  int max_iterations = 40;   // of one Newton attempt, 1..kMaxTrimIterations
  bool continuation = true;  // when the cold start fails: approach from an easier flight
};

// Trim from a cold start. The result is defined whatever is returned; when is_trimmed(status) it fulfils the
// equations of motion to the tolerance (1e-10 in double), otherwise it describes the best point of the first
// attempt. not_converged: no trim found; result.residual_state tells which equation is left, result.limit
// which limit the last point exceeds, often the reason. Cost: typically 3 to 9 Jacobians; at most about 450
// with the default options.
template <class R, class Policy>
TrimStatus trim(const Configuration<R>& c, const SteadyFlight<R>& flight, TrimWorkspace<R, Policy>& work,
                TrimResult<R>& result, const TrimOptions& options = {});

// The same from a first guess: result.state and result.controls as they come in (a neighbouring solution).
template <class R, class Policy>
TrimStatus trim_from(const Configuration<R>& c, const SteadyFlight<R>& flight, TrimWorkspace<R, Policy>& work,
                     TrimResult<R>& result, const TrimOptions& options = {});

namespace trim_detail {

// Largest scaled residual of a converged trim. In single precision the rounding of the loads sets it.
template <class R>
constexpr R tolerance() {
  const R wanted = R(1e-10);
  const R rounding = R(100) * std::numeric_limits<R>::epsilon();
  return wanted > rounding ? wanted : rounding;
}

inline constexpr int kHalvings = 12;
inline constexpr int kStageIterations =
    12;                                  // Newton steps of one stage of a continuation, and of a start nearby
inline constexpr int kFlightStages = 8;  // from level flight to the climb, turn and sideslip asked for
inline constexpr int kSpeedSearch = 4;   // neighbouring speeds tried on each side, 5 m/s apart
inline constexpr int kStagesPerSearch = 2;  // the way back in steps of 2.5 m/s

template <class R>
struct NewtonOutcome {
  TrimStatus status;  // ok, not_converged, singular or not_finite
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

// Newton from work.z, which holds the best point found when it returns.
template <class R, class Policy>
NewtonOutcome<R> newton(const Configuration<R>& c, const SteadyFlight<R>& flight,
                        TrimWorkspace<R, Policy>& work, int max_iterations, int& iterations) {
  const int n = work.equations.count;
  const auto residuals = [&](const auto* z, auto* residual) {
    using T = std::remove_reference_t<decltype(*residual)>;
    trim_residuals(c, flight, work.equations, work.rooms.template of<T>(), z, residual);
  };
  R scale[kMaxTrimUnknowns];
  for (int j = 0; j < n; ++j) scale[j] = work.equations.row[j].scale;

  NewtonOutcome<R> outcome{TrimStatus::not_converged, std::numeric_limits<R>::infinity(), 0};
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    Policy::jacobian(residuals, n, n, work.z, scale, work.residual, work.differentiation,
                     [&work](int i, int j, R slope) { work.jacobian(i, j) = slope; });
    outcome = largest(work.residual, n);
    if (outcome.status != TrimStatus::not_converged) return outcome;

    for (int i = 0; i < n; ++i) work.step[i] = -work.residual[i];
    if (lu_factor(work.jacobian, n, work.lu) != Status::ok || lu_solve(work.lu, work.step) != Status::ok) {
      outcome.status = TrimStatus::singular;
      return outcome;
    }
    limit_step(work.equations, work.step);

    const R before = square_norm(work.residual, n);
    R length = R(1);
    bool accepted = false;
    for (int halving = 0; halving <= kHalvings && !accepted; ++halving) {
      for (int j = 0; j < n; ++j) work.trial[j] = work.z[j] + length * work.step[j];
      residuals(static_cast<const R*>(work.trial), work.trial_residual);
      accepted = square_norm(work.trial_residual, n) < before;  // false for NaN
      length *= R(0.5);
    }
    if (!accepted) return outcome;
    ++iterations;
    for (int j = 0; j < n; ++j) work.z[j] = work.trial[j];
    outcome = largest(work.trial_residual, n);
    if (outcome.status == TrimStatus::ok) return outcome;
  }
  return outcome;
}

// Climb, turn and sideslip in equal parts, beginning at level flight.
template <class R, class Policy>
NewtonOutcome<R> from_level_flight(const Configuration<R>& c, const SteadyFlight<R>& flight,
                                   TrimWorkspace<R, Policy>& work, int& iterations) {
  SteadyFlight<R> stage{flight.speed, R(0), R(0), R(0)};
  trim_first_guess(c, stage, work.equations, work.z);
  NewtonOutcome<R> outcome = newton(c, stage, work, kStageIterations, iterations);
  for (int k = 1; k <= kFlightStages && outcome.status == TrimStatus::ok; ++k) {
    const R part = static_cast<R>(k) / R(kFlightStages);
    stage = {flight.speed, part * flight.climb, part * flight.turn_rate, part * flight.sideslip};
    outcome = newton(c, stage, work, kStageIterations, iterations);
  }
  return outcome;
}

// The nearest speed on one side that has a trim, and from there back to the speed asked for.
template <class R, class Policy>
NewtonOutcome<R> from_other_speed(const Configuration<R>& c, const SteadyFlight<R>& flight, R direction,
                                  TrimWorkspace<R, Policy>& work, int& iterations) {
  const R spacing = R(5);  // m/s
  NewtonOutcome<R> outcome{TrimStatus::not_converged, std::numeric_limits<R>::infinity(), 0};
  SteadyFlight<R> stage = flight;
  int distance = 0;
  for (int k = 1; k <= kSpeedSearch && outcome.status != TrimStatus::ok; ++k) {
    stage.speed = flight.speed + direction * spacing * static_cast<R>(k);
    if (first_invalid(stage) != SteadyFlightField::none) return outcome;
    trim_first_guess(c, stage, work.equations, work.z);
    outcome = newton(c, stage, work, kStageIterations, iterations);
    distance = k;
  }
  const int stages = distance * kStagesPerSearch;
  for (int k = stages - 1; k >= 0 && outcome.status == TrimStatus::ok; --k) {
    stage.speed = flight.speed + direction * spacing * static_cast<R>(k) / R(kStagesPerSearch);
    outcome = newton(c, stage, work, kStageIterations, iterations);
  }
  return outcome;
}

template <class R, class Policy>
void unpack_unknowns(const SteadyFlight<R>& flight, const TrimWorkspace<R, Policy>& work, State<R>& state,
                     Controls<R>& controls) {
  R x[state_count] = {};
  R u[control_count] = {};
  for (int j = 0; j < work.equations.count; ++j) {
    const TrimEquation<R>& row = work.equations.row[j];
    (row.state >= 0 ? x[row.state] : u[row.control]) = work.z[j];
  }
  unpack(x, state);
  unpack(u, controls);
  state.velocity = steady_velocity(flight, state.roll, state.pitch);
  state.rates = steady_rates(flight, state.roll, state.pitch);
}

template <class R, class Policy>
void pack_unknowns(const State<R>& state, const Controls<R>& controls, TrimWorkspace<R, Policy>& work) {
  R x[state_count];
  R u[control_count];
  pack(state, x);
  pack(controls, u);
  for (int j = 0; j < work.equations.count; ++j) {
    const TrimEquation<R>& row = work.equations.row[j];
    work.z[j] = row.state >= 0 ? x[row.state] : u[row.control];
  }
}

// Pitch of the blade's chord at the axis of rotation above that at the reference radius.
template <class R>
R root_twist(const Configuration<R>& c) {
  const RotorTables<R>& rotor = c.aircraft->rotor;
  return lookup(rotor.twist, Interpolation::linear, R(0)) -
         lookup(rotor.twist, Interpolation::linear, rotor.twist_reference);
}

// Everything in the result that follows from work.z.
template <class R, class Policy>
void describe(const Configuration<R>& c, const SteadyFlight<R>& flight, TrimWorkspace<R, Policy>& work,
              TrimResult<R>& result) {
  unpack_unknowns(flight, work, result.state, result.controls);
  const Vec3<R>& v = result.state.velocity;
  result.blades = mix_controls(c, result.controls, v);
  Evaluation<R>& e = work.evaluation;
  evaluate(c, result.state, result.controls, e);

  result.angle_of_attack = flight.speed > R(0) ? atan2(v.z, v.x) : R(0);
  result.wing_angle_of_attack = e.wing_alpha;
  result.sideslip = flight.speed > R(0) ? flight.sideslip : R(0);
  result.collective_root = result.controls.collective + root_twist(c);
  R force_z = R(0);
  for (const Loads<R>& loads : e.loads.component) force_z += loads.force.z;
  result.load_factor = -force_z / (c.mass.mass * kGravity<R>);
  for (int side = 0; side < 2; ++side) {
    const RotorLoads<R>& rotor = e.rotor[side].loads;
    result.thrust[side] = std::sqrt(dot(rotor.force, rotor.force));
    result.power[side] = rotor.torque * c.setup.rotor_speed;
  }
  R download = R(0);
  for (int side = 0; side < 2; ++side) {
    const Loads<R>& wake = e.loads.component[side == right ? wing_wake_right : wing_wake_left];
    download -= dot(wake.force, c.hub[side].thrust_axis);
  }
  const R thrust = result.thrust[right] + result.thrust[left];
  const R least_thrust = R(0.1) * c.mass.mass * kGravity<R>;
  result.download_fraction =
      download > R(0) ? download / (thrust > least_thrust ? thrust : least_thrust) : R(0);
  const LimitCheck<R> check = check_limits(c, flight.speed, result.wing_angle_of_attack, result.state,
                                           result.controls, result.blades);
  result.limit = check.limit;
  result.limit_value = check.value;
  result.limit_bound = check.bound;
  if (result.status == TrimStatus::ok) result.status = check.status;
}

template <class R, class Policy>
TrimStatus finish(const Configuration<R>& c, const SteadyFlight<R>& flight, const NewtonOutcome<R>& outcome,
                  TrimWorkspace<R, Policy>& work, TrimResult<R>& result) {
  const R right_angle = R(0.5) * kPi<R>;
  const bool upright = std::fabs(work.z[0]) < right_angle && std::fabs(work.z[1]) < right_angle;
  result.status = outcome.status == TrimStatus::ok && !upright ? TrimStatus::not_converged : outcome.status;
  result.residual = outcome.residual;
  result.residual_state = work.equations.row[outcome.worst].rate;
  if (result.status == TrimStatus::not_finite) {
    for (int j = 0; j < work.equations.count; ++j) work.z[j] = is_finite(work.z[j]) ? work.z[j] : R(0);
  }
  describe(c, flight, work, result);
  return result.status;
}

// Defined outputs, checked inputs. True when the trim may begin.
template <class R, class Policy>
bool begin(const Configuration<R>& c, const SteadyFlight<R>& flight, const TrimOptions& options,
           TrimWorkspace<R, Policy>& work, TrimResult<R>& result) {
  result.iterations = 0;
  result.attempts = 0;
  result.residual = std::numeric_limits<R>::quiet_NaN();
  result.residual_state = ix_u;
  result.limit = TrimLimit::none;
  result.limit_value = result.limit_bound = R(0);
  result.invalid = first_invalid(flight);
  const bool options_valid = options.max_iterations >= 1 && options.max_iterations <= kMaxTrimIterations;
  const bool prepared = c.aircraft != nullptr;
  result.status = TrimStatus::out_of_range;
  if (result.invalid != SteadyFlightField::none || !options_valid || !prepared) return false;
  trim_equations(c, work.equations);
  return true;
}

}  // namespace trim_detail

template <class R, class Policy>
TrimStatus trim(const Configuration<R>& c, const SteadyFlight<R>& flight, TrimWorkspace<R, Policy>& work,
                TrimResult<R>& result, const TrimOptions& options) {
  result = TrimResult<R>{};
  if (!trim_detail::begin(c, flight, options, work, result)) return result.status;
  const int n = work.equations.count;
  trim_first_guess(c, flight, work.equations, work.z);
  auto outcome = trim_detail::newton(c, flight, work, options.max_iterations, result.iterations);
  result.attempts = 1;

  if (outcome.status != TrimStatus::ok && options.continuation) {
    const auto first_outcome = outcome;
    for (int j = 0; j < n; ++j) work.first_z[j] = work.z[j];
    const bool level = flight.climb == R(0) && flight.turn_rate == R(0) && flight.sideslip == R(0);
    if (!level) {
      ++result.attempts;
      outcome = trim_detail::from_level_flight(c, flight, work, result.iterations);
    }
    for (int side = 0; side < 2 && outcome.status != TrimStatus::ok; ++side) {
      ++result.attempts;
      outcome = trim_detail::from_other_speed(c, flight, side == 0 ? R(-1) : R(1), work, result.iterations);
    }
    if (outcome.status != TrimStatus::ok) {
      outcome = first_outcome;
      for (int j = 0; j < n; ++j) work.z[j] = work.first_z[j];
    }
  }
  return trim_detail::finish(c, flight, outcome, work, result);
}

template <class R, class Policy>
TrimStatus trim_from(const Configuration<R>& c, const SteadyFlight<R>& flight, TrimWorkspace<R, Policy>& work,
                     TrimResult<R>& result, const TrimOptions& options) {
  if (!trim_detail::begin(c, flight, options, work, result)) return result.status;
  trim_detail::pack_unknowns(result.state, result.controls, work);
  result.attempts = 1;
  const auto outcome = trim_detail::newton(c, flight, work, options.max_iterations, result.iterations);
  return trim_detail::finish(c, flight, outcome, work, result);
}

}  // namespace tiltrotor
