// The analyses as compiled into the library, for double and the default differentiation: including this header instead
// of the single ones keeps a program from compiling them again.
#pragma once

#include "tiltrotor/analysis/modes.hpp"
#include "tiltrotor/analysis/reduction.hpp"
#include "tiltrotor/analysis/response.hpp"
#include "tiltrotor/analysis/trim.hpp"
#include "tiltrotor/analysis/trim_explanation.hpp"

// TILTROTOR_ANALYSIS(extern, R, Policy): declarations or definitions of everything on the real type R.
#define TILTROTOR_ANALYSIS(PREFIX, R, POLICY)                                                                         \
  PREFIX template TrimStatus trim(const Configuration<R>&, const SteadyFlight<R>&, TrimWorkspace<R, POLICY>&,         \
                                  TrimResult<R>&, const TrimOptions&);                                                \
  PREFIX template TrimStatus trim_from(const Configuration<R>&, const SteadyFlight<R>&, TrimWorkspace<R, POLICY>&,    \
                                       TrimResult<R>&, const TrimOptions&);                                           \
  PREFIX template Status linearize(const Configuration<R>&, const State<R>&, const Controls<R>&, const ControlSet&,   \
                                   LinearizationWorkspace<R, POLICY>&, LinearModel<R>&, R);                           \
  PREFIX template Status residualise(const LinearModel<R>&, ResidualisationWorkspace<R>&, LinearModel<R>&);           \
  PREFIX template void split(const LinearModel<R>&, SplitModel<R>&);                                                  \
  PREFIX template Status modes(const LinearModel<R>&, ModesWorkspace<R>&, ModeSet<R>&);                               \
  PREFIX template Status follow(const ModeSet<R>&, ModeSet<R>&);                                                      \
  PREFIX template Status start(const Configuration<R>&, const State<R>&, const Controls<R>&, R, Integrator,           \
                               Simulation<R>&);                                                                       \
  PREFIX template Status advance(const Configuration<R>&, SimulationWorkspace<R, POLICY>&, Simulation<R>&);

namespace tiltrotor {

#ifndef TILTROTOR_DEFINES_ANALYSIS
TILTROTOR_ANALYSIS(extern, double, DefaultDifferentiation)
TILTROTOR_ANALYSIS(extern, float, DefaultDifferentiation)
// Plain evaluations of the model: most of the time to compile a program that uses it.
extern template void evaluate(const Configuration<double>&, const State<double>&, const Controls<double>&,
                              Evaluation<double>&, double);
extern template void derivative(const Configuration<double>&, const State<double>&, const Controls<double>&,
                                State<double>&, double);
#endif

}  // namespace tiltrotor
