// Ways to a trim that a cold start does not reach: from an easier flight to the one asked for.
#pragma once

#include "tiltrotor/analysis/trim/trim_newton.hpp"

namespace tiltrotor::trim_solver {

inline constexpr int kStageIterations =
    12;  // Newton steps of one stage of a continuation, and of a start nearby
inline constexpr int kWindmillIterations = 40;
inline constexpr int kFlightStages = 8;      // from level flight to the climb, turn and sideslip asked for
inline constexpr int kSpeedSearch = 4;       // neighbouring speeds tried on each side, 5 m/s apart
inline constexpr int kStagesPerSearch = 2;   // the way back in steps of 2.5 m/s
inline constexpr int kCollectiveSteps = 24;  // of 1 deg, from a lighter aircraft to stalled rotors
inline constexpr int kTopSteps = 10;         // of a golden section: to 0.02 deg

// Climb, turn and sideslip in equal parts, beginning at level flight.
template <class R, class Policy>
NewtonOutcome<R> from_level_flight(const Configuration<R>& c, const SteadyFlight<R>& flight,
                                   TrimWorkspace<R, Policy>& work, int& iterations) {
  SteadyFlight<R> stage{flight.speed, R(0), R(0), R(0), flight.gust};
  trim_first_guess(c, stage, work.equations, work.z);
  NewtonOutcome<R> outcome = newton(c, stage, work, kStageIterations, iterations);
  for (int k = 1; k <= kFlightStages && outcome.status == TrimStatus::ok; ++k) {
    const R part = static_cast<R>(k) / R(kFlightStages);
    stage = {flight.speed, part * flight.climb, part * flight.turn_rate, part * flight.sideslip, flight.gust};
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
    if (first_invalid(*c.aircraft, stage) != SteadyFlightField::none) return outcome;
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

// What rotors and wing carry where the way from a lighter aircraft begins: far from stall, whatever rotor
// speed, altitude and weight.
template <class R>
struct EasyLift {
  R blade_loading;  // thrust coefficient over solidity
  R wing_lift;      // coefficient
};
template <class R>
inline constexpr EasyLift<R> kEasyLifts[] = {{R(0.077), R(1)}, {R(0.077), R(0)}, {R(0.044), R(0)}};

// As a part of the weight, at most 0.7.
template <class R>
R carried_part(const Configuration<R>& c, R speed, const EasyLift<R>& easy) {
  const RotorTables<R>& rotor = c.aircraft->rotor;
  const R chord = blade_chord(rotor, c.setup.options.chord, rotor.twist_reference);
  const R blades = R(2) * static_cast<R>(rotor.blades) * chord * rotor.radius;  // m^2, of both rotors
  const R wing = R(0.5) * c.aircraft->wing.area * square(speed);
  const R lift = c.air.density * (easy.blade_loading * blades * square(c.tip_speed) + easy.wing_lift * wing);
  const R part = lift / (c.mass.mass * kGravity<R>);
  const R most = R(0.7);
  return part < most ? part : most;
}

// From a lighter aircraft by more and more collective. At each collective the part of the weight that the
// aircraft carries is the unknown, so the way does not end where more collective gives less lift: there the
// rotors stall, and what is carried before they do is known. (Some flights have a trim far beyond that, with
// blades like flat plates and several times the power; it is not looked for.) Only where the aircraft hangs
// on its rotors: with the masts forward the wing may be what stalls.
//   ok            work.z is the trim
//   rotor_stall   `carried` is the largest part of the weight, below 1
//   otherwise     neither was found, `carried` is as it was
// The equations are those of the whole weight again when it returns.
template <class R, class Policy>
NewtonOutcome<R> from_less_weight(const Configuration<R>& c, const SteadyFlight<R>& flight,
                                  TrimWorkspace<R, Policy>& work, int& iterations, R& carried) {
  TrimEquations<R>& equations = work.equations;
  const auto solve = [&] { return newton(c, flight, work, kStageIterations, iterations); };
  NewtonOutcome<R> outcome{TrimStatus::not_converged, std::numeric_limits<R>::infinity(), 0};
  const R step = kRadPerDeg<R>;
  R& lift = work.z[kCollectiveRow];
  const auto lift_at = [&](R collective) {
    set_collective(equations, collective);
    outcome = solve();
    return lift;
  };
  R most = R(0);  // lifted so far, and its collective
  R middle = R(0);
  int rises = 0;
  bool falls = false;
  for (const EasyLift<R>& easy : kEasyLifts<R>) {
    trim_equations(c, equations);
    most = carried_part(c, flight.speed, easy);
    trim_first_guess(c, flight, equations, work.z, most);
    set_carried_weight(equations, most);
    outcome = solve();
    if (outcome.status != TrimStatus::ok) continue;
    middle = lift;
    lift = most;
    // Up, until the lift falls or is enough.
    falls = false;
    for (int k = 0; k < kCollectiveSteps && !falls && most < R(1) && outcome.status == TrimStatus::ok; ++k) {
      const R next = lift_at(middle + step);
      falls = next < most;
      if (!falls) {
        most = next;
        middle += step;
        ++rises;
      }
    }
    if (rises > 0) break;  // else the start was beyond the top
  }
  // The top lies between one step below and one above: golden section.
  const bool stalls = falls && rises > 0;
  R low = middle - step;
  R high = middle + step;
  for (int k = 0; stalls && k < kTopSteps && most < R(1) && outcome.status == TrimStatus::ok; ++k) {
    const bool above = high - middle > middle - low;
    const R probe = middle + R(0.381966) * (above ? high - middle : low - middle);
    const R found = lift_at(probe);
    if (found > most) {
      (above ? low : high) = middle;
      middle = probe;
      most = found;
    } else {
      (above ? high : low) = probe;
    }
  }
  trim_equations(c, equations);
  if (outcome.status != TrimStatus::ok) return outcome;
  lift = middle;
  if (most >= R(1)) return solve();
  if (stalls) carried = most;
  outcome.status = stalls ? TrimStatus::rotor_stall : TrimStatus::not_converged;
  return outcome;
}

}  // namespace tiltrotor::trim_solver
