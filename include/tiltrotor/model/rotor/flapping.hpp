// Gimbal tilt and coning of one rotor, in multiblade coordinates of the rotor frame A.
//
// Centrifugal stiffness cancels against the transformation to non-rotating coordinates: the gimbal is held by
// its spring and the air alone.
#pragma once

#include "tiltrotor/math/vector.hpp"
#include "tiltrotor/model/setup/configuration.hpp"

namespace tiltrotor {

template <class T>
struct FlapRates {
  T b1c_rate, b1s_rate;                  // rad/s
  T b1c_acceleration, b1s_acceleration;  // rad/s^2
};

// Derived here: moment balance of a rigid blade about the hub centre, first order in hub rates, summed over
// the blades times cos psi and sin psi.
// b1c'' = -2 Omega b1s' - (K b1c + C b1c' - Mc)/J - 2 Omega wx - Omega' b1s
// b1s'' = +2 Omega b1c' - (K b1s + C b1s' - Ms)/J - 2 Omega wy + Omega' b1c          J = N_b I_b / 2
// The terms wy', -wx' of the hub's angular acceleration are added by the complete model when switched on.
template <class T, class C, class S>
FlapRates<T> flap_rates(const Configuration<C>& c, const RotorConditions<S>& turn, const RotorState<T>& x,
                        const Vec3<T>& hub_rates_a, const T& mc, const T& ms) {
  using R = Real<T>;
  const RotorTables<R>& rotor = c.aircraft->rotor;
  const R inverse_j = R(2) / (static_cast<R>(rotor.blades) * rotor.flap_inertia);
  const S two_omega = R(2) * turn.speed;
  const C spring = c.hub_spring * inverse_j;
  const R damping = rotor.hub_damping * inverse_j;
  FlapRates<T> rates;
  rates.b1c_rate = x.b1c_rate;
  rates.b1s_rate = x.b1s_rate;
  rates.b1c_acceleration = mc * inverse_j - two_omega * x.b1s_rate - spring * x.b1c - damping * x.b1c_rate -
                           two_omega * hub_rates_a.x - c.setup.rotor_acceleration * x.b1s;
  rates.b1s_acceleration = ms * inverse_j + two_omega * x.b1c_rate - spring * x.b1s - damping * x.b1s_rate -
                           two_omega * hub_rates_a.y + c.setup.rotor_acceleration * x.b1c;
  return rates;
}

// First-order gimbal: tilt rates that balance the equations above without the acceleration, given the moments
// at zero tilt rate. The aerodynamic damping J Omega gamma/8 is that of a uniform blade with the aircraft's
// mean lift slope. Derived here: lift 1/2 rho a c (Omega r) (r b') dr of a tilting blade, moment to the tip,
// gamma = rho a c R^4 / I_b.
template <class T, class C, class S>
FlapRates<T> quasi_static_flap_rates(const Configuration<C>& c, const RotorConditions<S>& turn,
                                     const RotorState<T>& x, const Vec3<T>& hub_rates_a, const T& mc_still,
                                     const T& ms_still) {
  using R = Real<T>;
  const RotorTables<R>& rotor = c.aircraft->rotor;
  RotorState<T> still = x;
  still.b1c_rate = T(R(0));
  still.b1s_rate = T(R(0));
  const FlapRates<T> forcing = flap_rates(c, turn, still, hub_rates_a, mc_still, ms_still);
  const R inverse_j = R(2) / (static_cast<R>(rotor.blades) * rotor.flap_inertia);
  const R chord = blade_chord(rotor, c.setup.options.chord, rotor.twist_reference);
  const S lock = turn.density * rotor.lift_slope * chord * square(square(rotor.radius)) / rotor.flap_inertia;
  const S omega = turn.speed;
  const S d = rotor.hub_damping * inverse_j + lock * omega / R(8);
  const S g = R(2) * omega;
  const S inverse = R(1) / (d * d + g * g);
  // d b1c' + g b1s' = forcing_c,  d b1s' - g b1c' = forcing_s
  return {inverse * (d * forcing.b1c_acceleration - g * forcing.b1s_acceleration),
          inverse * (g * forcing.b1c_acceleration + d * forcing.b1s_acceleration), T(R(0)), T(R(0))};
}

// Derived here: the same balance summed over the blades; stiffness as a frequency of nu per rev (choices.csv:
// coning_frequency), which holds the blade at its precone.
// b0'' = -(Omega^2 + w0^2) b0 + w0^2 b_precone + M0/(N_b I_b),  w0^2 = (nu^2 - 1) Omega^2
template <class T, class C, class S>
T coning_acceleration(const Configuration<C>& c, const RotorConditions<S>& turn, const ConingState<T>& x,
                      const T& m0) {
  using R = Real<T>;
  const RotorTables<R>& rotor = c.aircraft->rotor;
  const S omega2 = square(turn.speed);
  const S w2 = (square(rotor.coning_frequency) - R(1)) * omega2;
  return m0 * (R(1) / (static_cast<R>(rotor.blades) * rotor.flap_inertia)) + w2 * rotor.precone -
         (omega2 + w2) * x.angle;
}

}  // namespace tiltrotor
