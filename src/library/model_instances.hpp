// The parts of the model and of linear algebra that many sources of the program and of the tests run, compiled once in
// double precision: those of the airframe in analysis_model.cpp, of a configuration that moves in analysis_moved.cpp, of
// the systems in analysis_systems.cpp (apart: without vectors both have as many directions). Instances of whole analyses:
// tiltrotor/analysis/instances.hpp.
#pragma once

#include "tiltrotor/analysis/instances.hpp"
#include "tiltrotor/analysis/linear/vehicle_direction.hpp"
#include "tiltrotor/analysis/linear/vehicle_modes.hpp"

// Dual numbers by what their directions are.
namespace tiltrotor::shared {
using Seeded = LinearizationWorkspace<double, AutoDiff>::Seeded;  // of A and B
using OfRotor = Dual<double, RotorInput<double>::kCount>;         // of a rotor's own inputs
using Moved = SensitivityWorkspace<double>::T;                    // of parameters of the configuration
using OfVehicle = VehicleDirectionWorkspace<double>::T;           // of the systems
}  // namespace tiltrotor::shared

#define TILTROTOR_MODEL_INSTANCES(PREFIX)                                                                    \
  PREFIX template BladeLoads<Batch<double>> blade_loads(                                                     \
      const Configuration<double>&, const ElementAir<double, double>&, const BladeFlow<Batch<double>>&);     \
  PREFIX template void blade_loads_and_slopes(const Configuration<double>&,                                  \
                                              const ElementAir<double, double>&,                             \
                                              const BladeFlow<Batch<double>>&, BladeSlopes<Batch<double>>&); \
  PREFIX template void rotor_response(const Configuration<double>&, const RotorConditions<double>&,          \
                                      const RotorInput<double>&, const AzimuthStations<double>&,             \
                                      RotorWorkspace<double>&, RotorResponse<double>&, bool);                \
  PREFIX template void rotor_response(const Configuration<double>&, const RotorConditions<double>&,          \
                                      const RotorInput<shared::OfRotor>&, const AzimuthStations<double>&,    \
                                      RotorWorkspace<shared::OfRotor>&, RotorResponse<shared::OfRotor>&,     \
                                      bool);                                                                 \
  PREFIX template void derivative(const Configuration<double>&, const State<double>&,                        \
                                  const Controls<double>&, AskedRotors, double, DerivativeSteps<double>&,    \
                                  State<double>&);                                                           \
  PREFIX template void derivative(const Configuration<double>&, const State<shared::Seeded>&,                \
                                  const Controls<shared::Seeded>&, KnownRotors<double>, double,              \
                                  DerivativeSteps<shared::Seeded>&, State<shared::Seeded>&);                 \
  PREFIX template void configure(Configuration<double>&);

#define TILTROTOR_MOVED_INSTANCES(PREFIX)                                                                  \
  PREFIX template void configure(Configuration<shared::Moved>&);                                           \
  PREFIX template void evaluate_aircraft(const Configuration<shared::Moved>&, const State<shared::Moved>&, \
                                         const Controls<shared::Moved>&, DerivativeSteps<shared::Moved>&,  \
                                         Evaluation<shared::Moved>&, double);                              \
  PREFIX template void derivative(const Configuration<shared::Moved>&, const State<shared::Moved>&,        \
                                  const Controls<shared::Moved>&, ExpandedRotors<double>, double,          \
                                  DerivativeSteps<shared::Moved>&, State<shared::Moved>&);

#define TILTROTOR_VEHICLE_INSTANCES(PREFIX)                                                                 \
  PREFIX template void expand_rotors(const Configuration<double>&, const State<double>&,                    \
                                     const Controls<double>&, double, RotorExpansionWorkspace<double>&,     \
                                     RotorExpansion<double>&);                                              \
  PREFIX template void configure(Configuration<shared::OfVehicle>&);                                        \
  PREFIX template void derivative(const Configuration<shared::OfVehicle>&, const State<shared::OfVehicle>&, \
                                  const Controls<shared::OfVehicle>&, ExpandedRotors<double>, double,       \
                                  DerivativeSteps<shared::OfVehicle>&, State<shared::OfVehicle>&);          \
  PREFIX template void airframe_demand(                                                                     \
      const Vehicle<double>&, const Configuration<double>&, const ConfigurationSetting<double>&,            \
      Configuration<double>&, const State<double>&, const SystemState<double>&, const Commands<double>&,    \
      const Controls<double>&, AirframeDemand<double>&, VehicleFlows<double>&, SystemState<double>&);       \
  PREFIX template void airframe_demand(                                                                     \
      const Vehicle<double>&, const Configuration<double>&, const ConfigurationSetting<double>&,            \
      Configuration<shared::OfVehicle>&, const State<shared::OfVehicle>&,                                   \
      const SystemState<shared::OfVehicle>&, const Commands<shared::OfVehicle>&,                            \
      const Controls<shared::OfVehicle>&, AirframeDemand<shared::OfVehicle>&,                               \
      VehicleFlows<shared::OfVehicle>&, SystemState<shared::OfVehicle>&);                                   \
  PREFIX template Status vehicle_modes(const VehicleShape&, VehicleModesWorkspace<double>&,                 \
                                       VehicleModes<double>&);                                              \
  PREFIX template Status eigenvalues(const Matrix<double, kMaxVehicleStates, kMaxVehicleStates>&, int,      \
                                     EigenvalueWorkspace<double, kMaxVehicleStates>&,                       \
                                     Eigenvalues<double, kMaxVehicleStates>&);                              \
  PREFIX template Status eigensystem(const Matrix<double, kMaxVehicleStates, kMaxVehicleStates>&, int,      \
                                     EigenWorkspace<double, kMaxVehicleStates>&,                            \
                                     Eigensystem<double, kMaxVehicleStates>&);

namespace tiltrotor {
TILTROTOR_MODEL_INSTANCES(extern)
TILTROTOR_MOVED_INSTANCES(extern)
TILTROTOR_VEHICLE_INSTANCES(extern)
}  // namespace tiltrotor
