// Figures of a flight: what it was like, and its modes along the way.
#pragma once

#include <string>
#include <vector>

#include "cli/script_flight.hpp"
#include "tiltrotor/analysis/linear/vehicle_modes.hpp"

namespace tiltrotor::cli {

class FlightFigures {
 public:
  void add(const FlightMoment& moment);
  void add_modes(double time, const VehicleModes<double>& modes);
  // `subject`: of the titles. SVG.
  std::string motion(const std::string& subject) const;
  std::string modes(const std::string& subject) const;

 private:
  struct Root {
    double time, real, imag;
    std::string name;
  };
  std::vector<FlightMoment> moments_;
  std::vector<Root> roots_;
};

}  // namespace tiltrotor::cli
