#include "study/linear_models.hpp"

#include <stdexcept>
#include <string>

namespace tiltrotor::study {

namespace {

struct WorkAreas {
  LinearizationWorkspace<double> linear;
  ResidualisationWorkspace<double> reduction;
  ModesWorkspace<double> modes;
};

// Large: one set for the whole program, made at first use.
WorkAreas& work() {
  static const auto areas = std::make_unique<WorkAreas>();
  return *areas;
}

void require(Status status, const char* what) {
  if (status != Status::ok) throw std::runtime_error(std::string(what) + ": " + status_text(status));
}

int row_of(const Linear& model, int state) {
  for (int i = 0; i < model.states; ++i) {
    if (model.state[i] == state) return i;
  }
  throw std::logic_error("the linear model has no such state");
}

}  // namespace

Linear linear_model(const Configured& c, const State<double>& x, const Controls<double>& u,
                    const ControlSet& columns) {
  Linear model;
  require(linearize(c, x, u, columns, work().linear, model), "linear model");
  return model;
}

Linear linear_model(const Configured& c, const Trimmed& trim) {
  return linear_model(c, trim.state, trim.controls, kInceptors);
}

Linear linear_model_at(const Setup& setup, double speed_mps, const ControlSet& columns) {
  const Configured c = configured(setup);
  const Trimmed t = trimmed_persistently(c, speed_mps);
  return linear_model(c, t.state, t.controls, columns);
}

Linear linear_model(const Configured& c, const SystemFlight<double>& systems, const State<double>& x,
                    const Controls<double>& u) {
  static const auto matrices = std::make_unique<VehicleMatrices>();
  vehicle_states(systems.vehicle, c.setup.options, matrices->shape);
  matrices->shape.inputs = 0;
  Configured put = c;
  require(linearize_vehicle(systems.vehicle, put, x, systems.state, u, analyses(), *matrices),
          "linear model with a governor");
  Linear model;
  clear(model);
  linear_states(c.setup.options, model);
  if (model.states != matrices->shape.states) throw std::logic_error("a governor with states of its own");
  model.controls = 0;
  for (int i = 0; i < model.states; ++i)
    for (int j = 0; j < model.states; ++j) model.a(i, j) = matrices->a(i, j);
  return model;
}

Linear quasi_steady(const Linear& full) {
  Linear reduced;
  require(residualise(full, work().reduction, reduced), "quasi-steady linear model");
  return reduced;
}

Modes modes_of(const Linear& model) {
  Modes set;
  require(modes(model, work().modes, set), "modes");
  return set;
}

Modes modes_of(const Configured& c, const Trimmed& trim) { return modes_of(linear_model(c, trim)); }

const Modes& modes_of(const Linear& model, Tracker& tracker, bool connects) {
  require(tracker.find(model, connects), "modes");
  return tracker.found();
}

double state_derivative(const Linear& model, int rate, int state) {
  return model.a(row_of(model, rate), row_of(model, state));
}

double control_derivative(const Linear& model, int rate, int control) {
  for (int j = 0; j < model.controls; ++j) {
    if (model.control[j] == control) return model.b(row_of(model, rate), j);
  }
  throw std::logic_error("the linear model has no such control");
}

}  // namespace tiltrotor::study
