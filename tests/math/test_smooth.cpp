// Smooth stand-ins for |x|, max, min, clip and switches: their definitions, limits, bounds on the deviation
// from the sharp function, and smoothness where branches meet.
#include "tiltrotor/math/smooth.hpp"

#include <algorithm>
#include <complex>
#include <limits>

#include "check.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"
#include "tiltrotor/math/differentiation/dual.hpp"
#include "tiltrotor/math/hyperbolic_tangent.hpp"

using namespace tiltrotor;

namespace {

using D = Dual<double, 1>;

template <class Function>
double slope(Function&& f, double x) {
  return f(D::variable(x, 0)).d.get(0);
}

}  // namespace

TEST(smooth_absolute_value) {
  const double e = 0.5;
  for (double x = -6; x <= 6; x += 0.37) {
    const double y = smooth_abs(x, e);
    CHECK_NEAR(y, std::hypot(x, e), 1e-15 * (1 + std::abs(x)));
    CHECK(y >= std::abs(x) && y <= std::abs(x) + e);
    CHECK_EQ(smooth_abs(-x, e), y);
    CHECK_NEAR(smooth_abs_zero(x, e), std::hypot(x, e) - e, 2e-15 * (1 + std::abs(x)));
    CHECK_NEAR(slope([&](const D& z) { return smooth_abs(z, e); }, x), x / std::hypot(x, e), 1e-15);
  }
  CHECK_EQ(smooth_abs(0.0, e), e);
  CHECK_EQ(smooth_abs_zero(0.0, e), 0.0);
  CHECK_EQ(slope([&](const D& z) { return smooth_abs_zero(z, e); }, 0), 0.0);
  CHECK_NEAR(smooth_abs(1e6, e), 1e6, 1e-6);
}

TEST(smooth_maximum_and_minimum) {
  const double e = 0.02;
  for (double x = -1; x <= 1; x += 0.013) {
    const double positive = smooth_positive(x, e);
    CHECK(positive > std::max(x, 0.0) && positive <= std::max(x, 0.0) + e / 2);
    CHECK_NEAR(positive - smooth_positive(-x, e), x, 1e-15);  // s(x) - s(-x) = x
    CHECK_NEAR(positive * smooth_positive(-x, e), e * e / 4, 1e-16);
    CHECK_NEAR(smooth_max(x, 0.15, e), 0.15 + smooth_positive(x - 0.15, e), 1e-16);
    CHECK(smooth_max(x, 0.15, e) >= std::max(x, 0.15) && smooth_max(x, 0.15, e) <= std::max(x, 0.15) + e / 2);
    CHECK(smooth_min(x, 0.15, e) <= std::min(x, 0.15) && smooth_min(x, 0.15, e) >= std::min(x, 0.15) - e / 2);
    CHECK_NEAR(smooth_max(x, 0.15, e) + smooth_min(x, 0.15, e), x + 0.15, 1e-15);
    CHECK_NEAR(slope([&](const D& z) { return smooth_positive(z, e); }, x), 0.5 * (1 + x / std::hypot(x, e)),
               1e-14);
  }
  CHECK_EQ(smooth_positive(0.0, e), e / 2);
  CHECK_EQ(slope([&](const D& z) { return smooth_positive(z, e); }, 0), 0.5);
}

TEST(smooth_clip_holds_at_both_ends) {
  const double e = 0.01;
  for (double x = -3; x <= 3; x += 0.05) {
    const double y = smooth_clip(x, -1.0, 2.0, e);
    CHECK_NEAR(y, std::min(std::max(x, -1.0), 2.0), e / 2 + 1e-15);
    // The middle maps on the middle, and the curve is symmetric about it.
    CHECK_NEAR(smooth_clip(1 - x, -1.0, 2.0, e), 1 - y, 1e-14);
  }
  CHECK_NEAR(smooth_clip(-100.0, -1.0, 2.0, e), -1.0, 1e-6);
  CHECK_NEAR(smooth_clip(100.0, -1.0, 2.0, e), 2.0, 1e-6);
  CHECK_NEAR(slope([&](const D& z) { return smooth_clip(z, -1.0, 2.0, e); }, 0.5), 1.0, 1e-4);
}

TEST(smooth_step_is_twice_continuous) {
  CHECK_EQ(smooth_step(-0.1), 0.0);
  CHECK_EQ(smooth_step(0.0), 0.0);
  CHECK_EQ(smooth_step(1.0), 1.0);
  CHECK_EQ(smooth_step(1.7), 1.0);
  CHECK_EQ(smooth_step(0.5), 0.5);
  double before = 0;
  for (double t = 0; t <= 1; t += 1.0 / 64) {
    const double s = smooth_step(t);
    CHECK(s >= before);
    before = s;
    CHECK_NEAR(s + smooth_step(1 - t), 1.0, 1e-15);
    CHECK_NEAR(slope([](const D& z) { return smooth_step(z); }, t), 30 * t * t * (1 - t) * (1 - t), 1e-14);
  }
  // Slope and curvature vanish towards both ends: 30 h^2 and 60 h at a distance h.
  for (const double h : {1e-2, 1e-4}) {
    const auto at = [](double t) { return slope([](const D& z) { return smooth_step(z); }, t); };
    CHECK_LE(at(h), 30 * h * h);
    CHECK_LE(at(1 - h), 30 * h * h);
    CHECK_LE((at(h) - at(0)) / h, 60 * h);
  }
  CHECK_EQ(slope([](const D& z) { return smooth_step(z); }, -1), 0.0);
  CHECK_EQ(slope([](const D& z) { return smooth_step(z); }, 2), 0.0);
  // NaN is no step: it stays NaN.
  CHECK(std::isnan(smooth_step(std::numeric_limits<double>::quiet_NaN())));
}

// max(x, 0) itself outside the width; inside, its slope is the step and both meet the ends three times smoothly.
TEST(smooth_ramp_is_exact_outside_its_width) {
  const double e = 0.3;
  const auto ramp = [e](const auto& x) { return smooth_ramp(x, e); };
  for (const double x : {0.15, 0.1501, 0.7, 1e6}) {
    CHECK_EQ(ramp(x), x);
    CHECK_EQ(ramp(-x), 0.0);
    CHECK_EQ(slope(ramp, x), 1.0);
    CHECK_EQ(slope(ramp, -x), 0.0);
  }
  double before = 0;
  for (double x = -0.15; x <= 0.15; x += 0.001) {
    CHECK_NEAR(slope(ramp, x), smooth_step(x / e + 0.5), 1e-14);
    CHECK(ramp(x) >= std::max(x, 0.0) - 1e-16 && ramp(x) <= std::max(x, 0.0) + 5.0 / 64 * e);
    CHECK(ramp(x) >= before);
    before = ramp(x);
  }
  CHECK_NEAR(ramp(0.0), 5.0 / 64 * e, 1e-16);
  CHECK_NEAR(ramp(0.15 - 1e-4), 0.15 - 1e-4, 1e-13);  // C3: departs with the fourth power
}

// Against the standard library, with its slope along x^2 by tanh' = 1 - tanh^2.
TEST(smooth_hyperbolic_tangent_over_its_argument) {
  const auto ratio = [](const auto& x2) { return hyperbolic_tangent_over(x2); };
  for (double x = 1e-8; x < 1e9; x *= 1.07) {
    const double t = std::tanh(x);
    CHECK_REL(ratio(x * x), t / x, 2e-15);
    if (x > 1e-2) CHECK_NEAR(slope(ratio, x * x), ((1 - t * t) / x - t / (x * x)) / (2 * x), 1e-14 / (x * x));
  }
  CHECK_EQ(ratio(0.0), 1.0);
  CHECK_REL(slope(ratio, 0), -1.0 / 3, 1e-15);  // tanh(x)/x = 1 - x^2/3 + ..
  CHECK_REL(hyperbolic_tangent_over(4.0f), std::tanh(2.0f) / 2, 1e-6f);
}

TEST(smooth_wrapped_difference) {
  const double pi = 3.14159265358979323846;
  for (double a = -3.1; a <= 3.1; a += 0.31) {
    for (double b = -3.1; b <= 3.1; b += 0.31) {
      const double d = wrapped_difference(a, b);
      CHECK(d >= -pi && d <= pi);
      CHECK_NEAR(std::sin(d), std::sin(a - b), 1e-14);
      CHECK_NEAR(std::cos(d), std::cos(a - b), 1e-14);
      CHECK_EQ(slope([&](const D& z) { return wrapped_difference(z, D(b)); }, a), 1.0);
      CHECK_EQ(slope([&](const D& z) { return wrapped_difference(D(a), z); }, b), -1.0);
    }
  }
}

TEST(smooth_primitives_in_every_scalar) {
  using C = std::complex<double>;
  const double h = 1e-30;
  for (double x = -0.4; x <= 1.4; x += 0.09) {
    const auto all = [](const auto& z) {
      using T = std::decay_t<decltype(z)>;
      return smooth_abs(z, 0.3) + smooth_positive(T(z * 2.0), 0.1) * smooth_max(z, 0.2, 0.05) -
             smooth_min(z, 0.5, 0.1) + smooth_clip(z, -0.1, 0.9, 0.02) * smooth_step(z);
    };
    const C c = all(C(x, h));
    const D d = all(D::variable(x, 0));
    CHECK_EQ(d.v, all(x));
    CHECK_NEAR(c.real(), d.v, 1e-14);
    CHECK_NEAR(d.d.get(0), c.imag() / h, 1e-13);
    CHECK_NEAR(static_cast<double>(smooth_abs(static_cast<float>(x), 0.3f)), smooth_abs(x, 0.3), 1e-6);
  }
}
