// One computation with dual numbers, compiled twice: with the compiler's vector types and with portable
// lanes.
#pragma once

#include <random>
#include <vector>

namespace lane_program {

constexpr unsigned kSeed = 2718;

// Values and partials of a chain of all operations, from random arguments. `D`: a dual with N partials of
// type R.
template <class D, class R, int N>
std::vector<R> results() {
  std::mt19937 engine(kSeed);
  std::uniform_real_distribution<double> uniform(0.2, 1.3);
  const auto dual = [&] {
    D x(static_cast<R>(uniform(engine)));
    for (int j = 0; j < N; ++j) x.d.set(j, static_cast<R>(uniform(engine)));
    return x;
  };
  std::vector<R> out;
  for (int n = 0; n < 20; ++n) {
    const D a = dual();
    const D b = dual();
    D c = a * b + sin(a) / (b + R(1));
    c = c - cos(b) * R(0.5) + R(2) / a;
    c *= sqrt(b) - R(0.1);
    c += atan2(a, b) * tan(D(b * R(0.5)));
    c -= -a;
    out.push_back(c.v);
    for (int j = 0; j < N; ++j) out.push_back(c.d.get(j));
  }
  return out;
}

}  // namespace lane_program

// Results of the portable build.
std::vector<double> portable_lane_results(int partials);
std::vector<float> portable_lane_results_float(int partials);
