// How a linear model moves with a parameter while the trim moves as well: dA/dp and dB/dp, exact.
//
//   dA/dp = d2f/dx dp + d2f/dx2 dx/dp + d2f/dx du du/dp
//
// Configuration, state and controls move along one direction of a nested dual number, whose partials are those of A and
// B: one evaluation on 32 of them, and all second derivatives that count are there.
#pragma once

#include "tiltrotor/analysis/linear/configuration_sensitivity.hpp"
#include "tiltrotor/analysis/trim/trim_motion.hpp"
#include "tiltrotor/model/rotor/nested_blades.hpp"

namespace tiltrotor {

inline constexpr int kMotionDirections = 32;  // of one pass

template <class R>
struct ModelMotionWorkspace {
  using T = Nested<Dual<R, kMotionDirections>>;
  Configuration<T> configuration;
  T state[state_count];
  T control[control_count];
  State<T> x, rates;
  Controls<T> u;
  DerivativeSteps<T> derivative;
};

// Per unit of the parameter; rows and columns are those of the point.
template <class R>
struct ModelMotion {
  R rates[state_count];  // along a trim those of the trim's equations stay zero
  R power[2];            // shaft power of the rotors, right and left, W
  Matrix<R, kMaxLinearStates, kMaxLinearStates> a;
  Matrix<R, kMaxLinearStates, kMaxLinearControls> b;
};

// `parameter` moves by one and state and controls with `motion`; ConfigurationParameter::count: these alone.
// Status: ok; bad_argument (c is not prepared); not_finite. At a knot of a table along mast angle or flap one-sided:
// configuration_sensitivity.hpp.
// Cost: a pass for every 32 states and inputs, each some 8 Jacobians.
template <class R>
Status model_motion(const Configuration<R>& c, const State<R>& x, const Controls<R>& u,
                    const LinearPoint<R>& point, ConfigurationParameter parameter,
                    const TrimMotion<R>& motion, ModelMotionWorkspace<R>& work, ModelMotion<R>& out) {
  using T = typename ModelMotionWorkspace<R>::T;
  using D = Dual<R, kMotionDirections>;
  if (c.aircraft == nullptr || parameter > ConfigurationParameter::count) return Status::bad_argument;
  const T by = {D(R(0)), D(R(1))};
  moved_configuration(c, &parameter, &by, parameter == ConfigurationParameter::count ? 0 : 1,
                      work.configuration);
  R base_x[state_count], base_u[control_count], along_x[state_count], along_u[control_count];
  flatten(x, base_x);
  flatten(u, base_u);
  flatten(motion.x, along_x);
  flatten(motion.u, along_u);
  set_zero(out.a);
  set_zero(out.b);
  bool finite = true;
  const int n = point.states;
  const int all = n + point.controls;
  for (int first = 0; first < all; first += kMotionDirections) {
    const int last = first + kMotionDirections < all ? first + kMotionDirections : all;
    for (int i = 0; i < state_count; ++i) work.state[i] = {D(base_x[i]), D(along_x[i])};
    for (int j = 0; j < control_count; ++j) work.control[j] = {D(base_u[j]), D(along_u[j])};
    for (int k = first; k < last; ++k)
      (k < n ? work.state[point.state[k]] : work.control[point.control[k - n]]).v.d.set(k - first, R(1));
    unflatten(work.state, work.x);
    unflatten(work.control, work.u);
    derivative(work.configuration, work.x, work.u, work.derivative, work.rates, R(0));
    flatten(work.rates, work.state);
    for (int i = 0; i < state_count; ++i) {
      out.rates[i] = work.state[i].along.v;
      finite &= is_finite(out.rates[i]);
    }
    for (int i = 0; i < n; ++i)
      for (int k = first; k < last; ++k) {
        const R slope = work.state[point.state[i]].along.d.get(k - first);
        (k < n ? out.a(i, k) : out.b(i, k - n)) = slope;
        finite &= is_finite(slope);
      }
  }
  for (const Side side : {right, left})
    out.power[side] =
        (work.derivative.rotor[side].loads.torque * work.configuration.setup.rotor_speed).along.v;
  return finite ? Status::ok : Status::not_finite;
}

// Compiled once for a program that says so: analysis/instances.hpp.
#ifdef TILTROTOR_EXTERN_INSTANCES
extern template Status model_motion(const Configuration<double>&, const State<double>&,
                                    const Controls<double>&, const LinearPoint<double>&,
                                    ConfigurationParameter, const TrimMotion<double>&,
                                    ModelMotionWorkspace<double>&, ModelMotion<double>&);
#endif

}  // namespace tiltrotor
