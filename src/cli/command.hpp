// A command of the program: what its help says and what it does.
#pragma once

#include "cli/arguments.hpp"

namespace tiltrotor::cli {

struct Command {
  const char* name;
  const char* summary;      // one line of the general help
  const char* description;  // paragraphs of its own help, each line ends in '\n'
  const char* example;      // a command line that works
  OptionList options;
  int (*run)(const Arguments& arguments);  // returns exit_success or another of errors.hpp
};

// In the order of the general help. Each is defined in command_<name>.cpp.
Command trim_command();
Command linearize_command();
Command modes_command();
Command bode_command();
Command qualities_command();
Command sensitivity_command();
Command interpolation_command();
Command qlpv_command();
Command performance_command();
Command respond_command();
Command fly_command();
Command derivative_command();
Command loads_command();
Command rotor_command();
Command report_command();
Command conventions_command();
Command completion_command();
Command version_command();

std::vector<Command> all_commands();

}  // namespace tiltrotor::cli
