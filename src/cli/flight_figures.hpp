// What figures of a flight are drawn from: rows of the flight, and its modes along the way.
#pragma once

#include "cli/script_flight.hpp"
#include "study/mission.hpp"
#include "tiltrotor/analysis/linear/vehicle_modes.hpp"

namespace tiltrotor::cli {

class FlightFigures {
 public:
  void add(const FlightMoment& moment);
  void add_modes(double time, const VehicleModes<double>& modes);
  const study::Table& motion() const { return motion_; }
  const study::Table& modes() const { return modes_; }

 private:
  study::Table motion_ = study::motion_along_flight();
  study::Table modes_ = study::modes_along_flight();
};

}  // namespace tiltrotor::cli
