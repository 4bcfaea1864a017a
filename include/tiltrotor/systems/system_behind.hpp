// Which system has led a configuration out of its range.
#pragma once

#include <cmath>

#include "tiltrotor/systems/vehicle.hpp"

namespace tiltrotor {

// The state that puts the first field of a setup out of its range, among kSystemVariables; -1: none does. A rotor is out
// for its twist where the mean of both is not, and the twist takes more than a hundredth of the range.
template <class R>
int system_behind(const Aircraft<R>& aircraft, const FlightSetup<R>& setup) {
  const Bounds<R>& speeds = aircraft.limits.rotor_speed;
  const R share = R(0.01) * (speeds.high - speeds.low);
  switch (first_out_of_range(aircraft, setup).field) {
    case SetupField::mast_deg:
      return kSystemIndex.mast;
    case SetupField::mast_rate:
      return kSystemIndex.mast_rate;
    case SetupField::flap_deg:
      return kSystemIndex.flap;
    case SetupField::rotor_speed:  // of a rotor
      return is_within(setup.rotor_speed, speeds.low, speeds.high) &&
                     std::fabs(setup.rotor_difference) > share
                 ? kSystemIndex.twist_rate
                 : kSystemIndex.rotor_speed;
    case SetupField::mass:
      return kSystemIndex.fuel;
    default:
      return -1;
  }
}

}  // namespace tiltrotor
