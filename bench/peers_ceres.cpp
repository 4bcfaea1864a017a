// The Jacobian with ceres::Jet.
#include <ceres/jet.h>

#include "peers_blades.hpp"
#include "peers_jacobian.hpp"

using Jet = ceres::Jet<double, bench::kPeerDirections>;

namespace tiltrotor {

template <>
struct ScalarTraits<Jet> {
  using Real = double;
  static double value(const Jet& x) { return x.a; }
  static Jet sqrt(const Jet& x) { return ceres::sqrt(x); }
  static Jet sin(const Jet& x) { return ceres::sin(x); }
  static Jet cos(const Jet& x) { return ceres::cos(x); }
  static Jet atan2(const Jet& y, const Jet& x) { return ceres::atan2(y, x); }
  static constexpr bool kTakesSlopes = true;
  template <int Arguments>
  static Jet from_slopes(double value, const double* slope, const Jet* const* x) {
    Jet result(value, slope[0] * x[0]->v);
    for (int a = 1; a < Arguments; ++a) result.v += slope[a] * x[a]->v;
    return result;
  }
};

template <>
class BladeGroup<Jet> : public bench::SingleBlades<Jet> {};

}  // namespace tiltrotor

using namespace bench;

int main(int argc, char** argv) {
  require(argc == 2, "usage: bench_peers_ceres DIRECTORY");
  introduce("Peer: ceres::Jet<double, 32>");
  Results results(argv[1]);
  const auto p = peer_case();
  compare_jacobian(*p, "ceres",
                   forward_pass<Jet>(
                       *p, [](Jet& x, double value, int direction) { x = Jet(value, direction); },
                       [](const Jet& y, int direction) { return y.v[direction]; }),
                   results);
  results.save();
}
