#include "library/vehicle_outputs.hpp"

#include <memory>

#include "tiltrotor/analysis/flight/vehicle_readings.hpp"

namespace tiltrotor {

namespace {

Configuration<double> in_its_air(const SystemFlight<double>& flight, const Configuration<double>& c,
                                 const State<double>& x, const Controls<double>& u) {
  Configuration<double> put = c;
  put.around = with_turbulence(c, x, u, flight.vehicle, flight.state);
  return put;
}

}  // namespace

void read_vehicle_moment(const SystemFlight<double>& flight, const Configuration<double>& c,
                         const State<double>& x, const Controls<double>& u, double azimuth,
                         VehicleMoment& moment) {
  moment.put = in_its_air(flight, c, x, u);
  moment.found.read({flight.vehicle, flight.state, c.setup, moment.put}, moment.put, x, flight.state, u,
                    azimuth);
}

Instruments<double> vehicle_readings(const SystemFlight<double>& flight, const Configuration<double>& c,
                                     const State<double>& x, const Controls<double>& u, double azimuth) {
  VehicleMoment moment;
  read_vehicle_moment(flight, c, x, u, azimuth, moment);
  return moment.found.readings;
}

Status linearize_vehicle_outputs(const SystemFlight<double>& flight, const Configuration<double>& c,
                                 const State<double>& x, const Controls<double>& u, const VehicleShape& shape,
                                 VehicleOutputs& found, double azimuth) {
  flatten(vehicle_readings(flight, c, x, u, azimuth), found.y);
  Configuration<double> put = in_its_air(flight, c, x, u);
  set_zero(found.c);
  set_zero(found.d);
  return linearize_vehicle_outputs(
      flight.vehicle, put, x, flight.state, u, shape, found.work,
      [&found](int i, int j, double slope) { found.c(i, j) = slope; },
      [&found](int i, int j, double slope) { found.d(i, j) = slope; }, azimuth);
}

Status linearize_vehicle_rows(const SystemFlight<double>& flight, const Configuration<double>& c,
                              const State<double>& x, const Controls<double>& u, const VehicleShape& shape,
                              int rows, const VehicleRead& read, VehicleRows& found, double azimuth) {
  Configuration<double> put = in_its_air(flight, c, x, u);
  const auto work = std::make_unique<VehicleDirectionWorkspace<double>>();
  found.outputs = rows;
  for (VehicleRows::Rows* matrix : {&found.c, &found.d})
    matrix->entry.assign(static_cast<std::size_t>(rows) * static_cast<std::size_t>(matrix->width), 0);
  std::vector<VehicleDirectionWorkspace<double>::T> y(static_cast<std::size_t>(rows));
  return linearize_vehicle_rows(
      flight.vehicle, put, x, flight.state, u, shape, *work, rows, y.data(),
      [&](VehicleDirectionWorkspace<double>::T* to) { read(*work, to); },
      [&found](int i, int j, double slope) { found.c(i, j) = slope; },
      [&found](int i, int j, double slope) { found.d(i, j) = slope; }, azimuth);
}

}  // namespace tiltrotor
