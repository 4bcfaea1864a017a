#include "tablegen/compose.hpp"

#include <algorithm>
#include <limits>

namespace tablegen {

double at(const Curve& curve, double x) {
  const auto& knot = curve.knot;
  if (x <= knot.front()) return curve.value.front();
  if (x >= knot.back()) return curve.value.back();
  const auto right = std::upper_bound(knot.begin(), knot.end(), x);
  const auto i = static_cast<std::size_t>(right - knot.begin()) - 1;
  if (x == knot[i]) return curve.value[i];  // a node keeps its value to the last bit
  return curve.value[i] + (curve.value[i + 1] - curve.value[i]) * ((x - knot[i]) / (knot[i + 1] - knot[i]));
}

double half_unit_at(const Curve& curve, double x) {
  const auto& knot = curve.knot;
  if (x <= knot.front()) return curve.half.front();
  if (x >= knot.back()) return curve.half.back();
  const auto right = std::upper_bound(knot.begin(), knot.end(), x);
  const auto i = static_cast<std::size_t>(right - knot.begin()) - 1;
  return x == knot[i] ? curve.half[i] : std::numeric_limits<double>::infinity();
}

Curve resampled(const Curve& curve, const std::vector<double>& knots) {
  Curve result{knots, {}, {}};
  for (const double x : knots) {
    result.value.push_back(at(curve, x));
    result.half.push_back(half_unit_at(curve, x));
  }
  if (around_circle(knots) && curve.knot.front() > knots.front() && curve.knot.back() < knots.back()) {
    result.value.front() = result.value.back() = 0.5 * (result.value.front() + result.value.back());
    result.half.front() = result.half.back() = 0.5 * (result.half.front() + result.half.back());
  }
  return result;
}

bool around_circle(const std::vector<double>& knots) { return knots.front() == -180 && knots.back() == 180; }

std::vector<double> union_of(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> result;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

Curve extended(const Curve& curve, const Curve& extension) {
  Curve result;
  for (const double x : union_of(curve.knot, extension.knot)) {
    const bool inside = x >= curve.knot.front() && x <= curve.knot.back();
    const Curve& source = inside ? curve : extension;
    if (!std::binary_search(source.knot.begin(), source.knot.end(), x)) continue;
    result.knot.push_back(x);
    result.value.push_back(at(source, x));
    result.half.push_back(half_unit_at(source, x));
  }
  return result;
}

Curve with_odd_half(const Curve& half) {
  Curve result;
  for (std::size_t i = half.knot.size(); i-- > 1;) {
    result.knot.push_back(-half.knot[i]);
    result.value.push_back(-half.value[i]);
    result.half.push_back(half.half[i]);
  }
  result.knot.insert(result.knot.end(), half.knot.begin(), half.knot.end());
  result.value.insert(result.value.end(), half.value.begin(), half.value.end());
  result.half.insert(result.half.end(), half.half.begin(), half.half.end());
  return result;
}

Surface side_by_side(const std::vector<Curve>& columns, const std::vector<double>& y) {
  Surface surface{{}, y, {}};
  for (const Curve& curve : columns) surface.x = union_of(surface.x, curve.knot);
  for (const Curve& curve : columns) surface.column.push_back(resampled(curve, surface.x));
  return surface;
}

Surface from_mach_0(Surface surface) {
  if (surface.y.front() > 0) {
    surface.y.insert(surface.y.begin(), 0.0);
    surface.column.insert(surface.column.begin(), Curve(surface.column.front()));
  }
  return surface;
}

}  // namespace tablegen
