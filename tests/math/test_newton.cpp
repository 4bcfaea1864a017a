// Damped Newton iteration on equations whose roots and traps are known in closed form.
#include "tiltrotor/math/newton.hpp"

#include "check.hpp"

using namespace tiltrotor;

namespace {

// One equation f(z) = 0 with its slope, defined where `permits` says so.
template <bool Cheap, bool StopsUphill>
struct Scalar {
  static constexpr bool kJacobianIsCheap = Cheap;
  static constexpr bool kStopsUphill = StopsUphill;
  double (*f)(double);
  double (*slope)(double);
  double lowest = -HUGE_VAL;
  double longest_step = HUGE_VAL;
  int values_asked = 0;
  bool asked_outside = false;

  void values(const double* z, double* residual) {
    asked_outside |= z[0] <= lowest;
    ++values_asked;
    residual[0] = f(z[0]);
  }
  void jacobian(const double* z, double* residual, Matrix<double, 2, 2>& slopes) {
    residual[0] = f(z[0]);
    slopes(0, 0) = slope(z[0]);
  }
  void limit_step(double* step) const {
    if (std::fabs(step[0]) > longest_step) step[0] = std::copysign(longest_step, step[0]);
  }
  bool permits(const double* z) const { return z[0] > lowest; }
};

template <class Problem>
NewtonResult<double> solved(Problem& problem, double& z, int& iterations, NewtonLimits limits = {50}) {
  static NewtonWorkspace<double, 2> work;
  work.z[0] = z;
  iterations = 0;
  const NewtonResult<double> found = newton(problem, 1, 1e-13, limits, work, iterations);
  z = work.z[0];
  return found;
}

double arctangent(double z) { return std::atan(z); }
double arctangent_slope(double z) { return 1 / (1 + z * z); }

struct CircleAndHyperbola {
  static constexpr bool kJacobianIsCheap = true;
  static constexpr bool kStopsUphill = true;
  void values(const double* z, double* f) {
    f[0] = z[0] * z[0] + z[1] * z[1] - 5;
    f[1] = z[0] * z[1] - 2;
  }
  void jacobian(const double* z, double* f, Matrix<double, 2, 2>& j) {
    values(z, f);
    j(0, 0) = 2 * z[0];
    j(0, 1) = 2 * z[1];
    j(1, 0) = z[1];
    j(1, 1) = z[0];
  }
  void limit_step(double*) const {}
  bool permits(const double*) const { return true; }
};

}  // namespace

// x^2 + y^2 = 5, x y = 2: the root (1, 2), by hand.
TEST(newton_finds_a_root_of_two_equations) {
  CircleAndHyperbola problem;
  NewtonWorkspace<double, 2> work;
  work.z[0] = 0.5;
  work.z[1] = 3;
  int iterations = 0;
  CHECK(newton(problem, 2, 1e-14, {20}, work, iterations).status == Status::ok);
  CHECK_NEAR(work.z[0], 1, 1e-14);
  CHECK_NEAR(work.z[1], 2, 1e-14);
  CHECK_LE(iterations, 7);  // quadratic: the error of 1 squared six times is below rounding
}

// Whole steps on atan(z) lead away from its root 0 from |z| > 1.3917 on: 2 z = (1 + z^2) atan(z).
TEST(newton_halves_steps_that_lead_away) {
  int iterations = 0;
  for (double start : {1.4, -3.0, 30.0}) {
    Scalar<false, true> problem{arctangent, arctangent_slope};
    double z = start;
    CHECK(solved(problem, z, iterations).status == Status::ok);
    CHECK_NEAR(z, 0, 1e-13);
    Scalar<true, true> at_once{arctangent, arctangent_slope};
    double same = start;
    CHECK(solved(at_once, same, iterations).status == Status::ok);
    CHECK_EQ(same, z);  // a Jacobian with the value changes no number
    CHECK_LT(at_once.values_asked, problem.values_asked);
  }
}

// ln z = 0 from 5: the whole step ends at 5 - 5 ln 5 < 0, where there is no logarithm.
TEST(newton_evaluates_where_it_may) {
  Scalar<false, true> problem{[](double z) { return std::log(z); }, [](double z) { return 1 / z; }, 0};
  double z = 5;
  int iterations = 0;
  CHECK(solved(problem, z, iterations).status == Status::ok);
  CHECK_NEAR(z, 1, 1e-13);
  CHECK(!problem.asked_outside);
}

// z = 10 in steps of at most 3 from 0: 3, 6, 9, 10.
TEST(newton_limits_its_steps) {
  Scalar<true, true> problem{[](double z) { return z - 10; }, [](double) { return 1.0; }};
  problem.longest_step = 3;
  double z = 0;
  int iterations = 0;
  CHECK(solved(problem, z, iterations).status == Status::ok);
  CHECK(z == 10 && iterations == 4);
  z = 0;
  const NewtonResult<double> short_of = solved(problem, z, iterations, {3});
  CHECK(short_of.status == Status::not_converged && short_of.residual == 1 && z == 9);
}

// A slope of the wrong sign leads uphill at any length: f = z from 1. Stopping keeps the start; going on takes the
// shortest step, 1 + 2^-12.
TEST(newton_uphill_stops_or_goes_on) {
  const auto line = [](double z) { return z; };
  const auto wrong = [](double) { return -1.0; };
  double z = 1;
  int iterations = 0;
  Scalar<true, true> stops{line, wrong};
  CHECK(solved(stops, z, iterations).status == Status::not_converged);
  CHECK(z == 1 && iterations == 0);
  Scalar<true, false> goes_on{line, wrong};
  CHECK(solved(goes_on, z, iterations, {1}).status == Status::not_converged);
  CHECK(z == 1 + std::ldexp(1, -12) && iterations == 1);
}

TEST(newton_says_how_it_failed) {
  double z = 1;
  int iterations = 0;
  Scalar<true, true> flat{[](double) { return 1.0; }, [](double) { return 0.0; }};
  CHECK(solved(flat, z, iterations).status == Status::singular);
  Scalar<true, true> undefined{[](double) { return std::nan(""); }, [](double) { return 1.0; }};
  CHECK(solved(undefined, z, iterations).status == Status::not_finite);
  CHECK(z == 1 && iterations == 0);
}

// The largest residual of those there are, whatever stands behind them; a NaN is larger than any.
TEST(newton_largest_residual_and_its_place) {
  const double nan = std::nan("");
  const double residual[] = {1e-3, -7, 2, 1e-12, nan, 1e-11, 100};
  const auto at = [&](int first, int n) { return largest_residual(residual + first, n, 1e-10); };
  CHECK(at(0, 3).residual == 7 && at(0, 3).worst == 1 && at(0, 3).status == Status::not_converged);
  CHECK(at(0, 4).residual == 7 && at(0, 1).residual == 1e-3);
  CHECK(at(3, 1).residual == 1e-12 && at(3, 1).status == Status::ok);
  CHECK(at(5, 1).residual == 1e-11 && at(5, 1).status == Status::ok);
  CHECK(std::isinf(at(0, 5).residual) && at(0, 5).worst == 4 && at(0, 5).status == Status::not_finite);
}
