// The axes of a plot: where its values stand on the drawing, grid, numbers and zero lines.
#pragma once

#include <string>

#include "plot/plot.hpp"
#include "plot/ticks.hpp"

namespace tiltrotor::plot {

// Where things stand on the drawing.
struct Layout {
  Scale x, y;
  double left, top, right, bottom;
  double height;
  double px(double value) const { return left + (right - left) * fraction(x, value); }
  double py(double value) const { return bottom - (bottom - top) * fraction(y, value); }
  bool inside(double vx, double vy) const {
    const double a = fraction(x, vx);
    const double b = fraction(y, vy);
    return a >= -1e-9 && a <= 1 + 1e-9 && b >= -1e-9 && b <= 1 + 1e-9;  // false for NaN
  }
};

// Axes with their upper edge at `top`, wide enough for the data and the numbers beside them.
Layout layout(const Plot& plot, double top);

std::string draw_axes(const Plot& plot, const Layout& at);
std::string draw_zero_lines(const Plot& plot, const Layout& at);

}  // namespace tiltrotor::plot
