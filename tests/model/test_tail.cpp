// Horizontal tail and fins: printed loads, signs of elevator, rudder and sideslip, downwash, blends, tables
// at hand.
// Expected: printed runs (printed_runs.hpp), the tables read by eye, geometry of the stations.
#include "printed_runs.hpp"

using namespace flight_cases;
using namespace printed_runs;

namespace {

Loads<double> tail(const Configuration<double>& c, const AirframeInput<double>& in) {
  const FreeStream<double> stream = free_stream(c, in.velocity_b);
  return horizontal_tail_loads(c, in, stream, tail_flow(c, stream), in.downwash);
}
Loads<double> fin(const Configuration<double>& c, const AirframeInput<double>& in, int side) {
  const FreeStream<double> stream = free_stream(c, in.velocity_b);
  return fin_loads(c, in, stream, tail_flow(c, stream), fin_flow(c, in, stream), side);
}
AirframeInput<double> cruise(double u, double v, double w) {
  AirframeInput<double> in{};
  in.velocity_b = {u, v, w};
  return in;
}

}  // namespace

TEST_OF_XV15(tail_printed_loads) {
  for (const Point& p : kPoints) {
    Replay r = replay(p);
    const double downwash = free_wing(r.c, r.in, r.stream, r.wake).downwash;
    const Printed load =
        in_pounds(horizontal_tail_loads(r.c, r.in, r.stream, tail_flow(r.c, r.stream), downwash));
    const double size = std::hypot(p.horizontal_tail.x, p.horizontal_tail.z);
    CHECK_NEAR(load.x, p.horizontal_tail.x, 0.05 * size);
    CHECK_NEAR(load.z, p.horizontal_tail.z, 0.05 * size);
    CHECK_REL(load.m, p.horizontal_tail.m, 0.05);
    NOTE(p.speed_kt << " kt: Z " << load.z << " (" << p.horizontal_tail.z << "), M " << load.m << " ("
                    << p.horizontal_tail.m << ")");
    // Both fins: X printed as 2.227, -1.595, -8.512 lb (sidewash details of the source); nothing sideways in
    // the sum.
    const double fins_x = p.speed_kt < 50 ? 2.227 : p.speed_kt < 80 ? -1.595 : -8.512;
    const Loads<double> r_fin = fin(r.c, r.in, right);
    const Loads<double> l_fin = fin(r.c, r.in, left);
    CHECK_NEAR((r_fin.force.x + l_fin.force.x) / kPound, fins_x, 5.0);
    CHECK_NEAR(r_fin.force.y + l_fin.force.y, 0.0, 1e-9);
  }
}

TEST(tail_signs) {
  const Configuration<double> c = configuration(90);
  AirframeInput<double> in = cruise(90, 0, 2);
  const Loads<double> neutral = tail(c, in);
  in.elevator = 5 * kRadPerDeg<double>;  // trailing edge down: lift up, nose down
  const Loads<double> down = tail(c, in);
  CHECK_LT(down.force.z, neutral.force.z);
  CHECK_LT(down.moment.y, neutral.moment.y);
  in.elevator = 0;
  in.downwash = 0.05;  // downwash takes lift away
  CHECK_LT(neutral.force.z, tail(c, in).force.z);
  in.downwash = 0;
  in.rates_b.y = 0.1;  // nose-up rate: more lift at the tail, damping
  CHECK_LT(tail(c, in).moment.y, neutral.moment.y);
  in.rates_b.y = 0;
  in.velocity_b.z = 6;  // more angle of attack: nose down, a stabilising surface
  CHECK_LT(tail(c, in).moment.y, neutral.moment.y);
}

// Damping by the arm from the CG, which at the XV-15 is 258.8 in: the tail meets q times that as angle of attack.
TEST(tail_pitch_rate_is_an_angle) {
  const Configuration<double> c = configuration(90, linear_tables());
  const AirframeInput<double> level = cruise(90, 0, 2);
  AirframeInput<double> pitching = level;
  pitching.rates_b.y = 0.02;
  AirframeInput<double> deflected = level;
  const double arm = aircraft().htail.surface.sl - c.mass.sl_cg;
  deflected.downwash = -0.02 * arm / 90;  // the same angle by upwash
  const double by_rate = tail(c, pitching).force.z - tail(c, level).force.z;
  const double by_angle = tail(c, deflected).force.z - tail(c, level).force.z;
  CHECK_REL(by_rate, by_angle, 0.03);
}

TEST(tail_hover_is_inert) {
  const Configuration<double> c = configuration(0);
  AirframeInput<double> in{};
  in.mean_wash[right] = in.mean_wash[left] = 17;
  for (const double load : flat(tail(c, in))) CHECK_EQ(load, 0.0);
}

TEST(tail_fins_sideslip_and_rudder) {
  const Configuration<double> c = configuration(90);
  AirframeInput<double> in = cruise(90, 4, 2);
  const Loads<double> slip = fin(c, in, right) + fin(c, in, left);
  CHECK_LT(slip.force.y, 0.0);   // wind from the right pushes to the left
  CHECK_LT(0.0, slip.moment.z);  // nose into the wind
  CHECK_LT(slip.moment.x, 0.0);  // fins above the CG: rolls to the left
  in = cruise(90, 0, 2);
  in.rudder = 5 * kRadPerDeg<double>;
  const Loads<double> rudder = fin(c, in, right) + fin(c, in, left);
  CHECK_LT(0.0, rudder.moment.z);  // right pedal, nose right
  CHECK_LT(rudder.force.y, 0.0);
  in.rudder = 0;
  in.rates_b.z = 0.1;
  CHECK_LT((fin(c, in, right) + fin(c, in, left)).moment.z, 0.0);  // yaw damping
  // Exchanged sides.
  AirframeInput<double> a = cruise(80, 5, 3);
  a.rates_b = {0.1, 0.05, -0.1};
  a.rudder = 0.1;
  a.mean_wash[right] = 3;
  a.mean_wash[left] = 5;
  AirframeInput<double> b = cruise(80, -5, 3);
  b.rates_b = {-0.1, 0.05, 0.1};
  b.rudder = -0.1;
  b.mean_wash[right] = 5;
  b.mean_wash[left] = 3;
  const Loads<double> r = fin(c, a, right);
  const Loads<double> l = fin(c, b, left);
  CHECK_NEAR(l.force.y, -r.force.y, 1e-9);
  CHECK_NEAR(l.force.x, r.force.x, 1e-9);
  CHECK_NEAR(l.moment.z, -r.moment.z, 1e-8);
  CHECK_NEAR(l.moment.x, -r.moment.x, 1e-8);
}

// K = X_K(M) - 0.24 max(|delta| - 15 deg, 0)/15 deg; X_K is 1 at low Mach number (table 5-IV).
TEST(tail_control_effectiveness) {
  const Configuration<double> c = configuration(0);
  const TailSurface<double>& surface = c.aircraft->htail.surface;
  const double full = control_effectiveness(c, surface, 0.05, 0.0);
  CHECK_NEAR(control_effectiveness(c, surface, 0.05, 10 * kRadPerDeg<double>), full, 1e-3);
  CHECK_NEAR(control_effectiveness(c, surface, 0.05, 30 * kRadPerDeg<double>), full - 0.24, 0.01);
  CHECK_EQ(control_effectiveness(c, surface, 0.05, -20 * kRadPerDeg<double>),
           control_effectiveness(c, surface, 0.05, 20 * kRadPerDeg<double>));
}

TEST(tail_mach_blend) {
  const Configuration<double> c = configuration(0);
  CHECK_EQ(tail_mach_weight(c, 0.18), 0.0);
  CHECK_NEAR(tail_mach_weight(c, 0.20), 0.5, 1e-12);
  CHECK_EQ(tail_mach_weight(c, 0.22), 1.0);
}

// Between the wakes the tail meets upwash: K_WH down to -1.13 near 80 kt, -12 deg (table 2-I); never clipped.
TEST_OF_XV15(tail_rotor_wash_can_be_upwash) {
  const Configuration<double> c = configuration(0);
  const double speed = 80 * 1852 / 3600.0;
  const double alpha = -12 * kRadPerDeg<double>;
  const FreeStream<double> stream =
      free_stream(c, Vec3<double>{speed * std::cos(alpha), 0, speed * std::sin(alpha)});
  CHECK_NEAR(tail_wash_ratio(c, stream), -1.13, 0.05);
  // The closed form at 100 kt and mast 0 is its first constant.
  Options options;
  options.tail_wash = TailWash::closed_form;
  const double fit_speed = 168.89 * kFoot;
  const Configuration<double> fit = configuration(0, options);
  CHECK_NEAR(tail_wash_ratio(fit, free_stream(fit, Vec3<double>{fit_speed, 0, 0})), -0.5838, 1e-4);
}
