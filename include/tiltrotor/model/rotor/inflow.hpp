// Three-state Pitt-Peters dynamic inflow in the angle-free hub-axis form: Pitt and Peters, Vertica 5 (1981);
// Peters and HaQuang, J. AHS 33 (1988).
//
// All quantities in the rotor frame A, over tip speed. The wake skew enters through the vector
// (X_c, X_s) = (mu_x, mu_y) / (V_T + lambda_+), of length tan(chi/2) pointing downstream: no angle, no
// division by the advance ratio, finite derivatives in hover.
#pragma once

#include "tiltrotor/math/smooth.hpp"
#include "tiltrotor/model/rotor/vortex_ring.hpp"
#include "tiltrotor/model/setup/configuration.hpp"

namespace tiltrotor {

template <class T>
struct InflowForcing {
  T c0, cc, cs;        // thrust and load-harmonic coefficients, aerodynamic loads only
  T mu_x, mu_y, mu_z;  // in-plane wind (direction of the air), axial speed (+ climb)
};

template <class T>
struct InflowRates {
  T lambda_0, lambda_c, lambda_s;  // 1/s
};

// Fore-aft gradient of the inflow that thrust makes, lambda_c / lambda_0 = 2 k tan(chi/2). `x2`: tan(chi/2)^2.
// Surveyed in Chen, NASA TM-102219 (1990); written without angles (derived here).
template <class T>
T inflow_gradient(InflowGradient law, const T& x2) {
  using R = Real<T>;
  switch (law) {
    case InflowGradient::coleman:  // tan(chi/2): Coleman, Feingold and Stempin, NACA ARR L5E10 (1945)
      return T(R(0.5));
    case InflowGradient::white_blake:  // sqrt(2) sin(chi)
      return R(1.4142135623730951) / (R(1) + x2);
    default:  // 15 pi/32 tan(chi/2)
      return T(R(15) * kPi<R> / R(64));
  }
}

// Inverse gain matrix in hub axes: rows and columns (0, c, s). `kappa` scales the mean gain L00 = kappa/2.
template <class T>
struct InflowGainInverse {
  T inv_00, inv_0c, inv_0s, inv_c0, inv_s0, inv_cc, inv_cs, inv_ss;
};

// `k`: inflow_gradient().
template <class T>
InflowGainInverse<T> inflow_gain_inverse(const T& xc, const T& xs, const T& k, Real<T> kappa) {
  using R = Real<T>;
  const T x2 = xc * xc + xs * xs;
  // Determinant of the (0, downstream) block; at least 0.25 for kappa = 1 and |X| <= 1.
  const T d = kappa * (R(1) - x2) + k * k * x2;
  const T inverse_d = R(1) / d;
  const T isotropic = R(1) / (R(2) * (R(1) + x2));
  const T directed = (R(2) * kappa - k * k) * inverse_d * isotropic;
  InflowGainInverse<T> m;
  m.inv_00 = R(2) * (R(1) - x2) * inverse_d;
  m.inv_0c = k * xc * inverse_d;
  m.inv_0s = k * xs * inverse_d;
  m.inv_c0 = -m.inv_0c;
  m.inv_s0 = -m.inv_0s;
  m.inv_cc = isotropic + directed * xc * xc;
  m.inv_cs = directed * xc * xs;
  m.inv_ss = isotropic + directed * xs * xs;
  return m;
}

// lambda' = Omega M^-1 [ C - diag(V_T, V_m, V_m) L^-1 lambda ]
template <class T, class C, class S>
InflowRates<T> inflow_rates(const Configuration<C>& c, const RotorConditions<S>& turn, const RotorState<T>& x,
                            const InflowForcing<T>& f) {
  using R = Real<T>;
  const SmoothingWidths<R>& e = c.aircraft->smooth;
  const S omega = turn.speed;
  const R m0 = c.apparent_mass_0;
  const R m1 = c.aircraft->inflow.apparent_mass_cyclic;

  const T through = f.mu_z + x.lambda_0;  // total through-flow, positive down through the disk
  const T in_plane2 = f.mu_x * f.mu_x + f.mu_y * f.mu_y;
  T mass_flow = in_plane2 + through * through + square(e.inflow_speed);  // V_T^2
  T harmonics = in_plane2 + through * (through + x.lambda_0);            // V_T V_m
  const T stream = sqrt(mass_flow);
  const InflowTables<R>& ring = c.aircraft->inflow;
  const bool in_ring = c.setup.options.descent_inflow == DescentInflow::vortex_ring &&
                       add_vortex_ring(f.mu_z, x.lambda_0, in_plane2, ring.windmill_descent,
                                       ring.ring_in_plane, mass_flow, harmonics);
  const T vt = in_ring ? sqrt(mass_flow) : stream;
  const T vm = harmonics / vt;

  if (c.setup.options.inflow == InflowShape::uniform) {
    return {(omega / m0) * (f.c0 - (R(2) / c.induced_power_factor) * vt * x.lambda_0), R(0) * x.lambda_c,
            R(0) * x.lambda_s};
  }
  const T inverse_skew = R(1) / (stream + smooth_positive(through, e.through_flow));
  const T xc = f.mu_x * inverse_skew;
  const T xs = f.mu_y * inverse_skew;
  const T k = inflow_gradient(c.setup.options.inflow_gradient, T(xc * xc + xs * xs));
  const InflowGainInverse<T> g = inflow_gain_inverse(xc, xs, k, c.induced_power_factor);
  InflowRates<T> rates;
  rates.lambda_0 =
      (omega / m0) * (f.c0 - vt * (g.inv_00 * x.lambda_0 + g.inv_0c * x.lambda_c + g.inv_0s * x.lambda_s));
  rates.lambda_c =
      (omega / m1) * (f.cc - vm * (g.inv_c0 * x.lambda_0 + g.inv_cc * x.lambda_c + g.inv_cs * x.lambda_s));
  rates.lambda_s =
      (omega / m1) * (f.cs - vm * (g.inv_s0 * x.lambda_0 + g.inv_cs * x.lambda_c + g.inv_ss * x.lambda_s));
  return rates;
}

}  // namespace tiltrotor
