// Every command, and the option that all share which have any.

#include "cli/command.hpp"
#include "cli/config_file.hpp"

namespace tiltrotor::cli {

std::vector<Command> all_commands() {
  std::vector<Command> commands = {trim_command(),          linearize_command(),  modes_command(),
                                   bode_command(),          qualities_command(),  sensitivity_command(),
                                   interpolation_command(), qlpv_command(),       performance_command(),
                                   respond_command(),       fly_command(),        derivative_command(),
                                   loads_command(),         rotor_command(),      report_command(),
                                   conventions_command(),   completion_command(), version_command()};
  for (Command& command : commands)
    if (!command.options.empty()) command.options.push_back(config_option());
  return commands;
}

}  // namespace tiltrotor::cli
