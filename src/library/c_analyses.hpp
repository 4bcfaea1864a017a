// The analyses in the precision of the C interface, compiled once for all of it.
#pragma once

#include "tiltrotor/analysis/instances.hpp"
#include "tiltrotor/tiltrotor.h"

namespace tiltrotor::c_interface {
using Seeded = LinearizationWorkspace<tr_real>::Seeded;
}

// The explicit integrator differentiates nothing. Derivatives are named so that no other object has copies of their parts,
// which the compiler may have laid out worse and the linker would choose.
#define TILTROTOR_C_INSTANCES(PREFIX)                                                                        \
  PREFIX template Status linearize(                                                                          \
      const Configuration<tr_real>&, const State<tr_real>&, const Controls<tr_real>&, const ControlSet&,     \
      LinearizationWorkspace<tr_real, DefaultDifferentiation>&, LinearModel<tr_real>&, tr_real);             \
  PREFIX template Status advance(const Configuration<tr_real>&,                                              \
                                 SimulationWorkspace<tr_real, NoDifferentiation>&, Simulation<tr_real>&,     \
                                 const tr_real*);                                                            \
  PREFIX template void derivative(const Configuration<tr_real>&, const State<c_interface::Seeded>&,          \
                                  const Controls<c_interface::Seeded>&, KnownRotors<tr_real>, tr_real,       \
                                  DerivativeSteps<c_interface::Seeded>&, State<c_interface::Seeded>&);       \
  PREFIX template void derivative(const Configuration<tr_real>&, const State<tr_real>&,                      \
                                  const Controls<tr_real>&, AskedRotors, tr_real, DerivativeSteps<tr_real>&, \
                                  State<tr_real>&);                                                          \
  PREFIX template void model_rates(const Configuration<tr_real>&, tr_real,                                   \
                                   ModelWorkspace<c_interface::Seeded>&, const RotorDirections*);            \
  TILTROTOR_COMMON_INSTANCES(PREFIX, tr_real)

// In c_trim.cpp.
#define TILTROTOR_C_TRIM(PREFIX)                                                                         \
  PREFIX template TrimStatus trim(const Configuration<tr_real>&, const SteadyFlight<tr_real>&,           \
                                  TrimWorkspace<tr_real, DefaultDifferentiation>&, TrimResult<tr_real>&, \
                                  const TrimOptions&);

namespace tiltrotor {
TILTROTOR_C_TRIM(extern)
#ifndef TILTROTOR_C_ANALYSES_CPP
TILTROTOR_C_INSTANCES(extern)
#endif
}  // namespace tiltrotor
