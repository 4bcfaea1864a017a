#include "plot/stack.hpp"

#include <algorithm>
#include <cstdlib>

#include "plot/svg.hpp"

namespace tiltrotor::plot {

namespace {

// Of the drawing's own box, `viewBox="0 0 WIDTH HEIGHT"`.
double height_of(const std::string& drawing, double width) {
  const std::string box = "viewBox=\"0 0 " + coordinate(width) + " ";
  const std::size_t place = drawing.find(box);
  return place == std::string::npos ? 0 : std::strtod(drawing.c_str() + place + box.size(), nullptr);
}

}  // namespace

std::string stacked_svg(const std::string& title, const std::vector<Plot>& plots) {
  constexpr std::size_t opening = 4;  // "<svg"
  std::string inner;
  double width = 0, height = 0;
  for (const Plot& plot : plots) {
    const std::string drawing = svg(plot);
    const double own = height_of(drawing, plot.width);
    inner += "<svg" + attribute("y", height) + attribute("width", plot.width) + attribute("height", own) +
             drawing.substr(opening);
    width = std::max(width, plot.width);
    height += own;
  }
  return open_svg(width, height, title) + inner + "</svg>\n";
}

}  // namespace tiltrotor::plot
