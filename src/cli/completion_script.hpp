// What a shell offers after `tiltrotor`, from the tables that --help prints.
#pragma once

#include <string>
#include <vector>

#include "cli/command.hpp"

namespace tiltrotor::cli {

// Words that an option's value may be, as its help lists them, "table, csv or json (csv)" or "none; rigid: the 8 ..";
// or the names of outputs, columns, inputs and parameters that it takes; none where it is something else.
std::vector<std::string> words_of_value(const std::string& command, const Option& option);

// A script to source in bash; zsh runs it under its bashcompinit.
std::string bash_completion(const std::vector<Command>& commands);
std::string zsh_completion(const std::vector<Command>& commands);

}  // namespace tiltrotor::cli
