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

#include "tiltrotor/analysis/trim/momentum_range.hpp"
#include "tiltrotor/math/algebra/lu.hpp"
#include "tiltrotor/model/rotor/rotor.hpp"

namespace tiltrotor {

enum class CyclicUse : unsigned char {
  given,        // cyclic as given, the gimbal tilts freely
  cancels_tilt  // cyclic found that holds the disk normal to the shaft
};

template <class R>
struct RotorFlow {
  R axial;                        // speed up the shaft (climb; airplane mode forward), m/s, -150..150
  R in_plane;                     // speed of the hub across the shaft, m/s, -150..150
  R collective;                   // blade pitch at the reference radius, rad, within 90 deg
  R lateral_cyclic, long_cyclic;  // A1, B1, rad, within 30 deg
  CyclicUse cyclic;
};

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
  MomentumRange momentum;  // whether momentum theory gives this inflow
  int iterations;
  R residual;  // largest scaled rate left over
};

// Two flapping or cyclic angles, three inflow states, coning.
inline constexpr int kRotorUnknowns = 6;

// Input, response and memory of one evaluation on scalar T.
template <class T>
struct SeededRotorWorkspace {
  T flat[RotorInput<T>::kCount];
  T variable[kRotorUnknowns];
  T residual[kRotorUnknowns];
  RotorInput<T> in;
  RotorResponse<T> out;
  RotorWorkspace<T> rotor;
};

template <class R>
struct IsolatedRotorWorkspace {
  RotorWorkspace<R> plain;
  SeededRotorWorkspace<Dual<R, kRotorUnknowns>> seeded;
  Matrix<R, kRotorUnknowns, kRotorUnknowns> jacobian;
  LU<R, kRotorUnknowns> factors;
};

namespace isolated_rotor_detail {

inline constexpr int kMaxIterations = 60;
inline constexpr int kMaxHalvings = 12;

template <class R>
bool valid(const RotorFlow<R>& flow) {
  const R speed = R(150);
  const R pitch = R(90) * kRadPerDeg<R>;
  const R cyclic = R(30) * kRadPerDeg<R>;
  return configuration_detail::within(flow.axial, -speed, speed) &&
         configuration_detail::within(flow.in_plane, -speed, speed) &&
         configuration_detail::within(flow.collective, -pitch, pitch) &&
         configuration_detail::within(flow.lateral_cyclic, -cyclic, cyclic) &&
         configuration_detail::within(flow.long_cyclic, -cyclic, cyclic);
}

template <class R>
bool finite(const RotorFlow<R>& flow) {
  return is_finite(flow.axial) && is_finite(flow.in_plane) && is_finite(flow.collective) &&
         is_finite(flow.lateral_cyclic) && is_finite(flow.long_cyclic);
}

// Which unknowns there are: always the two angles and the mean inflow.
struct Unknowns {
  int harmonics;  // 1 or 3 inflow states
  bool coning;
  int count() const { return 2 + harmonics + (coning ? 1 : 0); }
};

inline Unknowns unknowns(const Options& o) {
  return {o.inflow == InflowShape::uniform ? 1 : 3, o.coning_states};
}

// Puts the unknowns z where they belong. The angles are tilt (b1c, b1s) or cyclic (A1, B1).
template <class T>
void place(const Unknowns& set, CyclicUse cyclic, const T* z, RotorInput<T>& in) {
  if (cyclic == CyclicUse::given) {
    in.state.b1c = z[0];
    in.state.b1s = z[1];
  } else {
    in.lateral_cyclic = z[0];
    in.long_cyclic = z[1];
  }
  in.state.lambda_0 = z[2];
  if (set.harmonics == 3) {
    in.state.lambda_c = z[3];
    in.state.lambda_s = z[4];
  }
  if (set.coning) in.coning.angle = z[2 + set.harmonics];
}

// Rates that vanish in equilibrium, in parts of the rotor speed.
template <class T>
void residuals(const Configuration<Real<T>>& c, const Unknowns& set, const RotorResponse<T>& response,
               T* residual) {
  using R = Real<T>;
  const R per_omega = R(1) / c.setup.rotor_speed;
  const R per_omega2 = per_omega * per_omega;
  if (c.setup.options.flapping == FlapOrder::first) {
    residual[0] = response.flapping.b1c_rate * per_omega;
    residual[1] = response.flapping.b1s_rate * per_omega;
  } else {
    residual[0] = response.flapping.b1c_acceleration * per_omega2;
    residual[1] = response.flapping.b1s_acceleration * per_omega2;
  }
  residual[2] = response.inflow.lambda_0 * per_omega;
  if (set.harmonics == 3) {
    residual[3] = response.inflow.lambda_c * per_omega;
    residual[4] = response.inflow.lambda_s * per_omega;
  }
  if (set.coning) residual[2 + set.harmonics] = response.coning_acceleration * per_omega2;
}

// Mean inflow by momentum theory, thrust from the angle of attack at the reference radius.
template <class R>
R first_inflow(const Configuration<R>& c, const RotorFlow<R>& flow, R solidity) {
  const R reference = c.aircraft->rotor.twist_reference;
  const R mu = flow.in_plane / c.tip_speed;
  const R axial = flow.axial / c.tip_speed;
  const R largest = R(0.02);  // thrust coefficient: beyond it the blades stall
  const R least_flow = R(0.01);
  R n0 = R(0);
  for (int k = 0; k < 40; ++k) {
    const R angle = flow.collective - std::atan2(axial + n0, reference);
    R ct = solidity * c.aircraft->rotor.lift_slope * angle / R(6);
    ct = ct > largest ? largest : ct < -largest ? -largest : ct;
    const R speed = std::sqrt(mu * mu + square(axial + n0));
    n0 = R(0.75) * n0 + R(0.125) * ct / (speed > least_flow ? speed : least_flow);
  }
  return n0;
}

template <class R>
R sum_of_squares(const R* x, int n) {
  R sum = R(0);
  for (int i = 0; i < n; ++i) sum += x[i] * x[i];
  return sum;
}

template <class R>
R largest(const R* x, int n) {
  R size = R(0);
  for (int i = 0; i < n; ++i) size = std::fabs(x[i]) > size ? std::fabs(x[i]) : size;
  return size;
}

// Residuals at z on plain numbers; `rotor` receives input and response.
template <class R>
void rotor_residuals(const Configuration<R>& c, const Unknowns& set, CyclicUse cyclic, const R* z,
                     RotorWorkspace<R>& work, IsolatedRotor<R>& rotor, R* residual) {
  place(set, cyclic, z, rotor.input);
  rotor_response(c, rotor.input, c.azimuth, work, rotor.response);
  residuals(c, set, rotor.response, residual);
}

template <class R>
void jacobian(const Configuration<R>& c, const Unknowns& set, CyclicUse cyclic, const R* z,
              const RotorInput<R>& at, IsolatedRotorWorkspace<R>& work) {
  using D = Dual<R, kRotorUnknowns>;
  SeededRotorWorkspace<D>& seeded = work.seeded;
  R plain[RotorInput<R>::kCount];
  flatten(at, plain);
  for (int i = 0; i < RotorInput<R>::kCount; ++i) seeded.flat[i] = D(plain[i]);
  unflatten(seeded.flat, seeded.in);
  const int n = set.count();
  for (int j = 0; j < n; ++j) seeded.variable[j] = D::variable(z[j], j);
  place(set, cyclic, seeded.variable, seeded.in);
  rotor_response(c, seeded.in, c.azimuth, seeded.rotor, seeded.out);
  residuals(c, set, seeded.out, seeded.residual);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) work.jacobian(i, j) = seeded.residual[i].d.get(j);
  }
}

// Shortens the step so that no angle changes by more than 5 deg and no inflow by more than 0.02.
template <class R>
void limit_step(const Unknowns& set, R* step) {
  const R angle = R(5) * kRadPerDeg<R>;
  const R inflow = R(0.02);
  R factor = R(1);
  for (int j = 0; j < set.count(); ++j) {
    const bool is_inflow = j >= 2 && j < 2 + set.harmonics;
    const R limit = is_inflow ? inflow : angle;
    if (std::fabs(step[j]) * factor > limit) factor = limit / std::fabs(step[j]);
  }
  for (int j = 0; j < set.count(); ++j) step[j] *= factor;
}

template <class R>
RotorFigures<R> figures(const Configuration<R>& c, const RotorFlow<R>& flow, const RotorLoads<R>& loads,
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
  const bool hovers = flow.axial == R(0) && flow.in_plane == R(0) && ct > R(0) && f.power > R(0);
  f.figure_of_merit = hovers ? ct * std::sqrt(R(0.5) * ct) / f.power_coefficient : not_defined;
  const bool propels = flow.axial > R(0) && f.thrust > R(0) && f.power > R(0);
  f.efficiency = propels ? f.thrust * flow.axial / f.power : not_defined;
  return f;
}

// Damped Newton iteration from z, which ends where the rotor is.
template <class R>
Status solve(const Configuration<R>& c, const Unknowns& set, CyclicUse cyclic, R* z,
             IsolatedRotorWorkspace<R>& work, IsolatedRotor<R>& rotor) {
  const int n = set.count();
  const R tolerance = R(5e4) * std::numeric_limits<R>::epsilon();
  R residual[kRotorUnknowns];
  isolated_rotor_detail::rotor_residuals(c, set, cyclic, z, work.plain, rotor, residual);
  Status status = Status::not_converged;
  for (int k = 0; k < kMaxIterations; ++k, ++rotor.iterations) {
    rotor.residual = largest(residual, n);
    if (!is_finite(sum_of_squares(residual, n))) {
      status = Status::not_finite;
      break;
    }
    if (rotor.residual < tolerance) {
      status = Status::ok;
      break;
    }
    jacobian(c, set, cyclic, z, rotor.input, work);
    R step[kRotorUnknowns];
    for (int i = 0; i < n; ++i) step[i] = -residual[i];
    status = lu_factor(work.jacobian, n, work.factors);
    if (status == Status::ok) status = lu_solve(work.factors, step);
    if (status != Status::ok) break;
    status = Status::not_converged;
    limit_step(set, step);

    const R before = sum_of_squares(residual, n);
    R trial[kRotorUnknowns];
    for (int halving = 0; halving <= kMaxHalvings; ++halving) {
      for (int j = 0; j < n; ++j) trial[j] = z[j] + step[j];
      isolated_rotor_detail::rotor_residuals(c, set, cyclic, trial, work.plain, rotor, residual);
      if (sum_of_squares(residual, n) < before) break;
      for (int j = 0; j < n; ++j) step[j] *= R(0.5);
    }
    for (int j = 0; j < n; ++j) z[j] = trial[j];
  }
  rotor.residual = largest(residual, n);
  return status;
}

template <class R>
MomentumRange range(const Configuration<R>& c, const IsolatedRotor<R>& rotor) {
  const Vec3<R>& v = rotor.input.velocity_a;
  return momentum_range(axial_flow(c.air.density, c.aircraft->rotor.radius, rotor.response.loads.force_a.z,
                                   v.z, v.x, rotor.input.state.lambda_0 * c.tip_speed));
}

}  // namespace isolated_rotor_detail

// Equilibrium by damped Newton iteration on the exact Jacobian, from a start by momentum theory; where that
// ends outside the range of momentum theory or nowhere, once more from a rotor without inflow, of which the
// windmill's root is the next, and from an inflow above all roots. Where the blades at the windmill's inflow
// give more thrust than its wake can carry, only a root without meaning is left. Residuals are scaled with
// the rotor speed; the tolerance is 1e-11 in double. Status: ok; vortex_ring (in equilibrium, but no rotor
// flies so: rotor.momentum says whether in its own wake or on the other branch); out_of_range (flow outside
// the ranges given at RotorFlow) and not_finite (NaN or infinity in it), nothing computed; not_converged (the
// rotor is where the first start ended); singular, not_finite. `rotor` is defined whatever is returned. Cost:
// typically 4 to 8 rotor Jacobians, at most 180 and 2340 plain evaluations.
template <class R>
Status isolated_rotor(const Configuration<R>& c, const RotorFlow<R>& flow, IsolatedRotorWorkspace<R>& work,
                      IsolatedRotor<R>& rotor) {
  using namespace isolated_rotor_detail;
  rotor = IsolatedRotor<R>{};
  if (!finite(flow)) return Status::not_finite;
  if (!valid(flow)) return Status::out_of_range;
  const RotorTables<R>& tables = c.aircraft->rotor;
  const R chord = blade_chord(tables, c.setup.options.chord, tables.twist_reference);
  const R solidity = static_cast<R>(tables.blades) * chord / (kPi<R> * tables.radius);
  const Unknowns set = unknowns(c.setup.options);

  rotor.input.velocity_a = {-flow.in_plane, R(0), flow.axial};
  rotor.input.coning.angle = c.coning;
  rotor.input.collective = flow.collective;
  rotor.input.lateral_cyclic = flow.lateral_cyclic;
  rotor.input.long_cyclic = flow.long_cyclic;

  const auto start = [&](R n0, R* z) {
    for (int j = 0; j < kRotorUnknowns; ++j) z[j] = R(0);
    if (flow.cyclic == CyclicUse::cancels_tilt) {
      z[0] = flow.lateral_cyclic;
      z[1] = flow.long_cyclic;
    }
    z[2] = n0;
    if (set.coning) z[2 + set.harmonics] = c.coning;
  };
  // By momentum theory; below the windmill; above every root.
  const R starts[] = {first_inflow(c, flow, solidity), R(0), R(-1.2) * flow.axial / c.tip_speed};
  IsolatedRotor<R> best = rotor;
  Status status = Status::not_converged;
  for (const R n0 : starts) {
    R z[kRotorUnknowns];
    start(n0, z);
    const Status ended = solve(c, set, flow.cyclic, z, work, rotor);
    rotor.momentum = range(c, rotor);
    const bool found = ended == Status::ok && rotor.momentum == MomentumRange::holds;
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
