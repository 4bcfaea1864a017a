#include "cli/ground_handling.hpp"

#include <algorithm>

#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/systems/drive.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double kClosing = 0.5;   // 1/s, of an error of the rotor speed
constexpr double kLowering = 0.5;  // 1/(rad s), of throttle by collective: slow beside the lag of the engines
constexpr double kSlowly = 0.4;    // of the usual rates of the hands

}  // namespace

pilot::PilotOutput GroundHandling::hold(const Rotors& rotors, const pilot::PilotReach& reach, double dt) {
  const Aircraft<double>& aircraft = aircraft_data<double>();
  const auto bring = [&](double pilot::PilotOutput::*hand, double to) {
    const double way = kSlowly * dt * reach.rate.*hand;
    hands.*hand += std::clamp(to - hands.*hand, -way, way);
  };
  bring(&pilot::PilotOutput::collective, kFlatPitch);
  bring(&pilot::PilotOutput::long_stick, 0);
  bring(&pilot::PilotOutput::lat_stick, 0);
  bring(&pilot::PilotOutput::pedal, 0);
  if (rotors.hold_speed) {
    hands.throttle = std::clamp(hands.throttle - dt * kLowering * (rotors.collective - kNearFlat), 0.0, 1.0);
    return hands;
  }
  const double faster = std::clamp(kClosing * (rotors.wanted - rotors.speed), -kSpoolRate, kSpoolRate);
  const double torque = rotors.torque + drive_inertia(aircraft, aircraft.controls.engines) * faster;
  const double power = torque * rotors.speed / aircraft.controls.transmission_efficiency;
  bring(&pilot::PilotOutput::throttle, std::clamp(power / (2 * rotors.full_power), 0.0, 1.0));
  return hands;
}

}  // namespace tiltrotor::cli
