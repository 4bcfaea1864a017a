// What `tiltrotor sensitivity` can change: settings of the flight, numbers and tables of the aircraft, gains of the
// augmentation; each with a change that is usual for it.
#pragma once

#include <string>
#include <vector>

#include "cli/changed_aircraft.hpp"
#include "tiltrotor/analysis/linear/configuration_sensitivity.hpp"
#include "tiltrotor/analysis/trim/steady_flight.hpp"

namespace tiltrotor::cli {

enum class ParameterKind : unsigned char {
  flight,         // what the trim holds: exact
  setting,        // of the configuration: exact, and moves with systems too
  consequence,    // what follows from the setting: exact; with systems by its `change`, or of the air
  aircraft,       // a number or table of it
  scas_gain,      // of the augmentation, where it is on
  governor_gain,  // of one that governs the rotor speed
};

struct SensitivityParameter {
  const char* name;
  double amount;     // the usual change
  const char* unit;  // of the amount; "%" of the value
  ParameterKind kind;
  ConfigurationParameter parameter;                      // `count`: none
  double (*in_si)(const Configuration<double>&);         // a unit of the amount in that of the parameter
  void (*change)(ChangedAircraft& aircraft, double by);  // by so many units; nullptr: none
  double SteadyFlight<double>::*held = nullptr;  // of a flight: velocity or body rates are proportional to it
};

const std::vector<SensitivityParameter>& sensitivity_parameters();

// What is part of the linear model besides the airframe.
struct SensitivitySystems {
  Governor governor;
  bool scas;

  bool any() const { return scas || governor != Governor::off; }
};

// Whether the parameter can be changed there.
bool acts(const SensitivityParameter& parameter, const SensitivitySystems& systems);

// "all" that act, or names with commas between. Throws UsageError "<where>: ..." for an unknown one, or one that does
// not act.
std::vector<const SensitivityParameter*> chosen_parameters(const std::string& text, const std::string& where,
                                                           const SensitivitySystems& systems);

}  // namespace tiltrotor::cli
