// Trim: approaches from level flight, other speeds and less weight.
// Expected: the cold start of another weight, statics, and rates of zero in the plain model.
#include <algorithm>
#include <random>

#include "analysis_case.hpp"

using namespace analysis_case;

namespace {
// In thin air, on the real-time grid, with the inflow that lets the rotors stall at 3000 m.
Configuration<double> high_up(double altitude_m, double mass_kg = 5896.7) {
  FlightSetup<double> setup = flight_setup(aircraft_data<double>(), 0.0);
  setup.options = reference_options();
  setup.options.grid = BladeGrid::realtime;
  setup.altitude = altitude_m;
  setup.mass = mass_kg;
  Configuration<double> c;
  CHECK(prepare(aircraft_data<double>(), setup, c) == Status::ok);
  return c;
}
}  // namespace

// What the rotors carry at most is found by adding collective to a lighter aircraft until that gives less
// lift. Here the aircraft itself gets lighter, and the cold start decides.
TEST_OF_XV15(trim_tells_what_rotors_carry_before_they_stall) {
  for (double speed : {6.0, 8.0}) {
    const TrimResult<double> r = trimmed(high_up(3000), level(speed));
    CHECK(r.status == TrimStatus::rotor_stall);
    CHECK_LT(r.weight_carried, 1);
    CHECK_LT(0.99, r.weight_carried);
    CHECK(contains(explanation(r), "no trim: the aircraft carries at most 99."));
    const double carried = r.weight_carried * 5896.7;
    CHECK(is_trimmed(trimmed(high_up(3000, 0.9999 * carried), level(speed)).status));
    const TrimResult<double> heavy = trimmed(high_up(3000, 1.0001 * carried), level(speed));
    CHECK(heavy.status == TrimStatus::rotor_stall);
    CHECK_NEAR(heavy.weight_carried, 1 / 1.0001, 1e-5);
  }
}

// Newton from anywhere finds no other trim but with blades like flat plates, at two to three times the power
// of both engines (2 x 1156 kW); with 1 % less mass it finds the one short of stall.
TEST_OF_XV15(trim_beyond_stalled_rotors_has_no_use) {
  static TrimWorkspace<double> work;
  std::mt19937 random(20261122);
  const auto between = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto count_below = [&between](double power, double mass) {
    const Configuration<double> c = high_up(3000, mass);
    int count = 0;
    for (int k = 0; k < 40; ++k) {
      TrimResult<double> r{};
      r.controls.collective = between(8, 28) * kDeg;
      r.controls.long_stick = between(-4, 4);
      r.state.pitch = between(-10, 10) * kDeg;
      for (RotorState<double>& rotor : r.state.rotor) {
        rotor.lambda_0 = between(0.02, 0.12);
        rotor.lambda_c = between(-0.02, 0.05);
        rotor.b1c = between(-5, 5) * kDeg;
      }
      count += is_trimmed(trim_from(c, level(6), work, r)) && r.power[right] + r.power[left] < power;
    }
    return count;
  };
  const double twice_the_engines = 2 * 2 * 1156e3;
  CHECK_EQ(count_below(twice_the_engines, 5896.7), 0);
  const int lighter = count_below(twice_the_engines, 0.99 * 5896.7);
  CHECK_LE(10, lighter);
  NOTE("of 40 starts " << lighter << " lead to a flyable trim with 99 % of the mass, none with all of it");
}

// The same way on to the whole weight, where the rotors carry it: the trim of the cold start.
TEST(trim_over_less_weight_is_the_trim_of_the_cold_start) {
  static TrimWorkspace<double> work;
  for (double speed : {0.0, 20.0, 40.0}) {
    const Configuration<double> c = flown_configuration(0);
    const SteadyFlight<double> flight = flown(level(speed));
    const TrimResult<double> cold = trimmed(c, flight);
    int iterations = 0;
    double carried = 0;
    trim_equations(c, work.equations);
    CHECK(trim_solver::from_less_weight(c, flight, work, iterations, carried).status == TrimStatus::ok);
    State<double> x;
    Controls<double> u;
    trim_solver::unflatten_unknowns(flight, work, x, u);
    CHECK_NEAR(u.collective, cold.controls.collective, 1e-8);
    CHECK_NEAR(u.long_stick, cold.controls.long_stick, 1e-7);
    CHECK_NEAR(x.pitch, cold.state.pitch, 1e-8);
  }
}

// Whatever it finds, the equations are those of the whole weight again.
TEST_OF_XV15(trim_over_less_weight_leaves_the_equations) {
  static TrimWorkspace<double> work;
  TrimEquations<double> whole;
  struct Case {
    double altitude, speed;
    TrimStatus status;
  };
  for (const Case& k : {Case{0, 20, TrimStatus::ok}, Case{3500, 6, TrimStatus::rotor_stall},
                        Case{0, 100, TrimStatus::not_converged}}) {
    const Configuration<double> c = high_up(k.altitude);
    int iterations = 0;
    double carried = 1;
    trim_equations(c, whole);
    trim_equations(c, work.equations);
    CHECK(trim_solver::from_less_weight(c, level(k.speed), work, iterations, carried).status == k.status);
    CHECK_EQ(carried < 1, k.status == TrimStatus::rotor_stall);
    CHECK(!work.equations.relieved);
    CHECK_EQ(work.equations.carried, 1.0);
    CHECK_EQ(work.equations.row[kCollectiveRow].control, whole.row[kCollectiveRow].control);
    CHECK_EQ(work.equations.row[kCollectiveRow].step_limit, whole.row[kCollectiveRow].step_limit);
    CHECK_EQ(trimmed(c, level(k.speed)).weight_carried, carried);
  }
}

// The same top of the lift in single precision and by numerical differences.
TEST_OF_XV15(trim_of_stalled_rotors_in_every_build) {
  const Configuration<double> c = high_up(3500);
  const double carried = trimmed(c, level(6)).weight_carried;
  static TrimWorkspace<double, NumDiff> numerical;
  TrimResult<double> r;
  CHECK(trim(c, level(6), numerical, r) == TrimStatus::rotor_stall);
  CHECK_NEAR(r.weight_carried, carried, 1e-6);

  FlightSetup<float> setup = flight_setup(aircraft_data<float>(), 0.0F);
  setup.options = reference_options();
  setup.options.grid = BladeGrid::realtime;
  setup.altitude = 3500;
  static Configuration<float> single;
  CHECK(prepare(aircraft_data<float>(), setup, single) == Status::ok);
  static TrimWorkspace<float> work;
  TrimResult<float> low;
  CHECK(trim(single, SteadyFlight<float>{6, 0, 0, 0}, work, low) == TrimStatus::rotor_stall);
  CHECK_NEAR(low.weight_carried, carried, 1e-3);
}

// A vertical force in place of weight, turned back into axes level with the ground.
TEST(trim_relief_is_vertical) {
  const double roll = 0.3, pitch = -0.2, part = 0.25;
  State<double> rates{};
  relieve_weight(roll, pitch, part, rates);
  const Vector level_axes = to_earth({rates.velocity.x, rates.velocity.y, rates.velocity.z}, roll, pitch);
  CHECK_NEAR(level_axes.x, 0, 1e-15);
  CHECK_NEAR(level_axes.y, 0, 1e-15);
  CHECK_NEAR(level_axes.z, -part * 9.80665, 1e-15);
  CHECK_EQ(rates.rates.y, 0);
}

namespace {
void check_stands_still(const Configuration<double>& c, const SteadyFlight<double>& flight,
                        const TrimResult<double>& r) {
  State<double> rates;
  derivative(c, r.state, r.controls, rates);
  for (double x : {rates.velocity.x, rates.velocity.y, rates.velocity.z, rates.rates.x, rates.rates.y,
                   rates.rates.z, rates.roll, rates.pitch})
    CHECK_NEAR(x, 0, 1e-8);
  CHECK_NEAR(rates.yaw, flight.turn_rate, 1e-12);
  const Vec3<double>& v = r.state.velocity;
  CHECK_NEAR(std::sqrt(dot(v, v)), flight.speed, 1e-9);
}

// A wing whose flights are known to need the approaches below.
Options another_wing() {
  Options o;
  o.wake_fade_airplane = false;
  o.mast_drag = MastDrag::cross_flow;
  o.rotor_lift_flaps = RotorLiftFlaps::any;
  return o;
}
}  // namespace

// Flights that the first guess does not lead to, but an approach: from level flight, from a slower one, from
// a faster one. Whatever the way, the model stands still there. Which way leads to which flight is the XV-15's.
TEST_OF_XV15(trim_is_found_from_level_flight_and_other_speeds) {
  struct Case {
    double mast_deg, speed, climb_deg, turn_deg, sideslip_deg;
  };
  const Case cases[] = {{30, 87, -22, -2, 0}, {45, 48, 19, 0, 22}, {45, 37, -5, -24, 0}};
  bool used[6] = {};
  for (const Case& k : cases) {
    const Configuration<double> c = configuration(k.mast_deg, another_wing());
    const SteadyFlight<double> flight{k.speed, k.climb_deg * kDeg, k.turn_deg * kDeg, k.sideslip_deg * kDeg};
    const TrimResult<double> r = trimmed(c, flight);
    if (!CHECK(is_trimmed(r.status))) NOTE("mast " << k.mast_deg << ", " << k.speed << " m/s");
    used[r.attempts] = true;
    check_stands_still(c, flight, r);
  }
  CHECK(used[2] && used[3] && used[4]);
}

TEST(trim_found_by_an_approach_stands_still) {
  std::mt19937 random(20261126);
  const auto between = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Options options;
  options.grid = BladeGrid::realtime;
  int approached = 0;
  for (int k = 0; k < 60; ++k) {
    const Configuration<double> c = flown_configuration(between(25, 50), 0, options);
    const double climb = between(-25, 25), turn = between(-25, 25), sideslip = between(-25, 25);
    const SteadyFlight<double> flight = flown({between(35, 90), climb * kDeg, turn * kDeg, sideslip * kDeg});
    const TrimResult<double> r = trimmed(c, flight);
    if (!is_trimmed(r.status)) continue;
    check_stands_still(c, flight, r);
    approached += r.attempts > 1;
  }
  NOTE(approached << " of 60 random flights by an approach");
  CHECK_LE(1, approached);
}

// Where there is no trim, each way to approach one is tried: from level flight where the flight is not, from
// a speed below and above, and from less weight.
TEST(trim_tries_every_approach) {
  const Configuration<double> c = flown_configuration(0);
  CHECK_EQ(trimmed(c, flown(level(140))).attempts, 4);
  CHECK_EQ(trimmed(c, flown({140, 0, 0.1, 0})).attempts, 5);
  CHECK_EQ(trimmed(c, flown({140, 0, 0, 0.1})).attempts, 5);
  CHECK_EQ(trimmed(c, flown({140, 0.1, 0, 0})).attempts, 5);
}
