// The analyses as compiled functions in double precision.
//
// Whether they differentiate automatically or numerically is settled when these are compiled; a program
// that calls them here is compiled once and linked with either build/libanalyses.a or build/libanalyses-nd.a.
// The work areas lie in memory of the caller:
//
//   void* memory = ...;  // analyses_size() bytes, aligned to analyses_alignment()
//   Analyses& work = *place_analyses(memory);
//   trim(configuration, flight, work, result);
#pragma once

#include <cstddef>

#include "library/model_instances.hpp"
#include "tiltrotor/analysis/linear/output_model.hpp"

namespace tiltrotor {

struct Analyses;  // work areas of all of them; one at a time

std::size_t analyses_size();
std::size_t analyses_alignment();
Analyses* place_analyses(void* memory);

// "automatic" or "numerical".
const char* differentiation_name();

// As the templates of the same name in tiltrotor/analysis/.
TrimStatus trim(const Configuration<double>& c, const SteadyFlight<double>& flight, Analyses& work,
                TrimResult<double>& result);
Status linearize(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
                 const ControlSet& columns, Analyses& work, LinearModel<double>& model, double azimuth = 0);

// What the instruments read, and C and D beside A and B of linearize().
struct OutputMatrices {
  static constexpr int outputs = Instruments<double>::kCount;
  LinearPoint<double> point;
  double y[outputs];
  Matrix<double, outputs, kMaxLinearStates> c;
  Matrix<double, outputs, control_count> d;
};
Status linearize_outputs(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
                         const ControlSet& columns, Analyses& work, OutputMatrices& found);

Status advance(const Configuration<double>& c, Analyses& work, Simulation<double>& simulation,
               const double* xdot = nullptr);
Status advance_moving(MovingConfiguration<double>& moving, Analyses& work, Simulation<double>& simulation,
                      const double* xdot = nullptr);

// Rotors with the governor of the configuration's options at (x, u) of the airframe, in a balance of power; no other
// system. Stick and pedals stay as they are. With `scas` its rate damping is on; attitudes are not held, as while a pilot
// moves the stick.
SystemFlight<double> governed(const Configuration<double>& c, const State<double>& x, Controls<double>& u,
                              bool scas = false);

// The linear model of the vehicle, by rows and columns of its shape.
struct VehicleMatrices {
  VehicleShape shape;
  Matrix<double, kMaxVehicleStates, kMaxVehicleStates> a;
  Matrix<double, kMaxVehicleStates, vehicle_input_count> b;
};
// `matrices.shape` says which; `c` is put into what the systems ask for.
Status linearize_vehicle(const Vehicle<double>& v, Configuration<double>& c, const State<double>& x,
                         const SystemState<double>& s, const Controls<double>& u, Analyses& work,
                         VehicleMatrices& matrices, double azimuth = 0);
Status vehicle_modes(const VehicleMatrices& matrices, Analyses& work, VehicleModes<double>& found);
// Of the modes found last, rotors by mean (in the places of the right one) and difference.
const Eigensystem<double, kMaxVehicleStates>& vehicle_eigensystem(const Analyses& work);
Status advance_vehicle(Configuration<double>& c, SystemFlight<double>& flight, Analyses& work,
                       Simulation<double>& simulation, const double* xdot = nullptr);

}  // namespace tiltrotor
