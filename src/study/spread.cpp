#include "study/spread.hpp"

#include <algorithm>
#include <cmath>

#include "study/missing.hpp"

namespace tiltrotor::study {

Spread root_sum_square(const std::vector<EndChange>& changes) {
  double down = 0;
  double up = 0;
  for (const EndChange& c : changes) {
    if (std::isnan(c.at_low) || std::isnan(c.at_high)) return {kMissing, kMissing};
    down += std::pow(std::min({c.at_low, c.at_high, 0.0}), 2);
    up += std::pow(std::max({c.at_low, c.at_high, 0.0}), 2);
  }
  return {std::sqrt(down), std::sqrt(up)};
}

double share(const EndChange& change, const Spread& spread) {
  const Spread alone = root_sum_square({change});
  const double all = std::pow(spread.below, 2) + std::pow(spread.above, 2);
  return all > 0 ? (std::pow(alone.below, 2) + std::pow(alone.above, 2)) / all : 0;
}

plot::Band band_around(const plot::Series& curve, const text::Table& rows, const char* x_column,
                       double factor) {
  plot::Band band;
  band.color = curve.color;
  const std::vector<double> x = rows.numbers(x_column);
  const std::vector<double> below = rows.numbers("below");
  const std::vector<double> above = rows.numbers("above");
  if (x.empty()) return band;
  const double slack = 1e-9;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    const double at = curve.x[i];
    if (at < x.front() - slack || at > x.back() + slack) continue;
    std::size_t right_of = 1;
    while (right_of + 1 < x.size() && x[right_of] < at) ++right_of;
    const std::size_t left_of = right_of < x.size() ? right_of - 1 : 0;
    right_of = std::min(right_of, x.size() - 1);
    const double width = x[right_of] - x[left_of];
    const double part = width > 0 ? (at - x[left_of]) / width : 0;
    const auto between = [&](const std::vector<double>& v) {
      // At a node its own number alone, whatever is missing beside it.
      return part <= slack       ? v[left_of]
             : part >= 1 - slack ? v[right_of]
                                 : v[left_of] + part * (v[right_of] - v[left_of]);
    };
    band.x.push_back(at);
    band.low.push_back(curve.y[i] - factor * between(below));
    band.high.push_back(curve.y[i] + factor * between(above));
  }
  return band;
}

}  // namespace tiltrotor::study
