// Stability augmentation: its signs and limits, the first-order answers that its gains are made for (NASA TM-89428
// pp. 19-20), attitudes that are held, and switching without a jump.
#include "vehicle_case.hpp"

using namespace vehicle_case;

namespace {

const SystemTables<double>& tables() { return aircraft_data<double>().systems; }
const ControlTables<double>& travels() { return aircraft_data<double>().controls; }

struct RateAxis {
  int control, rate;
  double time;
};
const RateAxis kAxes[] = {{kControlIndex.long_stick, kStateIndex.rates.y, tables().augmentation.pitch_time},
                          {kControlIndex.lat_stick, kStateIndex.rates.x, tables().augmentation.roll_time},
                          {kControlIndex.pedal, kStateIndex.rates.z, tables().augmentation.yaw_time}};

// Angular acceleration of the bare aircraft by an inch, rotors in their balance, rad/s^2.
double sensitivity(Flight f, const RateAxis& axis) {
  f.vehicle().on = kNone;
  const Matrices& m = matrices(f);
  return settled(m, m.row(axis.rate), [&](int i) { return m.b[i][axis.control]; });
}

// After a step of an inch a first-order rate has come 1 - 1/e of its way to b T when T has passed. `reached`: that
// rate; `rate_after`(): the next, `dt` later.
template <class Next>
double time_constant(double reached, double dt, Next&& rate_after) {
  double before = 0;
  for (int k = 0; k < static_cast<int>(3 / dt); ++k) {
    const double now = rate_after() / reached;
    if (now >= 1) return dt * (k + (1 - before) / (now - before));
    before = now;
  }
  return std::nan("");
}
double expected_rate(const Flight& f, const RateAxis& axis) {
  return sensitivity(f, axis) * axis.time * (1 - std::exp(-1.0));
}

// In the linear model, x' = A x + b, by steps of a millisecond of the classical method.
double linear_time_constant(const Flight& f, const RateAxis& axis) {
  const double reached = expected_rate(f, axis);
  const Matrices& m = matrices(f);
  const int n = m.shape.states;
  double x[kMaxVehicleStates] = {};
  return time_constant(reached, 1e-3, [&] {
    double slope[4][kMaxVehicleStates];
    for (int s = 0; s < 4; ++s) {
      const double part = s == 0 ? 0 : s == 3 ? 1e-3 : 5e-4;
      for (int i = 0; i < n; ++i) {
        slope[s][i] = m.b[i][axis.control];
        for (int j = 0; j < n; ++j) slope[s][i] += m.a[i][j] * (x[j] + (s == 0 ? 0 : part * slope[s - 1][j]));
      }
    }
    for (int i = 0; i < n; ++i)
      x[i] += 1e-3 / 6 * (slope[0][i] + 2 * slope[1][i] + 2 * slope[2][i] + slope[3][i]);
    return x[m.row(axis.rate)];
  });
}

// In flight, by a step of so many inches.
double flown_time_constant(Flight f, const RateAxis& axis, double size) {
  const double reached = size * expected_rate(f, axis);
  double u[control_count];
  flatten(f.s.controls, u);
  u[axis.control] += size;
  unflatten(u, f.s.controls);
  return time_constant(reached, f.s.dt, [&] {
    CHECK(fly(f, 1) == Status::ok);
    double x[state_count];
    flatten(f.s.state, x);
    return x[axis.rate];
  });
}

}  // namespace

// Nose up asks for forward stick, roll to the right for left stick, yaw to the right for left pedal; no more than the
// authority.
TEST(augmentation_works_against_the_motion_within_its_authority) {
  State<double> x{};
  SystemState<double> s{};
  const double mast = 10 * kDeg;
  const AugmentationTables<double>& a = tables().augmentation;
  const double authority[3] = {a.pitch_authority * travels().long_travel,
                               a.roll_authority * travels().lat_travel,
                               a.yaw_authority * travels().pedal_travel};
  const double sign[3] = {1, -1, -1};
  for (int k = 0; k < 3; ++k) {
    for (const double rate : {0.001, -0.001, 5.0, -5.0}) {
      x.rates = {k == 1 ? rate : 0, k == 0 ? rate : 0, k == 2 ? rate : 0};
      const SeriesCommand<double> wanted = augmentation(tables(), travels(), mast, 5.0, x, s);
      CHECK_LT(0, sign[k] * rate * wanted.axis[k]);
      CHECK_LE(std::fabs(wanted.axis[k]), authority[k]);
      if (std::fabs(rate) > 1) CHECK_NEAR(std::fabs(wanted.axis[k]), authority[k], tables().smooth.stick);
      for (int other = 0; other < 3; ++other)
        if (other != k) CHECK_NEAR(wanted.axis[other], 0, 1e-15);
    }
  }
}

// A turn flown with the yaw rate of its bank, (g/V) sin(phi), is left alone; so is one that lasts.
TEST(augmentation_leaves_a_coordinated_turn_alone) {
  State<double> x{};
  SystemState<double> s{};
  const double speed = 60, bank = 0.3;
  x.roll = bank;
  x.rates.z = kGravity<double> / speed * std::sin(bank);
  CHECK_NEAR(augmentation(tables(), travels(), 0.5, speed, x, s).axis[2], 0, 1e-12);
  CHECK_EQ(turn_rate_wanted(tables().augmentation, 0.99 * tables().augmentation.turn_from, bank), 0.0);
  x.rates.z = 0.1;
  s.washout = augmentation(tables(), travels(), 0.5, speed, x, s).washed_rate;
  CHECK_NEAR(augmentation(tables(), travels(), 0.5, speed, x, s).axis[2], 0, 1e-12);
}

// Small inputs, servos and actuators in the loop: 0.4, 0.4, 0.6 s within 15 percent, in hover and at low speed, from the
// linear model and from a flight. At 20 m/s the tail gives pitch a stiffness, and a rate no first-order answer.
TEST_OF_XV15(augmentation_gives_first_order_rates) {
  struct Case {
    double mast, speed;
  };
  for (const Case& at : {Case{0, 0}, Case{0, 10}, Case{0, 20}}) {
    const Flight f = begun(at.mast, level(at.speed), with(Governor::pi));
    for (const RateAxis& axis : kAxes) {
      const double linear = linear_time_constant(f, axis), flight = flown_time_constant(f, axis, 0.25);
      NOTE("mast " << at.mast << " V " << at.speed << " " << kStateVariables[axis.rate].name << ": linear "
                   << linear << ", flown " << flight << " s, wanted " << axis.time);
      if (at.speed > 10 && axis.rate == kStateIndex.rates.y) continue;
      CHECK_REL(linear, axis.time, 0.15);
      CHECK_REL(flight, axis.time, 0.15);
    }
  }
}

// Six degrees away from the attitude that is held: the aircraft comes back, at about the time constant of attitude
// retention, 1 s; with rates alone it does not.
TEST(augmentation_brings_a_held_attitude_back) {
  for (const bool in_roll : {true, false}) {
    const auto left_over = [in_roll](bool holds) {
      Flight f = begun(0, level(0), with(Governor::pi));
      if (!holds) f.state().rest_long = f.state().rest_lat = 5;  // never at rest
      CHECK(fly(f, 1) == Status::ok);
      CHECK_EQ(f.state().holds_roll, holds ? 1.0 : 0.0);
      double& angle = in_roll ? f.s.state.roll : f.s.state.pitch;
      const double before = angle;
      angle += 0.1;
      CHECK(fly(f, 800) == Status::ok);
      return angle - before;
    };
    const double held = left_over(true), free = left_over(false);
    NOTE((in_roll ? "bank" : "pitch")
         << " left of 0.1 after 4 s: " << held << " held, " << free << " with rates alone");
    CHECK_LT(std::fabs(held), 0.02);
    CHECK_LT(2 * std::fabs(held), std::fabs(free));
  }
}

// The stick out of the dead-band gives the attitude up; let go, another is held once the aircraft hardly turns.
TEST(augmentation_holds_from_the_moment_of_rest) {
  Flight f = begun(0, level(0), with(Governor::pi));
  CHECK(fly(f, 1) == Status::ok);
  CHECK_EQ(f.state().holds_pitch, 1.0);
  const double before = f.state().held_pitch;
  f.s.controls.long_stick -= 0.6;
  CHECK(fly(f, 160) == Status::ok);
  CHECK_EQ(f.state().holds_pitch, 0.0);
  f.s.controls.long_stick += 0.6;
  CHECK(fly(f, 1) == Status::ok);
  CHECK_EQ(f.state().holds_pitch, 0.0);  // turns still
  CHECK(fly(f, 600) == Status::ok);
  CHECK_EQ(f.state().holds_pitch, 1.0);
  CHECK_LT(before, f.state().held_pitch);
  CHECK_NEAR(f.s.state.pitch, f.state().held_pitch, 1 * kDeg);
}

// Off and on in flight: no rate of the airframe jumps, the series actuators return as they move, and nothing of the
// augmentation is left.
TEST(augmentation_that_lets_go_begins_without_its_part) {
  SystemSwitches on = with(Governor::pi);
  Flight f = begun(0, {20, 0, 5 * kDeg, 0}, on);
  Vehicle<double> letting_go = f.vehicle();
  letting_go.disengages = true;
  const auto settled = [&](Vehicle<double> v) {
    SystemState<double> s = f.state();
    Controls<double> u = current_controls(f.s);
    settle(f.c, f.s.state, {3000.0, 3000.0}, v, s, u);
    return s;
  };
  const SystemState<double> held = settled(f.vehicle()), gone = settled(letting_go);
  CHECK_LT(1e-4, std::fabs(held.series[0]) + std::fabs(held.series[1]) + std::fabs(held.series[2]));
  for (const double way : gone.series) CHECK_EQ(way, 0.0);
  CHECK_EQ(gone.washout, 0.0);
}

TEST(augmentation_switches_without_a_jump) {
  const auto airframe_differs = [](const Rates& a, const Rates& b) {
    double worst = 0;
    for (int i = 0; i < state_count; ++i)
      worst = std::max(worst, std::fabs(a.of[i] - b.of[i]) / vehicle_variable(i).facts().bend);
    return worst;
  };
  Flight f = begun(0, level(20), with(Governor::pi));
  f.s.controls.lat_stick += 0.4;
  f.s.controls.long_stick += 0.3;
  CHECK(fly(f, 100) == Status::ok);
  const Rates on = rates(f);
  const double series = f.state().series[1];
  CHECK_LT(0.01, std::fabs(series));
  f.vehicle().disengages = true;
  CHECK_EQ(airframe_differs(on, rates(f)), 0.0);
  CHECK(fly(f, 20) == Status::ok);
  CHECK_REL(f.state().series[1], series * std::exp(-0.1 * tables().augmentation.servo), 1e-3);
  int steps = 0;
  Rates before = rates(f);
  while (f.vehicle().on.augmentation && steps < 400) {
    before = rates(f);
    const Flight here = f;
    CHECK(fly(f, 1) == Status::ok);
    ++steps;
    if (f.vehicle().on.augmentation) continue;
    Flight gone = here;  // at the same state, without it
    gone.vehicle() = f.systems.vehicle;
    for (double& way : gone.state().series) way = 0;
    CHECK_LT(airframe_differs(before, rates(gone)), 1e-4);
  }
  CHECK(!f.vehicle().on.augmentation && !f.vehicle().disengages);
  for (const double way : f.state().series) CHECK_EQ(way, 0.0);
  CHECK_EQ(f.state().washout, 0.0);
  CHECK_EQ(f.state().holds_roll, 0.0);

  const Rates off = rates(f);
  f.vehicle().on.augmentation = true;
  CHECK_EQ(airframe_differs(off, rates(f)), 0.0);
  CHECK(fly(f, 1) == Status::ok);
  CHECK_LT(std::fabs(f.state().series[1]), 0.2 * tables().augmentation.roll_authority * travels().lat_travel);
}
