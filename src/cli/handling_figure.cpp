#include "cli/handling_figure.hpp"

#include <algorithm>
#include <cmath>

#include "text/number.hpp"

namespace tiltrotor::cli {

namespace {

using plot::Plot;
using plot::Series;

Plot empty_plot(const char* id, const char* title, const char* x, const char* y) {
  Plot p;
  p.id = id;
  p.title = title;
  p.x.label = x;
  p.y.label = y;
  p.width = 640;
  p.axes_height = 300;
  return p;
}

const Criterion* criterion_of(const std::vector<Criterion>& all, const std::string& quantity, bool in_hover) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Criterion& c) {
    return c.quantity == quantity && c.in_hover == in_hover && c.has_levels;
  });
  return found != all.end() ? &*found : nullptr;
}

Series boundary(int level, const std::string& name) {
  Series s;
  s.name = name + " level " + std::to_string(level + 1);
  s.color = plot::kGrey;
  s.line = level == 0 ? plot::Line::solid : level == 1 ? plot::Line::dashed : plot::Line::dotted;
  return s;
}

// A line of points a mast angle, of flights in or beyond low speed that have both quantities.
template <class X, class Y>
bool add_flights(const std::vector<JudgedFlight>& flights, bool in_hover, X&& x_of, Y&& y_of, Plot& plot) {
  std::map<double, Series> by_mast;
  for (const JudgedFlight& f : flights) {
    const double x = x_of(f), y = y_of(f);
    if ((f.speed <= kLowSpeed) != in_hover || !std::isfinite(x) || !std::isfinite(y)) continue;
    Series& s = by_mast[f.mast_deg];
    s.x.push_back(x);
    s.y.push_back(y);
    s.tip.push_back(text::number_text(f.speed, 4) + " m/s");
  }
  std::size_t k = 0;
  for (auto& [mast, s] : by_mast) {
    s.name = "mast " + text::number_text(mast, 4) + " deg";
    s.color = plot::kLineColor[k++ % plot::kLineColors];
    s.marker = plot::Marker::circle;
    s.width = 1;
    plot.series.push_back(s);
  }
  return !by_mast.empty();
}

double quantity(const JudgedFlight& f, const std::string& name) {
  const auto found = f.quantities.find(name);
  return found != f.quantities.end() ? found->second : std::nan("");
}

// Least frequency, least damping ratio, least product of both: one line a level.
Plot dutch_roll(const std::vector<Criterion>& criteria, const std::vector<JudgedFlight>& flights, bool& any) {
  Plot p = empty_plot("qualities_dutch_roll", "Dutch roll, MIL-F-8785C", "Damping ratio", "Frequency, rad/s");
  constexpr double highest = 5;  // rad/s
  p.y.low = 0;
  p.y.high = highest;
  const Criterion* const ratio = criterion_of(criteria, "dutch_zeta", false);
  const Criterion* const product = criterion_of(criteria, "dutch_zeta_omega", false);
  const Criterion* const frequency = criterion_of(criteria, "dutch_omega", false);
  for (int level = 0; level < 3 && ratio != nullptr; ++level) {
    if (!ratio->level[level].given) continue;
    const bool has_product = product != nullptr && product->level[level].given;
    const double least =
        frequency != nullptr && frequency->level[level].given ? frequency->level[level].low : 0;
    Series s = boundary(level, "");
    s.name = s.name.substr(1);
    s.x.push_back(1);
    s.y.push_back(least);
    for (double omega = std::max(least, 0.01); omega <= highest; omega *= 1.02) {
      s.x.push_back(std::max(ratio->level[level].low, has_product ? product->level[level].low / omega : 0));
      s.y.push_back(omega);
    }
    p.series.push_back(s);
  }
  any = add_flights(
      flights, false, [](const JudgedFlight& f) { return quantity(f, "dutch_zeta"); },
      [](const JudgedFlight& f) { return quantity(f, "dutch_omega"); }, p);
  return p;
}

Plot short_period(const std::vector<Criterion>& criteria, const std::vector<JudgedFlight>& flights,
                  bool& any) {
  Plot p = empty_plot("qualities_short_period", "Short period, MIL-STD-1797A", "Damping ratio",
                      "Control anticipation parameter, 1/(g s2)");
  p.x.logarithmic = p.y.logarithmic = true;
  const Criterion* const ratio = criterion_of(criteria, "short_period_zeta", false);
  const Criterion* const cap = criterion_of(criteria, "cap", false);
  for (int level = 0; level < 3 && ratio != nullptr && cap != nullptr; ++level) {
    const Limit &x = ratio->level[level], &y = cap->level[level];
    if (!x.given || !y.given || !std::isfinite(x.low + x.high + y.low + y.high)) continue;
    Series s = boundary(level, "");
    s.name = s.name.substr(1);
    s.x = {x.low, x.high, x.high, x.low, x.low};
    s.y = {y.low, y.low, y.high, y.high, y.low};
    p.series.push_back(s);
  }
  any = add_flights(
      flights, false, [](const JudgedFlight& f) { return quantity(f, "short_period_zeta"); },
      [](const JudgedFlight& f) { return quantity(f, "cap"); }, p);
  return p;
}

Plot over_speed(const std::vector<Criterion>& criteria, const std::vector<JudgedFlight>& flights,
                const char* id, const char* title, const char* label, const std::string& of, bool& any) {
  Plot p = empty_plot(id, title, "True airspeed, m/s", label);
  any = add_flights(
      flights, false, [](const JudgedFlight& f) { return f.speed; },
      [&](const JudgedFlight& f) { return quantity(f, of); }, p);
  const Criterion* const criterion = criterion_of(criteria, of, false);
  double first = 1e9, last = -1e9;
  for (const Series& s : p.series)
    for (const double x : s.x) first = std::min(first, x), last = std::max(last, x);
  for (int level = 0; any && level < 3 && criterion != nullptr; ++level) {
    const Limit& limit = criterion->level[level];
    for (const double bound : {limit.low, limit.high}) {
      if (!limit.given || !std::isfinite(bound)) continue;
      Series s = boundary(level, "");
      s.name = s.name.substr(1);
      s.x = {first - 1, last + 1};
      s.y = {bound, bound};
      p.series.push_back(s);
    }
  }
  return p;
}

// Sensitivity and damping of the three axes in hover, each with the least values of its requirements.
Plot hover(const std::vector<Criterion>& criteria, const std::vector<JudgedFlight>& flights, bool& any) {
  Plot p = empty_plot("qualities_hover", "Hover and low speed: circles; least values: crosses",
                      "Sensitivity, rad/s2 an inch", "Damping, 1/s");
  std::size_t k = 0;
  any = false;
  for (const char* const axis : {"pitch", "roll", "yaw"}) {
    const std::string sensitivity = std::string("sensitivity_") + axis,
                      damping = std::string("damping_") + axis;
    Series s;
    s.name = axis;
    s.color = plot::kLineColor[k++];
    s.line = plot::Line::none;
    s.marker = plot::Marker::circle;
    for (const JudgedFlight& f : flights) {
      if (f.speed > kLowSpeed) continue;
      s.x.push_back(quantity(f, sensitivity));
      s.y.push_back(quantity(f, damping));
      any = true;
    }
    p.series.push_back(s);
    for (const Criterion& least : criteria) {
      if (least.quantity != sensitivity) continue;
      const std::string standard = least.name.substr(0, least.name.find(axis));
      for (const Criterion& other : criteria) {
        if (other.quantity != damping || other.name.compare(0, standard.size(), standard) != 0) continue;
        Series mark;
        mark.color = s.color;
        mark.line = plot::Line::none;
        mark.marker = plot::Marker::cross;
        mark.x = {least.level[0].low};
        mark.y = {other.level[0].low};
        p.series.push_back(mark);
        p.labels.push_back({mark.x[0], mark.y[0], standard + axis, s.color});
      }
    }
  }
  return p;
}

}  // namespace

std::vector<Plot> handling_plots(const std::vector<Criterion>& criteria,
                                 const std::vector<JudgedFlight>& flights) {
  std::vector<Plot> plots;
  bool any = false;
  const auto keep = [&](const Plot& p) {
    if (any) plots.push_back(p);
  };
  keep(hover(criteria, flights, any));
  keep(dutch_roll(criteria, flights, any));
  keep(short_period(criteria, flights, any));
  keep(over_speed(criteria, flights, "qualities_roll", "Roll mode, MIL-F-8785C", "Time constant, s",
                  "roll_time", any));
  keep(over_speed(criteria, flights, "qualities_phugoid", "Phugoid, MIL-F-8785C", "Damping ratio",
                  "phugoid_zeta", any));
  return plots;
}

}  // namespace tiltrotor::cli
