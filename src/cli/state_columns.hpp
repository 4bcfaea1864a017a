// Names of states, controls and settings in the columns of files.
//
// A state or control may stand in SI units under the name of the model (theta, th75_rad) or as the program
// prints it (pitch_deg, collective75_deg). What trim and respond print besides follows from these and is not
// read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tiltrotor/model/setup/configuration.hpp"
#include "tiltrotor/model/variables/controls.hpp"
#include "tiltrotor/model/variables/state.hpp"

namespace tiltrotor::cli {

// What a column fills; the model's number is (number - zero) * unit.
struct Target {
  enum class Kind : unsigned char {
    derived,
    rate,
    name,
    model,
    mast,
    altitude,
    flap,
    rotor_speed,
    mass,
    sl_cg,
    state,
    control
  } kind;
  int index = 0;  // place in kStateVariables or kControlVariables
  double unit = 1;
  double zero = 0;
  const char* unit_name = "";
  double size = 1;  // of the column's unit, in that of the name the program prints

  double read(double number) const { return (number - zero) * unit; }
  double shown(double value) const { return value / unit + zero; }
};

std::optional<Target> find_target(const std::string& column);

// Every name that find_target() knows, for messages.
std::vector<std::string> known_columns();

// Names under which a state or control may stand: that of the model first.
std::vector<std::string> state_columns(int state);
std::vector<std::string> control_columns(int control);

// States that a row must hold: the first 24, and the others that are alive.
std::vector<int> needed_states(const Options& options);

// Columns that make rows with `columns` readable again: the states, settings and, where wanted, the controls
// beyond the inceptors that are not among them.
std::vector<std::string> completing_columns(const std::vector<std::string>& columns, const Options& options,
                                            bool with_increments);
// The number of such a column, none of settings.
double completing_value(const std::string& column, const State<double>& x, const Controls<double>& u);

// A setting, in the unit of its column.
bool is_setting(const std::string& column);
double setting_value(const std::string& column, const FlightSetup<double>& setup);

}  // namespace tiltrotor::cli
