#include "library/analyses.hpp"

#include <new>

namespace tiltrotor {

struct Analyses {
  TrimWorkspace<double> trim;
  LinearizationWorkspace<double> linearization;
  SimulationWorkspace<double> simulation;
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
  return linearize(c, x, u, columns, work.linearization, model, azimuth);
}

Status advance(const Configuration<double>& c, Analyses& work, Simulation<double>& simulation,
               const double* xdot) {
  return advance(c, work.simulation, simulation, xdot);
}

Status advance_moving(MovingConfiguration<double>& moving, Analyses& work, Simulation<double>& simulation,
                      const double* xdot) {
  return advance_moving(moving, work.simulation, simulation, xdot);
}

}  // namespace tiltrotor
