// Integrators. Expected values: exact solutions, orders measured by halving the step, the stability function.
#include "tiltrotor/math/integrate.hpp"

#include "check.hpp"

using namespace tiltrotor;

namespace {

// Nonlinear, coupled, exact solution known: x = 1/(1+t), y = exp(-t) from x' = -x^2, y' = -y + x - x(t), here
// with the coupling written so that it vanishes on the solution: y' = -y + (x (1 + t) - 1).
struct Coupled {
  Status operator()(double t, const double* x, double* xdot) const {
    xdot[0] = -x[0] * x[0];
    xdot[1] = -x[1] + x[0] * (1.0 + t) - 1.0;
    return Status::ok;
  }
  void jacobian(double t, const double* x, Matrix<double, 4, 4>& j, double* time_slope) const {
    j(0, 0) = -2.0 * x[0];
    j(0, 1) = 0.0;
    j(1, 0) = 1.0 + t;
    j(1, 1) = -1.0;
    time_slope[0] = 0.0;
    time_slope[1] = x[0];
  }
};

double rk4_error(int steps) {
  static RungeKuttaWorkspace<double, 4> work;
  double x[2] = {1.0, 1.0};
  const double dt = 1.0 / steps;
  for (int i = 0; i < steps; ++i) CHECK(rk4_step(Coupled(), {i * dt, dt, x, 2}, work) == Status::ok);
  return std::hypot(x[0] - 0.5, x[1] - std::exp(-1.0));
}

double rk3_error(int steps) {
  static RungeKuttaWorkspace<double, 4> work;
  double x[2] = {1.0, 1.0};
  const double dt = 1.0 / steps;
  for (int i = 0; i < steps; ++i) CHECK(rk3_step(Coupled(), {i * dt, dt, x, 2}, work) == Status::ok);
  return std::hypot(x[0] - 0.5, x[1] - std::exp(-1.0));
}

double rodas3_error(int steps, bool with_time_slope) {
  static RosenbrockWorkspace<double, 4> work;
  static Matrix<double, 4, 4> jacobian;
  const Coupled f;
  double x[2] = {1.0, 1.0}, time_slope[2];
  const double dt = 1.0 / steps;
  for (int i = 0; i < steps; ++i) {
    f.jacobian(i * dt, x, jacobian, time_slope);
    const double* given = with_time_slope ? time_slope : nullptr;
    CHECK(rodas3_step(f, jacobian, {i * dt, dt, x, 2, nullptr, given}, work) == Status::ok);
  }
  return std::hypot(x[0] - 0.5, x[1] - std::exp(-1.0));
}

}  // namespace

TEST(rk4_has_order_4) {
  const double order = std::log2(rk4_error(40) / rk4_error(80));
  CHECK_NEAR(order, 4.0, 0.1);
  CHECK_LT(rk4_error(80), 1e-9);
}

TEST(rk3_has_order_3) {
  const double order = std::log2(rk3_error(40) / rk3_error(80));
  CHECK_NEAR(order, 3.0, 0.1);
  CHECK_LT(rk3_error(80), 1e-6);
}

// Its stability function is the exponential series to z^3; the reciprocal of a wrong weight would not be.
TEST(rk3_stability_function) {
  static RungeKuttaWorkspace<double, 1> work;
  for (double z : {-1.5, -0.3, 0.7}) {
    const auto f = [z](double, const double* x, double* xdot) {
      xdot[0] = z * x[0];
      return Status::ok;
    };
    double x[1] = {1.0};
    CHECK(rk3_step(f, {0.0, 1.0, x, 1}, work) == Status::ok);
    CHECK_NEAR(x[0], 1.0 + z + z * z / 2 + z * z * z / 6, 1e-15);
  }
}

// The first evaluation may be handed over: one call less, the same bits; a NaN in it is found.
TEST(integrators_take_over_a_known_first_slope) {
  static RungeKuttaWorkspace<double, 4> runge_kutta;
  static RosenbrockWorkspace<double, 4> rosenbrock;
  static Matrix<double, 4, 4> jacobian;
  int calls = 0;
  const auto f = [&calls](double t, const double* x, double* xdot) {
    ++calls;
    return Coupled()(t, x, xdot);
  };
  const double begin[2] = {0.8, 0.3};
  double slope[2], time_slope[2];
  CHECK(Coupled()(0.1, begin, slope) == Status::ok);
  Coupled().jacobian(0.1, begin, jacobian, time_slope);
  const double broken[2] = {slope[0], std::nan("")};
  for (int method = 0; method < 3; ++method) {
    const auto step = [&](double* x, const double* known) {
      if (method == 0) return rk3_step(f, {0.1, 0.2, x, 2, known}, runge_kutta);
      if (method == 1) return rk4_step(f, {0.1, 0.2, x, 2, known}, runge_kutta);
      return rodas3_step(f, jacobian, {0.1, 0.2, x, 2, known, time_slope}, rosenbrock);
    };
    double alone[2] = {begin[0], begin[1]}, helped[2] = {begin[0], begin[1]};
    calls = 0;
    CHECK(step(alone, nullptr) == Status::ok);
    const int all = calls;
    CHECK(step(helped, slope) == Status::ok);
    CHECK_EQ(calls - all, all - 1);
    for (int i = 0; i < 2; ++i) CHECK_EQ(alone[i], helped[i]);
    CHECK(step(helped, broken) == Status::not_finite);
    CHECK_EQ(helped[0], alone[0]);
  }
}

TEST(rk4_is_exact_for_cubic_polynomials_in_time) {  // the method is Simpson's rule for x' = g(t)
  static RungeKuttaWorkspace<float, 1> work;
  float x[1] = {1.0F};
  const auto f = [](float t, const float*, float* xdot) {
    xdot[0] = 4.0F * t * t * t;
    return Status::ok;
  };
  CHECK(rk4_step(f, {0.0F, 2.0F, x, 1}, work) == Status::ok);
  CHECK_NEAR(x[0], 17.0F, 1e-5);
}

TEST(rodas3_has_order_3) {
  const double order = std::log2(rodas3_error(80, true) / rodas3_error(160, true));
  CHECK_NEAR(order, 3.0, 0.1);
  CHECK_LT(rodas3_error(160, true), 1e-6);
}

TEST(rodas3_needs_the_time_slope_of_a_time_dependent_right_side) {
  const double order = std::log2(rodas3_error(80, false) / rodas3_error(160, false));
  CHECK_LT(order, 2.5);
}

TEST(rodas3_is_l_stable) {  // stability function at z -> -infinity is 0: the fast part is gone after one step
  static RosenbrockWorkspace<double, 1> work;
  const double rates[4] = {1e3, 1e6, 1e9, 1e12};
  for (double rate : rates) {
    const auto f = [rate](double, const double* x, double* xdot) {
      xdot[0] = -rate * x[0];
      return Status::ok;
    };
    const Matrix<double, 1, 1> jacobian = {{-rate}};
    double x[1] = {1.0};
    CHECK(rodas3_step(f, jacobian, {0.0, 1.0, x, 1}, work) == Status::ok);
    CHECK_LT(std::fabs(x[0]), 10.0 / rate + 1e-15);
  }
}

TEST(rodas3_stability_function) {  // R(z) to order 3 at small z, from the exponential; here z = -0.01, +0.01
  static RosenbrockWorkspace<double, 1> work;
  for (double z : {-0.01, 0.01}) {
    const auto f = [z](double, const double* x, double* xdot) {
      xdot[0] = z * x[0];
      return Status::ok;
    };
    const Matrix<double, 1, 1> jacobian = {{z}};
    double x[1] = {1.0}, error[1] = {0.0};
    CHECK(rodas3_step(f, jacobian, {0.0, 1.0, x, 1, nullptr, nullptr, error}, work) == Status::ok);
    CHECK_NEAR(x[0], std::exp(z), 2e-9);  // z^4 times a constant below 0.2
    CHECK_LT(std::fabs(error[0]), 1e-6);  // the estimate is of order z^3
    CHECK_LT(1e-8, std::fabs(error[0]));
  }
}

TEST(rodas3_stiff_relaxation_at_large_steps) {  // Prothero-Robinson: x' = -1e8 (x - cos t) - sin t, x = cos t
  static RosenbrockWorkspace<double, 1> work;
  const double rate = 1e8, dt = 0.05;
  const auto f = [rate](double t, const double* x, double* xdot) {
    xdot[0] = -rate * (x[0] - std::cos(t)) - std::sin(t);
    return Status::ok;
  };
  const Matrix<double, 1, 1> jacobian = {{-rate}};
  double x[1] = {2.0};  // starts off the slow solution
  for (int i = 0; i < 40; ++i) {
    const double t = i * dt;
    const double time_slope[1] = {-rate * std::sin(t) - std::cos(t)};
    CHECK(rodas3_step(f, jacobian, {t, dt, x, 1, nullptr, time_slope}, work) == Status::ok);
  }
  CHECK_NEAR(x[0], std::cos(2.0), 2e-3);
}

TEST(integrators_leave_the_state_alone_when_they_fail) {
  static RungeKuttaWorkspace<double, 3> runge_kutta;
  static RosenbrockWorkspace<double, 3> rosenbrock;
  static Matrix<double, 3, 3> jacobian;
  set_zero(jacobian);
  double x[3] = {1.0, 2.0, 3.0};
  for (int fails_at = 0; fails_at < 4; ++fails_at) {
    int calls = 0;
    const auto f = [&](double, const double*, double* xdot) {
      for (int i = 0; i < 3; ++i) xdot[i] = 1.0;
      return calls++ == fails_at ? Status::out_of_range : Status::ok;
    };
    CHECK(rk4_step(f, {0.0, 0.1, x, 3}, runge_kutta) == Status::out_of_range);
    calls = 0;
    if (fails_at < 3) CHECK(rk3_step(f, {0.0, 0.1, x, 3}, runge_kutta) == Status::out_of_range);
    calls = fails_at == 3 ? 1 : 0;  // three evaluations only
    CHECK(rodas3_step(f, jacobian, {0.0, 0.1, x, 3}, rosenbrock) == Status::out_of_range);
  }
  const auto infinite = [](double, const double*, double* xdot) {
    for (int i = 0; i < 3; ++i) xdot[i] = std::numeric_limits<double>::infinity();
    return Status::ok;
  };
  CHECK(rk4_step(infinite, {0.0, 0.1, x, 3}, runge_kutta) == Status::not_finite);
  CHECK(rodas3_step(infinite, jacobian, {0.0, 0.1, x, 3}, rosenbrock) == Status::not_finite);
  jacobian(0, 0) = 20.0;  // 1/(gamma dt) with dt = 0.1: the system is singular
  CHECK(rodas3_step(infinite, jacobian, {0.0, 0.1, x, 3}, rosenbrock) == Status::singular);
  jacobian(0, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK(rodas3_step(infinite, jacobian, {0.0, 0.1, x, 3}, rosenbrock) == Status::not_finite);
  CHECK(rk4_step(infinite, {0.0, 0.1, x, 4}, runge_kutta) == Status::bad_argument);
  CHECK(rk3_step(infinite, {0.0, 0.1, x, 3}, runge_kutta) == Status::not_finite);
  CHECK(rk3_step(infinite, {0.0, 0.1, x, 0}, runge_kutta) == Status::bad_argument);
  CHECK(rodas3_step(infinite, jacobian, {0.0, 0.0, x, 3}, rosenbrock) == Status::bad_argument);
  CHECK_EQ(x[0], 1.0);
  CHECK_EQ(x[1], 2.0);
  CHECK_EQ(x[2], 3.0);
}

constexpr const double* kNoSlope = nullptr;  // none known

TEST(integrators_refuse_bad_sizes_times_and_states) {
  static RungeKuttaWorkspace<double, 2> runge_kutta;
  static RosenbrockWorkspace<double, 2> rosenbrock;
  static Matrix<double, 2, 2> jacobian;
  set_zero(jacobian);
  int calls = 0;
  const auto f = [&calls](double, const double*, double* xdot) {
    xdot[0] = xdot[1] = 0.0;
    ++calls;
    return Status::ok;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto both = [&](double t, double dt, double second, int n, Status expected) {
    double x[2] = {1.0, second}, error[2] = {5.0, 5.0};
    CHECK(rk3_step(f, {t, dt, x, n}, runge_kutta) == expected);
    CHECK(rk4_step(f, {t, dt, x, n}, runge_kutta) == expected);
    CHECK(rodas3_step(f, jacobian, {t, dt, x, n, nullptr, nullptr, error}, rosenbrock) == expected);
    CHECK(x[0] == 1.0 && error[0] == (expected == Status::ok ? 0.0 : 5.0));
  };
  both(0.0, 0.1, 2.0, 2, Status::ok);
  both(0.0, 0.1, nan, 1, Status::ok);  // beyond n nothing is read
  calls = 0;
  both(0.0, 0.1, 2.0, 0, Status::bad_argument);
  both(0.0, 0.1, 2.0, 3, Status::bad_argument);
  both(nan, 0.1, 2.0, 2, Status::not_finite);
  both(0.0, infinity, 2.0, 2, Status::not_finite);
  both(0.0, 0.1, -infinity, 2, Status::not_finite);
  CHECK_EQ(calls, 0);
}

// Every increment of a step is finite, their sum with a state near the end of the range is not.
TEST(integrators_report_a_sum_beyond_the_range) {
  static RosenbrockWorkspace<double, 1> rosenbrock;
  static RungeKuttaWorkspace<double, 1> runge_kutta;
  const auto f = [](double, const double*, double* xdot) {
    xdot[0] = 2e307;
    return Status::ok;
  };
  double x[1] = {1.79e308}, error[1] = {5.0};
  CHECK(rodas3_step(f, Matrix<double, 1, 1>{}, {0.0, 1.0, x, 1, nullptr, nullptr, error}, rosenbrock) ==
        Status::not_finite);
  CHECK(rk3_step(f, {0.0, 1.0, x, 1}, runge_kutta) == Status::not_finite);
  CHECK(rk4_step(f, {0.0, 1.0, x, 1}, runge_kutta) == Status::not_finite);
  CHECK(x[0] == 1.79e308 && error[0] == 5.0);
  // From zero it is a plain step, with the estimate of a constant slope or without.
  x[0] = 0;
  CHECK(rodas3_step(f, Matrix<double, 1, 1>{}, {0.0, 1.0, x, 1, nullptr, nullptr, error}, rosenbrock) ==
        Status::ok);
  CHECK(rodas3_step(f, Matrix<double, 1, 1>{}, {0.0, 1.0, x, 1}, rosenbrock) == Status::ok);
  CHECK_REL(x[0], 4e307, 1e-15);
  CHECK_EQ(error[0], 0.0);
}

// With x' = g(t) the method is Simpson's rule, exact for cubic polynomials: the middle stage stands at t + dt
// / 2.
TEST(rk3_is_exact_for_cubic_polynomials_in_time) {
  static RungeKuttaWorkspace<double, 1> work;
  const auto f = [](double t, const double*, double* xdot) {
    xdot[0] = 4 * t * t * t - 6 * t + 1;
    return Status::ok;
  };
  double x[1] = {0.0};
  CHECK(rk3_step(f, {1.0, 2.0, x, 1}, work) == Status::ok);
  CHECK_NEAR(x[0], 58.0, 1e-12);  // t^4 - 3 t^2 + t between 1 and 3: 57 + 1
}
