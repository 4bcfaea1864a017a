#include "cli/governed.hpp"

#include "cli/errors.hpp"
#include "tiltrotor/systems/vehicle_airframe.hpp"
#include "tiltrotor/systems/vehicle_events.hpp"

namespace tiltrotor::cli {

OptionList scas_option() {
  return {{"--scas", "STATE", "off, or on: with the rate damping of the augmentation (off)"}};
}

bool wants_scas(const Arguments& arguments) { return arguments.choice("--scas", "off", {"off", "on"}) == 1; }

Status linearize_governed(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
                          const ControlSet& columns, Analyses& work, VehicleMatrices& matrices, bool scas) {
  Controls<double> at = u;
  const SystemFlight<double> flight = governed(c, x, at, scas);
  return linearize_flight(c, flight, x, at, columns, governed_commands(c.setup.options), work, matrices);
}

CommandColumns governed_commands(const Options& options) {
  return options.governor == Governor::off ? CommandColumns::none : CommandColumns::throttles;
}

Status linearize_flight(const Configuration<double>& c, const SystemFlight<double>& flight,
                        const State<double>& x, const Controls<double>& u, const ControlSet& columns,
                        CommandColumns commands, Analyses& work, VehicleMatrices& matrices, double azimuth) {
  VehicleShape& shape = matrices.shape;
  vehicle_states(flight.vehicle, c.setup.options, shape);
  shape.inputs = 0;
  for (int j = 0; j < columns.count; ++j) shape.input[shape.inputs++] = columns.index[j];
  const int first = commands == CommandColumns::all    ? 0
                    : commands == CommandColumns::none ? command_count
                                                       : kCommandIndex.throttle[right];
  for (int k = first; k < command_count; ++k) shape.input[shape.inputs++] = control_count + k;
  Configuration<double> put = c;
  put.around = with_turbulence(c, x, u, flight.vehicle, flight.state);
  return linearize_vehicle(flight.vehicle, put, x, flight.state, u, work, matrices, azimuth);
}

double governed_collective(const Configuration<double>& c, const SystemFlight<double>& flight,
                           const State<double>& x, const Controls<double>& u, double azimuth) {
  const Vehicle<double>& v = flight.vehicle;
  if (v.on.governor != Governor::ideal) return flight.state.governor;
  Configuration<double> put = c;
  DerivativeSteps<double> steps;
  AirframeDemand<double> demand;
  AirframeAnswer<double> answer;
  VehicleFlows<double> flows;
  SystemState<double> rates;
  vehicle_rates(v, c, c.setup, put, x, flight.state, v.commands, u,
                VehicleAirframe<double>{put, x, steps, azimuth}, demand, answer, flows, rates);
  return flows.governed;
}

VehicleShape governed_shape(const Options& options, const ControlSet& columns, bool scas) {
  Vehicle<double> vehicle{};
  vehicle.on.governor = options.governor;
  vehicle.on.interconnect = options.interconnect == Interconnect::twists;
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
