#include "cli/governed.hpp"

#include "cli/errors.hpp"
#include "tiltrotor/systems/vehicle_events.hpp"

namespace tiltrotor::cli {

OptionList scas_option() {
  return {{"--scas", "STATE", "off, or on: with the rate damping of the augmentation (off)"}};
}

bool wants_scas(const Arguments& arguments) { return arguments.choice("--scas", "off", {"off", "on"}) == 1; }

SystemFlight<double> governed(const Configuration<double>& c, const State<double>& x, Controls<double>& u,
                              bool scas) {
  SystemFlight<double> flight{};
  flight.vehicle.on.governor = c.setup.options.governor;
  flight.vehicle.on.augmentation = scas;
  flight.vehicle.ground.down = std::numeric_limits<double>::infinity();
  Evaluation<double> now;
  evaluate_aircraft(c, x, u, now);
  settle(c, x, now.rotor[right].loads.torque + now.rotor[left].loads.torque, flight.vehicle, flight.state, u);
  return flight;
}

Status linearize_governed(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
                          const ControlSet& columns, Analyses& work, VehicleMatrices& matrices, bool scas) {
  Controls<double> at = u;
  const SystemFlight<double> flight = governed(c, x, at, scas);
  VehicleShape& shape = matrices.shape;
  vehicle_states(flight.vehicle, c.setup.options, shape);
  shape.inputs = 0;
  for (int j = 0; j < columns.count; ++j) shape.input[shape.inputs++] = columns.index[j];
  for (const int throttle : kCommandIndex.throttle) shape.input[shape.inputs++] = control_count + throttle;
  Configuration<double> put = c;
  return linearize_vehicle(flight.vehicle, put, x, flight.state, at, work, matrices);
}

VehicleShape governed_shape(const Options& options, const ControlSet& columns, bool scas) {
  Vehicle<double> vehicle{};
  vehicle.on.governor = options.governor;
  vehicle.on.augmentation = scas;
  VehicleShape shape;
  vehicle_states(vehicle, options, shape);
  shape.inputs = 0;
  for (int j = 0; j < columns.count; ++j) shape.input[shape.inputs++] = columns.index[j];
  if (options.governor == Governor::off) return shape;
  for (const int throttle : kCommandIndex.throttle) shape.input[shape.inputs++] = control_count + throttle;
  return shape;
}

void require_no_governor(const Options& options, const Arguments& arguments, const char* option) {
  if (options.governor == Governor::off || !arguments.given(option)) return;
  throw UsageError(arguments.where(option) + ": goes with governor=off alone");
}

}  // namespace tiltrotor::cli
