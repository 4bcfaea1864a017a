// Help of the program and of one command.
#pragma once

#include <string>
#include <vector>

#include "cli/command.hpp"

namespace tiltrotor::cli {

std::string general_help(const std::vector<Command>& commands);
std::string command_help(const Command& command);

}  // namespace tiltrotor::cli
