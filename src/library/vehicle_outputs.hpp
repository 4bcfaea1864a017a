// What the instruments read in an aircraft with systems, and C and D of that, in double precision.
#pragma once

#include "library/analyses.hpp"
#include "tiltrotor/analysis/flight/vehicle_readings.hpp"
#include "tiltrotor/analysis/linear/vehicle_direction.hpp"

namespace tiltrotor {

struct VehicleOutputs {
  static constexpr int outputs = Instruments<double>::kCount;
  double y[outputs];
  Matrix<double, outputs, kMaxVehicleStates> c;
  Matrix<double, outputs, vehicle_input_count> d;
  VehicleDirectionWorkspace<double> work;
};

// Columns as `shape` says. Status: those of the template of the same name.
Status linearize_vehicle_outputs(const SystemFlight<double>& flight, const Configuration<double>& c,
                                 const State<double>& x, const Controls<double>& u, const VehicleShape& shape,
                                 VehicleOutputs& found, double azimuth = 0);

// What an evaluation in the flight's systems and air finds: for what is read of it besides.
struct VehicleMoment {
  Configuration<double> put;  // into what the systems ask for
  VehicleReadings<double> found;
};
void read_vehicle_moment(const SystemFlight<double>& flight, const Configuration<double>& c,
                         const State<double>& x, const Controls<double>& u, double azimuth,
                         VehicleMoment& moment);

// y alone.
Instruments<double> vehicle_readings(const SystemFlight<double>& flight, const Configuration<double>& c,
                                     const State<double>& x, const Controls<double>& u, double azimuth = 0);

}  // namespace tiltrotor
