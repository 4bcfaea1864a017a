#include "plot/plot.hpp"

#include <algorithm>
#include <limits>

#include "plot/marker.hpp"
#include "plot/svg.hpp"
#include "plot/ticks.hpp"

namespace tiltrotor::plot {

namespace {

constexpr double kFont = 13;
constexpr double kTitleFont = 14;
constexpr double kLegendRow = 19;
constexpr double kSwatch = 26;
constexpr double kMargin = 10;
constexpr const char* kInk = "#333333";
constexpr const char* kGrid = "#e4e4e4";

struct Bounds {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void add(const std::vector<double>& values, bool positive) {
    for (const double v : values) {
      if (!std::isfinite(v) || (positive && v <= 0)) continue;
      low = std::min(low, v);
      high = std::max(high, v);
    }
  }
};

Scale scale_of(const Axis& axis, Bounds data, int count) {
  if (!(data.low <= data.high)) data.low = data.high = 1;
  const bool has_low = std::isfinite(axis.low);
  const bool has_high = std::isfinite(axis.high);
  double low = has_low ? axis.low : data.low;
  double high = has_high ? axis.high : data.high;
  if (axis.logarithmic) return logarithmic_scale(low, high > low ? high : 10 * low);
  if (has_low && has_high) return linear_scale(low, high, count, true);
  Scale scale = linear_scale(low, high, count, false);
  if (has_low) scale.low = low;
  if (has_high) scale.high = high;
  const auto outside = [&](const Tick& t) {
    const double slack = 1e-9 * (scale.high - scale.low);
    return t.value < scale.low - slack || t.value > scale.high + slack;
  };
  scale.ticks.erase(std::remove_if(scale.ticks.begin(), scale.ticks.end(), outside), scale.ticks.end());
  return scale;
}

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

struct LegendEntry {
  const Series* series;  // or null: a filled cell
  std::string color;
  std::string name;
  double x, y;
};

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

std::string text_at(double x, double y, const std::string& text, const char* anchor, const std::string& color,
                    const std::string& more = "") {
  return "<text" + attribute("x", x) + attribute("y", y) + attribute("text-anchor", std::string(anchor)) +
         attribute("fill", color) + more + ">" + escaped(text) + "</text>\n";
}

std::string line_at(double x1, double y1, double x2, double y2, const std::string& color, double width = 1) {
  return "<line" + attribute("x1", x1) + attribute("y1", y1) + attribute("x2", x2) + attribute("y2", y2) +
         attribute("stroke", color) + attribute("stroke-width", width) + "/>\n";
}

std::string dash_of(Line line) {
  return line == Line::dashed   ? attribute("stroke-dasharray", std::string("7 4"))
         : line == Line::dotted ? attribute("stroke-dasharray", std::string("2 3"))
                                : "";
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

std::string draw_axes(const Plot& plot, const Layout& at) {
  std::string out;
  for (const Tick& t : at.x.ticks) {
    out += line_at(at.px(t.value), at.top, at.px(t.value), at.bottom, kGrid);
    if (!t.text.empty()) out += text_at(at.px(t.value), at.bottom + 17, t.text, "middle", kInk);
  }
  for (const Tick& t : at.y.ticks) {
    out += line_at(at.left, at.py(t.value), at.right, at.py(t.value), kGrid);
    if (!t.text.empty()) out += text_at(at.left - 6, at.py(t.value) + 0.35 * kFont, t.text, "end", kInk);
  }
  out += text_at((at.left + at.right) / 2, at.bottom + 37, plot.x.label, "middle", kInk);
  const double middle = (at.top + at.bottom) / 2;
  out += text_at(
      kMargin + 4, middle, plot.y.label, "middle", kInk,
      attribute("transform", "rotate(-90 " + coordinate(kMargin + 4) + " " + coordinate(middle) + ")"));
  return out;
}

std::string draw_zero_lines(const Plot& plot, const Layout& at) {
  std::string out;
  const auto shows_zero = [](const Axis& axis, const Scale& s) {
    return axis.zero_line && s.low <= 0 && s.high >= 0;
  };
  if (shows_zero(plot.x, at.x)) out += line_at(at.px(0), at.top, at.px(0), at.bottom, kGrey, 1.2);
  if (shows_zero(plot.y, at.y)) out += line_at(at.left, at.py(0), at.right, at.py(0), kGrey, 1.2);
  return out;
}

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
         attribute("stroke-width", 2.0) + dash_of(s.line) + " stroke-linejoin=\"round\"/>\n";
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

double widest_text(const Scale& scale) {
  double widest = 0;
  for (const Tick& t : scale.ticks) widest = std::max(widest, text_width(t.text, kFont));
  return widest;
}

Layout layout(const Plot& plot, double top) {
  Bounds bx, by;
  for (const Series& s : plot.series) {
    bx.add(s.x, plot.x.logarithmic);
    by.add(s.y, plot.y.logarithmic);
  }
  bx.add(plot.cells.x_edge, plot.x.logarithmic);
  by.add(plot.cells.y_edge, plot.y.logarithmic);
  Layout at{{}, scale_of(plot.y, by, 6), 0, top, 0, top + plot.axes_height, 0};
  at.left = kMargin + kFont + 10 + widest_text(at.y);
  // As many ticks as their numbers leave room for.
  for (int count = 8; count >= 2; --count) {
    at.x = scale_of(plot.x, bx, count);
    const double wide = widest_text(at.x);
    at.right = plot.width - std::max(16.0, 0.5 * wide + 4);
    const double gap = 10;
    if (at.x.logarithmic || static_cast<double>(at.x.ticks.size()) * (wide + gap) < at.right - at.left) break;
  }
  at.height = at.bottom + 47;
  return at;
}

}  // namespace

std::string svg(const Plot& plot) {
  double axes_top = 0;
  const std::vector<LegendEntry> entries = legend(plot, kMargin + kTitleFont + 8, axes_top);
  const Layout at = layout(plot, axes_top + 8);
  const std::string box = attribute("x", at.left) + attribute("y", at.top) +
                          attribute("width", at.right - at.left) + attribute("height", at.bottom - at.top);

  const double bold = 1.06;
  const double title_font = std::min(
      kTitleFont, kTitleFont * (plot.width - 2 * kMargin) / (bold * text_width(plot.title, kTitleFont) + 1));
  std::string out = open_svg(plot.width, at.height, plot.title);
  out +=
      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n<g" + attribute("font-size", kFont) + ">\n";
  out += "<clipPath" + attribute("id", plot.id + "_clip") + "><rect" + box + "/></clipPath>\n";
  out += text_at(kMargin, kMargin + kTitleFont, plot.title, "start", "#111111",
                 attribute("font-size", title_font) + " font-weight=\"600\"");
  out += draw_legend(entries) + draw_axes(plot, at);
  out += "<g" + attribute("clip-path", "url(#" + plot.id + "_clip)") + ">\n" + draw_cells(plot.cells, at) +
         draw_zero_lines(plot, at);
  for (const Series& s : plot.series) out += draw_line(s, at);
  out += "</g>\n<rect class=\"axes\"" + box + " fill=\"none\"" + attribute("stroke", kGrey) + "/>\n";
  for (const Series& s : plot.series) out += draw_markers(s, at);
  for (const Label& l : plot.labels) {
    if (!at.inside(l.x, l.y)) continue;
    // A white rim keeps the text legible on lines.
    out += text_at(at.px(l.x) + l.dx, at.py(l.y) + l.dy, l.text, l.dx < 0 ? "end" : "start", l.color,
                   " font-size=\"12\" paint-order=\"stroke\" stroke=\"#ffffff\" stroke-width=\"3\"");
  }
  return out + "</g>\n</svg>\n";
}

}  // namespace tiltrotor::plot
