// Masts, rotor speed and air that move during a flight: against small steps made anew by prepare(), against
// closed forms of the way, and against what does not move.
#include <algorithm>
#include <cstring>

#include "analysis_case.hpp"

using namespace analysis_case;

namespace {

SimulationWorkspace<double> work;

struct Flight {
  Configuration<double> c;
  Simulation<double> s;
};

Options realtime() {
  Options options;
  options.grid = BladeGrid::realtime;
  options.position_states = true;
  return options;
}

FlightSetup<double> moving_setup(double mast, double rate, double acceleration, double rotor_acceleration,
                                 const Options& options = realtime()) {
  FlightSetup<double> setup = flight_setup(aircraft_data<double>(), mast);
  setup.options = options;
  setup.mast_rate = rate;
  setup.mast_acceleration = acceleration;
  setup.rotor_acceleration = rotor_acceleration;
  return setup;
}

// Trimmed with the masts at rest, then on its way.
Flight begun(const FlightSetup<double>& setup, double speed, double dt, Integrator integrator) {
  Flight f;
  const Configuration<double> still = configuration(setup.mast_deg, setup.options);
  const TrimResult<double> r = trimmed(still, level(speed));
  CHECK(is_trimmed(r.status));
  CHECK(prepare(aircraft_data<double>(), setup, f.c) == Status::ok);
  CHECK(start(f.c, r.state, r.controls, dt, integrator, f.s) == Status::ok);
  return f;
}

Status fly(Flight& f, int steps, bool air_follows = false, double origin = 0) {
  MovingConfiguration<double> moving{&f.c, air_follows, origin, {}, 0};
  for (int k = 0; k < steps; ++k) {
    const Status status = advance_moving(moving, work, f.s);
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

double difference(const State<double>& a, const State<double>& b) {
  double x[state_count], y[state_count];
  flatten(a, x);
  flatten(b, y);
  double worst = 0;
  for (int i = 0; i < state_count; ++i) worst = std::max(worst, std::abs(x[i] - y[i]));
  return worst;
}

template <class S>
bool same_bits(const S& a, const S& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace

TEST(moving_nothing_keeps_the_bits) {
  const Options options = realtime();
  Flight a = begun(moving_setup(30, 0, 0, 0, options), 50, 0.005, Integrator::rk3), b = a;
  CHECK(add_input(a.s, {InputShape::pulse, kControlIndex.long_stick, 0.3, 0.1, 0.2}) == Status::ok);
  CHECK(add_input(b.s, {InputShape::pulse, kControlIndex.long_stick, 0.3, 0.1, 0.2}) == Status::ok);
  CHECK(fly(a, 200) == Status::ok);
  for (int k = 0; k < 200; ++k) CHECK(advance(b.c, work, b.s) == Status::ok);
  CHECK(same_bits(a.s.state, b.s.state));
  // Air that follows an altitude which is that of the setting all the time: the same to rounding.
  Flight d = begun(moving_setup(30, 0, 0, 0, options), 50, 0.005, Integrator::rk3), e = d;
  CHECK(fly(d, 1, true, 0) == Status::ok && fly(e, 1) == Status::ok);
  CHECK_LT(difference(d.s.state, e.s.state), 1e-12);
}

// The way of mast and rotor in closed form, whatever the lengths of the steps.
TEST(moving_masts_and_rotors_go_their_way) {
  for (const Integrator integrator : {Integrator::rk3, Integrator::rk4, Integrator::rodas3}) {
    Flight f = begun(moving_setup(20, 0.1, -0.05, -2), 45, 0.01, integrator);
    const double azimuth = current_azimuth(f.c, f.s), omega = f.c.setup.rotor_speed;
    CHECK(fly(f, 50) == Status::ok);
    const double t = 0.5;
    CHECK_NEAR(f.c.setup.mast_deg, 20 + (0.1 * t - 0.025 * t * t) / kDeg, 1e-11);
    CHECK_NEAR(f.c.setup.mast_rate, 0.1 - 0.05 * t, 1e-14);
    CHECK_NEAR(f.c.setup.rotor_speed, omega - 2 * t, 1e-12);
    CHECK_NEAR(current_azimuth(f.c, f.s) - azimuth, omega * t - t * t, 1e-11);
    // What follows from the setting follows.
    Configuration<double> anew;
    CHECK(prepare(aircraft_data<double>(), f.c.setup, anew) == Status::ok);
    CHECK(same_bits(anew.mass, f.c.mass) && same_bits(anew.hub, f.c.hub) &&
          same_bits(anew.gearing, f.c.gearing));
  }
}

// Every integrator keeps its order with masts and rotors on their way: errors against steps of a quarter.
TEST(moving_keeps_the_order_of_the_integrators) {
  const FlightSetup<double> setup = moving_setup(25, 0.13, 0.2, 3);
  const auto flown = [&setup](Integrator integrator, double dt) {
    Flight f = begun(setup, 45, dt, integrator);
    CHECK(fly(f, static_cast<int>(std::lround(0.2 / dt))) == Status::ok);
    return f.s.state;
  };
  const State<double> exact = flown(Integrator::rk4, 0.0003125);
  struct Case {
    Integrator integrator;
    double dt, order;
  };
  for (const Case& at : {Case{Integrator::rk3, 0.0025, 3}, Case{Integrator::rk4, 0.0025, 4},
                         Case{Integrator::rodas3, 0.0025, 3}}) {
    const double coarse = difference(flown(at.integrator, at.dt), exact);
    const double fine = difference(flown(at.integrator, at.dt / 2), exact);
    NOTE(coarse << " then " << fine);
    CHECK_LT(std::pow(2.0, at.order - 0.5), coarse / fine);
  }
}

// Blades one by one, which see time through their azimuth as well. At which steps the order shows is the XV-15's.
TEST_OF_XV15(moving_rotor_turns_its_blades) {
  Options options = realtime();
  options.azimuth = AzimuthMode::individual;
  double azimuth = 0;
  const auto flown = [&](double dt) {
    Flight f = begun(moving_setup(10, 0.1, 0, -4, options), 30, dt, Integrator::rk4);
    CHECK(fly(f, static_cast<int>(std::lround(0.1 / dt))) == Status::ok);
    azimuth = current_azimuth(f.c, f.s);
    CHECK_NEAR(azimuth, f.c.aircraft->rotor.speed_helicopter * 0.1 - 2 * 0.01, 1e-11);
    return f.s.state;
  };
  const State<double> exact = flown(0.0003125);
  const double coarse = difference(flown(0.0025), exact), fine = difference(flown(0.00125), exact);
  NOTE(coarse << " then " << fine);
  CHECK_LT(8, coarse / fine);
}

TEST(moving_masts_end_at_their_stops) {
  struct Case {
    double mast, rate, acceleration, seconds;  // till the stop
  };
  // Way = rate t + acceleration t^2/2.
  for (const Case& at :
       {Case{89.5, 0.13, 0, 0.5 * kDeg / 0.13}, Case{0.5, -0.13, 0, 0.5 * kDeg / 0.13},
        Case{0.5, 0.1, -1, 0.1 + std::sqrt(0.01 + 2 * 0.5 * kDeg)}, Case{0, -0.1, 0, 0}, Case{90, 0, 1, 0}}) {
    FlightSetup<double> setup = moving_setup(at.mast, at.rate, at.acceleration, 0);
    Flight f = begun(setup, at.mast < 45 ? 30 : 80, 0.01, Integrator::rk4);
    const int before = static_cast<int>(at.seconds / 0.01);
    CHECK(fly(f, before) == Status::ok);
    if (before > 0) CHECK(f.c.setup.mast_rate != 0);
    CHECK(fly(f, 1) == Status::ok);
    const bool upper = at.mast > 45;
    CHECK_EQ(f.c.setup.mast_deg, upper ? 90.0 : 0.0);
    CHECK_EQ(f.c.setup.mast_rate, 0.0);
    CHECK_EQ(f.c.setup.mast_acceleration, 0.0);
    CHECK(fly(f, 5) == Status::ok);
    CHECK_EQ(f.c.setup.mast_deg, upper ? 90.0 : 0.0);
  }
  // One that turns back before the stop does not meet it.
  Flight f = begun(moving_setup(1, -0.1, 1, 0), 30, 0.01, Integrator::rk4);
  CHECK(fly(f, 20) == Status::ok);
  CHECK_NEAR(f.c.setup.mast_deg, 1 + (-0.1 * 0.2 + 0.02) / kDeg, 1e-11);
  CHECK_EQ(f.c.setup.mast_acceleration, 1.0);
}

// The cut at the stop: as exact as a step that ends there.
TEST(moving_step_is_cut_at_the_stop) {
  Flight whole = begun(moving_setup(89.95, 0.13, 0, 0), 80, 0.02, Integrator::rk4);
  Flight parts = whole;
  CHECK(fly(whole, 1) == Status::ok);
  const double stop = 0.05 * kDeg / 0.13;
  CHECK(change_step(parts.s, stop) == Status::ok && fly(parts, 1) == Status::ok);
  CHECK_NEAR(parts.c.setup.mast_deg, 90, 1e-12);
  ConfigurationSetting<double> stopped = parts.c.setup;
  stopped.mast_deg = 90;
  stopped.mast_rate = 0;
  CHECK(change_configuration(stopped, parts.c, parts.s) == Status::ok);
  CHECK(change_step(parts.s, 0.02 - stop) == Status::ok && fly(parts, 1) == Status::ok);
  CHECK_LT(difference(whole.s.state, parts.s.state), 1e-12);
}

TEST(moving_beyond_a_range_leaves_everything) {
  const LimitTables<double>& limits = aircraft_data<double>().limits;
  Flight fast = begun(moving_setup(30, 0.999 * limits.mast_rate.high, limits.mast_acceleration.high, 0), 45,
                      0.01, Integrator::rk4),
         before = fast;
  CHECK(fly(fast, 1) == Status::out_of_range);
  CHECK(same_bits(fast.c, before.c) && same_bits(fast.s.state, before.s.state));
  // A rotor that speeds up beyond its range has no state to blame.
  Flight turning = begun(moving_setup(30, 0, 0, limits.rotor_acceleration.high), 45, 0.01, Integrator::rk4);
  CHECK(fly(turning, 1000) == Status::out_of_range);
  CHECK_EQ(turning.s.fault_state, -1);
  Flight low = begun(moving_setup(30, 0, 0, 0), 45, 0.01, Integrator::rk4), high = low;
  CHECK(fly(low, 1, true, -501) == Status::out_of_range);
  CHECK_EQ(low.s.fault_state, kStateIndex.position.z);
  CHECK(same_bits(low.c, high.c));
}

// A climb of a kilometre: density follows, and the flight is that of a configuration prepared anew at every step.
TEST(moving_air_follows_the_altitude) {
  Flight f = begun(moving_setup(90, 0, 0, 0), 90, 0.005, Integrator::rk3);
  Flight anew = f;
  f.s.state.position.z = anew.s.state.position.z = -20;
  f.s.state.pitch += 0.3;
  anew.s.state.pitch += 0.3;
  CHECK(fly(f, 400, true, 1000) == Status::ok);
  for (int k = 0; k < 400; ++k) {
    FlightSetup<double> setup = anew.c.setup;
    // Half a step on, at constant sink.
    const double sink = anew.s.state.velocity.z * std::cos(anew.s.state.pitch) -
                        anew.s.state.velocity.x * std::sin(anew.s.state.pitch);
    setup.altitude = 1000 - anew.s.state.position.z - 0.0025 * sink;
    CHECK(prepare(aircraft_data<double>(), setup, anew.c) == Status::ok);
    CHECK(advance(anew.c, work, anew.s) == Status::ok);
  }
  CHECK_LT(f.s.state.position.z, -50);
  CHECK_NEAR(f.c.setup.altitude, 1000 - f.s.state.position.z, 1e-9);
  CHECK_EQ(f.c.air.density, standard_air(f.c.setup.altitude).density);
  CHECK_LT(difference(f.s.state, anew.s.state), 2e-5);
}

// Inflow keeps its speed when rotor speed jumps; blades stay where they are.
TEST(moving_rotor_speed_keeps_the_speed_of_the_inflow) {
  Flight f = begun(moving_setup(20, 0, 0, 0), 40, 0.01, Integrator::rk4);
  CHECK(fly(f, 10) == Status::ok);
  const Simulation<double> before = f.s;
  const double tip = f.c.tip_speed, azimuth = current_azimuth(f.c, f.s);
  ConfigurationSetting<double> slower = f.c.setup;
  slower.rotor_speed = 0.9 * slower.rotor_speed;
  CHECK(change_configuration(slower, f.c, f.s) == Status::ok);
  CHECK_NEAR(current_azimuth(f.c, f.s), azimuth, 1e-13);
  for (const Side side : {right, left}) {
    const RotorState<double>&now = f.s.state.rotor[side], &was = before.state.rotor[side];
    CHECK_REL(now.lambda_0 * f.c.tip_speed, was.lambda_0 * tip, 1e-15);
    CHECK_REL(now.lambda_c * f.c.tip_speed, was.lambda_c * tip, 1e-15);
    CHECK_NEAR(now.lambda_s * f.c.tip_speed, was.lambda_s * tip, 1e-15);
    CHECK_EQ(now.b1c, was.b1c);
  }
  slower.rotor_speed = 1;
  const Flight kept = f;
  CHECK(change_configuration(slower, f.c, f.s) == Status::out_of_range);
  CHECK(same_bits(kept.c, f.c) && same_bits(kept.s.state, f.s.state));
}

// A change of rotor speed: what the equations of a blade in its own turning frame say. Gimbal tilt of a blade,
// b = b1c cos psi + b1s sin psi, feels no more than before: b'' is the same function of b and b' whatever Omega'.
TEST(moving_rotor_speed_acts_on_tilt_inflow_and_shaft) {
  const Options options = realtime();
  const Configuration<double> still = configuration(30, options);
  const TrimResult<double> r = trimmed(still, level(50));
  State<double> x = r.state;
  x.rotor[right].b1c = 0.03;
  x.rotor[right].b1s = -0.02;
  x.rotor[right].b1c_rate = 0.4;
  x.rotor[right].b1s_rate = -0.7;
  const double faster = 3;
  Configuration<double> spun;
  CHECK(prepare(aircraft_data<double>(), moving_setup(30, 0, 0, faster, options), spun) == Status::ok);
  Evaluation<double> a, b;
  evaluate_aircraft(still, x, r.controls, a);
  evaluate_aircraft(spun, x, r.controls, b);
  const auto blade_acceleration = [&](const Evaluation<double>& e, double omega_rate, double psi) {
    const RotorState<double>&now = x.rotor[right], &rate = e.rates.rotor[right];
    const double omega = still.setup.rotor_speed, s = std::sin(psi), c = std::cos(psi);
    return rate.b1c_rate * c + rate.b1s_rate * s + 2 * omega * (now.b1s_rate * c - now.b1c_rate * s) +
           omega_rate * (now.b1s * c - now.b1c * s) - omega * omega * (now.b1c * c + now.b1s * s);
  };
  for (const double psi : {0.0, 1.0, 2.5, 5.0})
    CHECK_NEAR(blade_acceleration(b, faster, psi), blade_acceleration(a, 0, psi), 1e-11);
  // v = lambda Omega R: its rate is the same.
  for (const Side side : {right, left}) {
    const double omega = still.setup.rotor_speed, lambda = x.rotor[side].lambda_0;
    CHECK_NEAR(b.rates.rotor[side].lambda_0 * omega + lambda * faster, a.rates.rotor[side].lambda_0 * omega,
               1e-11);
  }
  // The shaft's torque rises by the inertia of the blades; on the airframe the two shafts cancel but for their cant.
  const RotorTables<double>& rotor = aircraft_data<double>().rotor;
  const double torque = rotor.blades * rotor.flap_inertia * faster;
  for (const Side side : {right, left}) {
    const Component part = side == right ? Component::rotor_right : Component::rotor_left;
    const Vec3<double> more = b.loads[part].moment - a.loads[part].moment;
    CHECK_NEAR(std::sqrt(dot(more, more)), torque, 1e-9);
    CHECK_NEAR(std::fabs(dot(more, still.hub[side].thrust_axis_b)), torque, 1e-9);
  }
  const Vec3<double> both = b.loads[Component::rotor_right].moment + b.loads[Component::rotor_left].moment -
                            a.loads[Component::rotor_right].moment - a.loads[Component::rotor_left].moment;
  CHECK_NEAR(both.x, 0, 1e-9);
  CHECK_NEAR(both.z, 0, 1e-9);
}

// Slow conversion passes through the static trims: what a rate of the mast adds to the rates of the state is
// proportional to it.
TEST(moving_slowly_is_the_static_trim_to_first_order) {
  const Options options = realtime();
  for (const double mast : {15.0, 45.0, 75.0}) {
    const Configuration<double> still = configuration(mast, options);
    const TrimResult<double> r = trimmed(still, level(55));
    const auto rates = [&](double mast_rate) {
      Configuration<double> c;
      CHECK(prepare(aircraft_data<double>(), moving_setup(mast, mast_rate, 0, 0, options), c) == Status::ok);
      State<double> xdot;
      derivative(c, r.state, r.controls, xdot);
      return xdot;
    };
    const double fast = rates(0.02).velocity.z - rates(0).velocity.z;
    const double slow = rates(0.01).velocity.z - rates(0).velocity.z;
    CHECK_NEAR(fast / slow, 2, 0.02);
    const double pitching = rates(0.02).rates.y - rates(0).rates.y;
    CHECK_NEAR(pitching / (rates(0.01).rates.y - rates(0).rates.y), 2, 0.02);
    CHECK_LT(1e-5, std::fabs(fast));
  }
}

TEST(moving_time_to_the_stop_has_closed_forms) {
  const Bounds<double> stops{0, 90};
  const auto time = [&stops](double mast, double rate_deg, double acceleration_deg) {
    ConfigurationSetting<double> s{};
    s.mast_deg = mast;
    s.mast_rate = rate_deg * kDeg;
    s.mast_acceleration = acceleration_deg * kDeg;
    return time_to_stop(s, stops, 1e9);
  };
  CHECK_NEAR(time(10, 5, 0), 16, 1e-12);
  CHECK_NEAR(time(10, -5, 0), 2, 1e-12);
  CHECK_NEAR(time(0, 0, 10), std::sqrt(18.0), 1e-12);
  CHECK_NEAR(time(0, -2, 4), 0, 0);
  CHECK_NEAR(time(90, -2, 4), 1, 1e-12);  // leaves and comes back
  // Turns after 5 s at 70 deg, then falls 70 deg at 2 deg/s^2.
  CHECK_NEAR(time(45, 10, -2), 5 + std::sqrt(70.0), 1e-12);
  CHECK_EQ(time(45, 0, 0), 1e9);
  CHECK_NEAR(time(90, -1, 0), 90, 1e-12);
}
