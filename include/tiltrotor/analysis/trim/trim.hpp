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

#include "tiltrotor/analysis/trim/trim_continuation.hpp"
#include "tiltrotor/model/preparation.hpp"

namespace tiltrotor {

// What stopped the search for a trim, where that is known.
enum class TrimObstacle : unsigned char {
  none,
  attitude,    // no attitude near the balance of forces has the flight path, turn and sideslip
  upside_down  // a solution was found, with the aircraft on its back or past the vertical
};

// What came out, with enough to explain it: trim_explanation.hpp makes a sentence of it.
template <class R>
struct TrimResult {
  TrimStatus status;
  int iterations;      // Newton steps in all, first attempt and continuation
  int attempts;        // 1: the cold start converged; more: continuation was used
  R residual;          // largest scaled residual: accelerations over g, angular accelerations over 1 rad/s^2
  int residual_state;  // place in kStateVariables of the state whose rate is left over
  SteadyFlightField invalid;  // with out_of_range and not_finite: the first bad input
  R largest_speed;            // that the aircraft's ranges allow, m/s
  R largest_gust;             // the same

  State<R> state;           // yaw and position 0
  Controls<R> controls;     // the four inceptors, and the gust asked for; increments 0
  BladeControls<R> blades;  // what blades and surfaces see

  R angle_of_attack;       // atan2(w, u), 0 in hover, rad
  R wing_angle_of_attack;  // of the free wing with rotor-induced lift correction, rad
  R sideslip;              // asin(v / V), rad
  R load_factor;           // of load_factor()
  R collective_root;       // mean blade pitch at r = 0, rad
  R thrust[2];             // resultant force of the rotor on its hub, right and left, N
  R power[2];              // shaft power, right and left, W
  R download_fraction;  // force of the rotor wakes on the wing against the thrust, over the rotors' force (at
                        // least a tenth of the weight); 0 where the wing in the wake pulls forward

  TrimObstacle obstacle;  // of the search
  R weight_carried;       // 1; with rotor_stall the largest part of the weight that it can carry
  LimitCheck<R> limits;   // all that are exceeded, the decisive first
};

inline constexpr int kMaxTrimIterations = 200;

struct TrimOptions {
  int max_iterations = 40;    // of one Newton attempt, 1..kMaxTrimIterations
  bool continuation = true;   // when the cold start fails: approach from an easier flight
  int engines = kAllEngines;  // that run, 0 to those of the aircraft: what power_limit is about
};

// Trim from a cold start. The result is defined whatever is returned; when is_trimmed(status) it fulfils the
// equations of motion to the tolerance (1e-10 in double), otherwise it describes the best point of the first
// attempt. rotor_stall: there is none short of the rotors' stall, and result.weight_carried is the part of
// the weight that can be carried; looked for where the aircraft does not rest on its wing. not_converged: no
// trim found; result.residual_state tells which equation is left, result.obstacle and result.limits what the
// last point exceeds, often the reason. not_finite: a field of `flight` is NaN or infinite. No call raises a
// floating-point exception for an invalid operation, a division by zero or an overflow. Cost: typically 3 to
// 9 Jacobians; at most about 1800 Jacobians, each with 12 derivatives, with the default options.
template <class R, class Policy>
TrimStatus trim(const Configuration<R>& c, const SteadyFlight<R>& flight, TrimWorkspace<R, Policy>& work,
                TrimResult<R>& result, const TrimOptions& options = {});

// The same from a first guess: result.state and result.controls as they come in (a neighbouring solution).
template <class R, class Policy>
TrimStatus trim_from(const Configuration<R>& c, const SteadyFlight<R>& flight, TrimWorkspace<R, Policy>& work,
                     TrimResult<R>& result, const TrimOptions& options = {});

// Pitch of the blade's chord at the axis of rotation above that at the reference radius.
template <class R>
R blade_root_twist(const Configuration<R>& c) {
  const RotorTables<R>& rotor = c.aircraft->rotor;
  return lookup(rotor.twist, Interpolation::linear, R(0)) -
         lookup(rotor.twist, Interpolation::linear, rotor.twist_reference);
}

namespace trim_solver {

template <class R, class Policy>
void unflatten_unknowns(const SteadyFlight<R>& flight, const TrimWorkspace<R, Policy>& work, State<R>& state,
                        Controls<R>& controls) {
  R x[state_count] = {};
  R u[control_count] = {};
  for (int j = 0; j < work.equations.count; ++j) {
    const TrimEquation<R>& row = work.equations.row[j];
    (row.state >= 0 ? x[row.state] : u[row.control]) = work.z[j];
  }
  unflatten(x, state);
  unflatten(u, controls);
  controls.gust = flight.gust;
  state.velocity = steady_velocity(flight, state.roll, state.pitch) + flight.gust;
  state.rates = steady_rates(flight, state.roll, state.pitch);
}

template <class R, class Policy>
void flatten_unknowns(const State<R>& state, const Controls<R>& controls, TrimWorkspace<R, Policy>& work) {
  R x[state_count];
  R u[control_count];
  flatten(state, x);
  flatten(controls, u);
  for (int j = 0; j < work.equations.count; ++j) {
    const TrimEquation<R>& row = work.equations.row[j];
    work.z[j] = row.state >= 0 ? x[row.state] : u[row.control];
  }
}

// Everything in the result that follows from work.z.
template <class R, class Policy>
void describe(const Configuration<R>& c, const SteadyFlight<R>& flight, TrimWorkspace<R, Policy>& work,
              TrimResult<R>& result) {
  unflatten_unknowns(flight, work, result.state, result.controls);
  const Vec3<R> v = result.state.velocity - flight.gust;
  result.blades = mix_controls(c, result.controls, v);
  Evaluation<R>& e = work.evaluation;
  evaluate_aircraft(c, result.state, result.controls, e);

  result.angle_of_attack = flight.speed >= kLeastSpeed<R> ? atan2(v.z, v.x) : R(0);
  result.wing_angle_of_attack = e.wing_alpha;
  result.sideslip = flight.speed >= kLeastSpeed<R> ? steady_sideslip(flight, v) : R(0);
  result.collective_root = result.controls.collective + blade_root_twist(c);
  Vec3<R> force{};
  for (const Loads<R>& loads : e.loads.component) force = force + loads.force;
  result.load_factor = load_factor((R(1) / c.mass.mass) * force, v);
  for (int side = 0; side < 2; ++side) {
    const MastLoads<R>& rotor = e.rotor[side].loads;
    result.thrust[side] = std::sqrt(dot(rotor.force_a, rotor.force_a));
    result.power[side] = rotor.torque * c.setup.rotor_speed;
  }
  R download = R(0);
  for (int side = 0; side < 2; ++side) {
    const Loads<R>& wake = e.loads[side == right ? Component::wing_wake_right : Component::wing_wake_left];
    download -= dot(wake.force, c.hub[side].thrust_axis_b);
  }
  const R thrust = result.thrust[right] + result.thrust[left];
  const R least_thrust = R(0.1) * c.mass.mass * kGravity<R>;
  result.download_fraction =
      download > R(0) ? download / (thrust > least_thrust ? thrust : least_thrust) : R(0);
  result.limits = check_limits(c, flight.speed, result.wing_angle_of_attack, result.state, result.controls,
                               result.blades, e.rotor, work.engines);
  if (result.status == TrimStatus::ok) result.status = result.limits.status;
}

template <class R, class Policy>
void judge_outcome(const Configuration<R>& c, const SteadyFlight<R>& flight, const NewtonOutcome<R>& outcome,
                   TrimWorkspace<R, Policy>& work, TrimResult<R>& result) {
  const R right_angle = R(0.5) * kPi<R>;
  const bool upright = std::fabs(work.z[0]) < right_angle && std::fabs(work.z[1]) < right_angle;
  const bool solved = outcome.status == TrimStatus::ok;
  result.status = solved && !upright ? TrimStatus::not_converged : outcome.status;
  result.residual = outcome.residual;
  result.residual_state = work.equations.row[outcome.worst].rate;
  if (result.status == TrimStatus::not_finite) {
    for (int j = 0; j < work.equations.count; ++j) work.z[j] = is_finite(work.z[j]) ? work.z[j] : R(0);
    find_attitude(flight, work.z[kRollRow], work.z[kPitchRow]);
  }
  const R square_path = R(0.01);  // of cos^2: the path is within 6 deg of square to the nose
  const bool squeezed = attitude_margin(flight, work.z[kRollRow], work.z[kPitchRow]) < square_path;
  result.obstacle = solved     ? (upright ? TrimObstacle::none : TrimObstacle::upside_down)
                    : squeezed ? TrimObstacle::attitude
                               : TrimObstacle::none;
  describe(c, flight, work, result);
}

// A second trim from the inflow of the windmill, kept where it is one.
template <class R, class Policy>
void try_windmill(const Configuration<R>& c, const SteadyFlight<R>& flight, const NewtonOutcome<R>& before,
                  TrimWorkspace<R, Policy>& work, TrimResult<R>& result) {
  for (int j = 0; j < work.equations.count; ++j) work.first_z[j] = work.z[j];
  ++result.attempts;
  trim_windmill_guess(c, flight, work.equations, work.z);
  const NewtonOutcome<R> outcome = newton(c, flight, work, kWindmillIterations, result.iterations);
  if (outcome.status == TrimStatus::ok) {
    judge_outcome(c, flight, outcome, work, result);
    if (is_trimmed(result.status)) return;
  }
  for (int j = 0; j < work.equations.count; ++j) work.z[j] = work.first_z[j];
  judge_outcome(c, flight, before, work, result);
}

// Defined outputs, checked inputs. True when the trim may begin.
template <class R, class Policy>
bool accepts(const Configuration<R>& c, const SteadyFlight<R>& flight, const TrimOptions& options,
             TrimWorkspace<R, Policy>& work, TrimResult<R>& result) {
  result.iterations = 0;
  result.attempts = 0;
  result.residual = std::numeric_limits<R>::quiet_NaN();
  result.residual_state = kStateIndex.velocity.x;
  result.obstacle = TrimObstacle::none;
  result.weight_carried = R(1);
  result.limits = LimitCheck<R>{};
  const bool prepared = c.aircraft != nullptr;
  result.invalid = prepared ? first_invalid(*c.aircraft, flight) : SteadyFlightField::none;
  result.largest_speed = prepared ? c.aircraft->limits.speed : R(0);
  result.largest_gust = prepared ? c.aircraft->limits.gust : R(0);
  const bool options_valid =
      is_within(options.max_iterations, 1, kMaxTrimIterations) &&
      is_within(options.engines, kAllEngines, prepared ? c.aircraft->controls.engines : kAllEngines);
  result.status = all_finite(flight) ? TrimStatus::out_of_range : TrimStatus::not_finite;
  if (result.invalid != SteadyFlightField::none || !options_valid || !prepared) return false;
  trim_equations(c, work.equations);
  work.engines = options.engines;
  return true;
}

}  // namespace trim_solver

template <class R, class Policy>
TrimStatus trim(const Configuration<R>& c, const SteadyFlight<R>& flight, TrimWorkspace<R, Policy>& work,
                TrimResult<R>& result, const TrimOptions& options) {
  result = TrimResult<R>{};
  if (!trim_solver::accepts(c, flight, options, work, result)) return result.status;
  const int n = work.equations.count;
  trim_first_guess(c, flight, work.equations, work.z);
  auto outcome = trim_solver::newton(c, flight, work, options.max_iterations, result.iterations);
  result.attempts = 1;

  if (outcome.status != TrimStatus::ok && options.continuation) {
    const auto first_outcome = outcome;
    for (int j = 0; j < n; ++j) work.first_z[j] = work.z[j];
    const bool level = flight.climb == R(0) && flight.turn_rate == R(0) && flight.sideslip == R(0);
    if (!level) {
      ++result.attempts;
      outcome = trim_solver::from_level_flight(c, flight, work, result.iterations);
    }
    for (int side = 0; side < 2 && outcome.status != TrimStatus::ok; ++side) {
      ++result.attempts;
      outcome = trim_solver::from_other_speed(c, flight, side == 0 ? R(-1) : R(1), work, result.iterations);
    }
    if (outcome.status != TrimStatus::ok && !is_wingborne(c, flight.speed)) {
      ++result.attempts;
      outcome = trim_solver::from_less_weight(c, flight, work, result.iterations, result.weight_carried);
    }
    if (outcome.status != TrimStatus::ok) {
      const bool stalled = outcome.status == TrimStatus::rotor_stall;
      outcome = first_outcome;
      if (stalled) outcome.status = TrimStatus::rotor_stall;
      for (int j = 0; j < n; ++j) work.z[j] = work.first_z[j];
    }
  }
  trim_solver::judge_outcome(c, flight, outcome, work, result);
  const bool two_roots = c.setup.options.descent_inflow == DescentInflow::momentum;
  const bool doubtful =
      (result.status == TrimStatus::vortex_ring && two_roots) || result.status == TrimStatus::not_converged;
  if (doubtful && options.continuation && is_steep_descent(c, flight)) {
    trim_solver::try_windmill(c, flight, outcome, work, result);
  }
  return result.status;
}

template <class R, class Policy>
TrimStatus trim_from(const Configuration<R>& c, const SteadyFlight<R>& flight, TrimWorkspace<R, Policy>& work,
                     TrimResult<R>& result, const TrimOptions& options) {
  if (!trim_solver::accepts(c, flight, options, work, result)) return result.status;
  trim_solver::flatten_unknowns(result.state, result.controls, work);
  if (is_finite(work.z[kRollRow]) && is_finite(work.z[kPitchRow]))
    find_attitude(flight, work.z[kRollRow], work.z[kPitchRow]);
  result.attempts = 1;
  const auto outcome = trim_solver::newton(c, flight, work, options.max_iterations, result.iterations);
  trim_solver::judge_outcome(c, flight, outcome, work, result);
  return result.status;
}

}  // namespace tiltrotor
