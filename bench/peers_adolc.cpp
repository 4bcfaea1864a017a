// The Jacobian with ADOL-C: by trace, recorded anew each time because the table cells depend on the state,
// and without.
#include <adolc/adolc.h>
#include <adolc/adtl.h>

#include "peers_jacobian.hpp"
#include "peers_scalar.hpp"

using namespace bench;

using Traced = Foreign<adouble>;
using Traceless = Foreign<adtl::adouble>;

template <>
struct bench::PeerRules<adouble> {
  static double value(const adouble& x) { return x.getValue(); }
  // Its own tangent at the point: f + slope (x - x0).
  static adouble from_slopes(double value, int count, const double* slope, const Traced* const* x) {
    adouble result = value;
    for (int a = 0; a < count; ++a) result += slope[a] * (x[a]->n - x[a]->n.getValue());
    return result;
  }
};

template <>
struct bench::PeerRules<adtl::adouble> {
  static double value(const adtl::adouble& x) { return x.getValue(); }
  static adtl::adouble from_slopes(double value, int count, const double* slope, const Traceless* const* x) {
    adtl::adouble result = value;
    for (int i = 0; i < kPeerInputs; ++i) {
      double sum = 0;
      for (int a = 0; a < count; ++a) sum += slope[a] * x[a]->n.getADValue()[i];
      result.setADValue(static_cast<unsigned>(i), sum);
    }
    return result;
  }
};

namespace {

constexpr short kTag = 1;

auto traced_jacobian(const PeerCase& p) {
  return [&p](PeerJacobian& out) {
    trace_on(kTag);
    {
      ModelWorkspace<Traced> work;
      Traced z[kPeerInputs];
      Traced y[kMaxLinearStates];
      for (int j = 0; j < kPeerInputs; ++j) z[j].n <<= p.input[j];
      p.rates(work, z, y);
      double ignored = 0;
      for (int i = 0; i < p.exact.states; ++i) y[i].n >>= ignored;
    }
    trace_off();
    double* row[kMaxLinearStates];
    for (int i = 0; i < p.exact.states; ++i) row[i] = out.entry[i];
    require(jacobian(kTag, p.exact.states, kPeerInputs, p.input, row) >= 0, "ADOL-C failed");
  };
}

}  // namespace

int main(int argc, char** argv) {
  require(argc == 2, "usage: bench_peers_adolc DIRECTORY");
  introduce("Peer: ADOL-C, traced and traceless");
  Results results(argv[1]);
  const auto p = peer_case();
  compare_jacobian(*p, "adolc_traced", traced_jacobian(*p), results);
  adtl::setNumDir(kPeerInputs);
  compare_jacobian(*p, "adolc",
                   forward_pass<Traceless>(
                       *p,
                       [](Traceless& x, double value, int direction) {
                         x.n = value;
                         for (int i = 0; i < kPeerInputs; ++i)
                           x.n.setADValue(static_cast<unsigned>(i), i == direction ? 1 : 0);
                       },
                       [](const Traceless& y, int direction) { return y.n.getADValue()[direction]; }),
                   results);
  results.save();
}
