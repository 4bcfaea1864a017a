// How a flight and its linear model move along a direction, exact: evaluated on numbers that carry their slope.
#pragma once

#include <functional>
#include <memory>

#include "cli/along_aircraft.hpp"
#include "cli/trimmed_flights.hpp"
#include "tiltrotor/analysis/linear/vehicle_model.hpp"
#include "tiltrotor/analysis/trim/trim_motion.hpp"

namespace tiltrotor::cli {

// What moves, with slopes per unit: numbers of the aircraft, the setting of the configuration, the air around.
struct Moved {
  AlongAircraft& aircraft;
  ConfigurationSetting<Along>& setting;
  Surroundings<Along>& around;
};

class ModelSlope {
 public:
  ModelSlope();
  ~ModelSlope();

  // Of a configuration; `move` changes what it likes. Status: as prepare().
  Status begin(const Configuration<double>& c, const std::function<void(Moved)>& move);

  // Of the rates at (x, u), both held.
  Status rates(const State<double>& x, const Controls<double>& u, double (&slope)[state_count]);

  // Where state and controls move as well: of A of the airframe, rows and columns of the whole state, and of the power of
  // both rotors, W.
  struct Airframe {
    double power;
    double a[state_count][state_count];
  };
  Status airframe(const State<double>& x, const Controls<double>& u, const TrimMotion<double>& motion,
                  Airframe& slope);

  // Of what a target of the trimmed flight holds, in its unit.
  double held(const TrimTarget& target, const TrimmedFlight& flight, const TrimMotion<double>& motion) const;

  // Of A of the closed loop with governor and rate damping as governed() makes it, by its states.
  using Square = Matrix<double, kMaxVehicleStates, kMaxVehicleStates>;
  Status closed_loop(const State<double>& x, const Controls<double>& u, const TrimMotion<double>& motion,
                     bool scas, Square& slope);

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace tiltrotor::cli
