// Modes of the whole vehicle along a flight.
#pragma once

#include <memory>

#include "cli/script_flight.hpp"
#include "tiltrotor/analysis/linear/vehicle_modes.hpp"

namespace tiltrotor::cli {

class FlightModes {
 public:
  FlightModes();
  ~FlightModes();
  // Those of the linear model at this moment, every system that is on within.
  Status find(const ScriptFlight& flight);
  const VehicleModes<double>& found() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace tiltrotor::cli
