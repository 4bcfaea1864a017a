// A number that is not there: an empty cell of a table, a gap in a curve.
#pragma once

#include <limits>

namespace tiltrotor::study {

inline constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

}  // namespace tiltrotor::study
