#include "plot/legend.hpp"

#include "plot/drawing.hpp"
#include "plot/marker.hpp"
#include "plot/svg.hpp"
#include "plot/ticks.hpp"

namespace tiltrotor::plot {

namespace {

constexpr double kRow = 19;
constexpr double kLineSwatch = 26;
constexpr double kMarkerSwatch = 12;
constexpr double kGap = 14;  // between entries

double swatch(const Series& s) { return s.line == Line::none ? kMarkerSwatch : kLineSwatch; }

}  // namespace

std::vector<KeyEntry> key(const std::vector<const Series*>& series, double width, double top,
                          double& bottom) {
  std::vector<KeyEntry> entries;
  double x = kMargin;
  double y = top + kRow / 2;
  for (const Series* s : series) {
    const double wide = swatch(*s) + 5 + text_width(s->name, kFont);
    if (x > kMargin && x + wide > width) {
      x = kMargin;
      y += kRow;
    }
    entries.push_back({s, x, y});
    x += wide + kGap;
  }
  bottom = entries.empty() ? top : y + kRow / 2;
  return entries;
}

std::string draw_key(const std::vector<KeyEntry>& entries) {
  std::string out;
  for (const auto& [s, x, y] : entries) {
    const double wide = swatch(*s);
    if (s->line != Line::none) {
      out += "<path" + attribute("d", "M" + coordinate(x) + " " + coordinate(y) + "h" + coordinate(wide)) +
             attribute("stroke", s->color) + attribute("stroke-width", s->width) + dash_of(s->line) + "/>\n";
    }
    out += marker_svg(s->marker, x + wide / 2, y, s->marker_size, s->color, s->filled, "");
    out += text_at(x + wide + 5, y + 0.35 * kFont, s->name, "start", kInk);
  }
  return out;
}

std::string draw_color_bar(const Cells& cells, double width, double top, double& bottom) {
  bottom = top;
  if (cells.color.empty()) return "";
  constexpr double high = 10;
  const double label_width = text_width(cells.label, kSmallFont);
  const double left = kMargin + label_width + 8;
  const double block = (width - kMargin - left) / static_cast<double>(cells.color.size());
  const std::string small = attribute("font-size", kSmallFont);
  std::string out = text_at(kMargin, top + high, cells.label, "start", kInk, small);
  for (std::size_t i = 0; i < cells.color.size(); ++i) {
    const double x = left + block * static_cast<double>(i);
    out += "<rect" + attribute("x", x) + attribute("y", top) + attribute("width", block) +
           attribute("height", high) + attribute("fill", cells.color[i]) + attribute("stroke", kGrey) +
           attribute("stroke-width", 0.5) + "/>\n";
    if (i > 0) out += text_at(x, top + high + 13, value_text(cells.level[i - 1]), "middle", kInk, small);
  }
  bottom = top + high + 18;
  return out;
}

}  // namespace tiltrotor::plot
