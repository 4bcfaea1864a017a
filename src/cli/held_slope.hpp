// How what a trim holds moves along a direction, exact: results of `trim` and outputs.
#pragma once

#include "cli/trimmed_flights.hpp"
#include "tiltrotor/math/differentiation/along.hpp"

namespace tiltrotor::cli {

// Slope of the quantity that `target` holds, in its unit, per unit of the direction along which configuration, state and
// controls of the trimmed flight move.
double held_slope(const TrimTarget& target, const TrimmedFlight& flight, const Configuration<Along>& c,
                  const State<Along>& x, const Controls<Along>& u);

}  // namespace tiltrotor::cli
