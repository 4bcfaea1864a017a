// Names of lines at their curves: what a legend would have to be looked up for.
#pragma once

#include <vector>

#include "plot/axes.hpp"

namespace tiltrotor::plot {

struct CurveName {
  const Series* series;
  double x, y;  // where its text starts, on the base line
};

// Each name where it covers least of its own line and nothing else, inside the axes; a line whose name would
// cover others has none.
std::vector<CurveName> curve_names(const Plot& plot, const Layout& at);

}  // namespace tiltrotor::plot
