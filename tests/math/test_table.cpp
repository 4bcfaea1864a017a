// Interpolation tables in one to four dimensions, against textbook formulas written out apart from the
// library: multilinear interpolation, and cubic Hermite interpolation nested axis by axis.
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <vector>

#include "check.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"
#include "tiltrotor/math/differentiation/dual.hpp"
#include "tiltrotor/math/tables/table.hpp"
#include "tiltrotor/math/tables/table_slopes.hpp"

namespace {

using tiltrotor::Axis;
using tiltrotor::Dual;
using tiltrotor::grid_point;
using tiltrotor::GridPoint;
using tiltrotor::Interpolation;
using tiltrotor::Table;

constexpr Interpolation kModes[] = {Interpolation::c1, Interpolation::linear};

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

Numbers uneven_knots(Random& random, int count) {
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
std::size_t interval(const Numbers& knots, double x) {
  std::size_t i = 0;
  while (i + 2 < knots.size() && knots[i + 1] <= x) ++i;
  return i;
}
double clamped(const Numbers& knots, double x) { return std::min(std::max(x, knots.front()), knots.back()); }

// Multilinear: sum over the corners of the cell, each axis contributing (1 - t) or t. All axes in storage
// order.
double multilinear(const std::vector<Numbers>& axes, const Numbers& value, const Numbers& x) {
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
Numbers slopes(const Numbers& x, const Numbers& y) {
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
double hermite(const Numbers& x, const Numbers& y, const Numbers& m, double at) {
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
double nested_hermite(const Numbers& x, const Numbers& y, const Numbers& f, double at_x, double at_y) {
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
Numbers arguments(Random& random, const std::vector<Numbers>& axes) {
  Numbers x;
  for (const Numbers& k : axes) x.push_back(random.between(k.front() - 0.7, k.back() + 0.7));
  return x;
}
Numbers joined(Numbers a, const Numbers& b) {
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

// The dual derivative in every direction against complex step, and the value against the plain evaluation.
template <int Smooth>
void check_derivatives(
    const Numbers& x, const Dual<double, Smooth>& dual, const std::function<double(const Numbers&)>& plain,
    const std::function<std::complex<double>(const std::vector<std::complex<double>>&)>& complex) {
  constexpr double step = 1e-30;
  CHECK_EQ(dual.v, plain(x));
  for (std::size_t a = 0; a < Smooth; ++a) {
    std::vector<std::complex<double>> z(x.begin(), x.end());
    z[a] += std::complex<double>(0, step);
    const double expected = complex(z).imag() / step;
    CHECK_NEAR(dual.d.get(static_cast<int>(a)), expected, 1e-12 * std::max(1.0, std::abs(expected)));
  }
}

// ---- values ----

TEST(table_linear_agrees_with_multilinear_formula) {
  Random random;
  for (int round = 0; round < 200; ++round) {
    const Sample<1, 0> s1(random, {5});
    const Sample<2, 0> s2(random, {4, 6});
    const Sample<1, 1> s11(random, {3, 5});
    const Sample<2, 1> s21(random, {3, 4, 5});
    const Sample<1, 2> s12(random, {2, 4, 5});
    const Sample<3, 1> s31(random, {3, 4, 3, 5});
    const Sample<2, 2> s22(random, {3, 2, 4, 5});
    const auto check = [&](const auto& s, double actual, const Numbers& x) {
      CHECK_NEAR(actual, multilinear(all_axes(s), s.value, x), 1e-14);
    };
    const auto without_linear = [&](const auto& s) {
      const Numbers x = arguments(random, s.smooth);
      check(s, look(s, Interpolation::linear, x), x);
    };
    const auto with_linear = [&](const auto& s) {
      const Numbers x = arguments(random, s.smooth);
      const Numbers p = arguments(random, s.linear);
      check(s, look(s, Interpolation::linear, x, p), joined(p, x));
    };
    without_linear(s1);
    without_linear(s2);
    with_linear(s11);
    with_linear(s21);
    with_linear(s12);
    with_linear(s31);
    with_linear(s22);
  }
}

TEST(table_c1_agrees_with_textbook_hermite) {
  Random random;
  for (int round = 0; round < 200; ++round) {
    for (const int count : {2, 3, 7}) {
      const Sample<1, 0> s(random, {count});
      const Numbers x = arguments(random, s.smooth);
      CHECK_NEAR(look(s, Interpolation::c1, x),
                 hermite(s.smooth[0], s.value, slopes(s.smooth[0], s.value), x[0]), 1e-13);
    }
    for (const std::vector<int>& counts : {std::vector<int>{4, 5}, {2, 3}, {6, 1}, {1, 4}}) {
      const Sample<2, 0> s(random, counts);
      const Numbers x = arguments(random, s.smooth);
      CHECK_NEAR(look(s, Interpolation::c1, x), nested_hermite(s.smooth[0], s.smooth[1], s.value, x[0], x[1]),
                 1e-13);
    }
  }
}

// With linear axes: the blend of the blocks, each a table of its own.
TEST(table_c1_blends_blocks_along_linear_axes) {
  Random random;
  for (int round = 0; round < 200; ++round) {
    const Sample<2, 2> s(random, {3, 4, 4, 5});
    const Numbers x = arguments(random, s.smooth);
    const Numbers p = arguments(random, s.linear);
    const std::size_t block = s.smooth[0].size() * s.smooth[1].size();
    Numbers at_block;
    for (std::size_t start = 0; start < s.value.size(); start += block) {
      const auto first = s.value.begin() + static_cast<std::ptrdiff_t>(start);
      const Numbers f(first, first + static_cast<std::ptrdiff_t>(block));
      at_block.push_back(nested_hermite(s.smooth[0], s.smooth[1], f, x[0], x[1]));
    }
    CHECK_NEAR(look(s, Interpolation::c1, x, p), multilinear(s.linear, at_block, p), 1e-13);
  }
}

TEST(table_reproduces_its_nodes) {
  Random random;
  const Sample<3, 1> s(random, {3, 4, 3, 5});
  for (const Interpolation mode : kModes) {
    std::size_t index = 0;
    for (const double p : s.linear[0])
      for (const double x : s.smooth[0])
        for (const double y : s.smooth[1])
          for (const double z : s.smooth[2])
            CHECK_NEAR(look(s, mode, Numbers{x, y, z}, Numbers{p}), s.value[index++], 1e-15);
  }
}

// One axis: between two nodes the curve stays between their values.
TEST(table_c1_does_not_overshoot) {
  Random random;
  for (int round = 0; round < 100; ++round) {
    const Sample<1, 0> s(random, {8});
    for (std::size_t i = 0; i + 1 < s.value.size(); ++i) {
      const double low = std::min(s.value[i], s.value[i + 1]);
      const double high = std::max(s.value[i], s.value[i + 1]);
      for (int k = 0; k <= 50; ++k) {
        const double x = s.smooth[0][i] + (s.smooth[0][i + 1] - s.smooth[0][i]) * k / 50;
        const double f = look(s, Interpolation::c1, Numbers{x});
        CHECK(f >= low - 1e-14 && f <= high + 1e-14);
      }
    }
  }
}

// ---- derivatives ----

// Across a knot of any axis the value and every slope go on; so do they along the knot line of another axis.
TEST(table_c1_is_continuously_differentiable_across_knots) {
  Random random;
  constexpr double side = 1e-9;
  constexpr double tolerance = 1e-6;
  for (int round = 0; round < 20; ++round) {
    const Sample<2, 0> s2(random, {5, 6});
    const Sample<3, 1> s3(random, {2, 4, 5, 4});
    const auto check = [&](const std::vector<Numbers>& axes, const auto& slopes_at) {
      for (std::size_t a = 0; a < axes.size(); ++a) {
        for (std::size_t i = 1; i + 1 < axes[a].size(); ++i) {
          Numbers x;
          for (const Numbers& k : axes) x.push_back(random.between(k.front(), k.back()));
          x[a] = axes[a][i] - side;
          const Numbers before = slopes_at(x);
          x[a] = axes[a][i] + side;
          const Numbers after = slopes_at(x);
          for (std::size_t k = 0; k < before.size(); ++k) CHECK_NEAR(before[k], after[k], tolerance);
        }
      }
    };
    check(s2.smooth, [&](const Numbers& x) {
      const auto f = look(s2, Interpolation::c1, dual_variables<2>(x));
      return Numbers{f.v, f.d.get(0), f.d.get(1)};
    });
    check(s3.smooth, [&](const Numbers& x) {
      const auto f = look(s3, Interpolation::c1, dual_variables<3>(x), Numbers{s3.linear[0][0] + 0.1});
      return Numbers{f.v, f.d.get(0), f.d.get(1), f.d.get(2)};
    });
  }
}

TEST(table_dual_derivative_agrees_with_complex_step) {
  Random random;
  using Complex = std::vector<std::complex<double>>;
  for (int round = 0; round < 100; ++round) {
    for (const Interpolation mode : kModes) {
      const Sample<1, 0> s1(random, {6});
      const Numbers x1 = arguments(random, s1.smooth);
      check_derivatives<1>(
          x1, look(s1, mode, dual_variables<1>(x1)), [&](const Numbers& x) { return look(s1, mode, x); },
          [&](const Complex& z) { return look(s1, mode, z); });
      const Sample<2, 0> s2(random, {5, 4});
      const Numbers x2 = arguments(random, s2.smooth);
      check_derivatives<2>(
          x2, look(s2, mode, dual_variables<2>(x2)), [&](const Numbers& x) { return look(s2, mode, x); },
          [&](const Complex& z) { return look(s2, mode, z); });
      const Sample<2, 2> s22(random, {3, 2, 4, 5});
      const Numbers x22 = arguments(random, s22.smooth);
      const Numbers p22 = arguments(random, s22.linear);
      check_derivatives<2>(
          x22, look(s22, mode, dual_variables<2>(x22), p22),
          [&](const Numbers& x) { return look(s22, mode, x, p22); },
          [&](const Complex& z) { return look(s22, mode, z, p22); });
      const Sample<3, 1> s31(random, {3, 4, 3, 5});
      const Numbers x31 = arguments(random, s31.smooth);
      const Numbers p31 = arguments(random, s31.linear);
      check_derivatives<3>(
          x31, look(s31, mode, dual_variables<3>(x31), p31),
          [&](const Numbers& x) { return look(s31, mode, x, p31); },
          [&](const Complex& z) { return look(s31, mode, z, p31); });
    }
  }
}

// The argument is itself a function: the chain rule through from_slopes.
TEST(table_dual_derivative_follows_the_argument) {
  Random random;
  const Sample<1, 0> s(random, {6});
  const double knot = s.smooth[0][2];
  const auto t = Dual<double, 1>::variable(0.1, 0);
  const auto direct = look(s, Interpolation::c1, dual_variables<1>({knot + 0.01}));
  const auto chained = look(s, Interpolation::c1, std::vector<Dual<double, 1>>{knot + t * t});
  CHECK_NEAR(chained.v, direct.v, 1e-15);
  CHECK_NEAR(chained.d.get(0), 0.2 * direct.d.get(0), 1e-13);
}

// ---- ends ----

TEST(table_holds_its_end_values_with_zero_slope) {
  Random random;
  const Sample<2, 0> s(random, {4, 5});
  const Numbers& x = s.smooth[0];
  const Numbers& y = s.smooth[1];
  for (const Interpolation mode : kModes) {
    const double inside = 0.5 * (y[1] + y[2]);
    for (const double end : {x.front(), x.back()}) {
      const double outside = end == x.front() ? end - 1 : end + 1;
      const auto at_end = look(s, mode, dual_variables<2>({end, inside}));
      const auto beyond = look(s, mode, dual_variables<2>({outside, inside}));
      CHECK_EQ(beyond.v, at_end.v);
      CHECK_EQ(beyond.d.get(0), 0.0);
      CHECK_NEAR(beyond.d.get(1), at_end.d.get(1), 1e-14);
    }
    const auto corner = look(s, mode, dual_variables<2>({x.back() + 1, y.front() - 1}));
    CHECK_NEAR(corner.v, s.value[(x.size() - 1) * y.size()], 1e-15);
    CHECK_EQ(corner.d.get(0), 0.0);
    CHECK_EQ(corner.d.get(1), 0.0);
  }
}

TEST(table_end_node_counts_as_inside) {
  Random random;
  const Sample<1, 0> s(random, {5});
  const Numbers& x = s.smooth[0];
  const Numbers m = slopes(x, s.value);
  const auto first = look(s, Interpolation::c1, dual_variables<1>({x.front()}));
  const auto last = look(s, Interpolation::c1, dual_variables<1>({x.back()}));
  CHECK_NEAR(first.d.get(0), m.front(), 1e-13);
  CHECK_NEAR(last.d.get(0), m.back(), 1e-13);
  const std::size_t n = x.size();
  const double last_secant = (s.value[n - 1] - s.value[n - 2]) / (x[n - 1] - x[n - 2]);
  CHECK_NEAR(look(s, Interpolation::linear, dual_variables<1>({x.back()})).d.get(0), last_secant, 1e-13);
}

// An axis with one knot is a constant.
TEST(table_axis_with_one_knot_has_no_slope) {
  Random random;
  const Sample<2, 0> s(random, {4, 1});
  const double x = 0.5 * (s.smooth[0][1] + s.smooth[0][2]);
  for (const Interpolation mode : kModes) {
    const auto on = look(s, mode, dual_variables<2>({x, s.smooth[1][0]}));
    const auto off = look(s, mode, dual_variables<2>({x, 99.0}));
    CHECK_EQ(on.v, off.v);
    CHECK_EQ(on.d.get(1), 0.0);
    CHECK_EQ(off.d.get(1), 0.0);
    CHECK_EQ(on.d.get(0), off.d.get(0));
  }
}

TEST(table_finds_every_interval) {
  Random random;
  for (int count = 2; count <= tiltrotor::kMaxKnots; ++count) {
    const Numbers knots = uneven_knots(random, count);
    const Axis<double> axis{count, knots.data(), nullptr, 0, 0};
    for (int i = 0; i < count; ++i) {
      const int expected = std::min(i, count - 2);
      CHECK_EQ(tiltrotor::find_interval(axis, knots[static_cast<std::size_t>(i)]), expected);
      CHECK_EQ(tiltrotor::find_interval(axis, knots[static_cast<std::size_t>(i)] + 0.1), expected);
    }
    CHECK_EQ(tiltrotor::find_interval(axis, knots[0] - 1), 0);
  }
}

// ---- slopes ----

TEST(table_slopes_of_straight_lines_and_extrema) {
  const Numbers x{0, 1, 3, 4};
  Numbers m(4);
  const Numbers line{1, 3, 7, 9};
  tiltrotor::monotone_slopes(4, x.data(), line.data(), m.data(), 1);
  for (const double slope : m) CHECK_NEAR(slope, 2.0, 1e-15);
  const Numbers hill{0, 2, 2, 0};
  tiltrotor::monotone_slopes(4, x.data(), hill.data(), m.data(), 1);
  CHECK_EQ(m[1], 0.0);
  CHECK_EQ(m[2], 0.0);
  // End after an extremum: at most three times the secant of the end interval.
  const Numbers spike{0, 1, -50, -51};
  tiltrotor::monotone_slopes(4, x.data(), spike.data(), m.data(), 1);
  CHECK_EQ(m[0], 3.0);
}

TEST(table_works_in_single_precision) {
  const float knots[] = {0.0F, 1.0F, 3.0F};
  float node[] = {1.0F, 0.0F, 2.0F, 0.0F, 5.0F, 0.0F};
  float scratch[6];
  const Axis<float> axis[1] = {{3, knots, nullptr, 0, 0}};
  tiltrotor::fill_slopes<float, 1>(axis, node, scratch);
  const Table<float, 1> table{{{3, knots}}, {{0, nullptr}}, node};
  const double expected = hermite({0, 1, 3}, {1, 2, 5}, slopes({0, 1, 3}, {1, 2, 5}), 2.2);
  CHECK_NEAR(tiltrotor::lookup(table, Interpolation::c1, 2.2F), expected, 1e-6);
  const auto f = tiltrotor::lookup(table, Interpolation::c1, Dual<float, 1>::variable(2.2F, 0));
  CHECK_NEAR(f.v, expected, 1e-6);
}

}  // namespace

// An axis with one knot has one value everywhere.
TEST(table_linear_axis_of_one_knot) {
  const double knot[] = {3};
  const Axis<double> axis{1, knot};
  for (double x : {-1e9, 2.9, 3.0, 3.1, 1e9}) {
    const GridPoint<double> p = grid_point(axis, x);
    CHECK(p.interval == 0 && p.fraction == 0);
  }
}
