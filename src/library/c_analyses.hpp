// The analyses in the precision of the C interface, compiled once for all of it.
#pragma once

#include "tiltrotor/analysis/instances.hpp"
#include "tiltrotor/tiltrotor.h"

// The explicit integrator differentiates nothing.
#define TILTROTOR_C_INSTANCES(PREFIX)                                                                    \
  PREFIX template TrimStatus trim(const Configuration<tr_real>&, const SteadyFlight<tr_real>&,           \
                                  TrimWorkspace<tr_real, DefaultDifferentiation>&, TrimResult<tr_real>&, \
                                  const TrimOptions&);                                                   \
  PREFIX template Status linearize(                                                                      \
      const Configuration<tr_real>&, const State<tr_real>&, const Controls<tr_real>&, const ControlSet&, \
      LinearizationWorkspace<tr_real, DefaultDifferentiation>&, LinearModel<tr_real>&, tr_real);         \
  PREFIX template Status advance(const Configuration<tr_real>&,                                          \
                                 SimulationWorkspace<tr_real, NoDifferentiation>&, Simulation<tr_real>&, \
                                 const tr_real*);                                                        \
  TILTROTOR_COMMON_INSTANCES(PREFIX, tr_real)

#ifndef TILTROTOR_C_ANALYSES_CPP
namespace tiltrotor {
TILTROTOR_C_INSTANCES(extern)
}  // namespace tiltrotor
#endif
