// The linear model with systems: what its matrices and its outputs share.
#pragma once

#include "library/c_systems.hpp"
#include "tiltrotor/analysis/linear/vehicle_model.hpp"

// The airframe with a configuration that moves: compiled once, in c_system_model.cpp.
#define TILTROTOR_SYSTEM_INSTANCES(PREFIX)                                                               \
  PREFIX template void derivative(                                                                       \
      const Configuration<SensitivityWorkspace<tr_real>::T>&,                                            \
      const State<SensitivityWorkspace<tr_real>::T>&, const Controls<SensitivityWorkspace<tr_real>::T>&, \
      ExpandedRotors<tr_real>, tr_real, DerivativeSteps<SensitivityWorkspace<tr_real>::T>&,              \
      State<SensitivityWorkspace<tr_real>::T>&);

// The rotors to first order: in c_rotor_expansion.cpp, fast where the rest is small.
#define TILTROTOR_ROTOR_INSTANCES(PREFIX)                                                                  \
  PREFIX template void expand_rotors(const Configuration<tr_real>&, const State<tr_real>&,                 \
                                     const Controls<tr_real>&, tr_real, RotorExpansionWorkspace<tr_real>&, \
                                     RotorExpansion<tr_real>&);

namespace tiltrotor {
TILTROTOR_SYSTEM_INSTANCES(extern)
TILTROTOR_ROTOR_INSTANCES(extern)
}  // namespace tiltrotor

namespace tiltrotor::c_interface {

// States and inputs; `columns` is known.
void shape_of_systems(const Sim& s, std::int32_t columns, VehicleShape& of);
// The configuration of a call in its surroundings, turbulence included.
Configuration<R>& equipped_in_air(const Sim& s, Configuration<R>& c);

}  // namespace tiltrotor::c_interface
