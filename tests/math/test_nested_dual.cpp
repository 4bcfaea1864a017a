// Nested dual numbers: second derivatives against those of closed forms, and the rules of a chain.
#include "tiltrotor/math/differentiation/nested_dual.hpp"

#include <cmath>

#include "check.hpp"
#include "tiltrotor/math/smooth.hpp"

using namespace tiltrotor;
using D = Dual<double, 2>;
using N = Nested<D>;

namespace {

constexpr double kX = 0.7, kY = -1.3;
constexpr double kDx = 2, kDy = -0.5;  // the direction

// x and y with a partial each, moving along the direction.
const N x = {D::variable(kX, 0), D(kDx)};
const N y = {D::variable(kY, 1), D(kDy)};

// A function with its gradient and its second derivatives by hand.
struct Hand {
  double f, fx, fy, fxx, fxy, fyy;
};

void check_equal(const N& found, const Hand& h) {
  const double ulp = 4e-16;
  CHECK_NEAR(found.v.v, h.f, 4 * ulp * (1 + std::abs(h.f)));
  CHECK_NEAR(found.v.d.get(0), h.fx, 4 * ulp * (1 + std::abs(h.fx)));
  CHECK_NEAR(found.v.d.get(1), h.fy, 4 * ulp * (1 + std::abs(h.fy)));
  const double along = h.fx * kDx + h.fy * kDy;
  const double along_x = h.fxx * kDx + h.fxy * kDy;
  const double along_y = h.fxy * kDx + h.fyy * kDy;
  CHECK_NEAR(found.along.v, along, 16 * ulp * (1 + std::abs(along)));
  CHECK_NEAR(found.along.d.get(0), along_x, 32 * ulp * (1 + std::abs(along_x)));
  CHECK_NEAR(found.along.d.get(1), along_y, 32 * ulp * (1 + std::abs(along_y)));
}

}  // namespace

TEST(nested_dual_arithmetic_has_the_second_derivatives_of_closed_forms) {
  check_equal(x * x * y, {kX * kX * kY, 2 * kX * kY, kX * kX, 2 * kY, 2 * kX, 0});
  check_equal(x / y, {kX / kY, 1 / kY, -kX / (kY * kY), 0, -1 / (kY * kY), 2 * kX / (kY * kY * kY)});
  check_equal(3.0 / y, {3 / kY, 0, -3 / (kY * kY), 0, 0, 6 / (kY * kY * kY)});
  check_equal(2.0 - (x - y) * 4.0 + 1.0, {3 - 4 * (kX - kY), -4, 4, 0, 0, 0});
  check_equal(-x / 4.0, {-kX / 4, -0.25, 0, 0, 0, 0});
  N z = x;
  z *= y;
  z += x;
  z -= y;
  z *= 2.0;
  check_equal(z, {2 * (kX * kY + kX - kY), 2 * (kY + 1), 2 * (kX - 1), 0, 2, 0});
}

TEST(nested_dual_functions_have_the_second_derivatives_of_closed_forms) {
  const double s = std::sin(kX), c = std::cos(kX);
  check_equal(sin(x) * y, {s * kY, c * kY, s, -s * kY, c, 0});
  check_equal(cos(x) * y, {c * kY, -s * kY, c, -c * kY, -s, 0});
  const double r = std::sqrt(kX * kX + kY * kY), r3 = r * r * r;
  check_equal(sqrt(x * x + y * y), {r, kX / r, kY / r, kY * kY / r3, -kX * kY / r3, kX * kX / r3});
  const double r4 = r * r * r * r;
  check_equal(atan2(y, x), {std::atan2(kY, kX), -kY / (r * r), kX / (r * r), 2 * kX * kY / r4,
                            (kY * kY - kX * kX) / r4, -2 * kX * kY / r4});
  // The quintic t^3 (10 - 15 t + 6 t^2).
  const double t = kX, left = 1 - t;
  check_equal(smooth_step(x), {t * t * t * (10 - 15 * t + 6 * t * t), 30 * t * t * left * left, 0,
                               60 * t * left * (1 - 2 * t), 0, 0});
}

// f(g(x, y), h(x, y)) on two local numbers, chained: the same as all on the outer ones.
TEST(nested_dual_chain_equals_the_function_itself) {
  const auto f = [](const auto& a, const auto& b) { return sin(a * b) / (b + a * a); };
  const N outer[2] = {x * x + y, cos(y) * x};
  N local[2];
  for (int j = 0; j < 2; ++j) {
    local[j] = {D(outer[j].v.v), D(outer[j].along.v)};
    local[j].v.d.set(j, 1);
  }
  const N chained = chain(f(local[0], local[1]), outer);
  const N direct = f(outer[0], outer[1]);
  for (int i = 0; i < 2; ++i) {
    CHECK_REL(chained.v.d.get(i), direct.v.d.get(i), 1e-14);
    CHECK_REL(chained.along.d.get(i), direct.along.d.get(i), 1e-13);
  }
  CHECK_REL(chained.along.v, direct.along.v, 1e-14);
}
