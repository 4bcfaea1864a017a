#include "plot/legend.hpp"

#include "plot/drawing.hpp"
#include "plot/marker.hpp"
#include "plot/svg.hpp"

namespace tiltrotor::plot {

namespace {

constexpr double kLegendRow = 19;
constexpr double kSwatch = 26;

}  // namespace

std::vector<LegendEntry> legend(const Plot& plot, double top, double& bottom) {
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i < plot.cells.name.size(); ++i) {
    entries.push_back({nullptr, plot.cells.color[i], plot.cells.name[i], 0, 0});
  }
  for (const Series& s : plot.series) {
    if (!s.name.empty()) entries.push_back({&s, s.color, s.name, 0, 0});
  }
  double x = kMargin;
  double y = top + kLegendRow / 2;
  for (LegendEntry& e : entries) {
    const double width = kSwatch + 6 + text_width(e.name, kFont) + 14;
    if (x > kMargin && x + width > plot.width) {
      x = kMargin;
      y += kLegendRow;
    }
    e.x = x;
    e.y = y;
    x += width;
  }
  bottom = entries.empty() ? top : y + kLegendRow / 2;
  return entries;
}

std::string draw_legend(const std::vector<LegendEntry>& entries) {
  std::string out;
  for (const LegendEntry& e : entries) {
    if (e.series == nullptr) {
      out += "<rect" + attribute("x", e.x + 6) + attribute("y", e.y - 6) + attribute("width", kSwatch - 8) +
             attribute("height", 12.0) + attribute("fill", e.color) + attribute("stroke", kGrey) +
             attribute("stroke-width", 0.5) + "/>\n";
    } else {
      if (e.series->line != Line::none) {
        out += "<path" +
               attribute("d", "M" + coordinate(e.x) + " " + coordinate(e.y) + "h" + coordinate(kSwatch)) +
               attribute("stroke", e.color) + attribute("stroke-width", 2.0) + dash_of(e.series->line) +
               "/>\n";
      }
      out += marker_svg(e.series->marker, e.x + kSwatch / 2, e.y, e.series->marker_size, e.color,
                        e.series->filled, "");
    }
    out += text_at(e.x + kSwatch + 6, e.y + 0.35 * kFont, e.name, "start", kInk);
  }
  return out;
}

}  // namespace tiltrotor::plot
