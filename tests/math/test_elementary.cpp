// sin, cos and atan2 against the long double functions of the standard library: below 2 units in the last
// place over the documented range, exact at the special points, NaN outside.
#include "tiltrotor/math/scalar.hpp"

#include <algorithm>
#include <random>

#include "check.hpp"

using namespace tiltrotor;

namespace {

// Error in units in the last place of the result.
template <class R>
double units(R actual, long double exact) {
  if (exact == 0) return actual == R(0) ? 0 : 1e9;
  const R next = std::nextafter(std::abs(static_cast<R>(exact)), std::numeric_limits<R>::infinity());
  const long double unit =
      static_cast<long double>(next) - static_cast<long double>(std::abs(static_cast<R>(exact)));
  return static_cast<double>(std::abs(static_cast<long double>(actual) - exact) / unit);
}

// What the comparison itself may be off where long double is no wider than R (32-bit ARM): one unit.
template <class R>
constexpr double kComparisonError =
    std::numeric_limits<long double>::digits > std::numeric_limits<R>::digits ? 0 : 1;

template <class R>
void check_sine_cosine(double largest, double limit_beyond) {
  NOTE("seed 51");
  std::mt19937 engine(51);
  double worst[2] = {0, 0};  // within one turn, beyond
  for (const double range : {1e-3, 1.0, 6.3, 1e3, largest}) {
    double& worst_here = worst[range <= 6.3 ? 0 : 1];
    std::uniform_real_distribution<double> uniform(-range, range);
    for (int n = 0; n < 40000; ++n) {
      const R x = static_cast<R>(uniform(engine));
      const SineCosine<R> f = sine_cosine(x);
      const long double exact = static_cast<long double>(x);
      // Next to a zero crossing the reduced angle carries an absolute error: measured in units of 1e-3 there.
      const auto error = [](R actual, long double truth) {
        return std::abs(truth) > 1e-3L
                   ? units(actual, truth)
                   : static_cast<double>(std::abs(static_cast<long double>(actual) - truth) /
                                         (1e-3L * std::numeric_limits<R>::epsilon()));
      };
      const bool small = range <= 1e-3;
      worst_here =
          std::max(worst_here, small ? units(f.sine, std::sin(exact)) : error(f.sine, std::sin(exact)));
      worst_here = std::max(worst_here, error(f.cosine, std::cos(exact)));
    }
  }
  CHECK_LT(worst[0], 2.0 + kComparisonError<R>);
  CHECK_LT(worst[1], limit_beyond + kComparisonError<R>);
  NOTE("largest error within a turn " << worst[0] << ", beyond " << worst[1] << " units in the last place");
}

template <class R>
void check_arctangent() {
  NOTE("seed 52");
  std::mt19937 engine(52);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::uniform_real_distribution<double> exponent(-12, 12);
  double worst = 0;
  for (int n = 0; n < 200000; ++n) {
    const double spread = n % 2 == 0 ? 1 : std::pow(10.0, exponent(engine));
    const R y = static_cast<R>(uniform(engine) * spread);
    const R x = static_cast<R>(uniform(engine));
    if (x == R(0) && y == R(0)) continue;
    worst = std::max(worst, units(arctangent2(y, x),
                                  std::atan2(static_cast<long double>(y), static_cast<long double>(x))));
  }
  CHECK_LT(worst, 2.0 + kComparisonError<R>);
  NOTE("largest error: atan2 " << worst << " units in the last place");
}

}  // namespace

TEST(elementary_sine_cosine_double) { check_sine_cosine<double>(1e8, 2.0); }
TEST(elementary_sine_cosine_float) { check_sine_cosine<float>(1e4, 2.5); }
TEST(elementary_arctangent_double) { check_arctangent<double>(); }
TEST(elementary_arctangent_float) { check_arctangent<float>(); }

TEST(elementary_special_points) {
  CHECK_EQ(sine_cosine(0.0).sine, 0.0);
  CHECK_EQ(sine_cosine(0.0).cosine, 1.0);
  CHECK_EQ(arctangent2(0.0, 1.0), 0.0);
  CHECK_EQ(arctangent2(0.0, 0.0), 0.0);
  CHECK_EQ(arctangent2(1.0, 0.0), std::atan2(1.0, 0.0));
  CHECK_EQ(arctangent2(-1.0, 0.0), std::atan2(-1.0, 0.0));
  CHECK_EQ(arctangent2(0.0, -1.0), std::atan2(0.0, -1.0));
  CHECK_EQ(arctangent2(1.0, 1.0), std::atan2(1.0, 1.0));
  CHECK_EQ(arctangent2(1.0, -1.0), std::atan2(1.0, -1.0));
  for (const double x : {0.1, 0.9, 1.5, 3.0, 40.0}) {  // exact symmetries: left and right rotor see the same
    CHECK_EQ(sine_cosine(-x).sine, -sine_cosine(x).sine);
    CHECK_EQ(sine_cosine(-x).cosine, sine_cosine(x).cosine);
    CHECK_EQ(arctangent2(-x, 0.7), -arctangent2(x, 0.7));
    CHECK_EQ(arctangent2(-x, -0.7), -arctangent2(x, -0.7));
  }
}

TEST(elementary_outside_the_range) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x : {2e8, -2e8, infinity, -infinity, nan}) {
    CHECK(std::isnan(sine_cosine(x).sine));
    CHECK(std::isnan(sine_cosine(x).cosine));
  }
  CHECK(std::isfinite(sine_cosine(1e8).sine));
  CHECK(std::isnan(sine_cosine(2e4f).sine));
  CHECK(std::isnan(arctangent2(nan, 1.0)));
  CHECK(std::isnan(arctangent2(1.0, nan)));
}
