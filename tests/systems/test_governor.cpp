// Governors: against placed poles, the balance of power, and a linear model built by hand.
#include "tiltrotor/math/algebra/eigen.hpp"
#include "vehicle_case.hpp"

using namespace vehicle_case;

namespace {

const GovernorTables<double>& tables() { return aircraft_data<double>().systems.governor; }

SystemSwitches only(Governor governor) {
  SystemSwitches on{};
  on.governor = governor;
  return on;
}

double taken(const Rates& r) {
  return (r.airframe.torque[right] + r.airframe.torque[left]) * r.demand.setting.rotor_speed;
}

}  // namespace

// With the airframe frozen the loop has the frequency and damping that its gains are made for; where the rotor alone is
// damped more than that, more damping. The flights are those of the table.
TEST_OF_XV15(governor_places_the_poles_of_the_rotor_speed) {
  struct Case {
    double mast, speed;
    bool damped_by_rotor;
  };
  for (const Case& at : {Case{0, 0, false}, Case{15, 40, false}, Case{30, 60, false}, Case{60, 75, true},
                         Case{90, 100, true}}) {
    const Flight f = begun(at.mast, level(at.speed), only(Governor::pi));
    const Matrices& m = matrices(f);
    const int slow[2] = {m.system_row(kSystemIndex.rotor_speed), m.system_row(kSystemIndex.governor)};
    const auto entry = [&](int i, int j) {
      return settled(m, slow[i], [&](int row) { return m.a[row][slow[j]]; });
    };
    const double trace = entry(0, 0) + entry(1, 1);
    const double determinant = entry(0, 0) * entry(1, 1) - entry(0, 1) * entry(1, 0);
    const double frequency = std::sqrt(determinant), damping = -trace / (2 * frequency);
    NOTE("mast " << at.mast << " V " << at.speed << ": " << frequency << " rad/s, damping " << damping);
    CHECK_REL(frequency, tables().frequency, 0.02);
    if (at.damped_by_rotor) {
      CHECK_LT(tables().damping, damping);
    } else {
      CHECK_REL(damping, tables().damping, 0.02);
    }
  }
}

// A tenth more power: the rotor speed leaves by a few per cent, and returns.
TEST(governor_holds_the_rotor_speed) {
  for (const double mast : {0.0, 30.0, 60.0, 90.0}) {
    Flight f = begun(mast, level(20 + 0.9 * mast), with(Governor::pi), 0.01);
    const double wanted = f.vehicle().commands.rotor_speed;
    for (double& throttle : f.vehicle().commands.throttle) throttle *= 1.1;
    double most = 0;
    for (int k = 0; k < 2000; ++k) {
      CHECK(fly(f, 1) == Status::ok);
      most = std::max(most, std::fabs(f.state().rotor_speed / wanted - 1));
    }
    const double left_over = f.state().rotor_speed / wanted - 1;
    NOTE("mast " << mast << ": at most " << 100 * most << " percent, after 20 s " << 100 * left_over);
    CHECK_LT(most, 0.04);
    CHECK_NEAR(left_over, 0, 0.005);
    CHECK_LT(0, f.state().governor);  // more power: more collective
  }
}

// Signs: too fast or speeding up, more collective. Near the stop of its authority it goes no further than its rate over
// the return from there; beyond, with no error, it comes back.
TEST(governor_has_signs_rate_and_authority) {
  const SystemTables<double>& t = aircraft_data<double>().systems;
  const double wanted = 60, mast = 10 * kDeg;
  CHECK_LT(0, governor_rate(t, mast, wanted, 61.0, 0.0, 0.0));
  CHECK_LT(governor_rate(t, mast, wanted, 59.0, 0.0, 0.0), 0);
  CHECK_LT(0, governor_rate(t, mast, wanted, wanted, 0.1, 0.0));
  CHECK_LE(governor_rate(t, mast, wanted, 80.0, 5.0, 0.0), tables().rate);
  CHECK_NEAR(governor_rate(t, mast, wanted, wanted, 0.0, 0.0), 0, 1e-12);
  double collective = 0;
  for (int k = 0; k < 20000; ++k) collective += 1e-3 * governor_rate(t, mast, wanted, 75.0, 0.0, collective);
  CHECK_NEAR(collective, tables().authority + tables().rate / tables().stop, t.smooth.actuator_angle);
  for (int k = 0; k < 3000; ++k) collective += 1e-3 * governor_rate(t, mast, wanted, wanted, 0.0, collective);
  CHECK_NEAR(collective, tables().authority, 0.2 * kDeg);
}

// Ideal: at every step the rotors take what the engines give, rotor speed and lever untouched.
TEST(governor_ideal_takes_the_power_of_the_engines) {
  Flight f = begun(60, level(75), with(Governor::ideal), 0.01);
  const double omega = f.c.setup.rotor_speed;
  f.vehicle().commands.mast = 70 * kDeg;
  double worst = 0;
  for (int k = 0; k < 400; ++k) {
    if (k == 100)
      for (double& throttle : f.vehicle().commands.throttle) throttle *= 1.3;
    if (k == 200) f.s.controls.long_stick += 0.5;
    CHECK(fly(f, 1) == Status::ok);
    const Rates r = rates(f);
    const double given =
        f.c.aircraft->controls.transmission_efficiency * (f.state().power[right] + f.state().power[left]);
    worst = std::max(worst, std::fabs(taken(r) / given - 1));
    CHECK_EQ(f.c.setup.rotor_speed, omega);
  }
  NOTE("worst balance of power " << worst);
  CHECK_LT(worst, 1e-9);
}

// Throttles that close in hover at once: rotors that thrust take power at any collective. That is told, and nothing
// moves; in fast flight the air drives the rotors, and there is a collective.
TEST(governor_ideal_tells_that_there_is_no_collective) {
  for (const bool hovers : {true, false}) {
    Flight f = begun(hovers ? 0 : 90, level(hovers ? 0 : 100), only(Governor::ideal));
    for (double& throttle : f.vehicle().commands.throttle) throttle = 0;
    const Flight before = f;
    const Status status = fly(f, 20);
    if (!hovers) {
      CHECK(status == Status::ok);
      CHECK(matrices(f).status == Status::ok);
      continue;
    }
    CHECK(status == Status::out_of_range);
    CHECK_EQ(f.s.fault_state, state_count + kSystemIndex.governor);
    CHECK_LT(f.s.fault_time, 0.1);
    CHECK(matrices(before).status == Status::not_converged);
    CHECK(std::fabs(f.state().governor) < 1);
  }
}

// A - b_c (dP/dx)/(dP/dc) by hand: A and B of the airframe, slopes of the rotors' power by central differences.
TEST(governor_ideal_is_the_reduced_linear_model) {
  for (const double mast : {0.0, 45.0, 90.0}) {
    const Flight f = begun(mast, level(20 + 0.85 * mast), only(Governor::ideal));
    const Controls<double> u = current_controls(f.s);
    static LinearModel<double> bare;
    linear_model(f.c, f.s.state, u, kInceptors, bare);
    const auto power = [&](const State<double>& x, const Controls<double>& at) {
      Evaluation<double> e;
      evaluate_aircraft(f.c, x, at, e);
      return (e.rotor[right].loads.torque + e.rotor[left].loads.torque) * f.c.setup.rotor_speed;
    };
    double flat[state_count];
    flatten(f.s.state, flat);
    const auto power_at = [&] {
      State<double> x;
      unflatten(flat, x);
      return power(x, u);
    };
    double over_state[kMaxLinearStates];
    for (int j = 0; j < bare.states; ++j) {
      double& moved = flat[bare.state[j]];
      const double middle = moved, step = 1e-5 * kStateVariables[bare.state[j]].facts().bend;
      moved = middle + step;
      const double ahead = power_at();
      moved = middle - step;
      over_state[j] = (ahead - power_at()) / (2 * step);
      moved = middle;
    }
    Controls<double> more = u, less = u;
    more.collective += 1e-6;
    less.collective -= 1e-6;
    const double over_collective = (power(f.s.state, more) - power(f.s.state, less)) / 2e-6;

    const Matrices& m = matrices(f);
    CHECK_EQ(m.shape.states, bare.states);
    double worst = 0;
    for (int j = 0; j < bare.states; ++j) {
      double size = 1;
      for (int i = 0; i < bare.states; ++i) size = std::max(size, std::fabs(bare.a(i, j)));
      for (int i = 0; i < bare.states; ++i) {
        const double expected = bare.a(i, j) - bare.b(i, 0) * over_state[j] / over_collective;
        worst = std::max(worst, std::fabs(m.a[i][j] - expected) / size);
      }
    }
    // Power as an input: a throttle moves the collective by its power over the slope; the lever moves nothing.
    const int throttle = control_count + kCommandIndex.throttle[left];
    const double gain = f.c.aircraft->controls.transmission_efficiency *
                        demanded_power(aircraft_data<double>(), f.c.air, 1.0) / over_collective;
    double largest = 1;
    for (int i = 0; i < bare.states; ++i) largest = std::max(largest, std::fabs(bare.b(i, 0)));
    for (int i = 0; i < bare.states; ++i) {
      CHECK_NEAR(m.b[i][throttle], bare.b(i, 0) * gain, 1e-4 * largest * gain);
      CHECK_NEAR(m.b[i][kControlIndex.collective], 0, 1e-11 * largest);
    }
    NOTE("mast " << mast << ": worst " << worst << " of the column");
    CHECK_LT(worst, 1e-5);
  }
}

// Airplane mode at 100 m/s: rotors at fixed speed and collective are a brake, thrust falling by some 1100 N for each m/s,
// and damp the phugoid; those that take a constant power let it swing, near Lanchester's sqrt(2) g/V.
TEST_OF_XV15(governor_ideal_lets_the_phugoid_swing) {
  double damping[2] = {};
  for (const Governor governor : {Governor::off, Governor::ideal}) {
    const Flight f = begun(90, level(100), only(governor));
    const Matrices& m = matrices(f);
    static Matrix<double, kMaxVehicleStates, kMaxVehicleStates> a;
    static EigenWorkspace<double, kMaxVehicleStates> work;
    static Eigenvalues<double, kMaxVehicleStates> values;
    for (int i = 0; i < m.shape.states; ++i)
      for (int j = 0; j < m.shape.states; ++j) a(i, j) = m.a[i][j];
    CHECK(eigenvalues(a, m.shape.states, work, values) == Status::ok);
    double slowest = 1;  // rad/s, of those that swing
    for (int i = 0; i < values.size; ++i) {
      const double size = std::hypot(values.real[i], values.imag[i]);
      if (values.imag[i] <= 0 || size >= slowest) continue;
      slowest = size;
      damping[static_cast<int>(governor)] = -values.real[i] / size;
    }
    NOTE("governor " << static_cast<int>(governor) << ": " << slowest << " rad/s, damping "
                     << damping[static_cast<int>(governor)]);
    if (governor == Governor::ideal) CHECK_REL(slowest, std::sqrt(2.0) * kGravity<double> / 100, 0.25);
  }
  CHECK_LT(0.5, damping[0]);
  CHECK_NEAR(damping[1], 0.1, 0.03);
}
