// All analyses. Every program compiles instances of its own, with its own flags and vector width: those
// behind the C interface belong to the library alone and are never shared. A program of several files can
// compile them once: it defines TILTROTOR_EXTERN_INSTANCES in every file but one, which says
// TILTROTOR_INSTANCES(, double).
#pragma once

#include "tiltrotor/analysis/flight/response.hpp"
#include "tiltrotor/analysis/linear/modes.hpp"
#include "tiltrotor/analysis/linear/reduction.hpp"
#include "tiltrotor/analysis/trim/trim.hpp"
#include "tiltrotor/analysis/trim/trim_explanation.hpp"

// PREFIX extern: declarations; empty: definitions. What depends on the policy, and what does not.
#define TILTROTOR_POLICY_INSTANCES(PREFIX, R, POLICY)                                                      \
  PREFIX template TrimStatus trim(const Configuration<R>&, const SteadyFlight<R>&,                         \
                                  TrimWorkspace<R, POLICY>&, TrimResult<R>&, const TrimOptions&);          \
  PREFIX template TrimStatus trim_from(const Configuration<R>&, const SteadyFlight<R>&,                    \
                                       TrimWorkspace<R, POLICY>&, TrimResult<R>&, const TrimOptions&);     \
  PREFIX template Status linearize(const Configuration<R>&, const State<R>&, const Controls<R>&,           \
                                   const ControlSet&, LinearizationWorkspace<R, POLICY>&, LinearModel<R>&, \
                                   R);                                                                     \
  PREFIX template Status advance(const Configuration<R>&, SimulationWorkspace<R, POLICY>&, Simulation<R>&, \
                                 const R*);                                                                \
  PREFIX template Status advance_moving(MovingConfiguration<R>&, SimulationWorkspace<R, POLICY>&,          \
                                        Simulation<R>&, const R*);

#define TILTROTOR_COMMON_INSTANCES(PREFIX, R)                                                               \
  PREFIX template Status residualise(const LinearModel<R>&, ResidualisationWorkspace<R>&, LinearModel<R>&); \
  PREFIX template void split(const LinearModel<R>&, SplitModel<R>&);                                        \
  PREFIX template Status modes(const LinearModel<R>&, ModesWorkspace<R>&, ModeSet<R>&);                     \
  PREFIX template Status follow(const ModeSet<R>&, ModeSet<R>&);                                            \
  PREFIX template Status start(const Configuration<R>&, const State<R>&, const Controls<R>&, R, Integrator, \
                               Simulation<R>&);                                                             \
  PREFIX template void evaluate_aircraft(const Configuration<R>&, const State<R>&, const Controls<R>&,      \
                                         Evaluation<R>&, R);                                                \
  PREFIX template void derivative(const Configuration<R>&, const State<R>&, const Controls<R>&, State<R>&, R);

#define TILTROTOR_INSTANCES(PREFIX, R)            \
  TILTROTOR_POLICY_INSTANCES(PREFIX, R, AutoDiff) \
  TILTROTOR_POLICY_INSTANCES(PREFIX, R, NumDiff)  \
  TILTROTOR_COMMON_INSTANCES(PREFIX, R)

// Only for a program whose objects are all compiled alike: the instances of an object compiled with other
// flags would take the place of these.
#ifdef TILTROTOR_EXTERN_INSTANCES
namespace tiltrotor {
TILTROTOR_INSTANCES(extern, double)
TILTROTOR_INSTANCES(extern, float)
}  // namespace tiltrotor
#endif
