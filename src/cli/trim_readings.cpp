#include "cli/trim_readings.hpp"

namespace tiltrotor::cli {

void read_trim(const TrimmedFlight& flight, const std::vector<AirframeOutput>& outputs,
               Instruments<double>& readings, std::vector<double>& airframe) {
  const Configuration<double>& c = flight.configuration;
  const State<double>& x = flight.trim.state;
  DerivativeSteps<double> steps;
  State<double> rates;
  derivative(c, x, flight.trim.controls, steps, rates, 0.0);
  read_instruments(c, x, steps, rates, readings);
  airframe = airframe_readings(c, x, steps, rates, outputs);
}

double reading_of(const TrimmedFlight& flight, const NamedOutput& output) {
  Instruments<double> readings;
  std::vector<double> airframe;
  std::vector<AirframeOutput> outputs;
  if (output.reading < 0) outputs.push_back(output.output);
  read_trim(flight, outputs, readings, airframe);
  if (output.reading < 0) return airframe.front();
  double reading[Instruments<double>::kCount];
  flatten(readings, reading);
  return reading[output.reading];
}

}  // namespace tiltrotor::cli
