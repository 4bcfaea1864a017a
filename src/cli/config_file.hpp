// Options kept in a file, for --config.
#pragma once

#include <string>
#include <vector>

#include "cli/arguments.hpp"

namespace tiltrotor::cli {

Option config_option();

// An option as it stands in a file: `speed = 80`, `speed 80`, or `validate` alone.
struct ConfigLine {
  std::string name;  // with its dashes
  std::string value;
  bool has_value;
  std::string where;  // "FILE:LINE"
};

// Lines without content, and what follows a '#' at the beginning or behind a blank, do not count. Throws UsageError
// "FILE:LINE: ..." for what is no option.
std::vector<ConfigLine> read_config(const std::string& path);

}  // namespace tiltrotor::cli
