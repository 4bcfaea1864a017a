// What `tiltrotor sensitivity` can change: settings of the flight, numbers and tables of the aircraft, gains of the
// augmentation; each with a change that is usual for it.
#pragma once

#include <string>
#include <vector>

#include "cli/along_aircraft.hpp"
#include "cli/changed_aircraft.hpp"
#include "tiltrotor/analysis/linear/configuration_sensitivity.hpp"
#include "tiltrotor/analysis/trim/steady_flight.hpp"

namespace tiltrotor::cli {

enum class ParameterKind : unsigned char {
  flight,         // what the trim holds
  setting,        // of the configuration
  consequence,    // what follows from the setting; with systems by its `change`, or of the air
  aircraft,       // a number or table of it
  scas_gain,      // of the augmentation, where it is on
  governor_gain,  // of one that governs the rotor speed
};

// Changes an aircraft by so many units; nullptr: nothing does. Of numbers with a slope, and of plain ones, as a new aircraft.
struct AircraftChange {
  void (*along)(AlongAircraft& aircraft, Along by);
  void (*anew)(ChangedAircraft& aircraft, double by);
};

struct SensitivityParameter {
  const char* name;
  double amount;     // the usual change
  const char* unit;  // of the amount; "%" of the value
  ParameterKind kind;
  ConfigurationParameter parameter;               // `count`: none
  double (*in_si)(const Configuration<double>&);  // a unit of the amount in that of the parameter
  AircraftChange change;
  double SteadyFlight<double>::*held = nullptr;  // of a flight: velocity or body rates are proportional to it
};

const std::vector<SensitivityParameter>& sensitivity_parameters();

// What is part of the linear model besides the airframe.
struct SensitivitySystems {
  Governor governor;
  bool scas;

  bool any() const { return scas || governor != Governor::off; }
};

// What moves a quantity that a target of a trim lets go, by one unit of it in SI (deg and rpm: rad, rad/s).
const SensitivityParameter& freed_parameter(const std::string& freed);

// Whether the parameter can be changed there.
bool acts(const SensitivityParameter& parameter, const SensitivitySystems& systems);

// "all" that act, or names with commas between; `freed`, what targets let go, follows the others and is none of them.
// Throws UsageError "<where>: ..." for an unknown one, one that follows, or one that does not act.
std::vector<const SensitivityParameter*> chosen_parameters(const std::string& text, const std::string& where,
                                                           const SensitivitySystems& systems,
                                                           const std::vector<std::string>& freed = {});

}  // namespace tiltrotor::cli
