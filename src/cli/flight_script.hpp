// A flight script: what happens when, read and checked as a whole before anything flies.
#pragma once

#include <string>
#include <vector>

#include "cli/input_series.hpp"
#include "cli/script_commands.hpp"

namespace tiltrotor::cli {

// A line. Numbers stand in the order of the command's arguments, in the unit of the model: masts and flaps in deg,
// other angles in rad, inceptors in in, speeds in m/s, rotor speed in rad/s. An optional argument that is not given is
// not counted.
struct ScriptEvent {
  double time;  // s
  ScriptCommand command;
  std::size_t line;
  int control = -1;       // of an inceptor, step or doublet: place in kControlVariables
  std::size_t count = 0;  // of the numbers given
  double number[4] = {};
  std::size_t word = 0;    // place among the choices of the command's word
  std::size_t series = 0;  // place in FlightScript::series
};

struct FlightScript {
  std::string path;
  std::vector<ScriptEvent> events;  // in order of time; the last is `end`
  std::vector<InputSeries> series;

  double duration() const { return events.back().time; }
  // "<file>:<line>", for what is found wrong later.
  std::string where(const ScriptEvent& event) const { return path + ":" + std::to_string(event.line); }
};

const ScriptRule& rule_of(const ScriptEvent& event);

// "-" is standard input; series are sought from the folder of the script. Throws UsageError "<file>:<line>: ...".
FlightScript read_flight_script(const std::string& path);
// Of a text that the program holds.
FlightScript read_flight_script_text(const std::string& name, const std::string& text);

}  // namespace tiltrotor::cli
