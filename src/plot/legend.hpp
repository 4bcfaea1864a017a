// The legend of a plot, in rows above its axes.
#pragma once

#include <string>
#include <vector>

#include "plot/plot.hpp"

namespace tiltrotor::plot {

struct LegendEntry {
  const Series* series;  // or null: a filled cell
  std::string color;
  std::string name;
  double x, y;
};

// Entries placed from `top` on; `bottom` is the lower edge of the last row.
std::vector<LegendEntry> legend(const Plot& plot, double top, double& bottom);

std::string draw_legend(const std::vector<LegendEntry>& entries);

}  // namespace tiltrotor::plot
