// The commands of a flight script, one row each: what drives reading, help and tests.
#pragma once

#include <string>
#include <vector>

namespace tiltrotor::cli {

enum class ScriptCommand : unsigned char {
  mast,
  flap,
  rotor_speed,
  throttle,
  hold_speed,
  hold_height,
  hold_climb,
  hold_heading,
  hold_track,
  hold_position,
  turn,
  release,
  inceptor,  // ScriptRule::control says which
  step,
  doublet,
  series,
  scas,
  governor,
  interconnect,
  gear,
  brakes,
  engine,
  gust,
  wind,
  shear,
  turbulence,
  land,
  spool,
  end
};

struct ScriptUnit {
  const char* name;
  double size;  // of one, in the unit of the model
};

struct ScriptArgument {
  enum class Kind : unsigned char { number, whole, word, file } kind;
  std::string name;                // "ANGLE"
  std::vector<ScriptUnit> units;   // of a number; the first where none is written
  double low = 0, high = 0;        // in the unit of the model
  std::vector<std::string> words;  // the choices of a word
  bool is_optional = false;
};

struct ScriptRule {
  std::string name;  // one word or two
  ScriptCommand command;
  std::vector<ScriptArgument> arguments;
  std::string does;
  std::string example;  // its arguments
  int control = -1;     // place in kControlVariables
};

// Ranges are those of the aircraft.
const std::vector<ScriptRule>& script_rules();

// "0..90 deg" of a number, in the unit it is written in; "on or off" of a word.
std::string range_text(const ScriptArgument& argument, std::size_t unit = 0);

// "mast ANGLE"
std::string usage_text(const ScriptRule& rule);

// The language, for `tiltrotor fly --help`.
const std::string& script_help();

}  // namespace tiltrotor::cli
