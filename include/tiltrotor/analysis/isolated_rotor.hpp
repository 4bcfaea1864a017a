// An isolated rotor on a fixed shaft: inflow and flapping in equilibrium at a given pitch and flow, and the
// figures by which rotors are compared.
//
//   Configuration<double> c;  prepare(aircraft, setup, c);  // setup: rotor speed, altitude, switches
//   RotorFlow<double> flow{};  flow.collective = 0.2;
//   static IsolatedRotorWorkspace<double> work;             // placed by the caller
//   IsolatedRotor<double> rotor;
//   if (isolated_rotor(c, flow, work, rotor) == Status::ok) ... rotor.figures.thrust_coefficient
#pragma once

#include <cmath>

#include "tiltrotor/analysis/rotor_equations.hpp"
#include "tiltrotor/analysis/trim/momentum_range.hpp"
#include "tiltrotor/model/preparation.hpp"

namespace tiltrotor {

// Coefficients over rho pi R^2 (Omega R)^2 (and R).
template <class R>
struct RotorFigures {
  R thrust, torque, power;  // along the shaft, N; N m; W
  R thrust_coefficient, power_coefficient;
  R solidity;                    // with the chord at the collective's reference radius
  R axial_ratio, advance_ratio;  // speeds over tip speed
  R figure_of_merit;             // ideal over actual power of a rotor that stands still and lifts, else NaN
  R efficiency;                  // thrust times axial speed over power, while both are positive, else NaN
};

template <class R>
struct IsolatedRotor {
  RotorInput<R> input;  // flow, state and pitch in the rotor frame A
  RotorResponse<R> response;
  RotorFigures<R> figures;
  MomentumRange momentum;  // whether the inflow law holds
  int iterations;
  R residual;  // largest scaled rate left over
};

namespace rotor_equilibrium {

inline constexpr int kMaxIterations = 60;  // of one start

template <class R>
bool valid(const Aircraft<R>& aircraft, const RotorFlow<R>& flow) {
  const R speed = aircraft.limits.speed;
  const R pitch = R(90) * kRadPerDeg<R>;
  const R cyclic = R(30) * kRadPerDeg<R>;
  return is_within(flow.axial, -speed, speed) && is_within(flow.in_plane, -speed, speed) &&
         is_within(flow.collective, -pitch, pitch) && is_within(flow.lateral_cyclic, -cyclic, cyclic) &&
         is_within(flow.long_cyclic, -cyclic, cyclic);
}

template <class R>
bool finite(const RotorFlow<R>& flow) {
  return is_finite(flow.axial) && is_finite(flow.in_plane) && is_finite(flow.collective) &&
         is_finite(flow.lateral_cyclic) && is_finite(flow.long_cyclic);
}

template <class R>
RotorFigures<R> figures(const Configuration<R>& c, const RotorFlow<R>& flow, const MastLoads<R>& loads,
                        R solidity) {
  const R not_defined = std::numeric_limits<R>::quiet_NaN();
  const R radius = c.aircraft->rotor.radius;
  const R unit_force = c.air.density * kPi<R> * square(radius) * square(c.tip_speed);
  RotorFigures<R> f;
  f.thrust = loads.force_a.z;
  f.torque = loads.torque;
  f.power = loads.torque * c.setup.rotor_speed;
  f.thrust_coefficient = f.thrust / unit_force;
  f.power_coefficient = f.torque / (unit_force * radius);
  f.solidity = solidity;
  f.axial_ratio = flow.axial / c.tip_speed;
  f.advance_ratio = flow.in_plane / c.tip_speed;
  const R ct = f.thrust_coefficient;
  const bool at_rest = std::fabs(flow.axial) < kLeastSpeed<R> && std::fabs(flow.in_plane) < kLeastSpeed<R>;
  const bool hovers = at_rest && ct > R(0) && f.power > R(0);
  f.figure_of_merit = hovers ? ct * std::sqrt(R(0.5) * ct) / f.power_coefficient : not_defined;
  const bool propels = flow.axial >= kLeastSpeed<R> && f.thrust > R(0) && f.power > R(0);
  f.efficiency = propels ? f.thrust * flow.axial / f.power : not_defined;
  return f;
}

// From z, which ends where the rotor is.
template <class R>
Status solve(const Configuration<R>& c, const Unknowns& set, CyclicUse cyclic,
             IsolatedRotorWorkspace<R>& work, IsolatedRotor<R>& rotor) {
  NewtonWorkspace<R, kRotorUnknowns>& iteration = work.newton;
  RotorProblem<R> problem{c, set, cyclic, work, rotor.input, rotor.response};
  const R tolerance = R(5e4) * std::numeric_limits<R>::epsilon();
  const NewtonResult<R> found =
      newton(problem, set.count(), tolerance, {kMaxIterations}, iteration, rotor.iterations);
  problem.values(iteration.z, iteration.residual);
  rotor.residual = found.residual;
  return found.status;
}

template <class R>
MomentumRange range(const Configuration<R>& c, const IsolatedRotor<R>& rotor) {
  const Vec3<R>& v = rotor.input.velocity_a;
  return momentum_range(axial_flow(c.air.density, c.aircraft->rotor.radius, rotor.response.loads.force_a.z,
                                   v.z, v.x, rotor.input.state.lambda_0 * c.tip_speed),
                        c.setup.options.descent_inflow);
}

}  // namespace rotor_equilibrium

// Equilibrium by damped Newton iteration on the exact Jacobian, from a start by momentum theory; where that
// ends nowhere, once more from a rotor without inflow and from an inflow above all roots. Residuals are scaled
// with the rotor speed; the tolerance is 1e-11 in double. Status: ok; vortex_ring (in equilibrium in its own
// wake, between the boundaries of momentum_range.hpp: the mean of an unsteady flow); out_of_range (flow outside
// the ranges given at RotorFlow) and not_finite (NaN or infinity in it), nothing computed; not_converged (the
// rotor is where the first start ended); singular, not_finite. `rotor` is defined whatever is returned. Cost:
// typically 4 to 8 rotor Jacobians, at most 180 and 2340 plain evaluations.
//
// With descent_inflow=momentum the other starts are tried too where the first ends outside the range of
// momentum theory: the first of them is next to the windmill's root. Where the blades at the windmill's inflow
// give more thrust than its wake can carry, only a root without meaning is left. vortex_ring then means that
// no rotor flies so: rotor.momentum says whether in its own wake or on the other branch.
template <class R>
Status isolated_rotor(const Configuration<R>& c, const RotorFlow<R>& flow, IsolatedRotorWorkspace<R>& work,
                      IsolatedRotor<R>& rotor) {
  using namespace rotor_equilibrium;
  rotor = IsolatedRotor<R>{};
  if (!finite(flow)) return Status::not_finite;
  if (!valid(*c.aircraft, flow)) return Status::out_of_range;
  const RotorTables<R>& tables = c.aircraft->rotor;
  const R chord = blade_chord(tables, c.setup.options.chord, tables.twist_reference);
  const R solidity = static_cast<R>(tables.blades) * chord / (kPi<R> * tables.radius);
  const Unknowns set = unknowns(c.setup.options);

  rotor.input.velocity_a = {-flow.in_plane, R(0), flow.axial};
  rotor.input.coning.angle = c.coning;
  rotor.input.collective = flow.collective;
  rotor.input.lateral_cyclic = flow.lateral_cyclic;
  rotor.input.long_cyclic = flow.long_cyclic;

  R* const z = work.newton.z;
  const auto start = [&](R lambda_0) {
    for (int j = 0; j < kRotorUnknowns; ++j) z[j] = R(0);
    if (flow.cyclic == CyclicUse::cancels_tilt) {
      z[0] = flow.lateral_cyclic;
      z[1] = flow.long_cyclic;
    }
    z[2] = lambda_0;
    if (set.coning) z[2 + set.harmonics] = c.coning;
  };
  const bool one_root = c.setup.options.descent_inflow == DescentInflow::vortex_ring;
  // By momentum theory; below the windmill; above every root.
  const R starts[] = {first_inflow(c, flow, solidity), R(0), R(-1.2) * flow.axial / c.tip_speed};
  IsolatedRotor<R> best = rotor;
  Status status = Status::not_converged;
  for (const R lambda_0 : starts) {
    start(lambda_0);
    const Status ended = solve(c, set, flow.cyclic, work, rotor);
    rotor.momentum = range(c, rotor);
    const bool found = ended == Status::ok && (one_root || rotor.momentum == MomentumRange::holds);
    if (found || best.iterations == 0 || (ended == Status::ok && status != Status::ok)) {
      best = rotor;
      status = ended;
    }
    if (found || (ended != Status::ok && ended != Status::not_converged)) break;
  }
  rotor = best;
  if (status == Status::ok && rotor.momentum != MomentumRange::holds) status = Status::vortex_ring;
  rotor.figures = figures(c, flow, rotor.response.loads, solidity);
  return status;
}

}  // namespace tiltrotor
