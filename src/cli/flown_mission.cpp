#include "cli/flown_mission.hpp"

#include <cmath>
#include <stdexcept>

#include "cli/flight_figures.hpp"
#include "cli/flight_modes.hpp"
#include "cli/flight_summary.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace tiltrotor::cli {

namespace {

constexpr const char* kMission =
#include "mission.inc"
    ;
constexpr const char* kName = "src/examples/mission.txt";
constexpr double kStep = 0.01, kRowEvery = 0.5, kModesEvery = 5;  // s

FlightStart on_the_ground() {
  FlightStart start{};
  start.setup = flight_setup(aircraft_data<double>(), 0.0);
  start.setup.options.grid = BladeGrid::realtime;
  start.setup.options.position_states = true;
  start.on_ground = true;
  start.dt = kStep;
  return start;
}

}  // namespace

study::FlownMission fly_mission() {
  const FlightScript script = read_flight_script_text(kName, kMission);
  ScriptFlight flight(script, on_the_ground());
  study::FlownMission flown;
  flown.name = kName;
  FlightFigures figures;
  FlightSummary summary;
  FlightModes models(kInceptors);
  const long row_steps = std::lround(kRowEvery / kStep), model_steps = std::lround(kModesEvery / kStep);
  bool goes_on = true;
  for (long step = 0; goes_on; ++step) {
    summary.add(flight.now());
    if (step % row_steps == 0) figures.add(flight.now());
    if (step % model_steps == 0) {
      ++flown.models;
      Status status = models.linearize(flight);
      if (status == Status::ok) status = models.find();
      if (status == Status::ok) figures.add_modes(flight.now().time, models.found());
      flown.models_without_modes += status != Status::ok;
    }
    goes_on = flight.step();
  }
  if (flight.status() != Status::ok) throw std::runtime_error("mission: " + flight.fault());
  for (const std::string& line : flight.remarks()) summary.add(line);
  flown.motion = figures.motion();
  flown.modes = figures.modes();
  flown.height_error = summary.height_error();
  flown.power_part = summary.power_part();
  flown.touch_down = summary.touch_down();
  flown.summary = summary.text();
  return flown;
}

}  // namespace tiltrotor::cli
