// The exponential step against solutions in closed form.
#include <algorithm>
#include <cmath>
#include <limits>

#include "check.hpp"
#include "tiltrotor/math/exponential_step.hpp"

using namespace tiltrotor;

namespace {

ExponentialWorkspace<double, 2> work;
const double unit[] = {1, 1};

Matrix<double, 2, 2> matrix(double a, double b, double c, double d) {
  Matrix<double, 2, 2> m{};
  m(0, 0) = a;
  m(0, 1) = b;
  m(1, 0) = c;
  m(1, 1) = d;
  return m;
}

// x' = -x^2 cos t, x = 1/(1 + sin t), beside its own clock.
double error_at_1(int steps) {
  double x[] = {1, 0};
  const double dt = 1.0 / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = x[1];
    const double known[] = {-x[0] * x[0] * std::cos(t), 1};
    const Matrix<double, 2, 2> jacobian = matrix(-2 * x[0] * std::cos(t), x[0] * x[0] * std::sin(t), 0, 0);
    CHECK(exponential_step(jacobian, unit, {i * dt, dt, x, 2, known}, work) == Status::ok);
  }
  return std::abs(x[0] - 1 / (1 + std::sin(1.0)));
}

}  // namespace

// A damped oscillation, decay a and frequency w: one step of any length, in one part and in hundreds.
TEST(exponential_step_solves_a_linear_system) {
  const double a = -3, w = 20;
  const Matrix<double, 2, 2> jacobian = matrix(a, -w, w, a);
  for (const double dt : {0.001, 0.04, 0.3, 2.0, 10.0}) {
    double x[] = {1, 0.5};
    const double known[] = {a * x[0] - w * x[1], w * x[0] + a * x[1]};
    CHECK(exponential_step(jacobian, unit, {0.0, dt, x, 2, known}, work) == Status::ok);
    const double decay = std::exp(a * dt), c = std::cos(w * dt), s = std::sin(w * dt);
    CHECK_NEAR(x[0], decay * (c - 0.5 * s), 2e-13 * (1 + w * dt));
    CHECK_NEAR(x[1], decay * (s + 0.5 * c), 2e-13 * (1 + w * dt));
  }
}

// x' = -k x + b + s t from x = 1: x = p + (s/k) t + (1 - p) e^(-k t), p = b/k - s/k^2.
TEST(exponential_step_follows_an_input_that_ramps) {
  const double k = 5, b = 2, slope = 3, p = b / k - slope / (k * k);
  Matrix<double, 1, 1> jacobian{};
  jacobian(0, 0) = -k;
  ExponentialWorkspace<double, 1> small;
  for (const double dt : {0.01, 0.1, 1.0, 7.0}) {
    double x[] = {1};
    const double known[] = {b - k}, ramp[] = {slope};
    CHECK(exponential_step(jacobian, unit, {0.0, dt, x, 1, known, ramp}, small) == Status::ok);
    CHECK_NEAR(x[0], p + slope / k * dt + (1 - p) * std::exp(-k * dt), 1e-14 * (1 + k * dt));
  }
}

// J = 0: x + dt f; and states of any size: what the parts are cut by is scaled.
TEST(exponential_step_without_a_jacobian_is_a_straight_line) {
  double x[] = {1, -2};
  const double known[] = {3, 4};
  CHECK(exponential_step(Matrix<double, 2, 2>{}, unit, {0.0, 0.5, x, 2, known}, work) == Status::ok);
  CHECK_EQ(x[0], 2.5);
  CHECK_EQ(x[1], 0.0);
  const double scale[] = {1, 1e-9};
  double y[] = {1, 1e-9};
  const double rates[] = {1, 1e-9};
  CHECK(exponential_step(matrix(0, 1e9, 1e-9, 0), scale, {0.0, 0.5, y, 2, rates}, work) == Status::ok);
  CHECK_REL(y[0], std::exp(0.5), 1e-14);
  CHECK_REL(y[1], 1e-9 * std::exp(0.5), 1e-14);
}

// What couples two states may be large in one unit and small in another: x' = -x + 500 y, y' = -y is cut by neither.
TEST(exponential_step_finds_the_sizes_of_the_states) {
  for (const double coupling : {500.0, 1e6, 1e-6}) {
    double x[] = {1, 0.5};
    const double known[] = {-x[0] + coupling * x[1], -x[1]};
    CHECK(exponential_step(matrix(-1, coupling, 0, -1), unit, {0.0, 1.0, x, 2, known}, work) == Status::ok);
    CHECK_REL(x[0], std::exp(-1.0) * (1 + 0.5 * coupling), 1e-14);
    CHECK_REL(x[1], 0.5 * std::exp(-1.0), 1e-14);
  }
}

// The longest part and the shortest two; decay and growth.
TEST(exponential_step_where_it_is_cut) {
  Matrix<double, 1, 1> jacobian{};
  ExponentialWorkspace<double, 1> small;
  for (const double rate : {-10.01, -9.99, -5.01, -4.99, 4.99, 5.01}) {
    jacobian(0, 0) = rate;
    double x[] = {1};
    CHECK(exponential_step(jacobian, unit, {0.0, 1.0, x, 1, &rate}, small) == Status::ok);
    CHECK_NEAR(x[0], std::exp(rate), 1e-14 * (1 + std::exp(rate)));
  }
}

// The series of phi1 and phi2 beyond the terms taken, summed from there on, of their first terms; and none too
// many: a term less leaves out more than a third of the spacing of numbers.
TEST(exponential_step_terms_leave_out_less_than_rounding) {
  const auto left_out = [](double z, int m) {
    double term = 1, one = 0, two = 0;  // z^k / (k + 1)!
    for (int k = 1; k < 120; ++k) {
      if (k > m) two += 2 * term / static_cast<double>(k + 1);
      term *= z / static_cast<double>(k + 1);
      if (k > m) one += term;
    }
    return std::max(one, two);
  };
  for (const double z : {0.0, 1e-9, 0.01, 0.5, 1.0, 1.9, 2.1, 3.5, 5.0}) {
    const int m = exponential_terms(z), single = exponential_terms(static_cast<float>(z));
    CHECK_LT(left_out(z, m), std::numeric_limits<double>::epsilon());
    CHECK_LT(left_out(z, single), std::numeric_limits<float>::epsilon());
    if (m > 1) CHECK_LT(std::numeric_limits<double>::epsilon() / 3, left_out(z, m - 1));
  }
  CHECK_EQ(exponential_terms(5.0), 33);
  CHECK_EQ(exponential_terms(5.0F), 21);
}

TEST(exponential_step_has_order_2) {
  const double order = std::log2(error_at_1(40) / error_at_1(80));
  CHECK_NEAR(order, 2, 0.1);
  CHECK_LT(error_at_1(80), 2e-5);
}

TEST(exponential_step_refuses_and_leaves_the_state) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  double x[] = {1, 2};
  const double known[] = {1, 1}, bad[] = {1, nan};
  const Matrix<double, 2, 2> fast = matrix(-1e4, 0, 0, 0);
  CHECK(exponential_step(fast, unit, {0.0, 1.0, x, 2, known}, work) == Status::out_of_range);
  CHECK(exponential_step(fast, unit, {0.0, 0.01, x, 2, nullptr}, work) == Status::bad_argument);
  CHECK(exponential_step(fast, unit, {0.0, 0.01, x, 3, known}, work) == Status::bad_argument);
  CHECK(exponential_step(fast, unit, {0.0, 0.01, x, 2, bad}, work) == Status::not_finite);
  CHECK(exponential_step(matrix(nan, 0, 0, 0), unit, {0.0, 0.01, x, 2, known}, work) == Status::not_finite);
  CHECK_EQ(x[0], 1.0);
  CHECK_EQ(x[1], 2.0);
  CHECK(exponential_step(fast, unit, {0.0, 0.02, x, 2, known}, work) == Status::ok);
}
