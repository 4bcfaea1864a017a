// Spinners, pylon interference and side plates: printed loads, drag areas in pure axial and pure cross flow.
#include "printed_runs.hpp"

using namespace flight_cases;
using namespace printed_runs;

TEST_OF_XV15(pylon_printed_loads) {
  for (const Point& p : kPoints) {
    const Replay r = replay(p);
    const Printed pylons = in_pounds(pylon_interference_loads(r.c, r.wake));
    CHECK_REL(pylons.x, p.pylons.x, 0.005);
    CHECK_REL(pylons.z, p.pylons.z, 0.005);
    CHECK_REL(pylons.m, p.pylons.m, 0.005);
    const Printed spin = in_pounds(spinner_loads(r.c, r.in));
    CHECK_REL(spin.x, p.spinners.x, 0.005);
    CHECK_REL(spin.z, p.spinners.z, 0.005);
    CHECK_REL(spin.m, p.spinners.m, 0.005);
  }
}

// Both spinners: 2 x 1.0 ft2 along the mast, 2 x 6.5 ft2 across it; at hub height.
TEST_OF_XV15(pylon_spinner_drag_areas) {
  const double square_foot = kFoot * kFoot;
  AirframeInput<double> in{};
  in.velocity_b = {50, 0, 0};
  const double q = 0.5 * 1.225 * 2500;
  const Configuration<double> airplane = configuration(90);
  const Configuration<double> helicopter = configuration(0);
  const Loads<double> along_mast = spinner_loads(airplane, in);
  const Loads<double> across = spinner_loads(helicopter, in);
  CHECK_REL(along_mast.force.x, -q * 2 * square_foot, 1e-4);
  CHECK_REL(across.force.x, -q * 13 * square_foot, 1e-4);
  CHECK_NEAR(across.force.z, 0.0, 1e-9);
  // Waterline of the hubs 156 in against 81.65 in of the CG: drag up there raises the nose.
  CHECK_REL(across.moment.y, -across.force.x * (156.004 - 81.65) * kFoot / 12, 3e-4);
  // 45 deg: sin^3.
  in.velocity_b = {50, 0, 50};
  const double tilted =
      std::hypot(spinner_loads(helicopter, in).force.x, spinner_loads(helicopter, in).force.z);
  CHECK_REL(tilted, 2 * q * 2 * (1 + 5.5 * std::pow(0.5, 1.5)) * square_foot, 1e-3);
}

// Interference 13.5 ft2 at mast 0 (table 4-XV), plates of 24.05 ft2, wash on the wing 1.6 v0.
TEST_OF_XV15(pylon_printed_areas) {
  const PylonTables<double>& p = aircraft().pylon;
  CHECK_REL(lookup(p.interference, Interpolation::linear, 0.0), 13.5 * kFoot * kFoot, 1e-12);
  CHECK_REL(p.side_area, 24.05 * kFoot * kFoot, 1e-12);
  CHECK_EQ(aircraft().wake.wash_factor, 1.6);
}

TEST(pylon_interference_in_hover) {
  const Configuration<double> c = configuration(0);
  AirframeInput<double> in{};
  in.mean_wash[right] = in.mean_wash[left] = 17;
  const FreeStream<double> stream = free_stream(c, in.velocity_b);
  const WingInWake<double> wake[2] = {wing_in_wake(c, in, stream, right), wing_in_wake(c, in, stream, left)};
  const Loads<double> loads = pylon_interference_loads(c, wake);
  // Their area in the wash on the wing, pushing down.
  const double v = aircraft().wake.wash_factor * 17;
  const double area = lookup(aircraft().pylon.interference, Interpolation::linear, 0.0);
  CHECK_REL(loads.force.z, 0.5 * 1.225 * v * v * area, 1e-4);
  CHECK_NEAR(loads.force.x, 0.0, 1e-9);
}

// Sideward flight: flat plates of twice the area times K_PLAT (table 4-XVI); against the motion, odd.
TEST(pylon_side_plates) {
  const Configuration<double> c = configuration(0, linear_tables());
  AirframeInput<double> in{};
  in.velocity_b = {0, 10, 0};
  const Loads<double> r = pylon_side_loads(c, in);
  in.velocity_b.y = -10;
  const Loads<double> l = pylon_side_loads(c, in);
  CHECK_EQ(l.force.y, -r.force.y);
  CHECK_LT(r.force.y, 0.0);
  CHECK_EQ(r.force.x, 0.0);
  CHECK_EQ(r.force.z, 0.0);
  // Incidence of the flow to the mast: atan(10/1) with the 1 m/s of the smoothed axial speed.
  const double k_plat = 1;  // from 45 to 90 deg
  CHECK_REL(r.force.y, -0.5 * 1.225 * 100 * 2 * aircraft().pylon.side_area * k_plat, 2e-3);
  in.velocity_b = {40, 0, 3};
  CHECK_EQ(pylon_side_loads(c, in).force.y, 0.0);
}
