// Cubic splines with two continuous derivatives as linear maps of the values at their knots: slopes, and roughness.
//
//   slope      [i][k] = d s'(x_i) / d f_k
//   roughness  sum_ik f_i roughness[i][k] f_k = integral of s''^2
//
// Natural ends (s'' = 0), or, where the knots go once around, one value, slope and second derivative at both.
// The spline is the curve of least roughness through its values (Holladay 1957; de Boor 1978).
#pragma once

#include <vector>

namespace tablegen {

// Square, row by row.
struct SquareMatrix {
  explicit SquareMatrix(std::size_t order) : n(order), entry(order * order) {}
  double& operator()(std::size_t row, std::size_t column) { return entry[row * n + column]; }
  double operator()(std::size_t row, std::size_t column) const { return entry[row * n + column]; }
  std::size_t n;
  std::vector<double> entry;
};

// Cholesky's factor of a positive definite matrix, in its lower half; the upper is left. What is left of a pivot that
// rounding has eaten is taken as rounding.
SquareMatrix factorised(SquareMatrix a);
void solve(const SquareMatrix& factor, std::vector<double>& x);

struct Spline {
  SquareMatrix slope, roughness;
};

// Of one knot or more.
Spline spline_on(const std::vector<double>& knot, bool around);

}  // namespace tablegen
