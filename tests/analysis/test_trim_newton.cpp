// Trim: the first guess, Newton's iteration from it, and how the iteration fails.
// Expected: momentum theory, coordinated turns by hand, the order of Newton's method, made-up Jacobians.
#include <algorithm>
#include <limits>

#include "analysis_case.hpp"

using namespace analysis_case;

// Newton with an exact Jacobian doubles the number of digits: residuals after 1, 2, 3 ... steps.
TEST(trim_newton_converges_quadratically) {
  for (double mast : {0.0, 30.0, 60.0, 90.0}) {
    const Configuration<double> c = configuration(mast);
    double residual[13] = {};
    int steps = 0;
    for (int k = 1; k <= 12; ++k) {
      TrimOptions options;
      options.max_iterations = k;
      options.continuation = false;
      const TrimResult<double> r = trimmed(c, level(mast < 30 ? 30 : 70), options);
      residual[k] = r.residual;
      steps = k;
      if (is_trimmed(r.status)) break;
    }
    // Orders between successive steps, once close and above rounding.
    int quadratic = 0;
    for (int k = 1; k + 1 <= steps; ++k) {
      if (residual[k] < 3e-3 && residual[k + 1] > 1e-13) {
        const double order = std::log(residual[k + 1]) / std::log(residual[k]);
        CHECK_LT(1.5, order);
        ++quadratic;
      }
      if (residual[k] < 1e-4) CHECK_LT(residual[k + 1], 1e-6);
    }
    CHECK_LE(1, quadratic);
    CHECK_LT(residual[steps], 1e-10);
  }
}

TEST(trim_from_a_neighbour_takes_few_steps) {
  static TrimWorkspace<double> work;
  const Configuration<double> c = configuration(60);
  TrimResult<double> r = trimmed(c, level(70));
  for (double speed : {75.0, 80.0, 85.0}) {
    CHECK(trim_from(c, level(speed), work, r) == TrimStatus::ok);
    CHECK_LE(r.iterations, 5);
    CHECK_NEAR(r.controls.collective, trimmed(c, level(speed)).controls.collective, 1e-9);
  }
}

// A first guess that is no number is refused with the rate it spoils, and leaves no NaN behind.
TEST(trim_from_a_guess_that_is_no_number) {
  static TrimWorkspace<double> work;
  const Configuration<double> c = configuration(0);
  TrimResult<double> r = trimmed(c, level(20));
  const TrimResult<double> good = r;
  for (double State<double>::*const spoilt : {&State<double>::pitch, &State<double>::roll}) {
    r = good;
    r.state.*spoilt = std::nan("");
    CHECK(trim_from(c, level(20), work, r) == TrimStatus::not_finite);
    CHECK(contains(explanation(r), "is not a number at the first guess"));
    CHECK_EQ(r.iterations, 0);
    double x[state_count];
    flatten(r.state, x);
    for (const double value : x) CHECK(std::isfinite(value));
  }
  CHECK(trim_from(c, level(-1), work, r) == TrimStatus::out_of_range);
  CHECK(r.invalid == SteadyFlightField::speed);
}

// The guess for the inflow obeys momentum theory where the direction of the air through the disk is plain:
// hover, level flight and climb of the helicopter across and through its disk, the aeroplane along its shaft
// on any path.
TEST(trim_first_guess_obeys_momentum_theory) {
  struct Case {
    double mast_deg, speed, climb_deg, turn_deg;
    double across, through;  // of the speed
  };
  const double s = std::sin(10 * kDeg), k = std::cos(10 * kDeg);
  const Case cases[] = {{0, 0, 0, 0, 0, 0},     {0, 20, 0, 0, 1, 0},    {0, 20, 10, 0, k, s},
                        {0, 20, -10, 0, k, -s}, {90, 60, 0, 0, 0, 1},   {90, 60, 20, 0, 0, 1},
                        {90, 60, -5, 0, 0, 1},  {90, 60, -20, 0, 0, 1}, {90, 100, 10, 8, 0, 1}};
  for (const Case& at : cases) {
    const Configuration<double> c = configuration(at.mast_deg);
    const SteadyFlight<double> flight{at.speed, at.climb_deg * kDeg, at.turn_deg * kDeg, 0};
    TrimEquations<double> equations;
    trim_equations(c, equations);
    double z[kMaxTrimUnknowns];
    trim_first_guess(c, flight, equations, z);
    double n0[2] = {0, 0}, bank = 0;
    for (int j = 0; j < equations.count; ++j) {
      if (equations.row[j].state == kStateIndex.rotor[right].lambda_0) n0[right] = z[j];
      if (equations.row[j].state == kStateIndex.rotor[left].lambda_0) n0[left] = z[j];
      if (equations.row[j].state == kStateIndex.roll) bank = z[j];
    }
    CHECK_EQ(n0[right], n0[left]);
    // The helicopter's rotors carry the weight and a tenth for the download, those of the aeroplane the part
    // of the weight along the path and a lift over drag of about 7; the turn as much more as the bank asks.
    CHECK_NEAR(std::tan(bank), at.speed * std::cos(flight.climb) * flight.turn_rate / 9.80665, 1e-12);
    const double load =
        at.mast_deg < 45 ? 1.1 / std::cos(bank) : 0.15 / std::cos(bank) + std::sin(flight.climb);
    const double area = kPi<double> * std::pow(c.aircraft->rotor.radius, 2);
    const double thrust = std::max(load, 0.02) * c.mass.mass * 9.80665 / 2;
    // Thrust is mass flow times twice the induced velocity at the disk.
    const double induced = n0[right] * c.tip_speed;
    const double flow = std::hypot(at.across * at.speed, at.through * at.speed + induced);
    CHECK_REL(2 * c.air.density * area * flow * induced, thrust, 1e-6);
  }
}

// Without weight there is nothing to lift and no inflow; the guess stays finite.
TEST(trim_first_guess_of_an_aircraft_without_weight) {
  Configuration<double> c = configuration(0);
  c.mass.mass = 0;
  TrimEquations<double> equations;
  trim_equations(c, equations);
  double z[kMaxTrimUnknowns];
  trim_first_guess(c, level(0), equations, z);
  for (int j = 0; j < equations.count; ++j) {
    CHECK(std::isfinite(z[j]));
    if (equations.row[j].state == kStateIndex.rotor[right].lambda_0) CHECK_NEAR(z[j], 0, 0.01);
  }
}

namespace {

// Newton's iteration on plain numbers with a Jacobian that has `slope` in its diagonal, 1 beside it and
// nothing else.
double slope = 0;
struct GivenJacobian {
  static constexpr bool kJacobianIsCheap = false;
  template <class R, int N>
  using Scalar = R;
  template <class R, int N, int MaxInputs, int MaxOutputs>
  struct Workspace {};
  template <class R, int N, int MaxInputs, int MaxOutputs, class Function, class Put>
  static void jacobian(Function&& f, const JacobianRequest<R>& at, Workspace<R, N, MaxInputs, MaxOutputs>&,
                       Put&& put) {
    f(PlainInputs<R>{at.x}, PlainOutputs<R>{at.y});
    for (int i = 0; i < at.outputs; ++i)
      for (int j = 0; j < at.inputs; ++j) {
        const R entry = i == j ? slope : j == i + 1 ? 1 : 0;
        put(i, j, 1, &entry);
      }
  }
};

}  // namespace

// No step without a Jacobian, no step that overflows, none that leads uphill.
TEST(trim_says_how_the_iteration_failed) {
  static TrimWorkspace<double, GivenJacobian> work;
  const Configuration<double> c = configuration(0);
  TrimResult<double> r;
  TrimOptions options;
  for (double given : {0.0, 1e-200, HUGE_VAL}) {
    slope = given;
    for (bool continuation : {false, true}) {
      options.continuation = continuation;
      CHECK(trim(c, level(20), work, r, options) == TrimStatus::singular);
      CHECK(contains(explanation(r), "no trim found in 0 Newton steps"));
      CHECK_EQ(r.attempts, continuation ? 4 : 1);
    }
  }
  // Newton's direction is downhill for the true Jacobian; of a large diagonal, positive or negative, at most
  // one is.
  options.continuation = false;
  int stuck = 0;
  for (double given : {1e6, -1e6}) {
    slope = given;
    CHECK(trim(c, level(20), work, r, options) == TrimStatus::not_converged);
    stuck += r.iterations == 0 ? 1 : 0;
    CHECK_LT(1e-3, r.residual);
  }
  CHECK_LE(1, stuck);
}

// A solution upside down or beyond the vertical is not the steady flight asked for.
TEST(trim_upside_down_is_none) {
  static TrimWorkspace<double> work;
  const Configuration<double> c = configuration(90);
  for (double roll : {-2.0, 0.1, 1.5, 1.6}) {
    for (double pitch : {-1.6, 0.05, 1.5, 2.5}) {
      trim_equations(c, work.equations);
      trim_first_guess(c, level(80), work.equations, work.z);
      work.z[0] = roll;
      work.z[1] = pitch;
      TrimResult<double> r{};
      const trim_solver::NewtonOutcome<double> solved{TrimStatus::ok, 1e-12, 0};
      trim_solver::judge_outcome(c, level(80), solved, work, r);
      CHECK_EQ(is_trimmed(r.status), std::cos(roll) > 0 && std::cos(pitch) > 0);
      const trim_solver::NewtonOutcome<double> unsolved{TrimStatus::singular, 1, 0};
      trim_solver::judge_outcome(c, level(80), unsolved, work, r);
      CHECK(r.status == TrimStatus::singular);
    }
  }
}
