// What the reference pilot knows of the aircraft: gains at trims along masts and speeds, with and without augmentation,
// for each kind of governor and both rotor speeds.
#pragma once

#include "pilot/pilot_schedule.hpp"
#include "pilot/reference_pilot.hpp"
#include "tiltrotor/systems/vehicle.hpp"

namespace tiltrotor::cli {

class PilotTraining {
 public:
  // At altitude, mass, CG and options of `setup`, flaps as the aircraft has them at a mast angle. Conditions that have
  // no trim are left out. `warmer`: the air, than the standard atmosphere, K. Throws std::runtime_error when there is none
  // at all.
  explicit PilotTraining(const FlightSetup<double>& setup, double warmer = 0);

  // Gains at a mast angle, a speed and a rotor speed.
  pilot::PilotGains at(double mast_deg, double speed, double rotor_speed, const SystemSwitches& on) const;

  // What leads with a governor of this kind: behind one that works the power is the thrust.
  static pilot::Thrust thrust(Governor governor) {
    return governor == Governor::off ? pilot::Thrust::collective : pilot::Thrust::throttle;
  }

 private:
  struct Lessons {
    pilot::PilotSchedule schedule[2][2];  // without and with governor, without and with augmentation
  };
  Lessons helicopter_, airplane_;  // at the two speeds of the rotor
  double helicopter_speed_, airplane_speed_;
};

}  // namespace tiltrotor::cli
