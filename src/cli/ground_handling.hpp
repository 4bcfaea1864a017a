// The pilot of an aircraft that stands on its wheels: blades flat, sticks in the middle, and throttles that bring the
// rotors to the speed that is wanted, while the governor's collective goes back to nothing. An ideal governor holds the
// speed with the collective; there the throttles bring the blades near flat pitch.
#pragma once

#include "pilot/reference_pilot.hpp"

namespace tiltrotor::cli {

struct GroundHandling {
  static constexpr double kSpoolRate = 1.8;  // rad/s^2
  static constexpr double kFlatPitch = 0;    // at 0.75 R, rad: hardly any thrust
  static constexpr double kNearFlat =
      0.07;  // the same, of an ideal governor: further down it finds no collective

  pilot::PilotOutput hands;

  struct Rotors {
    double speed, wanted;  // rad/s
    double torque;         // of both, N m
    double full_power;     // of one engine, W
    bool hold_speed;       // by an ideal governor
    double collective;     // with what it adds, rad
  };
  pilot::PilotOutput hold(const Rotors& rotors, const pilot::PilotReach& reach, double dt);
};

}  // namespace tiltrotor::cli
