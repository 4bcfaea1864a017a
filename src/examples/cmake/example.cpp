#include <tiltrotor/tiltrotor.hpp>
using namespace tiltrotor;
int main() {
  static Configuration<double> c;
  static TrimWorkspace<double> work;
  static TrimResult<double> trimmed;
  if (prepare(aircraft_data<double>(), flight_setup(aircraft_data<double>(), 30.0), c) != Status::ok)
    return 1;
  return is_trimmed(trim(c, SteadyFlight<double>{40, 0, 0, 0}, work, trimmed)) ? 0 : 1;
}
