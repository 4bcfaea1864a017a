#include "tablegen/bounded_least.hpp"

#include <algorithm>
#include <cmath>

namespace tablegen {

namespace {

struct Form {
  const SquareMatrix& a;
  const std::vector<double>& centre;
  const std::vector<double>& pull;

  std::vector<double> gradient(const std::vector<double>& x) const {
    std::vector<double> g(a.n);
    for (std::size_t i = 0; i < a.n; ++i) {
      for (std::size_t k = 0; k < a.n; ++k) g[i] += a(i, k) * x[k];
      g[i] += pull[i] * (x[i] - centre[i]);
    }
    return g;
  }
  // Along d from x, where the gradient is g: exact, so that small gains are seen.
  double change(const std::vector<double>& g, const std::vector<double>& d) const {
    double sum = 0;
    for (std::size_t i = 0; i < a.n; ++i) {
      double bent = pull[i] * d[i];
      for (std::size_t k = 0; k < a.n; ++k) bent += a(i, k) * d[k];
      sum += d[i] * (g[i] + bent / 2);
    }
    return sum;
  }
};

}  // namespace

std::vector<double> bounded_least(const SquareMatrix& a, const std::vector<double>& centre,
                                  const std::vector<double>& half_width, const std::vector<double>& pull) {
  constexpr int most_steps = 200;
  constexpr int most_halvings = 40;
  constexpr double resolution = 1e-12;  // of the first fall
  const Form form{a, centre, pull};
  const auto bounded = [&](std::size_t i, double x) {
    return std::min(std::max(x, centre[i] - half_width[i]), centre[i] + half_width[i]);
  };
  std::vector<double> x = centre;
  double first_fall = 0;
  for (int step = 0; step < most_steps; ++step) {
    const std::vector<double> g = form.gradient(x);
    std::vector<std::size_t> free;
    for (std::size_t i = 0; i < a.n; ++i) {
      const bool held = (x[i] <= centre[i] - half_width[i] && g[i] >= 0) ||
                        (x[i] >= centre[i] + half_width[i] && g[i] <= 0);
      if (!held) free.push_back(i);
    }
    if (free.empty()) break;
    SquareMatrix system(free.size());
    std::vector<double> d(free.size());
    for (std::size_t r = 0; r < free.size(); ++r) {
      for (std::size_t c = 0; c < free.size(); ++c) system(r, c) = a(free[r], free[c]);
      system(r, r) += pull[free[r]];
      d[r] = -g[free[r]];
    }
    solve(factorised(system), d);

    double fall = 0;
    double length = 1;
    for (int halving = 0; halving < most_halvings && !(fall < 0); ++halving, length /= 2) {
      std::vector<double> moved = x;
      std::vector<double> by(a.n);
      for (std::size_t r = 0; r < free.size(); ++r) {
        const std::size_t i = free[r];
        moved[i] = bounded(i, x[i] + length * d[r]);
        by[i] = moved[i] - x[i];
      }
      fall = form.change(g, by);
      if (fall < 0) x = moved;
    }
    if (step == 0) first_fall = fall;
    if (!(fall < resolution * first_fall)) break;
  }
  return x;
}

}  // namespace tablegen
