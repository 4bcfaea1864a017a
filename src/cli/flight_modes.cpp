#include "cli/flight_modes.hpp"

#include "cli/governed.hpp"

namespace tiltrotor::cli {

struct FlightModes::Work {
  AnalysesWorkspace analyses;
  VehicleMatrices matrices;
  VehicleModes<double> modes;
};

FlightModes::FlightModes(const ControlSet& controls) : controls_(controls), work_(std::make_unique<Work>()) {}
FlightModes::~FlightModes() = default;

VehicleShape FlightModes::shape(const Options& options, bool twists) {
  Vehicle<double> v{};
  v.on = {Governor::pi, true, true, true, true, true, true, true};
  v.on.interconnect = twists;
  VehicleShape shape{};
  vehicle_states(v, options, shape);
  return shape;
}

std::vector<std::string> FlightModes::states(const Options& options, bool twists) const {
  const VehicleShape all = shape(options, twists);
  std::vector<std::string> names;
  for (int i = 0; i < all.states; ++i) names.emplace_back(vehicle_variable(all.state[i]).name);
  return names;
}

std::vector<std::string> FlightModes::inputs() const {
  std::vector<std::string> names;
  for (int j = 0; j < controls_.count; ++j) names.emplace_back(kControlVariables[controls_.index[j]].name);
  for (const Variable& command : kCommandVariables.row) names.emplace_back(command.name);
  return names;
}

Status FlightModes::linearize(const ScriptFlight& flight) {
  const FlightMoment& now = flight.now();
  return flight.loop().feedback().linearize_flight(
      flight.configuration(), flight.systems(), now.state, now.controls, controls_, CommandColumns::all,
      *work_->analyses, work_->matrices, nullptr, flight.loop().point(), flight.azimuth());
}

ShownModel FlightModes::model(const ScriptFlight& flight) const {
  const FlightMoment& now = flight.now();
  return ShownModel(work_->matrices, now.state, now.systems, now.controls, now.commands);
}

Status FlightModes::find() {
  work_->modes.count = 0;
  return vehicle_modes(work_->matrices, *work_->analyses, work_->modes);
}

const VehicleModes<double>& FlightModes::found() const { return work_->modes; }

}  // namespace tiltrotor::cli
