#include "plot/axes.hpp"

#include <algorithm>
#include <limits>

#include "plot/drawing.hpp"
#include "plot/svg.hpp"

namespace tiltrotor::plot {

namespace {

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

double widest_text(const Scale& scale) {
  double widest = 0;
  for (const Tick& t : scale.ticks) widest = std::max(widest, text_width(t.text, kFont));
  return widest;
}

}  // namespace

Layout layout(const Plot& plot, double top) {
  Bounds bx, by;
  for (const Series& s : plot.series) {
    bx.add(s.x, plot.x.logarithmic);
    by.add(s.y, plot.y.logarithmic);
  }
  for (const Band& b : plot.bands) {
    by.add(b.low, plot.y.logarithmic);
    by.add(b.high, plot.y.logarithmic);
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
  if (plot.equal_scale)
    at.bottom = top + (at.right - at.left) * (at.y.high - at.y.low) / (at.x.high - at.x.low);
  at.height = at.bottom + 47;
  return at;
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

}  // namespace tiltrotor::plot
