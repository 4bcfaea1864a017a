// A file of a C++ program that includes the headers and is compiled with whatever flags: its functions, never
// called, must not take the place of those behind the C interface.
#include <tiltrotor/analysis/linear/linear_model.hpp>
#include <tiltrotor/model/aircraft/aircraft_data.hpp>
#include <tiltrotor/model/derivative.hpp>
#include <tiltrotor/model/preparation.hpp>

double never_called(double speed);
double never_called(double speed) {
  using namespace tiltrotor;
  const Aircraft<double>& aircraft = aircraft_data<double>();
  static Configuration<double> configuration;
  if (prepare(aircraft, flight_setup(aircraft, speed), configuration) != Status::ok) return 0;
  State<double> x{}, rates{};
  Controls<double> u{};
  x.velocity.x = speed;
  derivative(configuration, x, u, rates);
  return rates.velocity.x + sin(speed) + atan2(speed, 2.0);
}
