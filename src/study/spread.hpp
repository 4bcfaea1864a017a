// How far a number may lie around its value, from the changes that doubtful inputs make, and as a band of a figure.
#pragma once

#include <vector>

#include "plot/plot.hpp"
#include "text/table.hpp"

namespace tiltrotor::study {

// Of one number when one input stands at the lower and at the upper end of its range.
struct EndChange {
  double at_low, at_high;
};

// How far a number may lie below and above its value; not negative.
struct Spread {
  double below, above;
};

// Changes upwards and changes downwards apart, each the root of the sum of its squares, as for independent inputs.
// A change that is not known, NaN, leaves the spread unknown.
Spread root_sum_square(const std::vector<EndChange>& changes);

// The part of an input in the squares that make the spread; 0 where there is none.
double share(const EndChange& change, const Spread& spread);

// A band around a curve from rows with x, `below` and `above`, x rising; between them linear, only where they reach.
// `factor`: of the curve's unit.
plot::Band band_around(const plot::Series& curve, const text::Table& rows, const char* x_column,
                       double factor = 1);

}  // namespace tiltrotor::study
