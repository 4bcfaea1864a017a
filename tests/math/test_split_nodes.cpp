// Nodes with slopes in single precision.
// Expected: the look-up with whole nodes of double, to the rounding of a float in the slopes; the values at the knots,
// exactly; derivatives by complex step, and from both sides of a knot.
#include <complex>

#include "math/table_sample.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"

using namespace table_sample;
using tiltrotor::lookup;
using tiltrotor::SplitNodes;

namespace {

using D = Dual<double, 2>;
using C = std::complex<double>;
using SplitTable = Table<double, 2, 1, SplitNodes<double, 2>>;

// The same table twice: two smooth axes and a linear one.
struct Both {
  Sample<2, 1> whole;
  std::vector<float> slope;
  explicit Both(Random& random) : whole(random, {4, 6, 5}) {
    for (std::size_t i = 0; i < whole.node.size(); ++i)
      if (i % 4 != 0) slope.push_back(static_cast<float>(whole.node[i]));
  }
  SplitTable split() const {
    const Table<double, 2, 1> t = whole.table();
    return {{t.smooth[0], t.smooth[1]}, {t.linear[0]}, {whole.value.data(), slope.data()}};
  }
};

template <class T, class Tabulated>
T look(const Tabulated& table, Interpolation mode, double place, const T& x, const T& y) {
  const GridPoint<double> at[1] = {grid_point(table.linear[0], place)};
  const T arguments[2] = {x, y};
  return lookup(table, mode, at, arguments);
}

}  // namespace

TEST(table_with_single_slopes_is_the_table) {
  Random random;
  for (int round = 0; round < 20; ++round) {
    const Both both(random);
    const SplitTable split = both.split();
    const Table<double, 2, 1> whole = both.whole.table();
    double steepest = 1;
    for (const float m : both.slope) steepest = std::max(steepest, std::fabs(static_cast<double>(m)));
    for (const Interpolation mode : kModes) {
      for (int k = 0; k < 50; ++k) {
        const double p = random.between(-4, 8), x = random.between(-4, 8), y = random.between(-4, 8);
        const D found = look(split, mode, p, D::variable(x, 0), D::variable(y, 1));
        const D expected = look(whole, mode, p, D::variable(x, 0), D::variable(y, 1));
        CHECK_NEAR(found.v, expected.v, 1e-6 * steepest);
        CHECK_EQ(found.v, look(split, mode, p, x, y));
        CHECK_NEAR(found.d.get(0), look(split, mode, p, C(x, 1e-30), C(y, 0)).imag() / 1e-30,
                   1e-12 * steepest);
        CHECK_NEAR(found.d.get(1), look(split, mode, p, C(x, 0), C(y, 1e-30)).imag() / 1e-30,
                   1e-12 * steepest);
      }
      // At a node the value itself, and one slope on both sides.
      const Numbers &xs = both.whole.smooth[0], &ys = both.whole.smooth[1];
      for (std::size_t i = 1; i + 1 < xs.size(); ++i) {
        for (std::size_t j = 0; j < ys.size(); ++j) {
          const double value = both.whole.value[i * ys.size() + j], p = both.whole.linear[0][0];
          CHECK_NEAR(look(split, mode, p, xs[i], ys[j]), value, 1e-14);
          if (mode == Interpolation::linear) continue;
          const D before = look(split, mode, p, D::variable(std::nextafter(xs[i], -9), 0), D(ys[j]));
          const D behind = look(split, mode, p, D::variable(xs[i], 0), D(ys[j]));
          CHECK_NEAR(before.d.get(0), behind.d.get(0), 1e-12 * steepest);
        }
      }
    }
  }
}
