// Wing, pylons and engine jets of the reference simulation in conversion and airplane mode: states and loads of
// ten level flights as printed (Kleinhesselink 2007, app. C, GTRS columns, there from NASA CR-166537), 13000 lb.
// Of the three flights at mast 15 the jets alone: their wing loads, with flap 40/25, are not those of the tables.
#include "printed_runs.hpp"
#include "tiltrotor/model/airframe/engine_jet.hpp"
#include "tiltrotor/model/airframe/pylon.hpp"
#include "tiltrotor/model/airframe/wing.hpp"

using namespace flight_cases;
using printed_runs::kFoot;
using printed_runs::kPound;

namespace {

constexpr double kNone = -1e9;  // not compared

struct Flight {
  double mast_deg, flap_deg, rotor_rpm;
  double u_fps, w_fps;    // body axes
  double inflow_ratio;    // whole flow through the disk over tip speed
  double rotor_force_lb;  // each
  double power_kw;        // of both rotors, from the printed torques
  double wing_x, wing_z;  // lb
  double rest_x, rest_z;  // pylons and jets, lb
};

constexpr Flight kFlights[] = {
    {15, 40, 589, 66.76, 10.06, .0525, 5722.74, 926, kNone, kNone, -90.71, -36.81},
    {15, 40, 589, 135, 1.54, .0611, 4522.93, 806, kNone, kNone, -307.17, -5.42},
    {15, 40, 589, 168.3, -12.92, .0872, 4631.46, 1050, kNone, kNone, -473.09, 32.62},
    {30, 20, 589, 133.1, 22.79, .0745, 3522.16, 738, -312.54, -5777.32, -299.48, -57.76},
    {30, 20, 589, 202.4, -6.78, .1486, 3687.94, 1218, -1992.2, -5794.07, -675.96, 17.01},
    {60, 20, 589, 166.5, 27.4, .1749, 1765.38, 768, 237.345, -9374.36, -437.472, -79.899},
    {60, 20, 589, 236.3, -3.18, .2718, 1992.96, 1076, -1295.23, -9315.26, -884.853, 14.714},
    {60, 20, 589, 269.6, -14.8, .3169, 2328.71, 1344, -1726.65, -8983.6, -1155.18, 68.495},
    {90, 0, 517, 234.6, 28.57, .3484, 700.62, 622, 573.88, -11291.4, -86.48, -8.09},
    {90, 0, 517, 303.5, 14.12, .4500, 744.59, 845, -168.37, -11741.6, -153.76, -5.13},
    {90, 0, 517, 337.4, 8.90, .5002, 823.46, 1012, -405.25, -11977.4, -189.68, -3.59},
    {90, 0, 517, 405.1, .87, .6002, 1064.06, 1469, -768.06, -12490.1, -268.32, -.42},
    {90, 0, 517, 438.8, -2.03, .6502, 1251.59, 1805, -977.98, -12751.5, -309.36, 1.06}};

struct Replay {
  Configuration<double> c;
  Loads<double> wing, pylons, jets;
};

Replay replay(const Flight& f, const Options& options = linear_tables()) {
  FlightSetup<double> setup = flight_setup(aircraft(), f.mast_deg);
  setup.options = options;
  setup.flap_deg = f.flap_deg;
  setup.rotor_speed = f.rotor_rpm * kPi<double> / 30;
  Replay r{};
  CHECK(prepare(aircraft(), setup, r.c) == Status::ok);
  const double tip = r.c.tip_speed;
  const Vec3<double>& up = r.c.nacelle_axis_b;
  AirframeInput<double> in{};
  in.velocity_b = {f.u_fps * kFoot, 0, f.w_fps * kFoot};
  in.mean_wash[right] = in.mean_wash[left] = tip * f.inflow_ratio - dot(in.velocity_b, up);
  in.rotor_force =
      2 * f.rotor_force_lb * kPound / (r.c.air.density * kPi<double> * square(tip * 12.5 * kFoot));
  in.advance_ratio = std::fabs(in.velocity_b.z * up.x - in.velocity_b.x * up.z) / tip;
  const FreeStream<double> stream = free_stream(r.c, in.velocity_b);
  const WingInWake<double> wake[2] = {wing_in_wake(r.c, in, stream, right),
                                      wing_in_wake(r.c, in, stream, left)};
  r.wing = free_wing(r.c, in, stream, wake).loads + wake[right].loads + wake[left].loads;
  r.pylons = pylon_interference_loads(r.c, wake);
  r.jets = engine_jet_loads(r.c, 1e3 * f.power_kw, std::hypot(in.velocity_b.x, in.velocity_b.z));
  return r;
}

}  // namespace

// With the whole wing at the free wing's angle, CD between mast angles by cos^3 and no rotor-induced lift with flap
// 20/12.5: along the body within 3 lb of up to 1992 lb, across it within 0.6 percent. (Before: 25 to 114 lb and up to
// 14 percent.)
TEST_OF_XV15(wing_printed_loads_in_conversion_and_airplane_mode) {
  for (const Flight& f : kFlights) {
    if (f.wing_x == kNone) continue;
    const printed_runs::Printed wing = printed_runs::in_pounds(replay(f).wing);
    CHECK_NEAR(wing.x, f.wing_x, 3);
    CHECK_REL(wing.z, f.wing_z, 0.006);
  }
}

// In airplane mode a part of the wing at the angle of the rotors' wake, as geometry has it, is lost: 25 to 48 lb
// less drag along the body and 265 to 1450 lb more lift than printed.
TEST_OF_XV15(wing_immersed_in_airplane_mode_misses_the_printed_loads) {
  Options options = linear_tables();
  options.wake_fade_airplane = false;
  for (const Flight& f : kFlights) {
    if (f.mast_deg < 90) continue;
    const printed_runs::Printed wing = printed_runs::in_pounds(replay(f, options).wing);
    CHECK_LT(24.0, wing.x - f.wing_x);
    CHECK_LT(wing.x - f.wing_x, 49.0);
    CHECK_LT(250.0, f.wing_z - wing.z);
    CHECK_LT(f.wing_z - wing.z, 1460.0);
  }
}

// What pylon drag from the tables leaves of the printed force lies along the nacelles at every mast angle: less than
// 0.25 lb across them. No drag does that; a jet does. Backward in airplane mode, 19 to 79 lb.
TEST_OF_XV15(engine_jets_printed_remainder_lies_along_the_nacelles) {
  for (const Flight& f : kFlights) {
    const Replay r = replay(f);
    const printed_runs::Printed pylons = printed_runs::in_pounds(r.pylons);
    const Vec3<double>& up = r.c.nacelle_axis_b;
    const double x = f.rest_x - pylons.x;
    const double z = f.rest_z - pylons.z;
    CHECK_NEAR(z * up.x - x * up.z, 0.0, 0.25);
    const double along_nacelle = x * up.x + z * up.z;
    if (f.mast_deg < 90) CHECK_LT(0.0, along_nacelle);
    if (f.mast_deg >= 90) {
      CHECK_LT(-79.0, along_nacelle);
      CHECK_LT(along_nacelle, -19.0);
    }
    // Four numbers, identified on these thirteen.
    CHECK_NEAR(printed_runs::in_pounds(r.jets).x, x, 3.1 * std::fabs(up.x) + 0.2);
    CHECK_NEAR(printed_runs::in_pounds(r.jets).z, z, 3.1 * std::fabs(up.z) + 0.2);
  }
}
