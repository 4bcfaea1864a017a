// A flight of the C++ analyses far from the origin and after many turns, in either precision.
// Expected: the same flight at the origin, circles in closed form.
#include <cstring>

#include "analysis_case.hpp"

using namespace analysis_case;

namespace {

template <class R>
struct Turning {
  Configuration<R> c;
  TrimResult<R> trimmed;

  Turning() {
    FlightSetup<R> setup = flight_setup(aircraft_data<R>(), R(0));
    setup.options.position_states = true;
    setup.options.grid = BladeGrid::realtime;
    static TrimWorkspace<R> work;
    CHECK(prepare(aircraft_data<R>(), setup, c) == Status::ok);
    CHECK(trim(c, SteadyFlight<R>{R(40), R(0), R(0.1), R(0)}, work, trimmed) == TrimStatus::ok);
  }

  Simulation<R> flown(const State<R>& begin, Integrator integrator) const {
    static SimulationWorkspace<R> work;
    Simulation<R> s;
    CHECK(start(c, begin, trimmed.controls, R(0.005), integrator, s) == Status::ok);
    for (int k = 0; k < 100; ++k) CHECK(advance(c, work, s) == Status::ok);
    return s;
  }
};

// Half a second from a place and heading far away, against the same from the origin.
template <class R>
void check_far_away() {
  const Turning<R> turning;
  for (const Integrator integrator : {Integrator::rk3, Integrator::rk4, Integrator::rodas3}) {
    const Simulation<R> home = turning.flown(turning.trimmed.state, integrator);
    State<R> begin = turning.trimmed.state;
    begin.position = {R(1e6), R(-3e5), R(-2000)};
    const Simulation<R> away = turning.flown(begin, integrator);
    const double place[] = {1e6, -3e5, -2000};
    for (int k = 0; k < 3; ++k)
      CHECK_NEAR(away.travel.sum[2 + k] - place[k], home.travel.sum[2 + k], 100 * 1.2e-16 * 1e6);
    CHECK(away.state.position.x == static_cast<R>(away.travel.sum[2]));

    begin = turning.trimmed.state;
    begin.yaw = static_cast<R>(4096 * kPi<double>);
    begin.roll += static_cast<R>(-200 * kPi<double>);
    const Simulation<R> turned = turning.flown(begin, integrator);
    const double off =
        std::abs(static_cast<double>(begin.roll - turning.trimmed.state.roll) + 200 * kPi<double>);
    CHECK_NEAR(turned.travel.sum[1] - static_cast<double>(begin.yaw), home.travel.sum[1], off + 1e-6);
    CHECK_NEAR(turned.state.velocity.y, home.state.velocity.y, 10 * off + (sizeof(R) == 8 ? 1e-9 : 1e-4));
    CHECK_LT(std::abs(current_state(turned).yaw), 3.2);
    CHECK_LT(std::abs(current_state(turned).roll), 3.2);
  }
}

}  // namespace

TEST(response_far_away_is_as_accurate) {
  check_far_away<double>();
  check_far_away<float>();
}

// A state changed by hand between steps counts; what was not touched keeps its digits.
TEST(response_state_changed_between_steps_counts) {
  static SimulationWorkspace<float> work;
  const Turning<float> turning;
  Simulation<float> s = turning.flown(turning.trimmed.state, Integrator::rk4);
  const double north = s.travel.sum[2];
  s.state.position.y = 1000.0f;
  s.state.yaw = 2.0f;
  CHECK(advance(turning.c, work, s) == Status::ok);
  CHECK_NEAR(s.travel.sum[3], 1000, 0.3);
  CHECK_NEAR(s.state.yaw, 2, 1e-3);
  CHECK_NEAR(s.travel.sum[2], north, 0.3);
}

// The rates of a linear model at current_state() begin the step after many turns too: the same bits.
TEST(response_rates_at_the_current_state_are_those_of_the_step) {
  static LinearModel<float> model;
  static LinearizationWorkspace<float> linearization;
  static SimulationWorkspace<float> work;
  const Turning<float> turning;
  State<float> begin = turning.trimmed.state;
  begin.yaw = 1234.5f;
  begin.roll += 100.0f;
  Simulation<float> alone = turning.flown(begin, Integrator::rk3);
  Simulation<float> helped = alone;
  for (int k = 0; k < 5; ++k) {
    CHECK(linearize(turning.c, current_state(helped), current_controls(helped), kInceptors, linearization,
                    model) == Status::ok);
    CHECK(advance(turning.c, work, helped, static_cast<const float*>(model.xdot)) == Status::ok);
    CHECK(advance(turning.c, work, alone) == Status::ok);
  }
  CHECK(std::memcmp(alone.travel.sum, helped.travel.sum, sizeof alone.travel.sum) == 0);
  CHECK_EQ(alone.state.velocity.x, helped.state.velocity.x);
}

// Against the circle that both functions draw.
TEST(response_angles_within_half_a_turn) {
  for (const double angle : {0.0, 1.0, -3.14159, 3.2, -7.0, 100.0, -54321.0, 999999.0}) {
    const double within = within_half_a_turn(angle);
    CHECK_LE(std::abs(within), kPi<double> * (1 + 1e-9));
    CHECK_NEAR(std::sin(within), std::sin(angle), 1e-15 + 2e-16 * std::abs(angle));
    CHECK_NEAR(std::cos(within), std::cos(angle), 1e-15 + 2e-16 * std::abs(angle));
    if (std::abs(angle) < kPi<double>) CHECK_EQ(within, angle);
  }
}

// A gust held in a trim: the equations are fulfilled with it, a wild one is refused.
TEST(trim_with_a_gust_is_steady) {
  const Configuration<double> c = configuration(30);
  static TrimWorkspace<double> work;
  TrimResult<double> calm, windy;
  for (const double turn : {0.0, 0.1}) {
    SteadyFlight<double> flight{50, 0.03, turn, 0.05};
    CHECK(trim(c, flight, work, calm) == TrimStatus::ok);
    flight.gust = {-6, 2, 3};
    CHECK(trim(c, flight, work, windy) == TrimStatus::ok);
    Evaluation<double> e;
    evaluate_aircraft(c, windy.state, windy.controls, e);
    for (const double rate : {e.rates.velocity.x, e.rates.velocity.y, e.rates.velocity.z, e.rates.rates.x,
                              e.rates.rates.y, e.rates.rates.z, e.rates.roll, e.rates.pitch})
      CHECK_NEAR(rate, 0, 1e-8);
    CHECK_NEAR(e.rates.yaw, turn, 1e-12);
    const Vec3<double> v = windy.state.velocity - windy.controls.gust;
    CHECK_NEAR(std::sqrt(dot(v, v)), 50, 1e-12);
    CHECK_EQ(windy.controls.gust.z, 3);
    if (turn == 0) {
      CHECK_NEAR(windy.controls.long_stick, calm.controls.long_stick, 1e-8);
      CHECK_NEAR(windy.angle_of_attack, calm.angle_of_attack, 1e-9);
      CHECK_REL(windy.power[right], calm.power[right], 1e-8);
    }
  }
  for (const double wild : {std::nan(""), 101.0, -HUGE_VAL}) {
    SteadyFlight<double> flight = level(50);
    flight.gust.y = wild;
    const TrimStatus refused = std::isfinite(wild) ? TrimStatus::out_of_range : TrimStatus::not_finite;
    CHECK(trim(c, flight, work, windy) == refused);
    CHECK(contains(explanation(windy), "gust must be within 50 m/s"));
  }
}
