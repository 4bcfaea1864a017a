#include "plot/marks.hpp"

#include <algorithm>

#include "plot/drawing.hpp"
#include "plot/marker.hpp"
#include "plot/svg.hpp"

namespace tiltrotor::plot {

// One path for each colour.
std::string draw_cells(const Cells& cells, const Layout& at) {
  std::vector<std::string> path(cells.color.size());
  const std::size_t rows = cells.y_edge.empty() ? 0 : cells.y_edge.size() - 1;
  for (std::size_t i = 0; i + 1 < cells.x_edge.size(); ++i) {
    for (std::size_t j = 0; j < rows; ++j) {
      const double value = cells.value[i * rows + j];
      if (!std::isfinite(value)) continue;
      const std::size_t color = static_cast<std::size_t>(
          std::upper_bound(cells.level.begin(), cells.level.end(), value) - cells.level.begin());
      const double x = at.px(cells.x_edge[i]);
      const double y = at.py(cells.y_edge[j]);
      path[color] += "M" + coordinate(x) + " " + coordinate(y) + "H" +
                     coordinate(at.px(cells.x_edge[i + 1])) + "V" + coordinate(at.py(cells.y_edge[j + 1])) +
                     "H" + coordinate(x) + "z";
    }
  }
  std::string out;
  for (std::size_t k = 0; k < path.size(); ++k) {
    if (path[k].empty()) continue;
    // A stroke of the same colour closes the hairlines between neighbours.
    out += "<path" + attribute("d", path[k]) + attribute("fill", cells.color[k]) +
           attribute("stroke", cells.color[k]) + attribute("stroke-width", 0.4) + "/>\n";
  }
  return out;
}

// Forth along the upper edge and back along the lower one.
std::string draw_band(const Band& band, const Layout& at) {
  std::string path;
  std::string back;
  const auto close = [&] {
    if (!back.empty()) path += back + "z";
    back.clear();
  };
  for (std::size_t i = 0; i < band.x.size(); ++i) {
    const double x = at.px(band.x[i]);
    const double low = at.py(band.low[i]);
    const double high = at.py(band.high[i]);
    if (!std::isfinite(x) || !std::isfinite(low) || !std::isfinite(high)) {
      close();
      continue;
    }
    path += (back.empty() ? "M" : "L") + coordinate(x) + " " + coordinate(high);
    back.insert(0, "L" + coordinate(x) + " " + coordinate(low));
  }
  close();
  if (path.empty()) return "";
  return "<path class=\"band\"" + attribute("d", path) + attribute("fill", band.color) +
         attribute("fill-opacity", 0.2) + "/>\n";
}

std::string draw_line(const Series& s, const Layout& at) {
  if (s.line == Line::none) return "";
  std::string path;
  bool pen_down = false;
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    const double x = at.px(s.x[i]);
    const double y = at.py(s.y[i]);
    const bool finite = std::isfinite(x) && std::isfinite(y);
    if (finite) path += (pen_down ? "L" : "M") + coordinate(x) + " " + coordinate(y);
    pen_down = finite;
  }
  if (path.empty()) return "";
  return "<path" + attribute("d", path) + " fill=\"none\"" + attribute("stroke", s.color) +
         attribute("stroke-width", s.width) + dash_of(s.line) + " stroke-linejoin=\"round\"/>\n";
}

std::string draw_markers(const Series& s, const Layout& at) {
  std::string out;
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    if (!at.inside(s.x[i], s.y[i])) continue;
    out += marker_svg(s.marker, at.px(s.x[i]), at.py(s.y[i]), s.marker_size, s.color, s.filled,
                      i < s.tip.size() ? s.tip[i] : "");
  }
  return out;
}

}  // namespace tiltrotor::plot
