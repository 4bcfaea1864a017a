#include "library/analyses.hpp"

#include <new>

#include "library/governed_flight.hpp"

namespace tiltrotor {

struct Analyses {
  TrimWorkspace<double> trim;
  OutputModelWorkspace<double> outputs;  // with that of A and B
  SimulationWorkspace<double> simulation;
  VehicleModelWorkspace<double> vehicle;
  VehicleModesWorkspace<double> vehicle_modes;
};

std::size_t analyses_size() { return sizeof(Analyses); }
std::size_t analyses_alignment() { return alignof(Analyses); }
Analyses* place_analyses(void* memory) { return new (memory) Analyses; }

const char* differentiation_name() { return DefaultDifferentiation::kName; }

TrimStatus trim(const Configuration<double>& c, const SteadyFlight<double>& flight, Analyses& work,
                TrimResult<double>& result) {
  return trim(c, flight, work.trim, result);
}

Status linearize(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
                 const ControlSet& columns, Analyses& work, LinearModel<double>& model, double azimuth) {
  return linearize(c, x, u, columns, work.outputs.linear, model, azimuth);
}

Status linearize_outputs(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
                         const ControlSet& columns, Analyses& work, OutputMatrices& found) {
  DerivativeSteps<double> steps;
  State<double> rates;
  derivative(c, x, u, steps, rates, 0.0);
  Instruments<double> readings;
  read_instruments(c, x, steps, rates, readings);
  flatten(readings, found.y);
  return linearize_outputs(
      c, x, u, columns, work.outputs, found.point, [&](int i, int j, double slope) { found.c(i, j) = slope; },
      [&](int i, int j, double slope) { found.d(i, j) = slope; });
}

Status advance(const Configuration<double>& c, Analyses& work, Simulation<double>& simulation,
               const double* xdot) {
  return advance(c, work.simulation, simulation, xdot);
}

Status advance_moving(MovingConfiguration<double>& moving, Analyses& work, Simulation<double>& simulation,
                      const double* xdot) {
  return advance_moving(moving, work.simulation, simulation, xdot);
}

SystemFlight<double> governed(const Configuration<double>& c, const State<double>& x, Controls<double>& u,
                              bool scas) {
  return governed_flight(c, x, u, scas);
}

Status linearize_vehicle(const Vehicle<double>& v, Configuration<double>& c, const State<double>& x,
                         const SystemState<double>& s, const Controls<double>& u, Analyses& work,
                         VehicleMatrices& matrices, double azimuth) {
  State<double> xdot;
  SystemState<double> sdot;
  set_zero(matrices.a);
  set_zero(matrices.b);
  return linearize_vehicle(
      v, c, x, s, u, matrices.shape, work.vehicle, xdot, sdot,
      [&](int i, int j, int count, const double* slope) { copy_row(slope, count, matrices.a.row(i) + j); },
      [&](int i, int j, int count, const double* slope) { copy_row(slope, count, matrices.b.row(i) + j); },
      azimuth);
}

Status vehicle_modes(const VehicleMatrices& matrices, Analyses& work, VehicleModes<double>& found) {
  work.vehicle_modes.a = matrices.a;
  return vehicle_modes(matrices.shape, work.vehicle_modes, found);
}

const Eigensystem<double, kMaxVehicleStates>& vehicle_eigensystem(const Analyses& work) {
  return work.vehicle_modes.system;
}

Status advance_vehicle(Configuration<double>& c, SystemFlight<double>& flight, Analyses& work,
                       Simulation<double>& simulation, const double* xdot) {
  return advance_vehicle(c, flight, work.simulation, simulation, xdot);
}

}  // namespace tiltrotor
