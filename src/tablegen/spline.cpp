#include "tablegen/spline.hpp"

#include <algorithm>
#include <cmath>

namespace tablegen {

SquareMatrix factorised(SquareMatrix a) {
  constexpr double rounding = 1e-14;
  for (std::size_t j = 0; j < a.n; ++j) {
    const double whole = a(j, j);
    for (std::size_t i = j; i < a.n; ++i) {
      double sum = a(i, j);
      for (std::size_t k = 0; k < j; ++k) sum -= a(i, k) * a(j, k);
      a(i, j) = i == j ? std::sqrt(std::max(sum, rounding * whole)) : sum / a(j, j);
    }
  }
  return a;
}

void solve(const SquareMatrix& factor, std::vector<double>& x) {
  for (std::size_t i = 0; i < factor.n; ++i) {
    for (std::size_t k = 0; k < i; ++k) x[i] -= factor(i, k) * x[k];
    x[i] /= factor(i, i);
  }
  for (std::size_t i = factor.n; i-- > 0;) {
    for (std::size_t k = i + 1; k < factor.n; ++k) x[i] -= factor(k, i) * x[k];
    x[i] /= factor(i, i);
  }
}

// The second derivatives m follow from the secants d = df/h: at every knot between two intervals
//   h0 m_before + 2 (h0 + h1) m + h1 m_after = 6 (d1 - d0)
Spline spline_on(const std::vector<double>& knot, bool around) {
  const std::size_t n = knot.size();
  Spline spline{SquareMatrix(n), SquareMatrix(n)};
  if (n < 2) return spline;
  const std::size_t intervals = n - 1;
  std::vector<double> h;
  for (std::size_t i = 0; i < intervals; ++i) h.push_back(knot[i + 1] - knot[i]);

  const std::size_t first = around ? 0 : 1;  // unknowns: m of the knots first, first + 1, ..
  const std::size_t unknowns = around ? intervals : n - 2;
  std::vector<std::vector<double>> bend(n, std::vector<double>(n));  // [i][k] = d m_i / d f_k
  if (unknowns > 0) {
    SquareMatrix system(unknowns);
    const auto before = [&](std::size_t u) {
      return (u + first + intervals - 1) % intervals;
    };  // an interval
    const auto after = [&](std::size_t u) { return (u + first) % intervals; };
    for (std::size_t u = 0; u < unknowns; ++u) {
      system(u, u) += 2 * (h[before(u)] + h[after(u)]);
      if (!around && u + 1 == unknowns) continue;
      const std::size_t next = (u + 1) % unknowns;
      system(u, next) += h[after(u)];
      system(next, u) += h[after(u)];
    }
    const SquareMatrix factor = factorised(system);
    for (std::size_t k = 0; k < n; ++k) {
      const auto secant = [&](std::size_t i) { return ((k == i + 1) - (k == i)) / h[i]; };
      std::vector<double> m(unknowns);
      for (std::size_t u = 0; u < unknowns; ++u) m[u] = 6 * (secant(after(u)) - secant(before(u)));
      solve(factor, m);
      for (std::size_t u = 0; u < unknowns; ++u) bend[u + first][k] = m[u];
      if (around) bend[n - 1][k] = m[0];
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    const auto secant = [&](std::size_t i) { return ((k == i + 1) - (k == i)) / h[i]; };
    for (std::size_t i = 0; i < intervals; ++i)
      spline.slope(i, k) = secant(i) - h[i] / 6 * (2 * bend[i][k] + bend[i + 1][k]);
    spline.slope(n - 1, k) =
        around ? spline.slope(0, k) : secant(n - 2) + h[n - 2] / 6 * (bend[n - 2][k] + 2 * bend[n - 1][k]);
  }
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t k = 0; k < n; ++k) {
      double sum = 0;
      for (std::size_t i = 0; i < intervals; ++i) {
        const double here = bend[i][k];
        const double there = bend[i + 1][k];
        sum += h[i] / 6 * (bend[i][j] * (2 * here + there) + bend[i + 1][j] * (here + 2 * there));
      }
      spline.roughness(j, k) = sum;
    }
  }
  return spline;
}

}  // namespace tablegen
