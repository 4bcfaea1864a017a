#include "plot/curve_names.hpp"

#include <algorithm>
#include <cmath>

#include "plot/drawing.hpp"
#include "plot/svg.hpp"

namespace tiltrotor::plot {

namespace {

constexpr double kBold = 1.1;        // over the width of plain text
constexpr double kStep = 3;          // drawing units between the points that stand for a line
constexpr double kClear = 5;         // between a name and its line
constexpr double kMostCost = 12;     // a name that costs more is not written
constexpr std::size_t kPlaces = 60;  // tried along a line

struct Point {
  double x, y;
};
struct Box {
  double left, top, right, bottom;
  bool has(const Point& p, double margin) const {
    return p.x > left - margin && p.x < right + margin && p.y > top - margin && p.y < bottom + margin;
  }
  bool meets(const Box& b) const {
    return left < b.right && b.left < right && top < b.bottom && b.top < bottom;
  }
};

// A line as points inside the axes, so close together that none slips through a name.
std::vector<Point> points_of(const Series& s, const Layout& at) {
  std::vector<Point> points;
  const auto add = [&](double x, double y) {
    if (x >= at.left && x <= at.right && y >= at.top && y <= at.bottom) points.push_back({x, y});
  };
  double x0 = std::nan("");
  double y0 = std::nan("");
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    const double x = at.px(s.x[i]);
    const double y = at.py(s.y[i]);
    const double length = std::hypot(x - x0, y - y0);
    const int steps = std::isfinite(length) ? static_cast<int>(std::min(length / kStep, 1000.0)) : 0;
    for (int k = 1; k <= steps; ++k) add(x0 + (x - x0) * k / (steps + 1), y0 + (y - y0) * k / (steps + 1));
    add(x, y);
    x0 = x;
    y0 = y;
  }
  return points;
}

Box box_of(const Label& l, const Layout& at) {
  const double x = at.px(l.x) + l.dx;
  const double y = at.py(l.y) + l.dy;
  const double wide = text_width(l.text, kNameFont);
  return {l.dx < 0 ? x - wide : x, y - kNameFont, l.dx < 0 ? x : x + wide, y};
}

struct Obstacles {
  std::vector<std::vector<Point>> line, marker;  // one of each for every series
  std::vector<Box> text;
};

Obstacles obstacles(const Plot& plot, const Layout& at) {
  Obstacles all;
  for (const Series& s : plot.series) {
    all.line.push_back(s.line == Line::none ? std::vector<Point>{} : points_of(s, at));
    all.marker.emplace_back();
    for (std::size_t i = 0; s.marker != Marker::none && i < s.x.size(); ++i) {
      if (at.inside(s.x[i], s.y[i])) all.marker.back().push_back({at.px(s.x[i]), at.py(s.y[i])});
    }
  }
  for (const Label& l : plot.labels) {
    if (at.inside(l.x, l.y)) all.text.push_back(box_of(l, at));
  }
  return all;
}

// What a name in that box covers, and how close others come to it.
double cost_of(const Box& box, std::size_t own, const Obstacles& all, const Layout& at) {
  if (box.left < at.left + 2 || box.right > at.right - 2 || box.top < at.top + 2 ||
      box.bottom > at.bottom - 2)
    return HUGE_VAL;
  for (const Box& text : all.text) {
    if (box.meets(text)) return HUGE_VAL;
  }
  double cost = 0;
  for (std::size_t i = 0; i < all.line.size(); ++i) {
    for (const Point& p : all.line[i]) {
      if (i == own) {
        cost += box.has(p, 0) ? 3 : 0;
      } else {
        cost += box.has(p, 0) ? 8 : box.has(p, kClear) ? 1 : 0;
      }
    }
    for (const Point& p : all.marker[i]) cost += box.has(p, 4) ? 10 : 0;
  }
  return cost;
}

// Above, below, beside and at the four corners of a point.
std::vector<Box> boxes_around(const Point& p, double wide) {
  constexpr double high = 12;
  std::vector<Box> boxes;
  for (const double right : {0.5, 0.0, 1.0}) {    // part of the name left of the point
    for (const double below : {1.0, 0.0, 0.5}) {  // part of it above the point
      if (right == 0.5 && below == 0.5) continue;
      const double dx = right == 0.5 ? 0 : kClear * (1 - 2 * right);
      const double dy = below == 0.5 ? 0 : kClear * (1 - 2 * below);
      const double left = p.x - right * wide + dx;
      const double top = p.y - below * high + dy;
      boxes.push_back({left, top, left + wide, top + high});
    }
  }
  return boxes;
}

}  // namespace

std::vector<CurveName> curve_names(const Plot& plot, const Layout& at) {
  Obstacles all = obstacles(plot, at);
  std::vector<CurveName> names;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& s = plot.series[i];
    const std::vector<Point>& line = all.line[i];
    if (s.name.empty() || line.empty()) continue;
    const double wide = kBold * text_width(s.name, kNameFont);
    const std::size_t stride = 1 + line.size() / kPlaces;
    Box best{};
    double least = HUGE_VAL;
    for (std::size_t k = 0; k < line.size(); k += stride) {
      // Of equal places that nearest to the end of the line.
      const double early = 0.5 * static_cast<double>(line.size() - k) / static_cast<double>(line.size());
      for (const Box& box : boxes_around(line[k], wide)) {
        const double cost = cost_of(box, i, all, at) + early;
        if (cost < least) {
          least = cost;
          best = box;
        }
      }
    }
    if (least > kMostCost) continue;
    all.text.push_back(best);
    names.push_back({&s, best.left, best.bottom - 2});
  }
  return names;
}

}  // namespace tiltrotor::plot
