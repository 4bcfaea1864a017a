// Matrices for the benchmarks of linear algebra: full, random, with a known seed.
#pragma once

#include <random>

#include "tiltrotor/math/algebra/eigen.hpp"
#include "tiltrotor/math/algebra/lu.hpp"

namespace bench {

using namespace tiltrotor;

inline constexpr int kMatrices = 16;  // taken in turn, so that no branch learns the path of one of them

template <int N>
struct MatrixSet {
  Matrix<double, N, N> a[kMatrices];
  double b[N];
};

template <int N>
void fill_at_random(MatrixSet<N>& set) {
  std::mt19937 random(N);
  std::uniform_real_distribution<double> entry(-1, 1);
  for (Matrix<double, N, N>& a : set.a) {
    set_zero(a);
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) a(i, j) = entry(random);
  }
  for (double& x : set.b) x = entry(random);
}

// The next of 0 .. kMatrices - 1.
inline int next(int& turn) { return turn = (turn + 1) % kMatrices; }

// Our own eigenvalues, eigenvectors and linear solution, one matrix after another.
template <int N>
struct OurAlgebra {
  const MatrixSet<N>& set;
  EigenWorkspace<double, N> eigen;
  Eigenvalues<double, N> values;
  Eigensystem<double, N> system;
  LU<double, N> lu;
  double x[N];
  int turn = 0;
  bool ok = true;

  explicit OurAlgebra(const MatrixSet<N>& matrices) : set(matrices) {}
  void find_values() { ok = ok && eigenvalues(set.a[next(turn)], N, eigen, values) == Status::ok; }
  void find_vectors() { ok = ok && eigensystem(set.a[next(turn)], N, eigen, system) == Status::ok; }
  void solve() {
    for (int i = 0; i < N; ++i) x[i] = set.b[i];
    ok = ok && lu_factor(set.a[next(turn)], N, lu) == Status::ok && lu_solve(lu, x) == Status::ok;
  }
};

}  // namespace bench
