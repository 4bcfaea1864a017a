// Published numbers laid over the curves: tables/<aircraft>/published/*.csv, compiled into the program.
#pragma once

#include <string>

#include "text/table.hpp"

namespace tiltrotor::study {

using text::Table;

// Whether there are any of the aircraft that is compiled in.
bool has_reference_points();

// The set of that name (file name without .csv). Throws std::logic_error when there is none.
Table reference_points(const std::string& name);

}  // namespace tiltrotor::study
