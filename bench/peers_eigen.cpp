// Eigenvalues and linear systems with Eigen's matrices of fixed size.
#include <Eigen/Dense>

#include "peers_algebra.hpp"

using namespace bench;

namespace {

template <int N>
struct EigenAlgebra {
  using Square = Eigen::Matrix<double, N, N>;
  Square a[kMatrices];
  Eigen::Matrix<double, N, 1> b, x;
  Eigen::EigenSolver<Square> eigen;
  Eigen::PartialPivLU<Square> lu;
  int turn = 0;
  bool ok = true;

  explicit EigenAlgebra(const MatrixSet<N>& set) {
    for (int k = 0; k < kMatrices; ++k)
      for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j) a[k](i, j) = set.a[k](i, j);
    for (int i = 0; i < N; ++i) b(i) = set.b[i];
  }
  void find_values() { ok = ok && eigen.compute(a[next(turn)], false).info() == Eigen::Success; }
  void find_vectors() { ok = ok && eigen.compute(a[next(turn)], true).info() == Eigen::Success; }
  void solve() { x = lu.compute(a[next(turn)]).solve(b); }
};

}  // namespace

int main(int argc, char** argv) {
  require(argc == 2, "usage: bench_peers_eigen DIRECTORY");
  introduce(
      "Peer: Eigen, fixed size (it does not balance; its eigensystem has right vectors alone, ours both)");
  Results results(argv[1]);
  compare_algebra<EigenAlgebra>("eigen", results);
  results.save();
}
