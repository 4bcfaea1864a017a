// The pilot of an aircraft that stands on its wheels: blades flat, sticks in the middle, and throttles that bring the
// rotors to the speed that is wanted, while the governor's collective goes back to nothing.
#pragma once

#include "pilot/reference_pilot.hpp"

namespace tiltrotor::cli {

struct GroundHandling {
  static constexpr double kSpoolRate = 1.8;  // rad/s^2
  static constexpr double kFlatPitch = 0;    // at 0.75 R, rad: hardly any thrust

  pilot::PilotOutput hands;

  struct Rotors {
    double speed, wanted;  // rad/s
    double torque;         // of both, N m
    double full_power;     // of one engine, W
  };
  pilot::PilotOutput hold(const Rotors& rotors, const pilot::PilotReach& reach, double dt);
};

}  // namespace tiltrotor::cli
