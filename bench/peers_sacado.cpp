// The Jacobian with Sacado's forward mode of fixed size.
#include <Sacado_No_Kokkos.hpp>

#include "peers_jacobian.hpp"
#include "peers_scalar.hpp"

using namespace bench;

using Number = Sacado::Fad::SFad<double, kPeerDirections>;
using Scalar = Foreign<Number>;

template <>
struct bench::PeerRules<Number> {
  static double value(const Number& x) { return x.val(); }
  static Number from_slopes(double value, int count, const double* slope, const Scalar* const* x) {
    Number result(value);
    for (int i = 0; i < kPeerDirections; ++i) {
      double sum = slope[0] * x[0]->n.fastAccessDx(i);
      for (int a = 1; a < count; ++a) sum += slope[a] * x[a]->n.fastAccessDx(i);
      result.fastAccessDx(i) = sum;
    }
    return result;
  }
};

int main(int argc, char** argv) {
  require(argc == 2, "usage: bench_peers_sacado DIRECTORY");
  introduce("Peer: Sacado::Fad::SFad<double, 32>");
  Results results(argv[1]);
  const auto p = peer_case();
  compare_jacobian(
      *p, "sacado",
      forward_pass<Scalar>(
          *p, [](Scalar& x, double value, int direction) { x.n = Number(kPeerDirections, direction, value); },
          [](const Scalar& y, int direction) { return y.n.fastAccessDx(direction); }),
      results);
  results.save();
}
