#include "cli/help.hpp"

#include <algorithm>

#include "cli/model_options.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace tiltrotor::cli {

namespace {

constexpr const char* switches_heading =
    "\nSwitches of the model for --option NAME=VALUE, the default first:\n";

}  // namespace

std::string general_help(const std::vector<Command>& commands) {
  constexpr std::size_t summary_column = 17;
  std::string text =
      "usage: tiltrotor COMMAND [options]\n"
      "Flight dynamics of a tilt-rotor: trim, exact linear models, modes, time responses.\n"
      "Aircraft " +
      std::string(aircraft_identity().name) + ": " + aircraft_identity().description + ".\n\n";
  for (const Command& command : commands) {
    std::string line = std::string("  ") + command.name;
    line.resize(summary_column, ' ');
    text += line + command.summary + "\n";
  }
  return text +
         "\n`tiltrotor COMMAND --help` explains a command. Results go to stdout, messages to stderr. Values "
         "may be given\n"
         "as --name VALUE or --name=VALUE; where several are allowed, as a list a,b,c or a range "
         "from:step:to.\n"
         "Exit status: 0 success, 1 a case failed (its row or a message says why) or the results could not "
         "be "
         "written\n"
         "(without a word when the reader of a pipe has left), 2 bad usage.\n" +
         switches_heading + model_options_help() +
         "\nExample: tiltrotor trim --mast 0 --speed 0:5:50 --format csv\n";
}

std::string command_help(const Command& command) {
  const std::string name = command.name;
  std::string text =
      "usage: tiltrotor " + name + (command.options.empty() ? "" : " [options]") + "\n" + command.description;
  if (!command.options.empty()) text += "\n" + options_help(command.options);
  const bool has_switches =
      std::any_of(command.options.begin(), command.options.end(),
                  [](const Option& option) { return option.name == std::string("--option"); });
  if (has_switches) text += switches_heading + model_options_help();
  return text + "\nExample: " + command.example + "\n";
}

}  // namespace tiltrotor::cli
