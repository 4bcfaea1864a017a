// Elementary functions, their partials, lengths and condition numbers where
// numbers are largest, smallest, or cancel: against long double, whose
// exponents and digits reach further, or against exact scaling by powers of two
// where it is no wider than double (32-bit ARM).
#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

#include "check.hpp"
#include "tiltrotor/math/algebra/lu.hpp"
#include "tiltrotor/math/differentiation/batch.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"
#include "tiltrotor/math/differentiation/dual.hpp"
#include "tiltrotor/math/smooth.hpp"

using namespace tiltrotor;

namespace {

constexpr bool kWide = std::numeric_limits<long double>::max_exponent > 2000;

// Error in units in the last place of the exact result; below the normal
// numbers, of the smallest number.
template <class R>
double units(R actual, long double exact) {
  const R size = std::fabs(static_cast<R>(exact));
  if (!(size <= std::numeric_limits<R>::max())) return actual == static_cast<R>(exact) ? 0 : 1e9;
  const R next = std::nextafter(size, std::numeric_limits<R>::infinity());
  const R unit = next <= std::numeric_limits<R>::max() ? next - size : size - std::nextafter(size, R(0));
  const auto error = std::fabs(static_cast<long double>(actual) - exact);
  return static_cast<double>(error / static_cast<long double>(unit));
}

// Numbers over all exponents, and the ends.
template <class R>
class AnyNumber {
 public:
  R operator()() {
    using L = std::numeric_limits<R>;
    const R ends[] = {L::max(), L::max() / 2, L::min(), L::denorm_min(), L::min() / 2, R(1), L::epsilon()};
    const int pick = std::uniform_int_distribution<int>(0, 20)(engine_);
    std::uniform_int_distribution<int> exponent(L::min_exponent - L::digits, L::max_exponent - 1);
    const R digits = static_cast<R>(std::uniform_real_distribution<double>(1, 2)(engine_));
    const R size = pick < 7 ? ends[pick] : std::ldexp(digits, exponent(engine_));
    return std::uniform_int_distribution<int>(0, 1)(engine_) == 0 ? size : -size;
  }

 private:
  std::mt19937 engine_{61};
};

template <class R>
void check_angle_everywhere() {
  AnyNumber<R> number;
  double worst = 0, worst_slope = 0;
  for (int n = 0; n < 200000; ++n) {
    const R y = number();
    const R x = n % 2 == 0 ? number() : static_cast<R>(y * static_cast<R>(0.3 + n % 17));
    if (!std::isfinite(x) || y == R(0)) continue;
    const auto wide_y = static_cast<long double>(y), wide_x = static_cast<long double>(x);
    worst = std::max(worst, units(arctangent2(y, x), std::atan2(wide_y, wide_x)));
    if (!kWide && sizeof(R) == sizeof(double)) continue;
    const long double square = wide_x * wide_x + wide_y * wide_y;
    const AngleSlopes<R> slope = arctangent2_slopes(y, x);
    worst_slope = std::max(
        {worst_slope, units(slope.along_y, wide_x / square), units(slope.along_x, -wide_y / square)});
  }
  CHECK_LT(worst, kWide ? 2.0 : 3.0);
  CHECK_LT(worst_slope, 6.0);
  NOTE("largest error: atan2 " << worst << ", slopes " << worst_slope << " units in the last place");
}

}  // namespace

TEST(elementary_angle_of_every_finite_point_double) { check_angle_everywhere<double>(); }
TEST(elementary_angle_of_every_finite_point_float) { check_angle_everywhere<float>(); }

// The neighbours of every multiple of pi/2 that the range holds (every
// thousandth of the far ones): there the reduced angle has lost all leading
// digits.
TEST(elementary_sine_next_to_its_zeros) {
  if (std::numeric_limits<long double>::digits <= std::numeric_limits<double>::digits) return;
  double worst = 0;
  for (double k = 1; k < 6.3e7; k += k < 2e4 ? 1 : 997) {
    double x = static_cast<double>(static_cast<long double>(k) * 1.57079632679489661923L);
    x = std::nextafter(x, 0.0);
    for (int n = 0; n < 3; ++n, x = std::nextafter(x, 1e9)) {
      const SineCosine<double> f = sine_cosine(x);
      worst = std::max({worst, units(f.sine, std::sin(static_cast<long double>(x))),
                        units(f.cosine, std::cos(static_cast<long double>(x)))});
    }
  }
  CHECK_LT(worst, 2.0);
  double worst_float = 0;
  for (int k = 1; k < 6366; ++k) {
    auto x = static_cast<float>(k * 1.57079632679489661923L);
    x = std::nextafter(std::nextafter(x, 0.0f), 0.0f);
    for (int n = 0; n < 5; ++n, x = std::nextafter(x, 1e9f)) {
      const SineCosine<float> f = sine_cosine(x);
      worst_float = std::max({worst_float, units(f.sine, std::sin(static_cast<long double>(x))),
                              units(f.cosine, std::cos(static_cast<long double>(x)))});
    }
  }
  CHECK_LT(worst_float, 2.5);
  NOTE("largest error " << worst << ", float " << worst_float << " units in the last place");
}

// Packs see the operations of plain numbers over their stated range.
TEST(batch_of_extreme_numbers_gives_the_plain_bits) {
  AnyNumber<double> number;
  using P = Batch<double>;
  for (int n = 0; n < 5000; ++n) {
    const auto within = [&number] { return std::fmod(std::log2(std::fabs(number())), 400.0); };
    P y = std::exp2(within()), x = -std::exp2(within());
    if (n % 3 == 0) y.set(0, 1.25), x.set(0, -3.5);  // a usual lane beside them
    const P angle = arctangent2(y, x);
    const AngleSlopes<P> slope = arctangent2_slopes(y, x);
    for (int lane = 0; lane < P::kLanes; ++lane) {
      CHECK_EQ(angle.get(lane), arctangent2(y.get(lane), x.get(lane)));
      CHECK_EQ(slope.along_y.get(lane), arctangent2_slopes(y.get(lane), x.get(lane)).along_y);
    }
    P turn = 1.5707963267948966 * (n + 1.0);
    turn.set(0, 0.3);
    const SineCosine<P> f = sine_cosine(turn);
    for (int lane = 0; lane < P::kLanes; ++lane)
      CHECK(f.sine.get(lane) == sine_cosine(turn.get(lane)).sine &&
            f.cosine.get(lane) == sine_cosine(turn.get(lane)).cosine);
  }
}

// d atan2 by hand: 1/(5 s) at (3 s, 4 s) along both axes, times 4/5 and -3/5.
TEST(dual_angle_of_extreme_sides) {
  using D = Dual<double, 2>;
  for (const double s : {1e-155, 1e-300, 1e-160, 1.0, 1e160, 1e300}) {
    const D angle = atan2(D::variable(3 * s, 0), D::variable(4 * s, 1));
    CHECK_NEAR(angle.v, std::atan2(3.0, 4.0), 1e-15);
    CHECK_REL(angle.d.get(0), 0.8 / (5 * s), 1e-15);
    CHECK_REL(angle.d.get(1), -0.6 / (5 * s), 1e-15);
    const double step = s * 1e-5;  // of a linear function
    const std::complex<double> z = atan2(std::complex<double>(3 * s, step), std::complex<double>(4 * s, 0));
    CHECK_REL(z.imag() / 1e-5, 0.16, 1e-14);
  }
  const D origin = atan2(D::variable(0.0, 0), D::variable(0.0, 1));
  CHECK(std::isnan(origin.d.get(0)));  // no derivative, and no silent zero
}

// The stated range of products, quotients and roots, by hand.
TEST(dual_rules_over_their_range) {
  using D = Dual<double, 1>;
  for (const double s : {1e-150, 1e-75, 1.0, 1e75, 1e150}) {
    const D x = D::variable(s, 0);
    CHECK_REL((1.0 / x).d.get(0), -1 / s / s, 1e-15);
    CHECK_REL((x / (2.0 * x)).v, 0.5, 1e-15);
    CHECK_NEAR((x / (2.0 * x)).d.get(0) * s, 0.0, 1e-15);
    CHECK_REL((x * x).d.get(0), 2 * s, 1e-15);
    CHECK_REL(sqrt(x).d.get(0), 0.5 / std::sqrt(s), 1e-15);
  }
  CHECK(std::isinf(sqrt(D::variable(0.0, 0)).d.get(0)));
}

TEST(smooth_primitives_over_their_range) {
  using D = Dual<double, 1>;
  for (const double s : {1e-150, 1e-75, 1.0, 1e75, 1e150}) {
    CHECK_REL(smooth_abs(3 * s, 4 * s), 5 * s, 1e-15);
    CHECK_REL(smooth_positive(D::variable(3 * s, 0), 4 * s).d.get(0), 0.8, 1e-15);
    CHECK_REL(smooth_max(-3 * s, s, 3 * s), 1.5 * s,
              1e-14);  // s + (-4 s + 5 s)/2
  }
}

TEST(smooth_wrapped_takes_off_every_turn) {
  for (int turns = -5; turns <= 5; ++turns)
    for (const double angle : {-3.1, -1.0, 0.0, 0.5, 3.1})
      CHECK_NEAR(wrapped(angle + turns * 2 * 3.14159265358979323846), angle, 1e-14);
  for (const double angle : {-3.1, -1e-9, 0.0, 2.0}) CHECK_EQ(wrapped(angle), angle);  // bits of its own
  using D = Dual<double, 1>;
  CHECK_EQ(wrapped(D::variable(9.0, 0)).d.get(0), 1.0);
}

TEST(elementary_length_of_every_size) {
  for (const double s : {1e-320, 1e-300, 1e-160, 1.0, 1e160, 3e307}) {
    const double expected = s < 1e-310 ? std::hypot(3 * s, 4 * s) : 5 * s;
    CHECK_REL(length_of(3 * s, 4 * s), expected, 1e-15);
  }
  CHECK_EQ(length_of(0.0, 0.0), 0.0);
  CHECK(std::isinf(length_of(1.7e308, 1.7e308)));
  CHECK_REL(length_of(3e-30f, 4e-30f), 5e-30f, 1e-6);
}

// The condition number does not depend on the size of the matrix.
TEST(lu_condition_of_a_matrix_of_any_size) {
  static Matrix<double, 6, 6> a;
  static LU<double, 6> lu;
  std::mt19937 generator(5);
  std::uniform_int_distribution<int> whole(1, 9);
  double expected = 0;
  for (const int exponent : {0, -1010, -1000, -700, 700, 1000, 1015}) {
    generator.seed(5);
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) a(i, j) = std::ldexp(whole(generator) + (i == j ? 10 : 0), exponent);
    CHECK(lu_factor(a, 6, lu) == Status::ok);
    if (exponent == 0) expected = lu_reciprocal_condition(lu);
    CHECK_REL(lu_reciprocal_condition(lu), expected, 1e-13);
  }
  CHECK(expected > 0.01);
  set_zero(a);
  for (int i = 0; i < 6; ++i) a(i, i) = 3e-308;
  CHECK(lu_factor(a, 6, lu) == Status::ok);
  CHECK_REL(lu_reciprocal_condition(lu), 1.0, 1e-13);
}
