// Shapes of modes as rows and as phasor diagrams.
#pragma once

#include <string>
#include <vector>

#include "cli/arguments.hpp"
#include "plot/plot.hpp"
#include "tiltrotor/analysis/linear/vehicle_modes.hpp"

namespace tiltrotor::cli {

struct ShapeEntry {
  std::string state;  // "theta", "b1c mean"
  std::string unit;
  bool is_rigid;
  double magnitude, angle_deg, participation;  // as Phasor; no angle where the state stands still
};

struct NamedShape {
  std::string mode, axis;
  double real, imag;
  std::string reference;  // the state that is one at angle zero
  std::vector<ShapeEntry> entry;
};

// --normalise: largest, or a state of the rigid body by name; where that stands still in a mode, the largest.
OptionList normalise_option();
// Place in State; -1: the largest.
int normalising_state(const Arguments& arguments);

// Of the airframe's modes, and of the vehicle's, whose eigensystem and shape are given.
std::vector<NamedShape> shapes_of(const ModeSet<double>& set, int normalising);
std::vector<NamedShape> shapes_of(const VehicleModes<double>& modes,
                                  const Eigensystem<double, kMaxVehicleStates>& system,
                                  const VehicleShape& shape, int normalising);

// One diagram a mode of the rigid body: its speeds, rates and angles each to a scale of their own, the longest 1.
plot::Plot phasor_diagram(const NamedShape& shape, const std::string& where, std::size_t number);

}  // namespace tiltrotor::cli
