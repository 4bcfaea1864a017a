// Time response: a second implementation, two integrators, geometry of a circle, and the linear model's
// exponential.
#include <algorithm>
#include <cstring>

#include "analysis_case.hpp"

using namespace analysis_case;

namespace {

SimulationWorkspace<double> work;

Simulation<double> started(const Configuration<double>& c, const TrimResult<double>& r, double dt,
                           Integrator integrator = Integrator::rk4) {
  Simulation<double> s;
  CHECK(start(c, r.state, r.controls, dt, integrator, s) == Status::ok);
  return s;
}

void run(const Configuration<double>& c, Simulation<double>& s, double duration) {
  const int steps = static_cast<int>(std::lround(duration / s.dt));
  for (int k = 0; k < steps; ++k) {
    if (!CHECK(advance(c, work, s) == Status::ok)) return;
  }
}

double difference(const State<double>& a, const State<double>& b) {
  double x[state_count], y[state_count];
  flatten(a, x);
  flatten(b, y);
  double worst = 0;
  for (int i = 0; i < state_count; ++i) worst = std::max(worst, std::abs(x[i] - y[i]));
  return worst;
}

}  // namespace

// tests/reference: one degree of collective at 40 m/s, mast 0, computed by a second implementation.
TEST_OF_XV15(response_reference_collective_step) {
  const check::CsvFile file("tests/reference/response_collective_1deg_40mps.csv");
  const Configuration<double> c = reference_configuration(0);
  Simulation<double> s = started(c, trimmed(c, level(40)), 0.005);
  CHECK(add_input(s, {InputShape::step, kControlIndex.collective, kDeg, 0, 0}) == Status::ok);
  double worst = 0;
  for (int row = 0; row < file.rows(); ++row) {
    if (row > 0) run(c, s, 0.1);
    CHECK_NEAR(current_time(s), file.number(row, "time_s"), 1e-9);
    const State<double>& x = s.state;
    const double climb = x.velocity.x * std::sin(x.pitch) - x.velocity.z * std::cos(x.pitch);
    const double forward = x.velocity.x * std::cos(x.pitch) + x.velocity.z * std::sin(x.pitch);
    const double actual[] = {x.velocity.x,   x.velocity.y, x.velocity.z, x.rates.y / kDeg,
                             x.pitch / kDeg, forward,      climb};
    const char* column[] = {"u_mps",         "v_mps", "w_mps", "q_degps", "pitch_deg", "forward_speed_mps",
                            "climb_rate_mps"};
    for (int k = 0; k < 7; ++k) {
      CHECK_NEAR(actual[k], file.number(row, column[k]), 1e-6);
      worst = std::max(worst, std::abs(actual[k] - file.number(row, column[k])));
    }
  }
  NOTE("worst difference " << worst);
}

// Without inputs a trimmed aircraft stays where it is.
TEST(response_trim_is_at_rest) {
  for (double mast : {0.0, 30.0, 90.0}) {
    const Configuration<double> c = configuration(mast);
    const TrimResult<double> r = trimmed(c, level(mast < 90 ? 40 : 90));
    Simulation<double> s = started(c, r, 0.01);
    run(c, s, 2);
    CHECK_LT(difference(s.state, r.state), 1e-7);
  }
}

// A steady turn flies a circle: heading grows by the turn rate, and after half a turn the aircraft is a
// diameter away.
TEST(response_steady_turn_flies_a_circle) {
  Options options;
  options.position_states = true;
  const Configuration<double> c = configuration(90, options);
  const double rate = 12 * kDeg, speed = 90;
  const TrimResult<double> r = trimmed(c, {speed, 0, rate, 0});
  Simulation<double> s = started(c, r, 0.01);
  run(c, s, 15);  // 180 deg
  CHECK_NEAR(s.state.yaw, 180 * kDeg, 1e-6);
  const double distance = std::hypot(s.state.position.x, s.state.position.y);
  CHECK_REL(distance, 2 * speed / rate, 1e-6);
  CHECK_NEAR(s.state.position.z, 0, 1e-4);
  CHECK_NEAR(s.state.roll, r.state.roll, 1e-6);
}

// Methods that share no coefficient, and their orders: halving the step divides RK4's error by 16, RK3's and
// RODAS3's by 8. A frame of 5 ms of RK3 is far closer than a pilot could see.
TEST(response_integrators_agree) {
  const Configuration<double> c = configuration(30);
  const TrimResult<double> r = trimmed(c, level(50));
  const auto flown = [&](Integrator integrator, double dt) {
    Simulation<double> s = started(c, r, dt, integrator);
    CHECK(add_input(s, {InputShape::doublet, kControlIndex.lat_stick, 1.0, 0.1, 0.2}) == Status::ok);
    CHECK(add_input(s, {InputShape::pulse, kControlIndex.collective, kDeg, 0.2, 0.2}) == Status::ok);
    run(c, s, 0.8);
    return s.state;
  };
  const State<double> fine = flown(Integrator::rk4, 0.0005);
  const double a = difference(flown(Integrator::rk4, 0.01), fine);
  const double b = difference(flown(Integrator::rk4, 0.005), fine);
  CHECK_LT(10, a / b);
  const double g = difference(flown(Integrator::rk3, 0.005), fine);
  const double h = difference(flown(Integrator::rk3, 0.0025), fine);
  CHECK_LT(6, g / h);
  CHECK_LT(g, 1e-3);
  const double d = difference(flown(Integrator::rodas3, 0.0025), fine);
  const double e = difference(flown(Integrator::rodas3, 0.00125), fine);
  CHECK_LT(6, d / e);
  CHECK_LT(e, 1e-5);
  NOTE("errors: rk4 10 and 5 ms " << a << " " << b << ", rk3 5 and 2.5 ms " << g << " " << h
                                  << ", rodas3 2.5 and 1.25 ms " << d << " " << e);
}

// The rates that a linear model found on its way are the step's first derivative: the same bits.
TEST(response_begins_with_the_rates_of_the_linear_model) {
  static LinearModel<double> model;
  static LinearizationWorkspace<double> linearization;
  Options options;
  options.position_states = options.coning_states = true;
  const Configuration<double> c = configuration(30, options);
  const TrimResult<double> r = trimmed(c, {50, 0.05, 0.1, 0});
  for (Integrator integrator : {Integrator::rk3, Integrator::rk4}) {
    Simulation<double> alone = started(c, r, 0.01, integrator);
    CHECK(add_input(alone, {InputShape::step, kControlIndex.lat_stick, 1.0, 0.005, 0}) == Status::ok);
    Simulation<double> helped = alone;
    for (int k = 0; k < 10; ++k) {
      CHECK(linearize(c, helped.state, current_controls(helped), kInceptors, linearization, model) ==
            Status::ok);
      CHECK(advance(c, work, helped, static_cast<const double*>(model.xdot)) == Status::ok);
      CHECK(advance(c, work, alone) == Status::ok);
    }
    CHECK_EQ(difference(alone.state, helped.state), 0.0);
    CHECK_LT(0.1, std::abs(alone.state.position.x));
    CHECK_LT(0.01, alone.state.yaw);
  }
}

// Small inputs: x(t) of the nonlinear model against the matrix exponential of its A and B (Taylor series).
TEST(response_of_small_inputs_is_linear) {
  static LinearModel<double> model;
  const Configuration<double> c = configuration(90);
  const TrimResult<double> r = trimmed(c, level(100));
  linear_model(c, r.state, r.controls, kInceptors, model);
  const double size = 1e-5, duration = 1.0, dt = 0.002;
  Simulation<double> s = started(c, r, dt);
  CHECK(add_input(s, {InputShape::step, kControlIndex.pedal, size, 0, 0}) == Status::ok);
  run(c, s, duration);
  // x' = A x + B u over pieces of 1 ms, each by its Taylor series.
  const int n = model.states;
  double x[kMaxLinearStates] = {};
  for (int piece = 0; piece < 1000; ++piece) {
    double term[kMaxLinearStates], next[kMaxLinearStates];
    for (int i = 0; i < n; ++i) {
      term[i] = model.b(i, 3) * size;
      for (int j = 0; j < n; ++j) term[i] += model.a(i, j) * x[j];
      term[i] *= 0.001;
    }
    for (int order = 2; order < 14; ++order) {
      for (int i = 0; i < n; ++i) x[i] += term[i];
      for (int i = 0; i < n; ++i) {
        next[i] = 0;
        for (int j = 0; j < n; ++j) next[i] += model.a(i, j) * term[j];
      }
      for (int i = 0; i < n; ++i) term[i] = next[i] * 0.001 / order;
    }
  }
  double flat[state_count], base[state_count];
  flatten(s.state, flat);
  flatten(r.state, base);
  double scale = 0;
  for (int i = 0; i < n; ++i) scale = std::max(scale, std::abs(x[i]));
  for (int i = 0; i < n; ++i) CHECK_NEAR(flat[model.state[i]] - base[model.state[i]], x[i], 1e-4 * scale);
}

TEST(response_inputs_have_their_shapes) {
  const InputSignal<double> pulse{InputShape::pulse, kControlIndex.pedal, 2, 1, 0.5};
  CHECK_EQ(value_at(pulse, 0.99), 0.0);
  CHECK_EQ(value_at(pulse, 1.2), 2.0);
  CHECK_EQ(value_at(pulse, 1.51), 0.0);
  const InputSignal<double> doublet{InputShape::doublet, kControlIndex.pedal, 2, 1, 0.5};
  CHECK_EQ(value_at(doublet, 1.2), 2.0);
  CHECK_EQ(value_at(doublet, 1.7), -2.0);
  CHECK_EQ(value_at(doublet, 2.1), 0.0);
  const InputSignal<double> step{InputShape::step, kControlIndex.pedal, 2, 1, 0};
  CHECK_EQ(value_at(step, 100.0), 2.0);

  const Configuration<double> c = configuration(0);
  Simulation<double> s = started(c, trimmed(c, level(20)), 0.01);
  for (int k = 0; k < kMaxInputs; ++k) CHECK(add_input(s, step) == Status::ok);
  CHECK(add_input(s, step) == Status::bad_argument);
  CHECK_NEAR(controls_at(s, 5.0).pedal, s.controls.pedal + 2 * kMaxInputs, 1e-12);
  s.inputs = 0;
  CHECK(add_input(s, {InputShape::pulse, kControlIndex.pedal, 1, 0, 0}) == Status::bad_argument);
  CHECK(add_input(s, {InputShape::step, control_count, 1, 0, 0}) == Status::bad_argument);
  const double nan = std::nan("");
  CHECK(add_input(s, {InputShape::step, kControlIndex.pedal, nan, 0, 0}) == Status::bad_argument);
  CHECK(add_input(s, {InputShape::step, -1, 1, 0, 0}) == Status::bad_argument);
  CHECK(add_input(s, {InputShape::step, kControlIndex.pedal, 1, HUGE_VAL, 0}) == Status::bad_argument);
  CHECK(add_input(s, {InputShape::doublet, kControlIndex.pedal, 1, 0, nan}) == Status::bad_argument);
  CHECK(add_input(s, {InputShape::step, kControlIndex.pedal, 1, 0, nan}) ==
        Status::ok);  // a step has no duration

  for (const double dt : {0.0, -0.01, 1.001, nan})
    CHECK(start(c, s.state, s.controls, dt, Integrator::rk4, s) == Status::out_of_range);
  CHECK(start(c, s.state, s.controls, 1.0, Integrator::rk4, s) == Status::ok);
  Controls<double> u = s.controls;
  u.lat_stick = nan;
  CHECK(start(c, s.state, u, 0.01, Integrator::rk4, s) == Status::not_finite);
  State<double> x = s.state;
  x.yaw = HUGE_VAL;
  CHECK(start(c, x, Controls<double>{}, 0.01, Integrator::rk4, s) == Status::not_finite);
}

TEST(response_replay_is_exact) {
  const Configuration<double> c = configuration(60);
  Simulation<double> s = started(c, trimmed(c, level(70)), 0.005);
  CHECK(add_input(s, {InputShape::doublet, kControlIndex.long_stick, 0.5, 0.1, 0.2}) == Status::ok);
  run(c, s, 0.2);
  Simulation<double> copy = s;
  run(c, s, 0.3);
  run(c, copy, 0.3);
  CHECK_EQ(difference(s.state, copy.state), 0.0);
}

// Blade by blade: the mean path is that of the averaged rotor, and the shaft turns.
TEST(response_of_individual_blades_follows_the_average) {
  Options options;
  options.azimuth = AzimuthMode::individual;
  const Configuration<double> blades = configuration(0, options);
  const Configuration<double> average = configuration(0);
  const TrimResult<double> r = trimmed(average, level(30));
  for (Integrator integrator : {Integrator::rk3, Integrator::rk4, Integrator::rodas3}) {
    Simulation<double> s = started(blades, r, 0.001, integrator);
    run(blades, s, 0.5);
    CHECK_NEAR(current_azimuth(blades, s), 0.5 * blades.setup.rotor_speed, 1e-9);
    CHECK_NEAR(s.state.velocity.x, r.state.velocity.x, 0.1);
    CHECK_NEAR(s.state.velocity.z, r.state.velocity.z, 0.1);
    CHECK_NEAR(s.state.pitch, r.state.pitch, 0.01);
    CHECK_LT(1e-9, difference(s.state, r.state));
  }
  // Turning blades make the right side depend on time, which a Rosenbrock method must be told to keep its
  // order.
  const auto flown = [&](Integrator integrator, double dt) {
    Simulation<double> s = started(blades, r, dt, integrator);
    run(blades, s, 0.1);
    return s.state;
  };
  const State<double> fine = flown(Integrator::rk4, 0.0002);
  const double coarse_error = difference(flown(Integrator::rodas3, 0.001), fine);
  const double fine_error = difference(flown(Integrator::rodas3, 0.0005), fine);
  CHECK_LT(5, coarse_error / fine_error);
  NOTE("rodas3 1 and 0.5 ms " << coarse_error << " " << fine_error);
}

TEST(response_reports_a_lost_flight) {
  const Configuration<double> c = configuration(0);
  const TrimResult<double> r = trimmed(c, level(40));
  Simulation<double> s = started(c, r, 0.01);
  CHECK(add_input(s, {InputShape::step, kControlIndex.lat_stick, 3000.0, 0.5, 0}) == Status::ok);
  Status status = Status::ok;
  for (int k = 0; k < 3000 && status == Status::ok; ++k) status = advance(c, work, s);
  CHECK(status == Status::out_of_range || status == Status::not_finite);
  CHECK(s.fault_state >= 0 && s.fault_state < state_count);
  CHECK_LT(0.5, s.fault_time);
  CHECK_NEAR(s.fault_time, current_time(s) + s.dt, 1e-9);
  double flat[state_count];
  flatten(s.state, flat);
  for (double x : flat) CHECK(std::isfinite(x));  // the last good state
  const Simulation<double> stopped = s;
  CHECK(advance(c, work, s) == status);
  CHECK_EQ(s.steps, stopped.steps);
  if (s.fault_state >= 0) NOTE("lost at " << s.fault_time << " s in " << kStateVariables[s.fault_state].name);

  Simulation<double> bad;
  State<double> x = r.state;
  x.rotor[right].lambda_0 = std::nan("");
  CHECK(start(c, x, r.controls, 0.01, Integrator::rk4, bad) == Status::not_finite);
  CHECK(start(c, r.state, r.controls, 0.0, Integrator::rk4, bad) == Status::out_of_range);
  CHECK(start(c, r.state, r.controls, std::nan(""), Integrator::rk4, bad) == Status::out_of_range);
  CHECK(advance(c, work, bad) == Status::out_of_range);
}

TEST(response_refuses_an_unknown_integrator) {
  const Configuration<double> c = configuration(0);
  const TrimResult<double> r = trimmed(c, level(20));
  Simulation<double> s = started(c, r, 0.01, static_cast<Integrator>(9));
  CHECK(advance(c, work, s) == Status::bad_argument);
  CHECK(advance(c, work, s) == Status::bad_argument);
  CHECK_EQ(difference(s.state, r.state), 0.0);
}
