// How the tables of the source are put together. Between knots everything is linear, as in the source;
// outside its range a curve keeps its end value.
#pragma once

#include <vector>

#include "tablegen/grid.hpp"

namespace tablegen {

double at(const Curve& curve, double x);

// How far print rounded the value there; infinite between the printed ones.
double half_unit_at(const Curve& curve, double x);

// The same curve on other knots. Where these go once around the circle, -180..180 deg, and the curve does
// not, its two held values meet at the ends, which are one place: each becomes their mean there.
Curve resampled(const Curve& curve, const std::vector<double>& knots);

// Knots that go once around the circle, in degrees.
bool around_circle(const std::vector<double>& knots);

// All knots of both, increasing.
std::vector<double> union_of(const std::vector<double>& a, const std::vector<double>& b);

// `curve` where it is defined, `extension` before and behind.
Curve extended(const Curve& curve, const Curve& extension);

// An odd function given for x >= 0, f(0) = 0, with its other half written out, so that 0 is an inner knot.
Curve with_odd_half(const Curve& half);

// Columns side by side over a second argument, on the knots of all of them together.
struct Surface {
  std::vector<double> x;
  std::vector<double> y;
  std::vector<Curve> column;  // one for each y, all on x
};
Surface side_by_side(const std::vector<Curve>& columns, const std::vector<double>& y);

// A first Mach column above 0 stands for the whole range from 0: its copy at Mach 0 goes before it.
Surface from_mach_0(Surface surface);

}  // namespace tablegen
