// Trim: against a second implementation, against Newton's laws written down independently in earth axes, and
// where no trim exists.
#include <algorithm>
#include <cstring>
#include <limits>
#include <random>

#include "analysis_case.hpp"

using namespace analysis_case;

// tests/reference: outputs of a second implementation of the same equations in another language.
TEST(trim_reference_grid) {
  const check::CsvFile grid("tests/reference/trim_grid_c1.csv");
  double worst_angle = 0, worst_inch = 0, worst_inflow = 0, worst_ratio = 0;
  int worst_iterations = 0;
  for (int row = 0; row < grid.rows(); ++row) {
    const Configuration<double> c = configuration(grid.number(row, "mast_deg"));
    const TrimResult<double> r = trimmed(c, level(grid.number(row, "speed_mps")));
    if (!CHECK(is_trimmed(r.status))) continue;
    CHECK_EQ(r.attempts, 1);
    CHECK_LE(r.iterations, 12);
    CHECK_LT(r.residual, 1e-10);
    const auto angle = [&](double value, const char* column) {
      const double expected = grid.number(row, column) * kDeg;
      CHECK_NEAR(value, expected, 1e-8);
      worst_angle = std::max(worst_angle, std::abs(value - expected));
    };
    const auto ratio = [&](double value, const char* column) {
      CHECK_REL(value, grid.number(row, column), 1e-7);
      worst_ratio = std::max(worst_ratio, std::abs(value / grid.number(row, column) - 1));
    };
    angle(r.state.pitch, "pitch_deg");
    angle(r.blades.long_cyclic[right], "B1_deg");
    angle(r.blades.elevator, "elevator_deg");
    angle(r.controls.collective, "collective75_deg");
    angle(r.collective_root, "collective_root_deg");
    angle(r.state.downwash, "downwash_deg");
    angle(r.wing_angle_of_attack, "alpha_wing_deg");
    const double stick = grid.number(row, "stick_in_0_9.6") - 4.8;
    CHECK_NEAR(r.controls.long_stick, stick, 1e-7);
    worst_inch = std::max(worst_inch, std::abs(r.controls.long_stick - stick));
    for (const RotorState<double>& rotor : r.state.rotor) {
      angle(rotor.b1c, "b1c_deg");
      angle(rotor.b1s, "b1s_deg");
      const double difference[] = {rotor.n0 - grid.number(row, "n0"), rotor.nc - grid.number(row, "nc"),
                                   rotor.ns - grid.number(row, "ns")};
      for (double d : difference) {
        CHECK_NEAR(d, 0, 1e-9);
        worst_inflow = std::max(worst_inflow, std::abs(d));
      }
    }
    ratio(r.thrust[right], "rotor_force_each_n");
    ratio(r.thrust[left], "rotor_force_each_n");
    ratio((r.power[right] + r.power[left]) / 1000, "power_total_kw");
    worst_iterations = std::max(worst_iterations, r.iterations);
  }
  NOTE("worst: angles " << worst_angle << " rad, stick " << worst_inch << " in, inflow " << worst_inflow
                        << ", thrust and power " << worst_ratio << " relative; iterations "
                        << worst_iterations);
}

// Every flight condition of the published GTRS and flight-test trim figures: one cold start each.
TEST(trim_published_conditions_from_cold_start) {
  struct Condition {
    double mast_deg, speed;
  };
  const Condition conditions[] = {{0, 0.5},    {0, 20.9},  {0, 31.0},  {0, 51.4},  {30, 41.0},  {30, 61.7},
                                  {60, 51.5},  {60, 72.3}, {60, 82.3}, {90, 72.0}, {90, 92.5},  {90, 102.9},
                                  {90, 123.5}, {0, 20.8},  {0, 43.27}, {90, 83.5}, {90, 102.4}, {0, 0},
                                  {0, 20},     {0, 30},    {0, 50},    {30, 42},   {30, 62},    {60, 52},
                                  {60, 72},    {60, 82},   {90, 75},   {90, 100},  {90, 120},   {90, 140}};
  int worst = 0;
  for (const Condition& k : conditions) {
    const TrimResult<double> r = trimmed(configuration(k.mast_deg), level(k.speed));
    if (!CHECK(r.status == TrimStatus::ok)) NOTE("mast " << k.mast_deg << ", " << k.speed << " m/s");
    CHECK_EQ(r.attempts, 1);
    CHECK_LE(r.iterations, 12);
    worst = std::max(worst, r.iterations);
  }
  NOTE("at most " << worst << " Newton steps");
}

namespace {

struct Vector {
  double x, y, z;
};
// Earth axes from body axes for 3-2-1 Euler angles with zero heading, as the product of two plane rotations.
Vector to_earth(const Vec3<double>& b, double roll, double pitch) {
  const double y = b.y * std::cos(roll) - b.z * std::sin(roll);
  const double z = b.y * std::sin(roll) + b.z * std::cos(roll);
  return {b.x * std::cos(pitch) + z * std::sin(pitch), y, -b.x * std::sin(pitch) + z * std::cos(pitch)};
}

}  // namespace

// Newton's second law in earth axes: a steady turn accelerates by turn rate x velocity; component forces and
// weight must supply it. Nothing of the body-axes equations is used.
TEST(trim_fulfils_newtons_law_in_earth_axes) {
  struct Case {
    double mast_deg, speed, climb_deg, turn_deg, sideslip_deg;
  };
  const Case cases[] = {{0, 0, 0, 20, 0},      {0, 20, -10, 0, 0},  {0, 40, 5, 8, 4},   {0, 40, 0, 10, 0},
                        {0, 30, 0, 0, -10},    {30, 50, 8, -6, 3},  {30, 40, 30, 0, 0}, {60, 60, -8, 10, 0},
                        {60, 60, 5, 8, 4},     {60, 80, 0, -15, 0}, {90, 80, 20, 0, 5}, {90, 100, 5, 10, 0},
                        {90, 120, -8, 10, -2}, {90, 140, 0, -5, 1}};
  for (const Case& k : cases) {
    const Configuration<double> c = configuration(k.mast_deg);
    const SteadyFlight<double> flight{k.speed, k.climb_deg * kDeg, k.turn_deg * kDeg, k.sideslip_deg * kDeg};
    const TrimResult<double> r = trimmed(c, flight);
    if (!CHECK(is_trimmed(r.status))) {
      NOTE("mast " << k.mast_deg << ", " << k.speed << " m/s, " << k.climb_deg << " " << k.turn_deg);
      continue;
    }
    CHECK_EQ(r.attempts, 1);
    CHECK_LE(r.iterations, 12);
    Evaluation<double> e;
    evaluate(c, r.state, r.controls, e);
    Vec3<double> force{0, 0, 0};
    for (const Loads<double>& loads : e.loads.component) force = force + loads.force;
    const Vector f = to_earth(force, r.state.roll, r.state.pitch);
    const Vector v = to_earth(r.state.velocity, r.state.roll, r.state.pitch);
    const double m = c.mass.mass;
    const double weight = m * 9.80665;
    CHECK_NEAR(f.x / weight, -m * flight.turn_rate * v.y / weight, 1e-9);
    CHECK_NEAR(f.y / weight, m * flight.turn_rate * v.x / weight, 1e-9);
    CHECK_NEAR(f.z / weight, -1, 1e-9);
    CHECK_NEAR(std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z), k.speed, 1e-12 * 150);
    CHECK_NEAR(-v.z, k.speed * std::sin(flight.climb), 1e-11);
    CHECK_NEAR(r.state.velocity.y, k.speed * std::sin(flight.sideslip), 1e-12);
    if (k.speed > 0) CHECK_LT(0, r.state.velocity.x);
    // The turn is steady in roll, pitch and heading.
    CHECK_NEAR(e.rates.roll, 0, 1e-12);
    CHECK_NEAR(e.rates.pitch, 0, 1e-12);
    CHECK_NEAR(e.rates.yaw, flight.turn_rate, 1e-12);
    // No angular acceleration, no motion of rotors and downwash.
    CHECK_NEAR(e.rates.rates.x, 0, 1e-10);
    CHECK_NEAR(e.rates.rates.y, 0, 1e-10);
    CHECK_NEAR(e.rates.rates.z, 0, 1e-10);
    CHECK_NEAR(e.rates.downwash, 0, 1e-10);
    for (const RotorState<double>& rotor : e.rates.rotor) {
      CHECK_NEAR(rotor.b1c_rate, 0, 1e-6);
      CHECK_NEAR(rotor.n0, 0, 1e-8);
    }
  }
}

// Textbook: a level turn without sideslip banks by about atan(V rate / g) and loads by sqrt(1 + (V rate /
// g)^2).
TEST(trim_coordinated_turn_load_factor) {
  const double speed = 80, rate = 10 * kDeg;
  const TrimResult<double> r = trimmed(configuration(90), {speed, 0, rate, 0});
  const double lateral = speed * rate / 9.80665;
  CHECK_REL(r.load_factor, std::sqrt(1 + lateral * lateral), 0.03);
  CHECK_NEAR(r.state.roll, std::atan(lateral), 1.5 * kDeg);
  CHECK_LT(r.state.rotor[left].n0 - r.state.rotor[right].n0, 1e-2);
}

// Energy: shaft power above level flight goes into weight times rate of climb, with the rotors' efficiency.
TEST(trim_climb_power_balance) {
  for (double speed : {80.0, 100.0, 120.0}) {
    const Configuration<double> c = configuration(90);
    const double climb = 5 * kDeg;
    const TrimResult<double> a = trimmed(c, level(speed));
    const TrimResult<double> b = trimmed(c, {speed, climb, 0, 0});
    const double more = b.power[0] + b.power[1] - a.power[0] - a.power[1];
    const double ratio = c.mass.mass * 9.80665 * speed * std::sin(climb) / more;
    CHECK_LT(0.8, ratio);
    CHECK_LT(ratio, 1.05);
  }
}

TEST(trim_symmetric_flight_is_symmetric) {
  for (double mast : {0.0, 30.0, 60.0, 90.0}) {
    const TrimResult<double> r = trimmed(configuration(mast), level(mast < 30 ? 30 : 60));
    CHECK_NEAR(r.state.roll, 0, 1e-12);
    CHECK_NEAR(r.state.velocity.y, 0, 1e-15);
    CHECK_NEAR(r.controls.lat_stick, 0, 1e-11);
    CHECK_NEAR(r.controls.pedal, 0, 1e-11);
    CHECK_NEAR(r.state.rotor[right].b1c, r.state.rotor[left].b1c, 1e-12);
    CHECK_REL(r.thrust[right], r.thrust[left], 1e-10);
  }
}

// The aircraft is its own mirror image: turn and sideslip reversed reverse roll, lateral stick and pedal.
TEST(trim_mirrored_flight_is_mirrored) {
  for (double mast : {0.0, 30.0, 90.0}) {
    const double speed = mast < 90 ? 40 : 90;
    const Configuration<double> c = configuration(mast);
    const TrimResult<double> a = trimmed(c, {speed, 3 * kDeg, 8 * kDeg, 3 * kDeg});
    const TrimResult<double> b = trimmed(c, {speed, 3 * kDeg, -8 * kDeg, -3 * kDeg});
    CHECK(is_trimmed(a.status));
    CHECK_NEAR(a.state.roll, -b.state.roll, 1e-9);
    CHECK_NEAR(a.state.pitch, b.state.pitch, 1e-9);
    CHECK_NEAR(a.controls.lat_stick, -b.controls.lat_stick, 1e-8);
    CHECK_NEAR(a.controls.pedal, -b.controls.pedal, 1e-8);
    CHECK_NEAR(a.state.rotor[right].ns, b.state.rotor[left].ns, 1e-9);
    CHECK_LT(std::abs(b.controls.lat_stick) * 0 + 1e-6, std::abs(a.state.roll));
  }
}

// In hover direction means nothing: every climb and sideslip angle gives the same trim.
TEST(trim_hover_has_no_direction) {
  const Configuration<double> c = configuration(0);
  const TrimResult<double> a = trimmed(c, level(0));
  const TrimResult<double> b = trimmed(c, {0, 20 * kDeg, 0, 30 * kDeg});
  CHECK_NEAR(a.state.pitch, b.state.pitch, 1e-9);
  CHECK_NEAR(a.controls.collective, b.controls.collective, 1e-9);
  CHECK_NEAR(b.state.velocity.y, 0, 0);
}

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

namespace {
std::string explanation(const TrimResult<double>& r) {
  char text[200];
  const int length = explain(r, text, 200);
  CHECK_EQ(static_cast<std::size_t>(length), std::strlen(text));
  return text;
}
bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }
}  // namespace

// Lower ends of the conversion corridor and the end of helicopter mode: computed with another
// program.
TEST(trim_tells_why_there_is_none) {
  const TrimResult<double> stalled = trimmed(configuration(30), level(24));
  CHECK(stalled.status == TrimStatus::wing_stall);
  CHECK(stalled.limit == TrimLimit::wing_angle);
  CHECK(contains(explanation(stalled), "wing angle of attack"));
  CHECK(trimmed(configuration(30), level(27)).status == TrimStatus::ok);

  const TrimResult<double> slow = trimmed(configuration(90), level(45));
  CHECK(slow.status == TrimStatus::not_converged);
  CHECK_LT(1e-3, slow.residual);
  CHECK(contains(explanation(slow), "left in the rate of"));
  CHECK(contains(explanation(slow), "wing angle of attack"));

  const TrimResult<double> stalls = trimmed(configuration(0), level(60));
  CHECK(stalls.status == TrimStatus::rotor_stall);
  CHECK(contains(explanation(stalls), "before its rotors stall"));

  const TrimResult<double> fast = trimmed(configuration(0), level(75));
  CHECK(fast.status == TrimStatus::not_converged);
  CHECK(contains(explanation(fast), "no trim found"));

  CHECK_EQ(slow.weight_carried, 1.0);
  CHECK_EQ(fast.weight_carried, 1.0);

  const TrimResult<double> sideways = trimmed(configuration(0), {40, 0, 0, 20 * kDeg});
  CHECK(sideways.status == TrimStatus::control_limit);
  CHECK(sideways.limit == TrimLimit::pedal);
  CHECK_LT(2.5, std::abs(sideways.limit_value));
  CHECK_NEAR(std::abs(sideways.limit_bound), 2.5, 1e-12);
  CHECK(contains(explanation(sideways), "pedal"));

  CHECK(explanation(trimmed(configuration(0), level(20))) == "trimmed in 4 Newton steps");
  char tiny[8];
  CHECK_EQ(explain(fast, tiny, 8), 7);
  CHECK_EQ(std::strlen(tiny), 7u);
  CHECK_EQ(explain(fast, tiny, 0), 0);
}

namespace {
// In thin air, on the real-time grid.
Configuration<double> high_up(double altitude_m, double mass_kg = 5896.7) {
  FlightSetup<double> setup = flight_setup(aircraft_data<double>(), 0.0);
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
TEST(trim_tells_what_rotors_carry_before_they_stall) {
  for (double speed : {6.0, 8.0}) {
    const TrimResult<double> r = trimmed(high_up(3000), level(speed));
    CHECK(r.status == TrimStatus::rotor_stall);
    CHECK_LT(r.weight_carried, 1);
    CHECK_LT(0.99, r.weight_carried);
    CHECK(contains(explanation(r), "no trim: the aircraft carries at most 99."));
    const double carried = r.weight_carried * 5896.7;
    CHECK(trimmed(high_up(3000, 0.9999 * carried), level(speed)).status == TrimStatus::ok);
    const TrimResult<double> heavy = trimmed(high_up(3000, 1.0001 * carried), level(speed));
    CHECK(heavy.status == TrimStatus::rotor_stall);
    CHECK_NEAR(heavy.weight_carried, 1 / 1.0001, 1e-5);
  }
}

// Newton from anywhere finds no other trim but with blades like flat plates, at two to three times the power
// of both engines (2 x 1156 kW); with 1 % less mass it finds the one short of stall.
TEST(trim_beyond_stalled_rotors_has_no_use) {
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
        rotor.n0 = between(0.02, 0.12);
        rotor.nc = between(-0.02, 0.05);
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
    const Configuration<double> c = configuration(0);
    const TrimResult<double> cold = trimmed(c, level(speed));
    int iterations = 0;
    double carried = 0;
    trim_equations(c, work.equations);
    CHECK(trim_detail::from_less_weight(c, level(speed), work, iterations, carried).status == TrimStatus::ok);
    State<double> x;
    Controls<double> u;
    trim_detail::unpack_unknowns(level(speed), work, x, u);
    CHECK_NEAR(u.collective, cold.controls.collective, 1e-8);
    CHECK_NEAR(u.long_stick, cold.controls.long_stick, 1e-7);
    CHECK_NEAR(x.pitch, cold.state.pitch, 1e-8);
  }
}

// Whatever it finds, the equations are those of the whole weight again.
TEST(trim_over_less_weight_leaves_the_equations) {
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
    CHECK(trim_detail::from_less_weight(c, level(k.speed), work, iterations, carried).status == k.status);
    CHECK_EQ(carried < 1, k.status == TrimStatus::rotor_stall);
    CHECK(!work.equations.relieved);
    CHECK_EQ(work.equations.carried, 1.0);
    CHECK_EQ(work.equations.row[kCollectiveRow].control, whole.row[kCollectiveRow].control);
    CHECK_EQ(work.equations.row[kCollectiveRow].step_limit, whole.row[kCollectiveRow].step_limit);
    CHECK_EQ(trimmed(c, level(k.speed)).weight_carried, carried);
  }
}

// The same top of the lift in single precision and by numerical differences.
TEST(trim_of_stalled_rotors_in_every_build) {
  const Configuration<double> c = high_up(3500);
  const double carried = trimmed(c, level(6)).weight_carried;
  static TrimWorkspace<double, NumDiff> numerical;
  TrimResult<double> r;
  CHECK(trim(c, level(6), numerical, r) == TrimStatus::rotor_stall);
  CHECK_NEAR(r.weight_carried, carried, 1e-6);

  FlightSetup<float> setup = flight_setup(aircraft_data<float>(), 0.0F);
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
  static ModelRoom<double> room;
  for (double& x : room.x) x = 0;
  relieve_weight(roll, pitch, part, room);
  const Vector level_axes = to_earth({room.x[ix_u], room.x[ix_v], room.x[ix_w]}, roll, pitch);
  CHECK_NEAR(level_axes.x, 0, 1e-15);
  CHECK_NEAR(level_axes.y, 0, 1e-15);
  CHECK_NEAR(level_axes.z, -part * 9.80665, 1e-15);
  CHECK_EQ(room.x[ix_q], 0);
}

TEST(trim_refuses_bad_input) {
  const Configuration<double> c = configuration(0);
  const double nan = std::nan("");
  struct Case {
    SteadyFlight<double> flight;
    SteadyFlightField field;
  };
  const Case cases[] = {{{nan, 0, 0, 0}, SteadyFlightField::speed},
                        {{-1, 0, 0, 0}, SteadyFlightField::speed},
                        {{151, 0, 0, 0}, SteadyFlightField::speed},
                        {{std::numeric_limits<double>::infinity(), 0, 0, 0}, SteadyFlightField::speed},
                        {{10, 1.1, 0, 0}, SteadyFlightField::climb},
                        {{10, nan, 0, 0}, SteadyFlightField::climb},
                        {{10, 0, 1.1, 0}, SteadyFlightField::turn_rate},
                        {{10, 0, 0, -1.1}, SteadyFlightField::sideslip}};
  for (const Case& k : cases) {
    const TrimResult<double> r = trimmed(c, k.flight);
    CHECK(r.status == TrimStatus::out_of_range);
    CHECK(r.invalid == k.field);
    CHECK_EQ(r.iterations, 0);
    CHECK_EQ(r.state.pitch, 0.0);
    CHECK(contains(explanation(r), "bad input"));
  }
  TrimOptions options;
  for (const int bad : {0, kMaxTrimIterations + 1}) {
    options.max_iterations = bad;
    CHECK(trimmed(c, level(10), options).status == TrimStatus::out_of_range);
    CHECK(explanation(trimmed(c, level(10), options)) == "bad input: configuration or options");
  }
  const Configuration<double> unprepared{};
  CHECK(trimmed(unprepared, level(10)).status == TrimStatus::out_of_range);
}

// The set of unknowns follows the options; whatever it is, every active state must stand still.
TEST(trim_under_every_set_of_states) {
  for (int k = 0; k < 16; ++k) {
    Options options;
    options.flapping = (k & 1) != 0 ? FlapOrder::first : FlapOrder::second;
    options.inflow = (k & 2) != 0 ? InflowShape::uniform : InflowShape::pitt_peters;
    options.coning_states = (k & 4) != 0;
    options.downwash_lag = (k & 8) == 0;
    const Configuration<double> c = configuration(30, options);
    const SteadyFlight<double> flight{45, 3 * kDeg, 5 * kDeg, 0};
    const TrimResult<double> r = trimmed(c, flight);
    if (!CHECK(r.status == TrimStatus::ok)) NOTE("set " << k);
    State<double> rates;
    derivative(c, r.state, r.controls, rates);
    double flat[state_count];
    pack(rates, flat);
    const ActiveStates active = active_states(options, false);
    const double omega = c.setup.rotor_speed;
    for (int i = 0; i < active.count; ++i) CHECK_NEAR(flat[active.index[i]], 0, 1e-9 * omega * omega);
  }
}

// Each limit alone, a tenth beyond on either side and just within.
TEST(trim_limits_are_found_one_by_one) {
  const Configuration<double> c = configuration(0);
  const ControlTables<double>& t = c.aircraft->controls;
  struct Case {
    TrimLimit limit;
    double bound;
    double Controls<double>::*control;
    double BladeControls<double>::*surface;
  };
  using U = Controls<double>;
  using S = BladeControls<double>;
  const Case cases[] = {{TrimLimit::long_stick, t.long_travel, &U::long_stick, nullptr},
                        {TrimLimit::lat_stick, t.lat_travel, &U::lat_stick, nullptr},
                        {TrimLimit::pedal, t.pedal_travel, &U::pedal, nullptr},
                        {TrimLimit::elevator, t.elevator_limit, nullptr, &S::elevator},
                        {TrimLimit::aileron, t.aileron_limit, nullptr, &S::aileron},
                        {TrimLimit::rudder, t.rudder_limit, nullptr, &S::rudder}};
  for (const Case& k : cases) {
    for (const double part : {-1.1, -1.0, 1.0, 1.1}) {
      Controls<double> u{};
      BladeControls<double> surfaces{};
      (k.control != nullptr ? u.*k.control : surfaces.*k.surface) = part * k.bound;
      const LimitCheck<double> check = check_limits(c, 0.0, 0.0, State<double>{}, u, surfaces);
      const bool beyond = std::abs(part) > 1;
      CHECK(check.limit == (beyond ? k.limit : TrimLimit::none));
      CHECK(check.status == (beyond ? TrimStatus::control_limit : TrimStatus::ok));
      CHECK_EQ(check.value, beyond ? part * k.bound : 0.0);
      CHECK_EQ(check.bound, beyond ? std::copysign(k.bound, part) : 0.0);
    }
  }
  for (const int side : {right, left}) {
    State<double> x{};
    x.rotor[side].b1c = -0.8 * t.flap_limit;
    CHECK(check_limits(c, 0.0, 0.0, x, {}, {}).status == TrimStatus::ok);
    x.rotor[side].b1s = 0.8 * t.flap_limit;
    const LimitCheck<double> check = check_limits(c, 0.0, 0.0, x, {}, {});
    CHECK(check.status == TrimStatus::flap_limit && is_trimmed(check.status));
    CHECK(check.limit == (side == right ? TrimLimit::gimbal_right : TrimLimit::gimbal_left));
    CHECK_NEAR(check.value, std::sqrt(1.28) * t.flap_limit, 1e-15);
  }
}

TEST(trim_explanations_of_every_outcome) {
  TrimResult<double> r{};
  r.status = TrimStatus::not_finite;
  r.residual_state = ix_w;
  CHECK(explanation(r) == "the rate of w is not a number at the first guess");
  r.status = TrimStatus::singular;
  r.iterations = 12;
  const std::string begin = "no trim found in 12 Newton steps: scaled residual ";
  const auto residual = [&](double value, const char* words) {
    r.residual = value;
    if (!CHECK(explanation(r) == begin + words + " left in the rate of w")) NOTE(explanation(r));
  };
  residual(0, "0");
  residual(7654, "7e3");
  residual(2.5e-4, "2e-4");
  residual(HUGE_VAL, "no number");
  residual(std::nan(""), "no number");
  residual(-1, "no number");
  residual(std::numeric_limits<double>::denorm_min(), "4e-324");
  r.status = TrimStatus::flap_limit;
  const auto limit = [&](TrimLimit which, double value, double bound, const std::string& words) {
    r.limit = which;
    r.limit_value = value;
    r.limit_bound = bound;
    if (!CHECK(explanation(r) == "trimmed, but " + words)) NOTE(explanation(r));
  };
  limit(TrimLimit::gimbal_left, 12.345 * kDeg, 12 * kDeg, "left gimbal tilt 12.35 deg is beyond 12.00 deg");
  limit(TrimLimit::lat_stick, -4.904, -4.8, "lateral stick -4.90 in is beyond -4.80 in");
  limit(TrimLimit::pedal, -0.001, std::nan(""), "pedal 0.00 in is beyond no number in");
  limit(TrimLimit::pedal, -1e9, HUGE_VAL, "pedal very large in is beyond very large in");
  r.status = TrimStatus::count;
  CHECK(explanation(r) == "bad input: configuration or options");
  CHECK(std::string(trim_status_word(TrimStatus::count)) == "unknown");
  r.status = static_cast<TrimStatus>(250);
  CHECK(explanation(r).empty());
}

// A first guess that is no number is refused with the rate it spoils, and leaves no NaN behind.
TEST(trim_from_a_guess_that_is_no_number) {
  static TrimWorkspace<double> work;
  const Configuration<double> c = configuration(0);
  TrimResult<double> r = trimmed(c, level(20));
  r.state.pitch = std::nan("");
  CHECK(trim_from(c, level(20), work, r) == TrimStatus::not_finite);
  CHECK(contains(explanation(r), "is not a number at the first guess"));
  CHECK_EQ(r.iterations, 0);
  double x[state_count];
  pack(r.state, x);
  for (const double value : x) CHECK(std::isfinite(value));
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
      if (equations.row[j].state == ix_rotor_right + 4) n0[right] = z[j];
      if (equations.row[j].state == ix_rotor_left + 4) n0[left] = z[j];
      if (equations.row[j].state == ix_roll) bank = z[j];
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
    if (equations.row[j].state == ix_rotor_right + 4) CHECK_NEAR(z[j], 0, 0.01);
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
  static void jacobian(Function&& f, int n, int m, const R* x, const R*, R* y,
                       Workspace<R, N, MaxInputs, MaxOutputs>&, Put&& put) {
    f(x, y);
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < n; ++j) put(i, j, i == j ? slope : j == i + 1 ? 1 : 0);
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

// The largest residual of those there are, whatever stands behind them; a NaN is larger than any.
TEST(trim_largest_residual_and_its_place) {
  const double nan = std::nan("");
  const double residual[] = {1e-3, -7, 2, 1e-12, nan, 1e-11, 100};
  const auto at = [&](int first, int n) { return trim_detail::largest(residual + first, n); };
  CHECK(at(0, 3).residual == 7 && at(0, 3).worst == 1 && at(0, 3).status == TrimStatus::not_converged);
  CHECK(at(0, 4).residual == 7 && at(0, 1).residual == 1e-3);
  CHECK(at(3, 1).residual == 1e-12 && at(3, 1).status == TrimStatus::ok);
  CHECK(at(5, 1).residual == 1e-11 && at(5, 1).status == TrimStatus::ok);
  CHECK(std::isinf(at(0, 5).residual) && at(0, 5).worst == 4 && at(0, 5).status == TrimStatus::not_finite);
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
      const trim_detail::NewtonOutcome<double> solved{TrimStatus::ok, 1e-12, 0};
      const TrimStatus status = trim_detail::finish(c, level(80), solved, work, r);
      CHECK_EQ(is_trimmed(status), std::cos(roll) > 0 && std::cos(pitch) > 0);
      const trim_detail::NewtonOutcome<double> unsolved{TrimStatus::singular, 1, 0};
      CHECK(trim_detail::finish(c, level(80), unsolved, work, r) == TrimStatus::singular);
    }
  }
}

// Flights that the first guess does not lead to, but an approach: from level flight, from a slower one, from
// a faster one. Whatever the way, the model stands still there.
TEST(trim_is_found_from_level_flight_and_other_speeds) {
  struct Case {
    double mast_deg, speed, climb_deg, turn_deg, sideslip_deg;
  };
  const Case cases[] = {{30, 87, -22, -2, 0}, {45, 48, 19, 0, 22}, {45, 37, -2, -22, 0}};
  bool used[6] = {};
  for (const Case& k : cases) {
    const Configuration<double> c = configuration(k.mast_deg);
    const SteadyFlight<double> flight{k.speed, k.climb_deg * kDeg, k.turn_deg * kDeg, k.sideslip_deg * kDeg};
    const TrimResult<double> r = trimmed(c, flight);
    if (!CHECK(is_trimmed(r.status))) NOTE("mast " << k.mast_deg << ", " << k.speed << " m/s");
    used[r.attempts] = true;
    State<double> rates;
    derivative(c, r.state, r.controls, rates);
    for (double x : {rates.velocity.x, rates.velocity.y, rates.velocity.z, rates.rates.x, rates.rates.y,
                     rates.rates.z, rates.roll, rates.pitch})
      CHECK_NEAR(x, 0, 1e-8);
    CHECK_NEAR(rates.yaw, flight.turn_rate, 1e-12);
    const Vec3<double>& v = r.state.velocity;
    CHECK_NEAR(std::sqrt(dot(v, v)), k.speed, 1e-9);
  }
  CHECK(used[2] && used[3] && used[4]);
}

// Download: force of the wakes on the wing against the rotors' thrust. In a glide the rotors hardly pull;
// then it is taken over a tenth of the weight.
TEST(trim_download_over_the_thrust) {
  struct Case {
    double mast_deg, speed, climb_deg;
    bool pulls;
  };
  for (const Case& k :
       {Case{0, 0, 0, true}, Case{0, 20, 0, true}, Case{90, 90, 0, true}, Case{90, 90, -6, false}}) {
    const Configuration<double> c = configuration(k.mast_deg);
    const TrimResult<double> r = trimmed(c, {k.speed, k.climb_deg * kDeg, 0, 0});
    CHECK(is_trimmed(r.status));
    Evaluation<double> e;
    evaluate(c, r.state, r.controls, e);
    const double tenth = 0.1 * c.mass.mass * 9.80665;
    const double thrust = r.thrust[right] + r.thrust[left];
    CHECK_EQ(thrust > tenth, k.pulls);
    // Symmetric flight: twice that of the right half, along the shaft, which leans forward by the mast angle.
    const Vec3<double>& f = e.loads.component[wing_wake_right].force;
    const double cant = c.hub[right].thrust_axis.y;
    const double along = std::sqrt(1 - cant * cant);
    const double against = -2 * (along * (std::sin(c.mast) * f.x - std::cos(c.mast) * f.z) + cant * f.y);
    CHECK_NEAR(r.download_fraction, std::fmax(against, 0) / std::fmax(thrust, tenth), 1e-9);
    NOTE("mast " << k.mast_deg << ", " << k.speed << " m/s: " << r.download_fraction);
  }
}

// Where there is no trim, each way to approach one is tried: from level flight where the flight is not, from
// a speed below and above, and from less weight.
TEST(trim_tries_every_approach) {
  const Configuration<double> c = configuration(0);
  CHECK_EQ(trimmed(c, level(140)).attempts, 4);
  CHECK_EQ(trimmed(c, {140, 0, 0.1, 0}).attempts, 5);
  CHECK_EQ(trimmed(c, {140, 0, 0, 0.1}).attempts, 5);
  CHECK_EQ(trimmed(c, {140, 0.1, 0, 0}).attempts, 5);
}
