// Least of a convex quadratic form within bounds.
#pragma once

#include <vector>

#include "tablegen/spline.hpp"

namespace tablegen {

// x within low..high with least x'Ax/2 + sum of pull (x - centre)^2 / 2, A positive semidefinite. Newton steps over the
// unknowns that no bound holds, bent at the bounds (Bertsekas 1982).
std::vector<double> bounded_least(const SquareMatrix& a, const std::vector<double>& centre,
                                  const std::vector<double>& half_width, const std::vector<double>& pull);

}  // namespace tablegen
