// Derivatives of interpolation tables: continuous across knots, and those of dual numbers against complex step.
#include <complex>
#include <functional>

#include "table_sample.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"

using namespace table_sample;

namespace {

// The dual derivative in every direction against complex step, and the value against the plain evaluation.
template <int Smooth>
void check_derivatives(
    const Numbers& x, const Dual<double, Smooth>& dual, const std::function<double(const Numbers&)>& plain,
    const std::function<std::complex<double>(const std::vector<std::complex<double>>&)>& complex) {
  constexpr double step = 1e-30;
  CHECK_EQ(dual.v, plain(x));
  for (std::size_t a = 0; a < Smooth; ++a) {
    std::vector<std::complex<double>> z(x.begin(), x.end());
    z[a] += std::complex<double>(0, step);
    const double expected = complex(z).imag() / step;
    CHECK_NEAR(dual.d.get(static_cast<int>(a)), expected, 1e-12 * std::max(1.0, std::abs(expected)));
  }
}

}  // namespace

// Across a knot of any axis the value and every slope go on; so do they along the knot line of another axis.
TEST(table_c1_is_continuously_differentiable_across_knots) {
  Random random;
  constexpr double side = 1e-9;
  constexpr double tolerance = 1e-6;
  for (int round = 0; round < 20; ++round) {
    const Sample<2, 0> s2(random, {5, 6});
    const Sample<3, 1> s3(random, {2, 4, 5, 4});
    const auto check = [&](const std::vector<Numbers>& axes, const auto& slopes_at) {
      for (std::size_t a = 0; a < axes.size(); ++a) {
        for (std::size_t i = 1; i + 1 < axes[a].size(); ++i) {
          Numbers x;
          for (const Numbers& k : axes) x.push_back(random.between(k.front(), k.back()));
          x[a] = axes[a][i] - side;
          const Numbers before = slopes_at(x);
          x[a] = axes[a][i] + side;
          const Numbers after = slopes_at(x);
          for (std::size_t k = 0; k < before.size(); ++k) CHECK_NEAR(before[k], after[k], tolerance);
        }
      }
    };
    check(s2.smooth, [&](const Numbers& x) {
      const auto f = look(s2, Interpolation::c1, dual_variables<2>(x));
      return Numbers{f.v, f.d.get(0), f.d.get(1)};
    });
    check(s3.smooth, [&](const Numbers& x) {
      const auto f = look(s3, Interpolation::c1, dual_variables<3>(x), Numbers{s3.linear[0][0] + 0.1});
      return Numbers{f.v, f.d.get(0), f.d.get(1), f.d.get(2)};
    });
  }
}

TEST(table_dual_derivative_agrees_with_complex_step) {
  Random random;
  using Complex = std::vector<std::complex<double>>;
  for (int round = 0; round < 100; ++round) {
    for (const Interpolation mode : kModes) {
      const Sample<1, 0> s1(random, {6});
      const Numbers x1 = arguments(random, s1.smooth);
      check_derivatives<1>(
          x1, look(s1, mode, dual_variables<1>(x1)), [&](const Numbers& x) { return look(s1, mode, x); },
          [&](const Complex& z) { return look(s1, mode, z); });
      const Sample<2, 0> s2(random, {5, 4});
      const Numbers x2 = arguments(random, s2.smooth);
      check_derivatives<2>(
          x2, look(s2, mode, dual_variables<2>(x2)), [&](const Numbers& x) { return look(s2, mode, x); },
          [&](const Complex& z) { return look(s2, mode, z); });
      const Sample<2, 2> s22(random, {3, 2, 4, 5});
      const Numbers x22 = arguments(random, s22.smooth);
      const Numbers p22 = arguments(random, s22.linear);
      check_derivatives<2>(
          x22, look(s22, mode, dual_variables<2>(x22), p22),
          [&](const Numbers& x) { return look(s22, mode, x, p22); },
          [&](const Complex& z) { return look(s22, mode, z, p22); });
      const Sample<3, 1> s31(random, {3, 4, 3, 5});
      const Numbers x31 = arguments(random, s31.smooth);
      const Numbers p31 = arguments(random, s31.linear);
      check_derivatives<3>(
          x31, look(s31, mode, dual_variables<3>(x31), p31),
          [&](const Numbers& x) { return look(s31, mode, x, p31); },
          [&](const Complex& z) { return look(s31, mode, z, p31); });
    }
  }
}

// The argument is itself a function: the chain rule through from_slopes.
TEST(table_dual_derivative_follows_the_argument) {
  Random random;
  const Sample<1, 0> s(random, {6});
  const double knot = s.smooth[0][2];
  const auto t = Dual<double, 1>::variable(0.1, 0);
  const auto direct = look(s, Interpolation::c1, dual_variables<1>({knot + 0.01}));
  const auto chained = look(s, Interpolation::c1, std::vector<Dual<double, 1>>{knot + t * t});
  CHECK_NEAR(chained.v, direct.v, 1e-15);
  CHECK_NEAR(chained.d.get(0), 0.2 * direct.d.get(0), 1e-13);
}
