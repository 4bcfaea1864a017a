// What the tests of eigenvalues and eigenvectors share: matrices, their workspace, distances and residuals.
#pragma once

#include <algorithm>
#include <complex>
#include <random>
#include <vector>

#include "check.hpp"
#include "tiltrotor/math/algebra/eigen.hpp"

namespace eigen_bench {

using namespace tiltrotor;
using Cplx = std::complex<double>;

inline constexpr double kEps = 2.220446049250313e-16;
inline constexpr double kPiHere = 3.14159265358979323846;
inline const double kNan = std::numeric_limits<double>::quiet_NaN();
inline const double kInfinity = std::numeric_limits<double>::infinity();

template <class R, int N>
void fill_random(Matrix<R, N, N>& a, int n, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  fill(a, std::numeric_limits<R>::quiet_NaN());  // nothing beyond n may be read
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) a(i, j) = static_cast<R>(normal(generator));
}

template <class R, int N>
double norm(const Matrix<R, N, N>& a, int n) {
  double square = 0.0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) square += static_cast<double>(a(i, j)) * static_cast<double>(a(i, j));
  return std::sqrt(square);
}

template <class R, int N>
Cplx eigenvalue(const Eigenvalues<R, N>& values, int k) {
  return {static_cast<double>(values.real[k]), static_cast<double>(values.imag[k])};
}
template <class R>
Cplx number(ComplexEntry<R> z) {
  return {static_cast<double>(z.real), static_cast<double>(z.imag)};
}

// Largest distance from an expected eigenvalue to its partner, each computed one used once.
template <class R, int N>
double distance(const Eigenvalues<R, N>& values, const std::vector<Cplx>& expected, bool relative = false) {
  std::vector<Cplx> left;
  for (int k = 0; k < values.size; ++k) left.push_back(eigenvalue(values, k));
  double worst = left.size() == expected.size() ? 0.0 : kInfinity;
  for (Cplx z : expected) {
    auto nearest = left.begin();
    for (auto it = left.begin(); it != left.end(); ++it)
      if (!(std::abs(*it - z) >= std::abs(*nearest - z))) nearest = it;
    const double error = std::abs(*nearest - z) / (relative ? std::abs(z) : 1.0);
    worst = error <= worst ? worst : error;  // keeps NaN
    left.erase(nearest);
  }
  return worst;
}

// Largest of |A v - lambda v|, |A^T conj(w) - lambda conj(w)|, over |A|; checks unit length and pair order on
// the way.
template <class R, int N>
double residual(const Matrix<R, N, N>& a, int n, const Eigensystem<R, N>& system, double tolerance) {
  double worst = 0.0;
  const double size = std::max(norm(a, n), 1e-300);
  for (int k = 0; k < n; ++k) {
    const Cplx lambda = eigenvalue(system.values, k);
    double right_square = 0.0, left_square = 0.0, v_square = 0.0, w_square = 0.0;
    for (int i = 0; i < n; ++i) {
      const Cplx v_i = number(right_entry(system, i, k)), w_i = number(left_entry(system, i, k));
      Cplx right = -lambda * v_i, left = -lambda * std::conj(w_i);
      for (int j = 0; j < n; ++j) {
        right += static_cast<double>(a(i, j)) * number(right_entry(system, j, k));
        left += static_cast<double>(a(j, i)) * std::conj(number(left_entry(system, j, k)));
      }
      right_square += std::norm(right / size);
      left_square += std::norm(left / size);
      v_square += std::norm(v_i);
      w_square += std::norm(w_i);
    }
    CHECK_NEAR(v_square, 1.0, tolerance);
    CHECK_NEAR(w_square, 1.0, tolerance);
    if (system.values.imag[k] > R(0)) CHECK_EQ(system.values.imag[k + 1], -system.values.imag[k]);
    const double here = std::sqrt(std::max(right_square, left_square));
    worst = here <= worst ? worst : here;
  }
  return worst;
}

template <class R, int N>
struct Bench {  // everything a test needs, static because of its size
  Matrix<R, N, N> a;
  EigenWorkspace<R, N> work;
  Eigenvalues<R, N> values;
  Eigensystem<R, N> system;
};
inline Bench<double, 31> bench;
inline Bench<float, 24> bench_float;

// Both routes on bench.a against known eigenvalues, and the residual of the vectors.
inline void check_known(int n, const std::vector<Cplx>& expected, double tolerance) {
  CHECK(eigenvalues(bench.a, n, bench.work, bench.values) == Status::ok);
  CHECK(eigensystem(bench.a, n, bench.work, bench.system) == Status::ok);
  CHECK_EQ(bench.values.converged, n);
  CHECK_LE(distance(bench.values, expected), tolerance);
  CHECK_LE(distance(bench.system.values, expected), tolerance);
  CHECK_LT(residual(bench.a, n, bench.system, 1e-12), 1e-13);
}

}  // namespace eigen_bench
