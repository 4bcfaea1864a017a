// How long a step of an explicit method may be: longer, and a mode that decays in flight grows in the
// computation.
//
//   const R longest = longest_stable_step(fastest_rates(c, x, u), kRungeKutta4Limits);
//
// Two families of modes are fast. Inflow decays the faster the more air passes the disk; the progressing
// gimbal mode turns at twice the rotor speed, hardly damped where the blades stall. Both have bounds that
// need no eigenvalues:
//
//   inflow  k (V + 2 v) / R + (sigma a / 16 M_c) sqrt(Omega^2 + V^2/R^2)       V at the hub, v induced
//   gimbal  Omega + sqrt(Omega^2 + K/J)                                        flapping.hpp
//
// The largest rate at which inflow alone decays is k V/R: of the eigenvalues of M^-1 L^-1 (inflow.hpp) in
// axial and in edgewise flow. The blades add their lift, sigma a / 16 per unit of harmonic inflow.
#pragma once

#include <cmath>

#include "tiltrotor/math/algebra/matrix.hpp"
#include "tiltrotor/model/setup/configuration.hpp"
#include "tiltrotor/model/variables/controls.hpp"
#include "tiltrotor/model/variables/state.hpp"

namespace tiltrotor {

template <class R>
struct FastestRates {
  R decay;        // 1/s, of modes well damped
  R oscillation;  // rad/s, of modes hardly damped
};

// Where |R(z)| = 1 bounds the stability function R of a method: |z| in the nearest direction at least 10 deg
// from the imaginary axis, and on that axis.
struct StabilityLimits {
  double decay, oscillation;
};
inline constexpr StabilityLimits kRungeKutta3Limits = {2.32, 1.732};
inline constexpr StabilityLimits kRungeKutta4Limits = {2.61, 2.828};

// What the bounds above leave out; tests/analysis/test_stable_step.cpp holds them against eigenvalues.
inline constexpr double kCompressibleSlope = 2.25;  // lift slope at high Mach number over the mean one
inline constexpr double kAirOnGimbal = 1.03;        // blade loads on the frequency of the gimbal

// k above.
template <class R>
R inflow_decay(const Configuration<R>& c) {
  const R m0 = c.apparent_mass_0;
  const R m1 = c.aircraft->inflow.apparent_mass_cyclic;
  const R kappa = c.induced_power_factor;
  const R k = R(15) * kPi<R> / R(64);  // skew gain of inflow_gain_inverse()
  const R axial_mean = R(2) / (kappa * m0);
  const R axial_harmonic = R(1) / (R(2) * m1);
  // Edgewise, mean and fore-aft inflow: s^2 + 2 h s + q = 0.
  const R h = kappa / (R(4) * k * k * m1);
  const R q = R(1) / (k * k * m0 * m1);
  const R edgewise = h * h > q ? h + std::sqrt(h * h - q) : std::sqrt(q);
  return larger_of(edgewise, larger_of(axial_mean, axial_harmonic));
}

// Bounds on the modes at a state and controls. Cost: five square roots and a few dozen multiplications.
template <class R>
FastestRates<R> fastest_rates(const Configuration<R>& c, const State<R>& x, const Controls<R>& u) {
  const RotorTables<R>& rotor = c.aircraft->rotor;
  const R blades = static_cast<R>(rotor.blades);
  const R omega = c.setup.rotor_speed;
  const Vec3<R>& arm = c.hub[right].arm_b;
  const auto through = [&](const Vec3<R>& gust) {
    const Vec3<R> air = x.velocity - u.gust - gust;
    return std::sqrt(dot(air, air));
  };
  const Surroundings<R>& around = c.around;
  const R hub_speed = larger_of(through(around.rotor_gust_b[right]), through(around.rotor_gust_b[left])) +
                      std::sqrt(dot(arm, arm) * dot(x.rates, x.rates)) +
                      std::sqrt(dot(arm, arm) * dot(around.gust_rates_b, around.gust_rates_b));
  const auto induced = [](const RotorState<R>& r) {
    return std::fabs(r.lambda_0) + std::fabs(r.lambda_c) + std::fabs(r.lambda_s);
  };
  const R induced_speed = c.tip_speed * larger_of(induced(x.rotor[right]), induced(x.rotor[left]));

  const R chord = blade_chord(rotor, c.setup.options.chord, rotor.twist_reference);
  const R solidity = blades * chord / (kPi<R> * rotor.radius);
  const R slope = R(kCompressibleSlope) * rotor.lift_slope;
  const R blade_lift = solidity * slope / (R(16) * c.aircraft->inflow.apparent_mass_cyclic);
  const R spring = R(2) * c.hub_spring / (blades * rotor.flap_inertia);  // K/J

  FastestRates<R> fastest;
  fastest.decay = inflow_decay(c) * (hub_speed + R(2) * induced_speed) / rotor.radius +
                  blade_lift * std::sqrt(square(omega) + square(hub_speed / rotor.radius));
  fastest.oscillation = R(kAirOnGimbal) * (omega + std::sqrt(square(omega) + spring));
  return fastest;
}

template <class R>
R longest_stable_step(const FastestRates<R>& fastest, const StabilityLimits& limits) {
  return smaller_of(static_cast<R>(limits.decay) / fastest.decay,
                    static_cast<R>(limits.oscillation) / fastest.oscillation);
}

}  // namespace tiltrotor
