// Trim: against a second implementation, and against Newton's laws written down independently in earth axes.
#include <algorithm>

#include "analysis_case.hpp"

using namespace analysis_case;

// tests/reference: outputs of a second implementation of the same equations in another language.
TEST_OF_XV15(trim_reference_grid) {
  const check::CsvFile grid("tests/reference/trim_grid_c1.csv");
  double worst_angle = 0, worst_inch = 0, worst_inflow = 0, worst_ratio = 0;
  int worst_iterations = 0;
  for (int row = 0; row < grid.rows(); ++row) {
    const Configuration<double> c = reference_configuration(grid.number(row, "mast_deg"));
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
      const double difference[] = {rotor.lambda_0 - grid.number(row, "n0"),
                                   rotor.lambda_c - grid.number(row, "nc"),
                                   rotor.lambda_s - grid.number(row, "ns")};
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
TEST_OF_XV15(trim_published_conditions_from_cold_start) {
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
    const Configuration<double> c = flown_configuration(k.mast_deg);
    const SteadyFlight<double> flight =
        flown({k.speed, k.climb_deg * kDeg, k.turn_deg * kDeg, k.sideslip_deg * kDeg});
    const TrimResult<double> r = trimmed(c, flight);
    if (!CHECK(is_trimmed(r.status))) {
      NOTE("mast " << k.mast_deg << ", " << k.speed << " m/s, " << k.climb_deg << " " << k.turn_deg);
      continue;
    }
    CHECK_EQ(r.attempts, 1);
    CHECK_LE(r.iterations, 12);
    Evaluation<double> e;
    evaluate_aircraft(c, r.state, r.controls, e);
    Vec3<double> force{0, 0, 0};
    for (const Loads<double>& loads : e.loads.component) force = force + loads.force;
    const Vector f = to_earth(force, r.state.roll, r.state.pitch);
    const Vector v = to_earth(r.state.velocity, r.state.roll, r.state.pitch);
    const double m = c.mass.mass;
    const double weight = m * 9.80665;
    CHECK_NEAR(f.x / weight, -m * flight.turn_rate * v.y / weight, 1e-9);
    CHECK_NEAR(f.y / weight, m * flight.turn_rate * v.x / weight, 1e-9);
    CHECK_NEAR(f.z / weight, -1, 1e-9);
    CHECK_NEAR(std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z), flight.speed, 1e-12 * 150);
    CHECK_NEAR(-v.z, flight.speed * std::sin(flight.climb), 1e-11);
    CHECK_NEAR(r.state.velocity.y, flight.speed * std::sin(flight.sideslip), 1e-12);
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
      CHECK_NEAR(rotor.lambda_0, 0, 1e-8);
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
  CHECK_LT(r.state.rotor[left].lambda_0 - r.state.rotor[right].lambda_0, 1e-2);
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
    CHECK_NEAR(a.state.rotor[right].lambda_s, b.state.rotor[left].lambda_s, 1e-9);
    // A turn with sideslip: no zeros were compared.
    CHECK_LT(1 * kDeg, std::abs(a.state.roll));
    CHECK_LT(1e-2, std::abs(a.controls.lat_stick));
    CHECK_LT(1e-2, std::abs(a.controls.pedal));
  }
}

// The set of unknowns follows the options; whatever it is, every active state must stand still.
TEST(trim_under_every_set_of_states) {
  int most = 0;
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
    flatten(rates, flat);
    const ActiveStates active = active_states(options, false);
    const double omega = c.setup.rotor_speed;
    for (int i = 0; i < active.count; ++i)
      if (!CHECK_NEAR(flat[active.index[i]], 0, 1e-9 * omega * omega))
        NOTE("set " << k << ": " << kStateVariables[active.index[i]].name << " moves");
    TrimEquations<double> equations;
    trim_equations(c, equations);
    most = std::max(most, equations.count);
  }
  CHECK_EQ(most, kMaxTrimUnknowns);  // the room they have is what they need at most
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
    const Configuration<double> c = flown_configuration(k.mast_deg);
    const TrimResult<double> r = trimmed(c, flown({k.speed, k.climb_deg * kDeg, 0, 0}));
    CHECK(is_trimmed(r.status));
    Evaluation<double> e;
    evaluate_aircraft(c, r.state, r.controls, e);
    const double tenth = 0.1 * c.mass.mass * 9.80665;
    const double thrust = r.thrust[right] + r.thrust[left];
    CHECK_EQ(thrust > tenth, k.pulls);
    // Symmetric flight: twice that of the right half, along the shaft, which leans forward by the mast angle.
    const Vec3<double>& f = e.loads[Component::wing_wake_right].force;
    const double cant = c.hub[right].thrust_axis_b.y;
    const double along = std::sqrt(1 - cant * cant);
    const double against = -2 * (along * (std::sin(c.mast) * f.x - std::cos(c.mast) * f.z) + cant * f.y);
    CHECK_NEAR(r.download_fraction, std::fmax(against, 0) / std::fmax(thrust, tenth), 1e-9);
    NOTE("mast " << k.mast_deg << ", " << k.speed << " m/s: " << r.download_fraction);
  }
}
