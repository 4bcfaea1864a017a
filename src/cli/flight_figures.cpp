#include "cli/flight_figures.hpp"

namespace tiltrotor::cli {

void FlightFigures::add(const FlightMoment& m) {
  constexpr double kilo = 1e3;
  motion_.add({m.time, m.height, m.airspeed, m.mast_deg, m.flap_deg, (m.power[right] + m.power[left]) / kilo,
               2 * m.power_allowed / kilo, m.load_factor});
}

void FlightFigures::add_modes(double time, const VehicleModes<double>& modes) {
  for (int i = 0; i < modes.count; ++i)
    modes_.add({time, std::string(modes.mode[i].name), modes.mode[i].real, modes.mode[i].imag});
}

}  // namespace tiltrotor::cli
