// The variables of the FMU: one table for the description and for what answers.
//
//   time                         0
//   states, their derivatives    1000 + place in tr_state.x, 2000 + place
//   continuous inputs            3000 + place in TR_INPUTS: controls, commands of systems
//   outputs                      4000 + place, below
//   settings                     5000 + Setting: parameters, and inputs that jump
//   event indicators             6000 + wheel: nose, right, left
#pragma once

#include <cstdint>

#include "tiltrotor/tiltrotor.h"

namespace tiltrotor_fmu {

enum Setting {
  // what tr_setup says
  kMast,
  kFlap,
  kRotorSpeed,
  kMass,
  kCgStation,
  kAltitude,
  kGrid,
  kTables,
  kConing,
  // the flight it begins in
  kTrim,
  kTrimSpeed,
  kTrimClimb,
  kTrimTurnRate,
  kTrimSideslip,
  // air and ground
  kEnvironment,
  kTemperatureOffset,
  kPressureRatio,
  kGroundDown,
  // switches of tr_systems
  kGovernor,
  kConversion,
  kEngines,
  kActuators,
  kScas,
  kGear,
  kGroundEffect,
  kWindShear,
  kTurbulence,
  kInterconnect,
  kTurbulenceSeed,
  kTurbulenceW20,
  kLongestStep,
  // inputs that jump
  kWindNorth,
  kWindEast,
  kWindDown,
  kBrakeRight,
  kBrakeLeft,
  kGearDown,
  kEngineFailedRight,
  kEngineFailedLeft,
  kSettings
};
constexpr int kFirstInputSetting = kWindNorth;

// The numbers of tr_outputs after time_s, then what follows from them, from states and from the configuration.
constexpr int kOutputNx = TR_OUTPUTS, kOutputNy = kOutputNx + 1, kOutputNz = kOutputNx + 2,
              kOutputFlightPath = kOutputNx + 3, kOutputMast = kOutputNx + 4, kOutputFlap = kOutputNx + 5,
              kOutputRotorSpeed = kOutputNx + 6;
// Of the components, which the C interface does not have: angles of attack of wing and horizontal tail; force x y z and moment
// x y z of each component in the order of the library, and of all.
constexpr int kLoadedComponents = 14, kNumbersOfLoads = 6;
constexpr int kOutputWingAngle = kOutputNx + 7, kOutputTailAngle = kOutputNx + 8,
              kOutputLoads = kOutputNx + 9, kFirstOfComponents = kOutputWingAngle,
              kOutputJets = kOutputLoads + 12 * kNumbersOfLoads,
              kOutputs = kOutputLoads + kLoadedComponents * kNumbersOfLoads;
constexpr int kWheels = 3;

// Continuous states of Model Exchange: the first of tr_state.x. Those after them belong to the augmentation and the
// turbulence, which move on between steps of tr_step alone: Co-Simulation.
constexpr int kContinuousStates = TR_SERIES_ACTUATORS;

enum class Type { float64, boolean, enumeration, uint32 };
enum class Role { time, state, rate, input, output, setting, indicator, none };
constexpr std::uint32_t kFirst[] = {0, 1000, 2000, 3000, 4000, 5000, 6000};
constexpr int kCount[] = {1, TR_STATES, kContinuousStates, TR_INPUTS, kOutputs, kSettings, kWheels};

struct Place {
  Role role;
  int index;
};
/// Of a value reference; Role::none when there is no such variable.
Place place_of(std::uint32_t reference);
inline std::uint32_t reference_of(Role role, int index) {
  return kFirst[static_cast<int>(role)] + static_cast<std::uint32_t>(index);
}

struct SettingFacts {
  const char *name, *unit;
  Type type;
  double start;       // of what the aircraft says it is 0 here
  const char* field;  // whose range it has, as tr_get_range knows it; nullptr: that of least and most
  const char* text;
  double least = 0, most = 0;
};
const SettingFacts& facts_of(int setting);

struct OutputFacts {
  const char *name, *unit;
  const char* text;
};
const OutputFacts& output_facts(int output);

Type type_of(Place place);
const char* name_of(Place place);  // without what stands before it
const char* unit_of(Place place);  // of a rate: that of its state
const char* text_of(Place place);  // what it is, in a few words; of a rate and of time nothing

/// As the description has it: "input.pedal", "der(state.u)".
struct FullName {
  char text[64];
};
FullName full_name(Place place);

/// What the library accepts, in unit_of(place); of what is not set all numbers.
struct Range {
  double low, high;
  bool holds(double value) const { return value >= low && value <= high; }
};
Range range_of(Place place);

/// Of the size that a variable of this unit usually has.
double nominal_of(const char* unit);
/// Of outputs from mast to rotor speed: the state it is where its system is on.
int state_of_output(int output);
/// Whether a rate, an output or an event indicator may change with a state or an input.
bool depends(Place unknown, Place known);

/// Names this library, its aircraft and this table: "{tiltrotor-...}".
void instantiation_token(char (&token)[64]);

/// Whole degrees stay whole: 90 deg is a limit.
double degrees(double rad);
constexpr double kRadians = 0.017453292519943295;  // of a degree
constexpr double kGravity = 9.80665;               // m/s^2, of load factors

}  // namespace tiltrotor_fmu
