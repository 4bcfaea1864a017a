// The Jacobian with Eigen's AutoDiffScalar.
#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

#include "peers_jacobian.hpp"
#include "peers_scalar.hpp"

using namespace bench;

using Derivatives = Eigen::Matrix<double, kPeerDirections, 1>;
using Number = Eigen::AutoDiffScalar<Derivatives>;
using Scalar = Foreign<Number>;

template <>
struct bench::PeerRules<Number> {
  static double value(const Number& x) { return x.value(); }
  static Number from_slopes(double value, int count, const double* slope, const Scalar* const* x) {
    Number result(value, slope[0] * x[0]->n.derivatives());
    for (int a = 1; a < count; ++a) result.derivatives() += slope[a] * x[a]->n.derivatives();
    return result;
  }
};

int main(int argc, char** argv) {
  require(argc == 2, "usage: bench_peers_eigen_autodiff DIRECTORY");
  introduce("Peer: Eigen::AutoDiffScalar<Matrix<double, 32, 1>>");
  Results results(argv[1]);
  const auto p = peer_case();
  compare_jacobian(
      *p, "eigen_autodiff",
      forward_pass<Scalar>(
          *p, [](Scalar& x, double value, int direction) { x.n = Number(value, kPeerDirections, direction); },
          [](const Scalar& y, int direction) { return y.n.derivatives()(direction); }),
      results);
  results.save();
}
