// A flight of the whole vehicle as a script says, the reference pilot at the controls.
//
//   ScriptFlight flight(script, start);
//   do { ... flight.now() ... } while (flight.step());
//
// A step: commands that are due, the pilot's hands, steps, doublets, series and gusts on top; what there is now; and on.
// The pilot presses the force trim as long as a loop of his needs the stick, so that the attitude hold of the
// augmentation does not pull against him; a stick that no loop needs is let go where it stands.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/airframe_outputs.hpp"
#include "cli/feedback_flight.hpp"
#include "cli/flight_script.hpp"
#include "cli/pilot_training.hpp"
#include "tiltrotor/analysis/flight/instruments.hpp"
#include "tiltrotor/analysis/flight/response.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace tiltrotor::cli {

struct FlightStart {
  FlightSetup<double> setup;  // altitude: of the ground
  bool on_ground;             // on its wheels, rotors turning slowly; else in trim, the gear up
  double speed, height;       // of the trim, m/s and m
  double dt;                  // s
  const Aircraft<double>* aircraft = &aircraft_data<double>();
  std::vector<AirframeOutput> outputs = {};  // that are read beside the instruments
  double warmer = 0;                         // air, than the standard atmosphere, K
  bool engine_failed[2] = {};                // from the beginning
};

// What there is at a moment, and what acts from then on.
struct FlightMoment {
  double time;
  State<double> state;
  Controls<double> controls;  // of the pilot and of a feedback law, without the augmentation
  SystemState<double> systems;
  Commands<double> commands;
  State<double> rates;
  Vec3<double> velocity_n;  // north east down, over the ground, m/s
  double height;            // of the wheels above the ground, at rest on it 0, m
  double airspeed;          // m/s
  double load_factor;       // upwards along the body's z axis
  double mast_deg, rotor_speed, flap_deg;
  double power[2];     // of the engines at their shafts, W
  double rotor_power;  // of both rotors, W
  bool is_governed;    // else the rotors keep their speed, whatever they take
  int engines_running;
  double power_allowed;  // of one engine, take-off power here, W
  double weight_on_wheels;
  double wanted_height;  // m; not a number where none is held
  bool height_settles;   // the aircraft has been there
  Instruments<double> readings;
  std::vector<double> airframe;  // FlightStart::outputs
};

class ScriptFlight {
 public:
  // Throws UsageError or std::runtime_error when the flight cannot begin.
  // A feedback law adds to what the pilot does; it counts from the trim in which the flight begins.
  ScriptFlight(const FlightScript& script, const FlightStart& start, const Feedback& feedback = {});
  ~ScriptFlight();

  const FlightMoment& now() const;
  // On to the next moment; false at the end and where the flight fails.
  bool step();
  Status status() const;
  // "at 12.5 s: u out of range"; of a flight that failed.
  std::string fault() const;

  // What is flown now, for linear models.
  const Configuration<double>& configuration() const;
  const SystemFlight<double>& systems() const;
  const FeedbackFlight& loop() const;
  double azimuth() const;
  // Commands that the aircraft did not obey or that had no effect, and controls that a stop held back, a line each:
  // "gear up at 12 s: ignored, ...".
  std::vector<std::string> remarks() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace tiltrotor::cli
