// Plots one above the other in one drawing.
#pragma once

#include <string>
#include <vector>

#include "plot/plot.hpp"

namespace tiltrotor::plot {

std::string stacked_svg(const std::string& title, const std::vector<Plot>& plots);

}  // namespace tiltrotor::plot
