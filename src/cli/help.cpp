#include "cli/help.hpp"

#include "cli/model_options.hpp"

namespace tiltrotor::cli {

std::string general_help(const std::vector<Command>& commands) {
  constexpr std::size_t summary_column = 15;
  std::string text =
      "usage: tiltrotor COMMAND [options]\n"
      "Flight dynamics of the XV-15 tilt-rotor: trim, exact linear models, modes, time responses.\n\n";
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
         "Exit status: 0 success, 1 a case failed (its row or a message says why), 2 bad usage.\n"
         "\nSwitches of the model for --option NAME=VALUE, the default first:\n" +
         model_options_help() + "\nExample: tiltrotor trim --mast 0 --speed 0:5:50 --format csv\n";
}

std::string command_help(const Command& command) {
  const std::string name = command.name;
  std::string text =
      "usage: tiltrotor " + name + (command.options.empty() ? "" : " [options]") + "\n" + command.description;
  if (!command.options.empty()) text += "\n" + options_help(command.options);
  return text + "\nExample: " + command.example + "\n";
}

}  // namespace tiltrotor::cli
