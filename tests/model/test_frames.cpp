// Frames of the tilting masts: hand-written rotations, hub positions from the stations of the drawings, the
// mirror between the two rotors, and the motion of the hub by finite differences of positions.
#include "flight_cases.hpp"

using namespace flight_cases;

namespace {

using V = Vec3<double>;
constexpr double kInch = 0.0254;

void check_vector(const V& actual, const V& expected, double tolerance) {
  CHECK_NEAR(actual.x, expected.x, tolerance);
  CHECK_NEAR(actual.y, expected.y, tolerance);
  CHECK_NEAR(actual.z, expected.z, tolerance);
}

/// Angles in rad, a mast of length 1.
HubFrame<double> hub(double mast, double cant, int side) {
  return hub_frame(sine_and_cosine(mast), sine_and_cosine(cant), side, V{0, 0, 0}, 1.0);
}

}  // namespace

TEST(frames_hub_axes_are_a_rotation) {
  for (const double mast : {0.0, 20.0, 45.0, 77.0, 90.0}) {
    for (const double cant_deg : {0.0, 1.0, 5.0}) {
      for (const int side : {right, left}) {
        const HubFrame<double> f = hub(mast * kRadPerDeg<double>, cant_deg * kRadPerDeg<double>, side);
        const Rotation<double>& r = f.from_body;
        for (const V& row : {r.row_x, r.row_y, r.row_z}) CHECK_NEAR(dot(row, row), 1.0, 1e-15);
        check_vector(cross(r.row_x, r.row_y), r.row_z, 1e-15);  // right-handed
        check_vector(r.row_z, -1.0 * f.thrust_axis_b, 0);
        check_vector(f.arm_b, f.thrust_axis_b, 1e-15);  // mast of length 1 from the pivot
      }
    }
  }
}

TEST(frames_helicopter_and_airplane_axes) {
  const HubFrame<double> up = hub(0.0, 0.0, right);
  check_vector(up.thrust_axis_b, V{0, 0, -1}, 0);
  check_vector(up.from_body.row_x, V{1, 0, 0}, 0);
  check_vector(up.from_body.row_y, V{0, 1, 0}, 0);
  const HubFrame<double> forward = hub(kPi<double> / 2, 0.0, right);
  check_vector(forward.thrust_axis_b, V{1, 0, 0}, 1e-15);
  check_vector(forward.from_body.row_x, V{0, 0, 1}, 1e-15);  // hub x axis points down in airplane mode
  // Cant leans both rotors outboard.
  const double cant = 1 * kRadPerDeg<double>;
  CHECK_NEAR(hub(0.0, cant, right).thrust_axis_b.y, std::sin(cant), 1e-15);
  CHECK_NEAR(hub(0.0, cant, left).thrust_axis_b.y, -std::sin(cant), 1e-15);
}

// Hub stations of the aircraft without cant: SL 300 - 56 sin, WL 100 + 56 cos (mast 4.667 ft), BL 193 (in).
TEST_OF_XV15(frames_hub_stations) {
  Options options;
  options.mast_cant = false;
  for (const double mast : {0.0, 30.0, 90.0}) {
    const Configuration<double> c = configuration(mast, options);
    const double sine = std::sin(mast * kRadPerDeg<double>);
    const double cosine = std::cos(mast * kRadPerDeg<double>);
    for (const int side : {right, left}) {
      CHECK_NEAR((c.mass.sl_cg - c.hub[side].arm_b.x) / kInch, 300 - 56.004 * sine, 1e-9);
      CHECK_NEAR((c.mass.wl_cg - c.hub[side].arm_b.z) / kInch, 100 + 56.004 * cosine, 1e-9);
      CHECK_NEAR(c.hub[side].arm_b.y / kInch, side == right ? 193 : -193, 1e-9);
    }
  }
  // With 1 deg of cant at mast 0 the hubs stand 56 in x sin 1 deg further outboard, none at mast 90.
  CHECK_NEAR(configuration(0).hub[right].arm_b.y / kInch, 193 + 56.004 * std::sin(kRadPerDeg<double>), 1e-9);
  CHECK_NEAR(configuration(90).hub[left].arm_b.y / kInch, -193, 1e-9);
}

TEST(frames_mirror_of_the_rotor_frame) {
  const V a{1, 2, 3};
  check_vector(mirror_polar(a, right), V{-1, 2, -3}, 0);
  check_vector(mirror_polar(a, left), V{-1, -2, -3}, 0);
  check_vector(mirror_axial(a, right), V{-1, 2, -3}, 0);
  check_vector(mirror_axial(a, left), V{1, 2, 3}, 0);
  const V b{-0.3, 0.8, 1.7};
  for (const int side : {right, left}) {
    // Each is its own inverse, and a cross product of polar vectors is axial.
    check_vector(mirror_polar(mirror_polar(a, side), side), a, 0);
    check_vector(mirror_axial(mirror_axial(a, side), side), a, 0);
    check_vector(cross(mirror_polar(a, side), mirror_polar(b, side)), mirror_axial(cross(a, b), side), 1e-15);
  }
}

// What a rotor sees of the aircraft's motion, against positions of the hub in space a short time apart.
TEST(frames_hub_velocity_from_positions) {
  Generator random(8);
  for (const double mast_deg : {0.0, 37.0, 90.0}) {
    FlightSetup<double> setup = flight_setup(aircraft(), mast_deg);
    setup.mast_rate = 0.1;
    Configuration<double> c;
    if (!CHECK(prepare(aircraft(), setup, c) == Status::ok)) return;
    const StateAndControls<double> s = random_case(random, c);
    for (const int side : {right, left}) {
      const BladeControls<double> blades = mix_controls(c, s.u, s.x.velocity);
      const RotorInput<double> in = rotor_input(c, s.x, s.x.velocity, blades, side);
      // Hub in body axes turns about the pivot as the mast moves; body axes turn about the CG.
      const double h = 1e-5;
      const auto hub_at = [&](double t) {
        const double m = c.mast + setup.mast_rate * t;
        const double cant = aircraft().mast.cant * std::cos(c.mast);
        const double sigma = side == right ? 1 : -1;
        const V axis{std::cos(cant) * std::sin(m), std::sin(cant) * sigma, -std::cos(cant) * std::cos(m)};
        const MastTables<double>& mast = aircraft().mast;
        const V pivot = station_arm(c.mass, mast.sl_pivot, sigma * mast.bl_pivot, mast.wl_pivot);
        const V hub = pivot + aircraft().mast.length * axis;
        return t * s.x.velocity + hub + t * cross(s.x.rates, hub);
      };
      const V moved = (1 / (2 * h)) * (hub_at(h) - hub_at(-h));
      const V in_h = mirror_polar(in.velocity_a, side);
      const V in_body = c.hub[side].from_body.apply_inverse(in_h);
      // The small cant changes the arc of the hub by 1 - cos(cant).
      check_vector(in_body, moved, 2e-4 * 0.1 * 1.5 + 1e-6);
      const V rates_h = mirror_axial(in.rates_a, side);
      const V rates_body = c.hub[side].from_body.apply_inverse(rates_h);
      const V expected = s.x.rates - setup.mast_rate * c.hub[side].from_body.row_y;
      check_vector(rates_body, expected, 1e-14);
    }
  }
}
