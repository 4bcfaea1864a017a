// Published numbers laid over the curves: tests/validation/*.csv, compiled into the program.
#pragma once

#include <string>

#include "report/table.hpp"

namespace tiltrotor::report {

// The set of that name (file name without .csv). Throws std::logic_error when there is none.
Table reference_points(const std::string& name);

}  // namespace tiltrotor::report
