// One frame of a simulation that knows its own dynamics: A, B and the eigenvalues of A, and a step of the
// flight that begins with the rates found on the way.
#pragma once

#include "flights.hpp"
#include "tiltrotor/analysis/linear/linear_eigenvalues.hpp"

namespace bench {

inline constexpr double kFrameTime = 0.005;  // s

template <class Policy>
struct FrameWork {
  SimulationWorkspace<double, Policy> simulation;
  LinearizationWorkspace<double, Policy> linearization;
  LinearEigenvaluesWorkspace<double> eigen;
  LinearModel<double> model;
  Eigenvalues<double, kMaxLinearStates> values;
};

// A flight from trim; `pulse`: size of a collective input that begins at once, rad.
inline Simulation<double> flight_with_input(const Configuration<double>& c, const TrimResult<double>& trim,
                                            InputShape shape, double size) {
  Simulation<double> flight;
  require(start(c, trim.state, trim.controls, kFrameTime, Integrator::rk3, flight) == Status::ok, "no start");
  const double half_time = 0.5;
  require(add_input(flight, {shape, kControlIndex.collective, size, 0.0, half_time}) == Status::ok,
          "no input");
  return flight;
}

template <class Policy>
void step(const Configuration<double>& c, FrameWork<Policy>& work, Simulation<double>& flight) {
  require(advance(c, work.simulation, flight) == Status::ok, "the flight diverged");
}

template <class Policy>
void frame(const Configuration<double>& c, FrameWork<Policy>& work, Simulation<double>& flight) {
  require(linearize(c, current_state(flight), current_controls(flight), kBladeControls, work.linearization,
                    work.model) == Status::ok,
          "no linear model");
  require(eigenvalues(work.model, work.eigen, work.values) == Status::ok, "no eigenvalues");
  require(advance(c, work.simulation, flight, work.model.xdot) == Status::ok, "the flight diverged");
}

}  // namespace bench
