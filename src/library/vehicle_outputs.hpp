// What the instruments read in an aircraft with systems, and C and D of that, in double precision.
#pragma once

#include <functional>
#include <vector>

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

// The same of outputs that `read` takes from what the work area holds of an evaluation: `rows` numbers.
struct VehicleRows {
  struct Rows {
    int width;
    std::vector<double> entry;
    double& operator()(int i, int j) {
      return entry[static_cast<std::size_t>(i) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(j)];
    }
    double operator()(int i, int j) const { return const_cast<Rows&>(*this)(i, j); }
  };
  int outputs = 0;
  std::vector<double> y;  // left to the caller
  Rows c{kMaxVehicleStates, {}}, d{vehicle_input_count, {}};
};
using VehicleRead =
    std::function<void(const VehicleDirectionWorkspace<double>&, VehicleDirectionWorkspace<double>::T*)>;
Status linearize_vehicle_rows(const SystemFlight<double>& flight, const Configuration<double>& c,
                              const State<double>& x, const Controls<double>& u, const VehicleShape& shape,
                              int rows, const VehicleRead& read, VehicleRows& found, double azimuth = 0);

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
