// The C2 fit of the table generator, on small cases.
// Expected: natural and closed splines solved by hand (de Boor 1978), fits whose least roughness is plain.
#include <cmath>
#include <limits>

#include "check.hpp"
#include "tablegen/c2_fit.hpp"
#include "tablegen/flat_knots.hpp"
#include "tablegen/spline.hpp"

namespace {

using Numbers = std::vector<double>;

tablegen::TableArray curve(const Numbers& knot, const Numbers& value, double half) {
  return {"htail.made_up", "", {knot}, {}, value, Numbers(value.size(), half)};
}

double value(const tablegen::C2Fit& fit, std::size_t knot) { return fit.node[2 * knot]; }
double slope(const tablegen::C2Fit& fit, std::size_t knot) { return fit.node[2 * knot + 1]; }

constexpr double kNarrow = 1e-12;

}  // namespace

// Second derivatives 0, -4, 4, 0: 4 a + b = -12, a + 4 b = 12.
TEST(tablegen_c2_is_the_natural_spline_of_four_points) {
  const tablegen::C2Fit fit = tablegen::c2_fit(curve({0, 1, 2, 3}, {0, 1, 0, 1}, kNarrow));
  const double slopes[] = {5.0 / 3, -1.0 / 3, -1.0 / 3, 5.0 / 3};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK_NEAR(value(fit, i), static_cast<double>(i % 2), 2 * kNarrow);
    CHECK_NEAR(slope(fit, i), slopes[i], 1e-10);
  }
  // Unequal intervals: 2 (1 + 3) m = 6 (1/3 - 1).
  const tablegen::C2Fit bent = tablegen::c2_fit(curve({0, 1, 4}, {0, 1, 2}, kNarrow));
  CHECK_NEAR(slope(bent, 0), 1 + 0.5 / 6, 1e-10);
  CHECK_NEAR(slope(bent, 1), 1 - 2 * 0.5 / 6, 1e-10);
  CHECK_NEAR(slope(bent, 2), 1.0 / 3 - 3 * 0.5 / 6, 1e-10);
}

// On equal knots around a circle the spline of sin(kx) has the slopes of k cos(kx) times 3 sin(kh)/(kh (2 + cos(kh))).
TEST(tablegen_c2_closes_around_the_circle) {
  constexpr double radian = 3.14159265358979323846 / 180;
  Numbers knot, sine;
  for (int x = -180; x <= 180; x += 30) {
    knot.push_back(x);
    sine.push_back(std::sin(2 * radian * x));
  }
  sine.back() = sine.front();
  const tablegen::C2Fit fit = tablegen::c2_fit(curve(knot, sine, kNarrow));
  const double h = 30 * radian;
  const double factor = 3 * std::sin(2 * h) / (h * (2 + std::cos(2 * h))) * radian;
  for (std::size_t i = 0; i < knot.size(); ++i)
    CHECK_NEAR(slope(fit, i), factor * std::cos(2 * radian * knot[i]), 1e-10);
  CHECK(slope(fit, 0) == slope(fit, knot.size() - 1));
}

// Roughness of three equal steps is 3/2 (f0 - 2 f1 + f2)^2.
TEST(tablegen_c2_uses_the_half_unit_of_print) {
  const tablegen::C2Fit corner = tablegen::c2_fit(curve({0, 1, 2}, {0, 1, 0}, 0.1));
  CHECK_NEAR(value(corner, 0), 0.1, 1e-12);
  CHECK_NEAR(value(corner, 1), 0.9, 1e-12);
  CHECK_NEAR(value(corner, 2), 0.1, 1e-12);
  CHECK_NEAR(corner.deviation, 1, 1e-12);
  CHECK_NEAR(corner.roughness, 1.6 * 1.6 / 4, 1e-12);
  // Straight lines are within print: the nearest to it, by least squares.
  const tablegen::C2Fit straight = tablegen::c2_fit(curve({0, 1, 2}, {0, 0.1, 0}, 0.1));
  for (std::size_t i = 0; i < 3; ++i) CHECK_NEAR(value(straight, i), 0.1 / 3, 1e-6);
  CHECK(straight.roughness < 1e-9);
  // What is straight in print stays.
  const tablegen::C2Fit same = tablegen::c2_fit(curve({0, 1, 4}, {1, 3, 9}, 0.5));
  for (std::size_t i = 0; i < 3; ++i) CHECK_NEAR(slope(same, i), 2, 1e-14);
  CHECK_EQ(same.deviation, 0.0);
}

// A value between printed ones is free: the curve is the spline of the others.
TEST(tablegen_c2_leaves_unprinted_values_free) {
  tablegen::TableArray table = curve({0, 1, 2, 3}, {0, 5, 4, 0}, kNarrow);
  table.half[1] = std::numeric_limits<double>::infinity();
  const tablegen::C2Fit fit = tablegen::c2_fit(table);
  const double m = -6;  // at 2: 2 (2 + 1) m = 6 (-4 - 2); before it f = m x^3 / 12 + (2 - m / 3) x
  CHECK_NEAR(value(fit, 1), 2 - m / 4, 1e-9);
  CHECK_NEAR(slope(fit, 1), 2 - m / 12, 1e-9);
  CHECK(fit.deviation <= 1);
}

// Along both axes f = g(x) k(y) has the tensor product of both splines; along Mach number the monotone slopes.
TEST(tablegen_c2_of_two_axes) {
  const Numbers x = {0, 1, 2, 3}, g = {0, 1, 0, 1};
  const Numbers y = {0, 2, 4}, k = {1, 2, 1};
  const Numbers gx = {5.0 / 3, -1.0 / 3, -1.0 / 3, 5.0 / 3}, ky = {0.75, 0, -0.75};
  tablegen::TableArray table{"fin.made_up", "", {x, y}, {}, {}, {}};
  for (const double a : g)
    for (const double b : k) table.value.push_back(a * b);
  table.half.assign(table.value.size(), kNarrow);
  const tablegen::C2Fit fit = tablegen::c2_fit(table);
  table.over_mach = true;
  const tablegen::C2Fit over_mach = tablegen::c2_fit(table);
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < y.size(); ++j) {
      const double* const node = &fit.node[4 * (i * y.size() + j)];
      CHECK_NEAR(node[1], gx[i] * k[j], 1e-10);
      CHECK_NEAR(node[2], g[i] * ky[j], 1e-10);
      CHECK_NEAR(node[3], gx[i] * ky[j], 1e-10);
    }
    CHECK_NEAR(over_mach.node[4 * (i * y.size() + 1) + 2], 0, 1e-9);  // at the top
  }
}

// Least of a form within bounds: where the gradient pushes against the bound, and vanishes elsewhere.
TEST(tablegen_c2_fit_meets_the_conditions_of_a_least) {
  Numbers knot, value, half;
  for (int i = 0; i < 60; ++i) {
    knot.push_back(i + 0.3 * std::sin(1.7 * i));
    value.push_back(std::round(100 * std::sin(0.2 * knot.back())) / 100);
    half.push_back(i % 3 == 0 ? 0.005 : 0.02);
  }
  tablegen::TableArray table{"wing.made_up", "", {knot}, {}, value, half};
  const tablegen::C2Fit fit = tablegen::c2_fit(table);
  const tablegen::SquareMatrix form = tablegen::spline_on(knot, false).roughness;
  int held = 0;
  double largest = 0;
  for (std::size_t i = 0; i < knot.size(); ++i) {
    double g = 0, size = 0;
    for (std::size_t k = 0; k < knot.size(); ++k) {
      g += form(i, k) * fit.node[2 * k];
      size += std::fabs(form(i, k) * fit.node[2 * k]);
    }
    const double off = (fit.node[2 * i] - value[i]) / half[i];
    CHECK(std::fabs(off) <= 1 + 1e-12);
    const bool at_bound = std::fabs(off) > 1 - 1e-9;
    held += at_bound ? 1 : 0;
    const double wrong = at_bound ? std::max(g * off, 0.0) : std::fabs(g);
    largest = std::max(largest, wrong / size);
  }
  NOTE("held " << held << " of 60, largest gradient left " << largest << " of its terms");
  CHECK(held > 5 && held < 60);
  CHECK(largest < 1e-6);
}

// 1 from 2 on, after a dip: knots at half the interval beside, twice as far, .., and never half a unit away there.
TEST(tablegen_c2_stays_where_print_repeats_a_value) {
  const tablegen::TableArray table = curve({0, 1, 2, 12}, {1, 0, 1, 1}, 0.05);
  const tablegen::TableArray graded = tablegen::with_flat_knots(table);
  CHECK(graded.smooth[0] == (Numbers{0, 1, 2, 2.5, 3, 4, 6, 12}));
  const tablegen::C2Fit fit = tablegen::c2_fit(graded);
  for (std::size_t i = 2; i < 8; ++i) CHECK_LE(std::fabs(value(fit, i) - 1), 0.05 + 1e-12);
  const tablegen::C2Fit swinging = tablegen::c2_fit(table);
  const auto between = [](const tablegen::C2Fit& f, std::size_t i, double h) {
    return (value(f, i) + value(f, i + 1)) / 2 + h / 8 * (slope(f, i) - slope(f, i + 1));
  };
  CHECK(between(swinging, 2, 10) > 1.5);
  CHECK_LE(between(fit, 6, 6), 1.06);
  // On two axes the lines that bend there are free.
  tablegen::TableArray two{"fin.made_up", "", {{0, 1, 5}, {0, 1}}, {}, {0, 0, 1, 1, 1, 2}, Numbers(6, 0.05)};
  const tablegen::TableArray free = tablegen::with_flat_knots(two);
  CHECK(free.smooth[0] == (Numbers{0, 1, 1.5, 2, 3, 5}));
  CHECK_EQ(free.half[4], 0.05);
  CHECK(std::isinf(free.half[5]));
  CHECK_NEAR(free.value[5], 1.125, 1e-15);
}
