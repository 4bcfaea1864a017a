// Places on linear axes that carry partials: slopes of a table along mast angle and flap, by hand.
#include <complex>

#include "check.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"
#include "tiltrotor/math/tables/table.hpp"

using namespace tiltrotor;

namespace {

using D = Dual<double, 1>;
constexpr double kKnots[] = {0, 30, 90};
const Axis<double> kAxis{3, kKnots};

// f = 2, 5, 17 at the knots along the linear axis, times 1 + 3 x of the smooth axis from 0 to 1.
constexpr double kSmooth[] = {0, 1};
constexpr double kNodes[] = {2, 0, 8, 0, 5, 0, 20, 0, 17, 0, 68, 0};
const Table<double, 1, 1> kTable{{{2, kSmooth}}, {kAxis}, kNodes};

struct Expected {
  double at;
  int interval;
  double fraction, slope;
  double value, along;  // of the table at x = 0.5, and its slope along the linear axis
};
constexpr Expected kExpected[] = {
    {12, 0, 0.4, 1.0 / 30, 2.5 * 3.2, 2.5 * 0.1},
    {75, 1, 0.75, 1.0 / 60, 2.5 * 14, 2.5 * 0.2},
    {0, 0, 0, 1.0 / 30, 2.5 * 2, 2.5 * 0.1},    // a knot: the interval above
    {30, 1, 0, 1.0 / 60, 2.5 * 5, 2.5 * 0.2},   // likewise, though the corner above weighs nothing
    {90, 1, 1, 1.0 / 60, 2.5 * 17, 2.5 * 0.2},  // the last: the interval below
    {-1, 0, 0, 0, 2.5 * 2, 0},                  // outside the end holds
    {91, 1, 1, 0, 2.5 * 17, 0},
};

}  // namespace

TEST(table_place_carries_the_slope_of_its_interval) {
  for (const Expected& e : kExpected) {
    const GridPoint<double> plain = grid_point(kAxis, e.at);
    const GridPoint<D> place = grid_point(kAxis, D::variable(e.at, 0));
    const GridPoint<std::complex<double>> step = grid_point(kAxis, std::complex<double>(e.at, 1e-30));
    CHECK_EQ(place.interval, e.interval);
    CHECK_EQ(step.interval, e.interval);
    CHECK_EQ(plain.interval, e.interval);
    CHECK_EQ(place.fraction.v, plain.fraction);
    CHECK_NEAR(plain.fraction, e.fraction, 1e-15);
    CHECK_NEAR(place.fraction.d.get(0), e.slope, 1e-17);
    CHECK_NEAR(step.fraction.imag() / 1e-30, e.slope, 1e-17);
  }
}

TEST(table_carries_the_slope_along_its_linear_axis) {
  for (const Expected& e : kExpected) {
    const GridPoint<D> place[1] = {grid_point(kAxis, D::variable(e.at, 0))};
    const D x[1] = {D(0.5)};
    const D f = lookup(kTable, Interpolation::linear, place, x);
    CHECK_NEAR(f.v, e.value, 1e-14);
    CHECK_NEAR(f.d.get(0), e.along, 1e-15);

    const GridPoint<double> plain[1] = {grid_point(kAxis, e.at)};
    const double half[1] = {0.5};
    CHECK_EQ(lookup(kTable, Interpolation::linear, plain, half), f.v);
  }
}
