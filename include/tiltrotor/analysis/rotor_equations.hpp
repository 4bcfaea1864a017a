// The equations of an isolated rotor in equilibrium: its flow, the unknowns, the rates that vanish, a first guess.
#pragma once

#include <cmath>

#include "tiltrotor/math/newton.hpp"
#include "tiltrotor/model/rotor/rotor.hpp"

namespace tiltrotor {

enum class CyclicUse : unsigned char {
  given,        // cyclic as given, the gimbal tilts freely
  cancels_tilt  // cyclic found that holds the disk normal to the shaft
};

template <class R>
struct RotorFlow {
  R axial;       // speed up the shaft (climb; airplane mode forward), m/s, within LimitTables::speed
  R in_plane;    // speed of the hub across the shaft, m/s, within LimitTables::speed
  R collective;  // blade pitch at the reference radius, rad, within 90 deg
  R lateral_cyclic, long_cyclic;  // A1, B1, rad, within 30 deg
  CyclicUse cyclic;
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
  NewtonWorkspace<R, kRotorUnknowns> newton;
};

namespace rotor_equilibrium {

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

template <class R>
struct EquilibriumBounds {
  // Of the first guess: thrust coefficient beyond which the blades stall, flow through the disk over tip speed,
  // rounds, each a quarter of the way to momentum theory.
  static constexpr R largest_thrust = R(0.02);
  static constexpr R least_flow = R(0.01);
  static constexpr int inflow_rounds = 40;
  // Of a Newton step: angles, rad, and inflow over tip speed.
  static constexpr R angle_step = R(5) * kRadPerDeg<R>;
  static constexpr R inflow_step = R(0.02);
};

// Mean inflow by momentum theory, lambda_0 = CT/(2 |mu, axial + lambda_0|), thrust from the angle of attack at
// the reference radius, CT = sigma a alpha/6 (a uniform blade's lift, integrated over r^2).
template <class R>
R first_inflow(const Configuration<R>& c, const RotorFlow<R>& flow, R solidity) {
  const EquilibriumBounds<R> bounds{};
  const R reference = c.aircraft->rotor.twist_reference;
  const R mu = flow.in_plane / c.tip_speed;
  const R axial = flow.axial / c.tip_speed;
  R lambda_0 = R(0);
  for (int k = 0; k < bounds.inflow_rounds; ++k) {
    const R angle = flow.collective - std::atan2(axial + lambda_0, reference);
    R ct = solidity * c.aircraft->rotor.lift_slope * angle / R(6);
    ct = ct > bounds.largest_thrust    ? bounds.largest_thrust
         : ct < -bounds.largest_thrust ? -bounds.largest_thrust
                                       : ct;
    const R speed = std::sqrt(mu * mu + square(axial + lambda_0));
    const R aim = R(0.5) * ct / (speed > bounds.least_flow ? speed : bounds.least_flow);
    lambda_0 = R(0.75) * lambda_0 + R(0.25) * aim;
  }
  return lambda_0;
}

// Shortens the step, its direction kept, until no unknown changes by more than its largest step.
template <class R>
void limit_step(const Unknowns& set, R* step) {
  R factor = R(1);
  for (int j = 0; j < set.count(); ++j) {
    const bool is_inflow = j >= 2 && j < 2 + set.harmonics;
    const R limit = is_inflow ? EquilibriumBounds<R>::inflow_step : EquilibriumBounds<R>::angle_step;
    if (std::fabs(step[j]) * factor > limit) factor = limit / std::fabs(step[j]);
  }
  for (int j = 0; j < set.count(); ++j) step[j] *= factor;
}

// Equilibrium as newton() wants it. `in` and `out` are those of the last values().
template <class R>
struct RotorProblem {
  static constexpr bool kJacobianIsCheap = true;
  static constexpr bool kStopsUphill = false;

  const Configuration<R>& c;
  const Unknowns& set;
  CyclicUse cyclic;
  IsolatedRotorWorkspace<R>& work;
  RotorInput<R>& in;
  RotorResponse<R>& out;

  void values(const R* z, R* residual) {
    place(set, cyclic, z, in);
    rotor_response(c, rotor_conditions(c, right), in, c.azimuth, work.plain, out);
    residuals(c, set, out, residual);
  }
  void jacobian(const R* z, R* residual, Matrix<R, kRotorUnknowns, kRotorUnknowns>& slopes) {
    using D = Dual<R, kRotorUnknowns>;
    SeededRotorWorkspace<D>& seeded = work.seeded;
    R plain[RotorInput<R>::kCount];
    flatten(in, plain);
    for (int i = 0; i < RotorInput<R>::kCount; ++i) seeded.flat[i] = D(plain[i]);
    unflatten(seeded.flat, seeded.in);
    const int n = set.count();
    for (int j = 0; j < n; ++j) seeded.variable[j] = D::variable(z[j], j);
    place(set, cyclic, seeded.variable, seeded.in);
    rotor_response(c, rotor_conditions(c, right), seeded.in, c.azimuth, seeded.rotor, seeded.out);
    residuals(c, set, seeded.out, seeded.residual);
    for (int i = 0; i < n; ++i) {
      residual[i] = seeded.residual[i].v;
      for (int j = 0; j < n; ++j) slopes(i, j) = seeded.residual[i].d.get(j);
    }
  }
  void limit_step(R* step) const { rotor_equilibrium::limit_step(set, step); }
  bool permits(const R*) const { return true; }
};

}  // namespace rotor_equilibrium

}  // namespace tiltrotor
