// Columns that `trim` prints.
#pragma once

#include <string>
#include <vector>

namespace tiltrotor::cli {

// Without those that complete the state (state_columns.hpp).
std::vector<std::string> trim_columns();

}  // namespace tiltrotor::cli
