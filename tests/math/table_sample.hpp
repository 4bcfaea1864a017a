// What the tests of interpolation tables share: random tables that own their arrays, and textbook formulas written out
// apart from the library: multilinear interpolation, and cubic Hermite interpolation nested axis by axis.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "check.hpp"
#include "tiltrotor/math/differentiation/dual.hpp"
#include "tiltrotor/math/tables/table.hpp"
#include "tiltrotor/math/tables/table_slopes.hpp"

namespace table_sample {

using tiltrotor::Axis;
using tiltrotor::Dual;
using tiltrotor::grid_point;
using tiltrotor::GridPoint;
using tiltrotor::Interpolation;
using tiltrotor::Table;

inline constexpr Interpolation kModes[] = {Interpolation::c1, Interpolation::linear};

// Reproducible numbers in [0, 1).
class Random {
 public:
  double operator()() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  double between(double low, double high) { return low + (high - low) * (*this)(); }

 private:
  unsigned long long state_ = 20240607;
};

using Numbers = std::vector<double>;

inline Numbers uneven_knots(Random& random, int count) {
  Numbers knots{random.between(-3, 0)};
  while (static_cast<int>(knots.size()) < count) knots.push_back(knots.back() + random.between(0.2, 2));
  return knots;
}

// A table that owns its arrays. Plain values are kept beside the nodes for the independent evaluation.
template <int Smooth, int Linear>
struct Sample {
  std::vector<Numbers> smooth;
  std::vector<Numbers> linear;
  Numbers value;  // linear axes outermost
  Numbers node;

  Sample(Random& random, const std::vector<int>& counts) {
    std::size_t size = 1;
    for (std::size_t a = 0; a < counts.size(); ++a) {
      (a < Linear ? linear : smooth).push_back(uneven_knots(random, counts[a]));
      size *= static_cast<std::size_t>(counts[a]);
    }
    for (std::size_t i = 0; i < size; ++i) value.push_back(random.between(-2, 2));
    fill();
  }

  void fill() {
    constexpr std::size_t per_node = std::size_t{1} << Smooth;
    node.assign(value.size() * per_node, 0);
    for (std::size_t i = 0; i < value.size(); ++i) node[i * per_node] = value[i];
    const Table<double, Smooth, Linear> t = table();
    std::size_t block = per_node;
    for (const Numbers& knots : smooth) block *= knots.size();
    Numbers scratch(block);
    for (std::size_t at = 0; at < node.size(); at += block)
      tiltrotor::fill_slopes<double, Smooth>(t.smooth, &node[at], scratch.data());
  }

  Table<double, Smooth, Linear> table() const {
    Table<double, Smooth, Linear> t{};
    for (std::size_t a = 0; a < Smooth; ++a)
      t.smooth[a] = {static_cast<int>(smooth[a].size()), smooth[a].data()};
    for (std::size_t a = 0; a < Linear; ++a)
      t.linear[a] = {static_cast<int>(linear[a].size()), linear[a].data()};
    t.node = node.data();
    return t;
  }
};

// ---- the library's look-up, one signature for all shapes ----

template <class T, int Smooth>
T look(const Sample<Smooth, 0>& s, Interpolation mode, const std::vector<T>& x) {
  if constexpr (Smooth == 1) {
    return tiltrotor::lookup(s.table(), mode, x[0]);
  } else {
    return tiltrotor::lookup(s.table(), mode, x[0], x[1]);
  }
}
template <class T, int Smooth, int Linear>
T look(const Sample<Smooth, Linear>& s, Interpolation mode, const std::vector<T>& x, const Numbers& p) {
  const Table<double, Smooth, Linear> t = s.table();
  GridPoint<double> place[Linear];
  for (std::size_t a = 0; a < Linear; ++a) place[a] = grid_point(t.linear[a], p[a]);
  T arguments[Smooth];
  std::copy(x.begin(), x.end(), arguments);
  return tiltrotor::lookup(t, mode, place, arguments);
}

// ---- independent evaluation ----

// Interval of x, counted by walking; x is inside the knots.
inline std::size_t interval(const Numbers& knots, double x) {
  std::size_t i = 0;
  while (i + 2 < knots.size() && knots[i + 1] <= x) ++i;
  return i;
}
inline double clamped(const Numbers& knots, double x) {
  return std::min(std::max(x, knots.front()), knots.back());
}

// Multilinear: sum over the corners of the cell, each axis contributing (1 - t) or t. All axes in storage
// order.
inline double multilinear(const std::vector<Numbers>& axes, const Numbers& value, const Numbers& x) {
  double sum = 0;
  for (unsigned corner = 0; corner < (1U << axes.size()); ++corner) {
    double weight = 1;
    std::size_t index = 0;
    for (std::size_t a = 0; a < axes.size(); ++a) {
      const Numbers& k = axes[a];
      std::size_t at = 0;
      if (k.size() > 1) {
        const double held = clamped(k, x[a]);
        const std::size_t i = interval(k, held);
        const double t = (held - k[i]) / (k[i + 1] - k[i]);
        const unsigned right = (corner >> a) & 1U;
        weight *= right == 1 ? t : 1 - t;
        at = i + right;
      } else if (((corner >> a) & 1U) == 1) {
        weight = 0;
      }
      index = index * k.size() + at;
    }
    sum += weight * value[index];
  }
  return sum;
}

// Slopes of the monotone cubic through (x, y), from the formulas of Fritsch and Butland as used by PCHIP.
inline Numbers slopes(const Numbers& x, const Numbers& y) {
  const std::size_t n = x.size();
  if (n == 1) return {0};
  Numbers h, d;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h.push_back(x[i + 1] - x[i]);
    d.push_back((y[i + 1] - y[i]) / h[i]);
  }
  if (n == 2) return {d[0], d[0]};
  const auto sign = [](double v) { return (v > 0) - (v < 0); };
  const auto end = [&](double h0, double h1, double d0, double d1) {
    const double m = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (sign(m) != sign(d0)) return 0.0;
    return sign(d0) != sign(d1) && std::abs(m) > 3 * std::abs(d0) ? 3 * d0 : m;
  };
  Numbers m{end(h[0], h[1], d[0], d[1])};
  for (std::size_t i = 1; i + 1 < n; ++i) {
    // 1/m is the weighted mean of the reciprocal secants.
    const double share = (h[i - 1] + 2 * h[i]) / (3 * (h[i - 1] + h[i]));
    m.push_back(sign(d[i - 1]) * sign(d[i]) > 0 ? 1 / (share / d[i - 1] + (1 - share) / d[i]) : 0.0);
  }
  m.push_back(end(h[n - 2], h[n - 3], d[n - 2], d[n - 3]));
  return m;
}

// Cubic Hermite polynomial of one interval in Newton's form, held outside the knots.
inline double hermite(const Numbers& x, const Numbers& y, const Numbers& m, double at) {
  if (x.size() == 1) return y[0];
  at = clamped(x, at);
  const std::size_t i = interval(x, at);
  const double h = x[i + 1] - x[i];
  const double secant = (y[i + 1] - y[i]) / h;
  const double second = (secant - m[i]) / h;
  const double third = (m[i] - 2 * secant + m[i + 1]) / (h * h);
  const double s = at - x[i];
  return y[i] + s * (m[i] + s * (second + (s - h) * third));
}

// Two axes: along y in every row, with values and with the slopes along x; then along x.
inline double nested_hermite(const Numbers& x, const Numbers& y, const Numbers& f, double at_x, double at_y) {
  const std::size_t rows = x.size();
  const std::size_t columns = y.size();
  const auto row = [&](const Numbers& g, std::size_t i) {
    return Numbers(g.begin() + static_cast<std::ptrdiff_t>(i * columns),
                   g.begin() + static_cast<std::ptrdiff_t>((i + 1) * columns));
  };
  const auto along_y = [&](const Numbers& g) {
    Numbers result;
    for (std::size_t i = 0; i < rows; ++i)
      for (const double m : slopes(y, row(g, i))) result.push_back(m);
    return result;
  };
  const auto along_x = [&](const Numbers& g) {
    Numbers result(g.size());
    for (std::size_t j = 0; j < columns; ++j) {
      Numbers column;
      for (std::size_t i = 0; i < rows; ++i) column.push_back(g[i * columns + j]);
      const Numbers m = slopes(x, column);
      for (std::size_t i = 0; i < rows; ++i) result[i * columns + j] = m[i];
    }
    return result;
  };
  const Numbers fx = along_x(f);
  const Numbers fy = along_y(f);
  const Numbers first = along_y(fx);
  const Numbers second = along_x(fy);
  Numbers value, slope;
  for (std::size_t i = 0; i < rows; ++i) {
    Numbers mixed;
    for (std::size_t j = 0; j < columns; ++j)
      mixed.push_back((first[i * columns + j] + second[i * columns + j]) / 2);
    value.push_back(hermite(y, row(f, i), row(fy, i), at_y));
    slope.push_back(hermite(y, row(fx, i), mixed, at_y));
  }
  return hermite(x, value, slope, at_x);
}

// ---- what several tests use ----

// An argument inside the knots or, now and then, outside.
inline Numbers arguments(Random& random, const std::vector<Numbers>& axes) {
  Numbers x;
  for (const Numbers& k : axes) x.push_back(random.between(k.front() - 0.7, k.back() + 0.7));
  return x;
}
inline Numbers joined(Numbers a, const Numbers& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
template <int Smooth, int Linear>
std::vector<Numbers> all_axes(const Sample<Smooth, Linear>& s) {
  std::vector<Numbers> axes = s.linear;
  axes.insert(axes.end(), s.smooth.begin(), s.smooth.end());
  return axes;
}

template <int Smooth>
std::vector<Dual<double, Smooth>> dual_variables(const Numbers& x) {
  std::vector<Dual<double, Smooth>> result;
  for (int a = 0; a < Smooth; ++a)
    result.push_back(Dual<double, Smooth>::variable(x[static_cast<std::size_t>(a)], a));
  return result;
}

}  // namespace table_sample
