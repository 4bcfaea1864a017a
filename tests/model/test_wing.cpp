// Free wing: printed loads, split of the area, mast blending of drag, aileron and rate terms, downwash.
// Expected: printed runs (printed_runs.hpp), the tables read by eye, closed forms of the blends.
#include "printed_runs.hpp"

using namespace flight_cases;
using namespace printed_runs;

namespace {

struct Flow {
  AirframeInput<double> in{};
  FreeWing<double> wing{};
  WingInWake<double> wake[2]{};
};

Flow flow(const Configuration<double>& c, const AirframeInput<double>& in) {
  Flow f;
  f.in = in;
  const FreeStream<double> stream = free_stream(c, in.velocity_b);
  for (const int side : {right, left}) f.wake[side] = wing_in_wake(c, in, stream, side);
  f.wing = free_wing(c, in, stream, f.wake);
  return f;
}

AirframeInput<double> cruise(double u, double w) {
  AirframeInput<double> in{};
  in.velocity_b = {u, 0, w};
  in.rotor_force = 0.005;
  in.advance_ratio = 0.1;
  return in;
}

}  // namespace

TEST_OF_XV15(wing_printed_loads) {
  for (const Point& p : kPoints) {
    const Replay r = replay(p);
    const FreeWing<double> wing = free_wing(r.c, r.in, r.stream, r.wake);
    const Printed load = in_pounds(wing.loads);
    CHECK_NEAR(load.x, p.free_wing.x, 10.0);
    CHECK_NEAR(load.z, p.free_wing.z, 10.0);
    CHECK_NEAR(load.m, p.free_wing.m, 45.0);
    NOTE(p.speed_kt << " kt: X " << load.x << " (" << p.free_wing.x << "), Z " << load.z << " ("
                    << p.free_wing.z << "), M " << load.m << " (" << p.free_wing.m << ")");
    // From 40 kt the printed immersed loads are zero.
    for (const int side : {right, left}) CHECK_NEAR(r.wake[side].immersed.area, 0.0, 1e-9);
  }
}

// Angle of the free stream behind the rotors, by hand: alpha_F - 0.26 X_RW C_RF / mu^2 at 100 kt (mu above
// its floor).
TEST(wing_rotor_induced_angle) {
  const Replay r = replay(kPoints[2]);
  const double alpha = std::atan2(-36.86, 164.7);
  const double floor = 0.5 * (0.2136 - 0.15 + std::hypot(0.2136 - 0.15, 0.02)) + 0.15;
  const double expected = alpha - 0.26 * 0.0806 * r.in.rotor_force / (floor * floor);
  CHECK_NEAR(free_wing(r.c, r.in, r.stream, r.wake).alpha, expected, 3e-4);  // 0.05 m/s of the smoothed angle
}

// The same coefficients serve both parts: wake area taken from the free wing, side by side, none lost.
TEST(wing_area_is_split) {
  Options options = linear_tables();
  options.wake_fade_airplane = false;
  const Configuration<double> c = configuration(90, options);
  AirframeInput<double> in = cruise(80, 4);
  const Flow none = flow(c, in);
  const double lift_all = none.wing.loads.force.z;
  // Remove the wake of one side by putting its area to zero: the free wing grows by that area.
  const FreeStream<double> stream = free_stream(c, in.velocity_b);
  Flow bare = none;
  bare.wake[right].immersed.area = bare.wake[left].immersed.area = 0;
  const Loads<double> whole = free_wing(c, in, stream, bare.wake).loads;
  const double covered = none.wake[right].immersed.area + none.wake[left].immersed.area;
  const double area = aircraft().wing.area;
  CHECK_LT(0.05 * area, covered);
  CHECK_REL(lift_all / whole.force.z, 1 - covered / area, 1e-12);
  // One side covered: the lift left on the other side rolls the aircraft towards the covered side.
  Flow one = bare;
  one.wake[right].immersed.area = 5;
  one.wake[right].immersed.lateral = 3;
  const Loads<double> half = free_wing(c, in, stream, one.wake).loads;
  const double per_area = whole.force.z / area;
  CHECK_REL(half.moment.x - whole.moment.x, -5 * 3 * per_area, 1e-9);
  CHECK_LT(0.0, half.moment.x - whole.moment.x);
}

TEST(wing_drag_between_mast_angles) {
  // Weight of the upright-pylon table: cross-flow law by hand, without the clip and norm widths.
  Options crossflow;
  crossflow.mast_drag = MastDrag::cross_flow;
  for (const double mast : {15.0, 45.0, 75.0}) {
    const Configuration<double> c = configuration(mast, crossflow);
    for (const double alpha_deg : {-12.0, 0.0, 9.0}) {
      const double a = alpha_deg * kRadPerDeg<double>;
      const double across = std::pow(std::sin((90 - mast + alpha_deg) * kRadPerDeg<double>), 3);
      const double along = std::pow(std::abs(std::sin(a)), 3);
      const double expected = (across - mast / 90 * along) / std::pow(std::cos(a), 3);
      CHECK_NEAR(upright_pylon_weight(c, a), expected, 0.02);
    }
  }
  CHECK_EQ(upright_pylon_weight(configuration(0), 0.1), 1.0);
  CHECK_EQ(upright_pylon_weight(configuration(90), 0.1), 0.0);
  Options options;
  options.mast_drag = MastDrag::linear;
  CHECK_NEAR(upright_pylon_weight(configuration(30, options), 0.1), 2.0 / 3, 1e-15);
  // A wing with upright pylons has more drag and never less.
  CHECK_LT(wing_coefficients(configuration(60), 0.05, 0.2).drag,
           wing_coefficients(configuration(15), 0.05, 0.2).drag);
}

TEST_OF_XV15(wing_flap_settings_blend) {
  const auto lift = [](double flap) {
    FlightSetup<double> setup = flight_setup(aircraft(), 0.0);
    setup.flap_deg = flap;
    Configuration<double> c;
    CHECK(prepare(aircraft(), setup, c) == Status::ok);
    return wing_coefficients(c, 0.05, 0.1);
  };
  CHECK_REL(lift(30).lift, 0.5 * (lift(20).lift + lift(40).lift), 1e-12);
  CHECK_REL(lift(30).drag, 0.5 * (lift(20).drag + lift(40).drag), 1e-12);
  CHECK_REL(lift(57.5).lift, 0.5 * (lift(40).lift + lift(75).lift), 1e-12);
  CHECK_LT(lift(0).lift, lift(20).lift);
  CHECK_LT(lift(20).drag, lift(40).drag);
  // Hover: flap 40/25 at -90 deg has a drag coefficient of 1.44.
  const Configuration<double> c = configuration(0);
  CHECK_NEAR(wing_coefficients(c, -kPi<double> / 2, 0.1).drag, 1.44, 0.005);
}

TEST_OF_XV15(wing_lateral_terms) {
  const Configuration<double> c = configuration(90);
  AirframeInput<double> in = cruise(80, 4);
  const Loads<double> level = flow(c, in).wing.loads;
  CHECK_NEAR(level.moment.x, 0.0, 1e-9);
  CHECK_NEAR(level.moment.z, 0.0, 1e-9);
  in.rates_b.x = 0.2;
  const Loads<double> rolling = flow(c, in).wing.loads;
  CHECK_LT(rolling.moment.x, -1000.0);  // damped
  // Roll damping by the printed derivative: Cl_p about -0.774, q S b^2/(2V) p.
  const double speed = std::sqrt(80 * 80 + 16 + 25.0);
  const double q = 0.5 * 1.225 * (80 * 80 + 16);
  const double span = 32.17 * kFoot;
  CHECK_REL(rolling.moment.x, q * 181 * kFoot * kFoot * span * span / (2 * speed) * -0.774 * 0.2, 0.12);
  in.rates_b.x = 0;
  in.rates_b.z = 0.2;
  CHECK_LT(0.0, flow(c, in).wing.loads.moment.x);  // nose right: the left wing is faster
  in.rates_b.z = 0;
  in.aileron = 0.1;
  const Loads<double> aileron = flow(c, in).wing.loads;
  CHECK_LT(1000.0, aileron.moment.x);  // rolls right
  in.aileron = -0.1;
  CHECK_NEAR(flow(c, in).wing.loads.moment.x, -aileron.moment.x, 1e-6 * aileron.moment.x);
  // Deflection costs lift on both signs.
  CHECK_NEAR(flow(c, in).wing.loads.force.z, aileron.force.z, 1e-6 * std::abs(aileron.force.z));
  // Effect of the aileron fades between 8 and 25 deg.
  CHECK_EQ(aileron_fade(c, 7.9 * kRadPerDeg<double>), 1.0);
  CHECK_EQ(aileron_fade(c, -7.9 * kRadPerDeg<double>), 1.0);
  CHECK_NEAR(aileron_fade(c, 16.5 * kRadPerDeg<double>), 0.5, 1e-12);
  CHECK_EQ(aileron_fade(c, 25.1 * kRadPerDeg<double>), 0.0);
  const Configuration<double> linear = configuration(90, linear_tables());
  CHECK_NEAR(aileron_fade(linear, -16.5 * kRadPerDeg<double>), 0.5, 1e-12);
}

// Downwash of the table over sqrt(1 - M^2), and its lag: eps' = (eps - eps_L) V / l_t.
TEST(wing_downwash_and_its_lag) {
  const Configuration<double> c = configuration(90);
  const double slow = flow(c, cruise(60, 3)).wing.downwash;
  CHECK(slow > 0.01 && slow < 0.2);
  StateAndControls<double> s{};
  s.x.velocity = {60, 0, 3};
  s.x.downwash = 0.02;
  s.u.collective = 0.38;
  Evaluation<double> out;
  evaluate_aircraft(c, s.x, s.u, out);
  const WingTables<double>& wing = aircraft().wing;
  const double speed = std::hypot(60, 3, wing.downwash_speed_floor);
  CHECK_REL(out.rates.downwash, (out.wing_downwash - 0.02) * speed / wing.downwash_arm, 1e-12);
}

namespace {

// Exactly the table of mast 0 there and exactly that of mast 90 there, at every angle of attack; in between
// cos^3 of the mast angle, also of the rule of the cubed sine at zero angle of attack.
template <class R>
void check_pylon_weight(R tolerance) {
  for (MastDrag drag : {MastDrag::cosine, MastDrag::cross_flow, MastDrag::linear}) {
    const bool linear = drag == MastDrag::linear;
    const auto at = [&](R mast_deg, R alpha) {
      FlightSetup<R> setup = flight_setup(aircraft_data<R>(), mast_deg);
      setup.options.mast_drag = drag;
      Configuration<R> c;
      CHECK(prepare(aircraft_data<R>(), setup, c) == Status::ok);
      const Dual<R, 1> weight = upright_pylon_weight(c, Dual<R, 1>::variable(alpha, 0));
      if (mast_deg == R(0) || mast_deg == R(90)) CHECK_EQ(weight.d.get(0), R(0));
      return weight.v;
    };
    for (R alpha : {R(-0.7), R(-0.1), R(0), R(0.013), R(0.3), R(1)}) {
      CHECK_EQ(at(R(0), alpha), R(1));
      CHECK_EQ(at(R(90), alpha), R(0));
    }
    for (R mast_deg : {R(15), R(45), R(70)}) {
      const R c = std::cos(mast_deg * kRadPerDeg<R>);
      CHECK_NEAR(at(mast_deg, R(0)), linear ? 1 - mast_deg / 90 : c * c * c, tolerance);
    }
  }
}

}  // namespace

TEST(wing_pylon_weight_is_exact_at_both_ends) {
  check_pylon_weight<double>(2e-4);  // smoothing of the absolute angles
  check_pylon_weight<float>(2e-4f);
}
