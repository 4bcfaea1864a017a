// What stands between the axes of a plot: filled cells and bands, lines and markers.
#pragma once

#include <string>

#include "plot/axes.hpp"

namespace tiltrotor::plot {

std::string draw_cells(const Cells& cells, const Layout& at);
std::string draw_band(const Band& band, const Layout& at);
std::string draw_line(const Series& s, const Layout& at);
std::string draw_markers(const Series& s, const Layout& at);  // those inside the axes

}  // namespace tiltrotor::plot
