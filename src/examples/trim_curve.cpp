// Attitude, collective and power over speed in conversion, by the C++ headers.
//
//   c++ -std=c++17 trim_curve.cpp $(pkg-config --cflags --libs tiltrotor)
#include <cstdio>
#include <tiltrotor/tiltrotor.hpp>

using namespace tiltrotor;

int main() {
  const Aircraft<double>& aircraft = aircraft_data<double>();
  static Configuration<double> configuration;
  static TrimWorkspace<double> work;
  static TrimResult<double> trimmed;
  if (prepare(aircraft, flight_setup(aircraft, 30.0), configuration) != Status::ok) return 1;
  for (int speed = 30; speed <= 60; speed += 10) {
    const SteadyFlight<double> flight = {static_cast<double>(speed), 0, 0, 0};
    const TrimStatus status = trim(configuration, flight, work, trimmed);
    if (!is_trimmed(status)) {
      std::printf("%d m/s: %s\n", speed, trim_status_word(status));
      return 1;
    }
    std::printf("%d m/s: pitch %6.2f deg, collective %5.2f deg, %4.0f kW, %s\n", speed,
                trimmed.state.pitch * kDegPerRad<double>, trimmed.controls.collective * kDegPerRad<double>,
                (trimmed.power[right] + trimmed.power[left]) / 1000, trim_status_word(status));
  }
  return 0;
}
