#include "cli/script_commands.hpp"

#include <algorithm>
#include <cmath>

#include "cli/arguments.hpp"
#include "cli/flight_options.hpp"
#include "cli/flight_range.hpp"
#include "cli/units.hpp"
#include "text/number.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/airframe/airflow.hpp"
#include "tiltrotor/model/variables/control_range.hpp"
#include "tiltrotor/systems/drive.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double kDegree = kRadPerDeg<double>;

// What the language allows where the aircraft has no limit of its own.
constexpr double kMostClimb = 20, kMostSink = 5, kLeastSink = 0.1;  // m/s
constexpr double kLeastAcceleration = 0.1, kMostAcceleration = 5;   // m/s^2
constexpr double kMostTurn = 60 * kDegree;                          // rad/s
constexpr double kLeastTime = 0.01, kMostTime = 600;                // s
constexpr double kMostSeed = 2147483647;

const std::vector<ScriptUnit> kMastUnits = {{"deg", 1}};  // the model has them in deg
const std::vector<ScriptUnit> kAngle = {{"deg", kDegree}, {"rad", 1}};
const std::vector<ScriptUnit> kSpin = {{"rpm", kRpm}, {"rad/s", 1}};
const std::vector<ScriptUnit> kVelocity = {{"m/s", 1}, {"kt", kKnot<double>}};
const std::vector<ScriptUnit> kAcceleration = {{"m/s2", 1}};
const std::vector<ScriptUnit> kVertical = {{"m/s", 1}, {"ft/min", kFoot / 60}};
const std::vector<ScriptUnit> kLength = {{"m", 1}, {"ft", kFoot}};
const std::vector<ScriptUnit> kTurning = {{"deg/s", kDegree}, {"rad/s", 1}};
const std::vector<ScriptUnit> kTime = {{"s", 1}};
const std::vector<ScriptUnit> kInches = {{"in", 1}};
const std::vector<ScriptUnit> kPart = {{"", 1}};

ScriptArgument number(const char* name, const std::vector<ScriptUnit>& units, double low, double high) {
  return {ScriptArgument::Kind::number, name, units, low, high, {}};
}
ScriptArgument number(const char* name, const std::vector<ScriptUnit>& units, const Bounds<double>& range) {
  return number(name, units, range.low, range.high);
}
ScriptArgument whole(const char* name, double low, double high) {
  return {ScriptArgument::Kind::whole, name, kPart, low, high, {}};
}
ScriptArgument word(const char* name, const std::vector<std::string>& words) {
  return {ScriptArgument::Kind::word, name, {}, 0, 0, words};
}
ScriptArgument optional(ScriptArgument argument) {
  argument.is_optional = true;
  return argument;
}

// The pilot's inputs: where they stand from now on, and for a while beside where they stand.
struct Inceptor {
  const char* name;   // beside step and doublet
  const char* place;  // alone
  int control;
  const std::vector<ScriptUnit>& units;
};
const Inceptor kScriptInceptors[] = {
    {"long", "stick long", kControlIndex.long_stick, kInches},
    {"lat", "stick lat", kControlIndex.lat_stick, kInches},
    {"pedal", "pedal", kControlIndex.pedal, kInches},
    {"collective", "collective", kControlIndex.collective, kAngle},
};

void add_inceptors(std::vector<ScriptRule>& rules) {
  for (const Inceptor& i : kScriptInceptors)
    rules.push_back({i.place,
                     ScriptCommand::inceptor,
                     {number("PLACE", i.units, control_range(aircraft_data<double>(), i.control))},
                     "stays there, out of the pilot's hands until he holds a loop that needs it",
                     "0.5",
                     i.control});
  const ScriptArgument duration = number("DURATION", kTime, kLeastTime, kMostTime);
  const struct {
    const char* name;
    ScriptCommand command;
    const char* does;
  } signals[] = {{"step ", ScriptCommand::step, "adds so much for so long, up to the stops"},
                 {"doublet ", ScriptCommand::doublet,
                  "adds and takes away so much, half the time each, up to the stops"}};
  for (const auto& signal : signals)
    for (const Inceptor& i : kScriptInceptors) {
      const double most = largest_amplitude(i.control);
      rules.push_back({std::string(signal.name) + i.name,
                       signal.command,
                       {number("AMOUNT", i.units, -most, most), duration},
                       signal.does,
                       "0.5 2",
                       i.control});
    }
}

std::vector<ScriptRule> make_rules() {
  using C = ScriptCommand;
  const Aircraft<double>& aircraft = aircraft_data<double>();
  const LimitTables<double>& limits = aircraft.limits;
  const double top = limits.altitude.high, gust = limits.gust, wind = limits.wind;
  std::vector<ScriptRule> rules = {
      {"mast", C::mast, {number("ANGLE", kMastUnits, limits.mast_deg)}, "masts convert to it", "30"},
      {"flap", C::flap, {number("ANGLE", kMastUnits, limits.flap_deg)}, "flaps run to it", "20"},
      {"rotor",
       C::rotor_speed,
       {number("SPEED", kSpin, limits.rotor_speed)},
       "speed the governor holds",
       "517"},
      {"throttle",
       C::throttle,
       {number("RIGHT", kPart, 0, kMostThrottle<double>),
        optional(number("LEFT", kPart, 0, kMostThrottle<double>))},
       "part of take-off power of each engine, or of both; above 1 contingency power",
       "0.5"},
      {"hold speed",
       C::hold_speed,
       {number("SPEED", kVelocity, 0, limits.speed),
        optional(number("ACCELERATION", kAcceleration, kLeastAcceleration, kMostAcceleration))},
       "over the ground when slow, through the air from 30 m/s on; he gets there at 1.5 m/s2",
       "80kt 2"},
      {"hold height",
       C::hold_height,
       {number("HEIGHT", kLength, 0, top), optional(number("CLIMB", kVertical, kLeastSink, kMostClimb))},
       "above the ground; he gets there at 6 m/s",
       "30 3"},
      {"hold climb",
       C::hold_climb,
       {number("RATE", kVertical, -kMostClimb, kMostClimb)},
       "up is positive",
       "2"},
      {"hold heading",
       C::hold_heading,
       {number("ANGLE", kAngle, -kPi<double> * 2, kPi<double> * 2)},
       "turns there the short way",
       "90"},
      {"hold track",
       C::hold_track,
       {number("ANGLE", kAngle, -kPi<double> * 2, kPi<double> * 2)},
       "along the line through where he is, wind or not",
       "90"},
      {"hold position", C::hold_position, {}, "over where he is; instead of a speed", ""},
      {"turn",
       C::turn,
       {number("RATE", kTurning, -kMostTurn, kMostTurn)},
       "right is positive; he turns by at most 12 deg/s and 20 deg of bank",
       "3"},
      {"release",
       C::release,
       {word("LOOP", {"speed", "height", "heading", "position", "all"})},
       "the pilot no longer looks after it (height: climb too; heading: turn and track too)",
       "height"},
  };
  add_inceptors(rules);
  const std::vector<ScriptRule> rest = {
      {"series",
       C::series,
       {{ScriptArgument::Kind::file, "FILE", {}, 0, 0, {}}, optional(word("BETWEEN", {"linear", "held"}))},
       "inputs from a CSV file, see below",
       "inputs.csv held"},
      {"scas", C::scas, {word("STATE", {"on", "off"})}, "stability and control augmentation", "on"},
      {"governor",
       C::governor,
       {word("KIND", {"off", "ideal", "pi"})},
       "of the rotor speed; on the wheels throttles hold it, and pi waits",
       "pi"},
      {"interconnect",
       C::interconnect,
       {word("SHAFT", {"rigid", "twists"})},
       "between the rotors, with governor pi",
       "twists"},
      {"gear",
       C::gear,
       {word("PLACE", {"up", "down"})},
       "landing gear, on its way for " + number_text(aircraft.gear.transit, 3) +
           " s; up is ignored with weight on the wheels",
       "up"},
      {"brakes", C::brakes, {number("PART", kPart, 0, 1)}, "part of full braking", "1"},
      {"engine",
       C::engine,
       {whole("NUMBER", 1, aircraft.controls.engines), word("EVENT", {"fail", "restart"})},
       "1 is the right one",
       "1 fail"},
      {"gust",
       C::gust,
       {number("U", kVelocity, -gust, gust), number("V", kVelocity, -gust, gust),
        number("W", kVelocity, -gust, gust), number("DURATION", kTime, kLeastTime, kMostTime)},
       "1-cosine, along the body's axes: forward, right, down",
       "0 0 -5 4"},
      {"wind",
       C::wind,
       {number("NORTH", kVelocity, -wind, wind), number("EAST", kVelocity, -wind, wind),
        number("DOWN", kVelocity, -wind, wind)},
       "velocity of the air over the ground",
       "-5 0 0"},
      {"shear",
       C::shear,
       {word("KIND", {"none", "terminal", "other"})},
       "the wind is that 20 ft above the ground and grows with height (MIL-F-8785C)",
       "terminal"},
      {"turbulence",
       C::turbulence,
       {number("W20", kVelocity, 0, gust), optional(whole("SEED", 0, kMostSeed))},
       "wind at 20 ft that sets its strength (15, 30, 45 kt: light, moderate, severe); 0 ends it",
       "30kt 7"},
      {"land",
       C::land,
       {number("RATE", kVertical, kLeastSink, kMostSink)},
       "sinks so fast until on the ground, then takes the thrust off",
       "0.5"},
      {"spool", C::spool, {}, "rotors from where they turn to the speed of helicopter mode", ""},
      {"end", C::end, {}, "of the flight; nothing follows", ""},
  };
  rules.insert(rules.end(), rest.begin(), rest.end());
  return rules;
}

// In a unit, rounded inward to three decimals, so that what is shown is allowed.
double shown(double bound, double size, bool is_low) {
  constexpr double decimals = 1e3, rounding = 1e-9;
  const double exact = given_as(bound, size), steps = exact * decimals;
  if (std::fabs(steps - std::round(steps)) < rounding * std::fmax(1, std::fabs(steps)))
    return std::round(steps) / decimals;
  return (is_low ? std::ceil(steps) : std::floor(steps)) / decimals;
}

}  // namespace

const std::vector<ScriptRule>& script_rules() {
  static const std::vector<ScriptRule> rules = make_rules();
  return rules;
}

std::string range_text(const ScriptArgument& argument, std::size_t unit) {
  if (argument.kind == ScriptArgument::Kind::word) return one_of(argument.words);
  if (argument.kind == ScriptArgument::Kind::file) return "the name of a file";
  const ScriptUnit& in = argument.units[unit];
  return text::range_text(
      {shown(argument.low, in.size, true), shown(argument.high, in.size, false), in.name});
}

std::string usage_text(const ScriptRule& rule) {
  std::string usage = rule.name;
  for (const ScriptArgument& a : rule.arguments) usage += a.is_optional ? " [" + a.name + "]" : " " + a.name;
  return usage;
}

const std::string& script_help() {
  static const std::string help = [] {
    std::string all =
        "A script has a command a line: TIME COMMAND [ARGUMENTS], the time in s, never going back; # begins a comment.\n"
        "The first unit that is named is that of a number without one: `hold speed 40` and `hold speed 80kt`.\n\n";
    constexpr std::size_t widest = 36;
    for (const ScriptRule& rule : script_rules()) {
      const std::string usage = usage_text(rule);
      all += "  " + usage + std::string(usage.size() < widest ? widest - usage.size() : 1, ' ') + rule.does +
             "\n";
      for (const ScriptArgument& a : rule.arguments) {
        if (a.kind == ScriptArgument::Kind::file) continue;
        all += std::string(widest + 4, ' ') + a.name + ": " + range_text(a);
        for (std::size_t unit = 1; unit < a.units.size(); ++unit)
          all += std::string(" or ") + a.units[unit].name;
        all += "\n";
      }
    }
    all +=
        "\nA series is a CSV file with a column time_s, from the time of its line on, and one for every input it moves: "
        "the\ncontrols as `trim` prints them (long_stick_in: from the rear stop; long_stick_from_neutral_in does as well), or "
        "under\nthe names of the model in its units (long_stick in, from neutral; collective rad; gust_u m/s), throttle_1 and\n"
        "throttle_2. Between its rows inputs are interpolated (linear) or stay (held); after the last one they stay.\n";
    return all;
  }();
  return help;
}

}  // namespace tiltrotor::cli
