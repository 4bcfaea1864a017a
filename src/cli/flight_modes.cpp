#include "cli/flight_modes.hpp"

namespace tiltrotor::cli {

struct FlightModes::Work {
  VehicleModelWorkspace<double> model;
  VehicleModesWorkspace<double> modes;
  VehicleModes<double> found;
  Configuration<double> configuration;
};

FlightModes::FlightModes() : work_(std::make_unique<Work>()) {}
FlightModes::~FlightModes() = default;

Status FlightModes::find(const ScriptFlight& flight) {
  const SystemFlight<double>& systems = flight.systems();
  Work& w = *work_;
  w.configuration = flight.configuration();
  VehicleShape shape;
  vehicle_states(systems.vehicle, w.configuration.setup.options, shape);
  shape.inputs = 0;
  State<double> rates;
  SystemState<double> system_rates;
  const FlightMoment& now = flight.now();
  w.found.count = 0;
  const Status status = linearize_vehicle(
      systems.vehicle, w.configuration, now.state, now.systems, now.controls, shape, w.model, rates,
      system_rates, [&w](int i, int j, double slope) { w.modes.a(i, j) = slope; }, [](int, int, double) {});
  return status == Status::ok ? vehicle_modes(shape, w.modes, w.found) : status;
}

const VehicleModes<double>& FlightModes::found() const { return work_->found; }

}  // namespace tiltrotor::cli
