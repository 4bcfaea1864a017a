// Radial shape of the mean inflow: annular momentum theory in closed form, the shape that another implementation
// found for this blade, and where it fades.
#include "settled_rotor.hpp"
#include "tiltrotor/model/rotor/radial_inflow.hpp"

using namespace flight_cases;
using namespace settled_rotor;

namespace {

const double kRadius = aircraft().rotor.radius;

double shape_at(const Configuration<double>& c, double x) {
  const BladeStation<double>* s = c.blade.station;
  int i = 1;
  while (i < c.blade.count - 1 && s[i].radius < x * kRadius) ++i;
  const double t = (x * kRadius - s[i - 1].radius) / (s[i].radius - s[i - 1].radius);
  return 1 + s[i - 1].inflow_shape + t * (s[i].inflow_shape - s[i - 1].inflow_shape);
}

// Of the rotor in mean inflow `lambda_0` with the hub's speeds over tip speed, m/s over tip speed and lambda_0.
double share(const Configuration<double>& c, double mu_x, double mu_z, double lambda_0) {
  RotorInput<double> in{};
  in.velocity_a = {mu_x * c.tip_speed, 0, mu_z * c.tip_speed};
  in.state.lambda_0 = lambda_0;
  return mean_inflow(c, in).shaped / (c.tip_speed * lambda_0);
}

}  // namespace

// lambda(x) = sigma a / 16 (sqrt(1 + 32 theta x / (sigma a)) - 1), an untwisted blade of constant chord in hover
// with small angles: Gessow and Myers 1952, ch. 4; Leishman 2006, eq. 3.61.
TEST(radial_inflow_is_that_of_annular_momentum) {
  const TextbookRotor textbook;
  Aircraft<double> a = textbook.aircraft();
  a.inflow.shape_thrust = 0.002;  // small angles
  a.inflow.shape_tip_mach = 0.01;
  FlightSetup<double> setup = flight_setup(a, 0.0);
  setup.options.grid_refinement = 4;
  setup.options.tables = Interpolation::linear;
  Configuration<double> c;
  CHECK(prepare(a, setup, c) == Status::ok);

  const double solidity =
      a.rotor.blades * blade_chord(a.rotor, setup.options.chord, 0.5) / (kPi<double> * kRadius);
  const double sigma_a = solidity * TextbookRotor::kLiftSlope;
  const double mean = std::sqrt(0.002 / 2);
  // Pitch from the inflow of one station, then every other station from the pitch.
  const auto lambda = [&](double theta, double x) {
    return sigma_a / 16 * (std::sqrt(1 + 32 * theta * x / sigma_a) - 1);
  };
  const double at_75 = mean * shape_at(c, 0.75);
  const double theta = (std::pow(at_75 * 16 / sigma_a + 1, 2) - 1) * sigma_a / (32 * 0.75);
  for (const double x : {0.3, 0.45, 0.6, 0.9}) CHECK_REL(mean * shape_at(c, x), lambda(theta, x), 0.01);
  // The thrust is that of the design hover: C_T = 4 integral lambda^2 x dx over the lifting part.
  double thrust = 0;
  const int steps = 1000;
  for (int k = 0; k < steps; ++k) {
    const double x = a.rotor.root_cutout + (a.rotor.tip_loss - a.rotor.root_cutout) * (k + 0.5) / steps;
    thrust += 4 * std::pow(lambda(theta, x), 2) * x * (a.rotor.tip_loss - a.rotor.root_cutout) / steps;
  }
  CHECK_REL(thrust, 0.002, 0.02);
}

// The same balance of this blade by another implementation, at 587 rpm; found with its own stations.
TEST_OF_XV15(radial_inflow_shape_of_the_blade) {
  const double x[] = {0.12, 0.16, 0.20, 0.25, 0.30, 0.35, 0.40, 0.45,
                      0.50, 0.60, 0.65, 0.70, 0.75, 0.85, 0.90};
  const double s[] = {0.593,  0.6703, 0.7277, 0.7818, 0.845, 0.9084, 0.9742, 1.0327,
                      1.0812, 1.1032, 1.1089, 1.1096, 1.08,  1.0797, 1.0386};
  for (const BladeGrid grid : {BladeGrid::specification, BladeGrid::realtime}) {
    Options options;
    options.grid = grid;
    const Configuration<double> c = configuration(0, options);
    for (int k = 0; k < 15; ++k) CHECK_NEAR(shape_at(c, x[k]), s[k], 0.015);
  }
}

// Outside the tip-loss radius, where nothing lifts, the shape holds.
TEST(radial_inflow_holds_at_the_tip) {
  const Configuration<double> c = configuration(0);
  int inside = c.blade.count - 1;
  while (c.blade.station[inside].lift_weight == 0) --inside;
  for (int i = inside; i < c.blade.count; ++i)
    CHECK_EQ(c.blade.station[i].inflow_shape, c.blade.station[inside].inflow_shape);
}

// c = cos of the wake's skew: 1 along the shaft, lambda_0 / sqrt(mu^2 + lambda_0^2) edgewise, none when the wake
// goes up through the disk.
TEST(radial_inflow_fades_with_the_skew_of_the_wake) {
  const Configuration<double> c = configuration(0);
  CHECK_NEAR(share(c, 0, 0, 0.07), 1, 2e-3);
  CHECK_NEAR(share(c, 0, 0.5, 0.01), 1, 1e-4);
  CHECK_NEAR(share(c, 0.17, 0, 0.05), 0.05 / std::hypot(0.17, 0.05), 1e-3);
  CHECK_NEAR(share(c, 0.3, -0.1, 0.02), 0, 1e-3);
  CHECK_EQ(share(c, 0, -0.3, 0.05), 0.0);
  // Descent at a fifth of the induced velocity changes nothing yet; half way down the fade, 0.6 of it, is half.
  CHECK_NEAR(share(c, 0, -0.01, 0.05), 1, 5e-3);
  CHECK_NEAR(share(c, 0, -0.03, 0.05), 0.5, 1e-2);
}

// The switch, and mast angle, altitude and rotor speed, which the shape of the design hover does not know.
TEST(radial_inflow_belongs_to_the_aircraft) {
  Options options;
  options.radial_inflow = RadialInflow::constant;
  const Configuration<double> constant = configuration(0, options);
  const Configuration<double> helicopter = configuration(0);
  FlightSetup<double> setup = flight_setup(aircraft(), 90.0);
  setup.altitude = 3000;
  Configuration<double> airplane;
  CHECK(prepare(aircraft(), setup, airplane) == Status::ok);
  for (int i = 0; i < helicopter.blade.count; ++i) {
    CHECK_EQ(constant.blade.station[i].inflow_shape, 0.0);
    CHECK_EQ(airplane.blade.station[i].inflow_shape, helicopter.blade.station[i].inflow_shape);
  }
}
