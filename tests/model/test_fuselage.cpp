// Fuselage: printed loads, symmetry in sideslip, table values at chosen angles, moment transport to the CG.
#include "printed_runs.hpp"

using namespace flight_cases;
using namespace printed_runs;

namespace {

Loads<double> at(const Configuration<double>& c, const Vec3<double>& velocity) {
  AirframeInput<double> in{};
  in.velocity_b = velocity;
  return fuselage_loads(c, in, free_stream(c, velocity));
}

}  // namespace

TEST_OF_XV15(fuselage_printed_loads) {
  for (const Point& p : kPoints) {
    const Replay r = replay(p);
    const Printed load = in_pounds(fuselage_loads(r.c, r.in, r.stream));
    const double size = std::hypot(p.fuselage.x, p.fuselage.z);
    CHECK_NEAR(load.x, p.fuselage.x, 0.005 * size);
    CHECK_NEAR(load.z, p.fuselage.z, 0.005 * size);
    CHECK_REL(load.m, p.fuselage.m, 0.005);
  }
}

TEST(fuselage_is_symmetric_in_sideslip) {
  const Configuration<double> c = configuration(30);
  for (const double v : {0.5, 4.0, 20.0, 60.0}) {
    const Loads<double> r = at(c, {40, v, 3});
    const Loads<double> l = at(c, {40, -v, 3});
    const double scale = std::abs(r.moment.y) + std::abs(r.moment.z);
    CHECK_NEAR(l.force.x, r.force.x, 1e-12 * scale);
    CHECK_NEAR(l.force.y, -r.force.y, 1e-12 * scale);
    CHECK_NEAR(l.force.z, r.force.z, 1e-12 * scale);
    CHECK_NEAR(l.moment.x, -r.moment.x, 1e-12 * scale);
    CHECK_NEAR(l.moment.y, r.moment.y, 1e-12 * scale);
    CHECK_NEAR(l.moment.z, -r.moment.z, 1e-12 * scale);
    CHECK_LT(r.force.y, 0.0);   // pushed to the lee
    CHECK_LT(r.moment.z, 0.0);  // a body alone is unstable: the nose turns away from the wind
  }
}

// Twice the speed, four times the load; nothing at rest.
TEST(fuselage_scales_with_dynamic_pressure) {
  const Configuration<double> c = configuration(0);
  const Loads<double> slow = at(c, {30, 3, 2});
  const Loads<double> fast = at(c, {60, 6, 4});
  // The 0.05 m/s of the smoothed angle leaves less than 1e-3.
  CHECK_REL(fast.force.x, 4 * slow.force.x, 3e-3);
  CHECK_REL(fast.force.y, 4 * slow.force.y, 3e-3);
  CHECK_REL(fast.moment.z, 4 * slow.moment.z, 3e-3);
  const Loads<double> still = at(c, {0, 0, 0});
  for (const double load : flat(still)) CHECK_EQ(load, 0.0);
}

// The same force at two centres of gravity: moments differ by the shift cross the force.
TEST(fuselage_moment_about_the_cg) {
  FlightSetup<double> setup = flight_setup(aircraft(), 0.0);
  Configuration<double> aft;
  Configuration<double> forward;
  CHECK(prepare(aircraft(), setup, aft) == Status::ok);
  setup.sl_cg -= 0.2;
  setup.wl_cg += 0.1;
  CHECK(prepare(aircraft(), setup, forward) == Status::ok);
  const Vec3<double> v{40, 5, 4};
  const Loads<double> a = at(aft, v);
  const Loads<double> b = at(forward, v);
  // The CG moved 0.2 m forward and 0.1 m up: the force acts 0.2 m further aft and 0.1 m lower.
  const Vec3<double> shift{-0.2, 0, 0.1};
  const Vec3<double> change = cross(shift, a.force);
  CHECK_NEAR(b.moment.x - a.moment.x, change.x, 1e-9);
  CHECK_NEAR(b.moment.y - a.moment.y, change.y, 1e-9);
  CHECK_NEAR(b.moment.z - a.moment.z, change.z, 1e-9);
}
