// An aircraft in the balance of power of its governor.
#pragma once

#include <limits>

#include "tiltrotor/analysis/flight/right_side.hpp"
#include "tiltrotor/systems/vehicle_events.hpp"

namespace tiltrotor {

// See governed() of analyses.hpp.
template <class R>
SystemFlight<R> governed_flight(const Configuration<R>& c, const State<R>& x, Controls<R>& u, bool scas) {
  SystemFlight<R> flight{};
  flight.vehicle.on.governor = c.setup.options.governor;
  flight.vehicle.on.interconnect = c.setup.options.interconnect == Interconnect::twists;
  flight.vehicle.on.augmentation = scas;
  flight.vehicle.ground.down = std::numeric_limits<R>::infinity();
  Evaluation<R> now;
  evaluate_aircraft(c, x, u, now);
  settle(c, x, {now.rotor[right].loads.torque, now.rotor[left].loads.torque}, flight.vehicle, flight.state,
         u);
  return flight;
}

}  // namespace tiltrotor
