// Markers of a plot.
#pragma once

#include <string>

#include "plot/plot.hpp"

namespace tiltrotor::plot {

// A marker of half width `size` at a point of the drawing; a browser shows `tip` over it.
std::string marker_svg(Marker marker, double x, double y, double size, const std::string& color, bool filled,
                       const std::string& tip);

}  // namespace tiltrotor::plot
