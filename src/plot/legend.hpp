// What a plot says above its axes: a bar of the colours of its cells, and a key of its markers and of the lines
// that have no name at their curve.
#pragma once

#include <string>
#include <vector>

#include "plot/plot.hpp"

namespace tiltrotor::plot {

struct KeyEntry {
  const Series* series;
  double x, y;
};

// Entries placed in rows from `top` on; `bottom` is the lower edge of the last row.
std::vector<KeyEntry> key(const std::vector<const Series*>& series, double width, double top, double& bottom);
std::string draw_key(const std::vector<KeyEntry>& entries);

// A block for each colour from `top` on, with the limits between them; empty without cells.
std::string draw_color_bar(const Cells& cells, double width, double top, double& bottom);

}  // namespace tiltrotor::plot
