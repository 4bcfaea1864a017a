// The rotor against closed forms of rotor theory: figure of merit in hover, Glauert's inflow and the flapping
// of a centrally hinged rotor in forward flight, Amer's loss of pitch damping, the windmill of airplane mode.
// The expected values are the formulas named at each test.
#include "settled_rotor.hpp"
#include "this_aircraft.hpp"
#include "tiltrotor/analysis/isolated_rotor.hpp"

using namespace flight_cases;
using namespace settled_rotor;

namespace {

const double kRadius = aircraft().rotor.radius;
const double kDiskArea = kPi<double> * kRadius * kRadius;
// Of the textbook rotor.
const double kSolidity = aircraft().rotor.blades * TextbookRotor::chord() / (kPi<double> * kRadius);

IsolatedRotorWorkspace<double> work;

// Uniform inflow with the induced power factor `kappa`.
Configuration<double> with_uniform_inflow(const Aircraft<double>& a, double mast_deg, double kappa) {
  FlightSetup<double> setup = flight_setup(a, mast_deg);
  setup.options.tables = Interpolation::linear;
  setup.options.grid_refinement = 4;
  setup.options.inflow = InflowShape::uniform;
  setup.options.radial_inflow = RadialInflow::constant;
  setup.options.induced_power_factor = kappa;
  Configuration<double> c;
  CHECK(prepare(a, setup, c) == Status::ok);
  return c;
}

IsolatedRotor<double> settled_in(const Configuration<double>& c, double collective, double in_plane,
                                 double axial) {
  RotorFlow<double> flow{};
  flow.collective = collective;
  flow.in_plane = in_plane;
  flow.axial = axial;
  IsolatedRotor<double> rotor;
  CHECK(isolated_rotor(c, flow, work, rotor) == Status::ok);
  return rotor;
}

}  // namespace

// Ideal power over power, figure of merit M = P_i / (P_i + P_0) with P_0 = sigma cd / 8 (Gessow and
// Myers 1952, ch. 4): one without drag, nothing without thrust.
TEST(rotor_figure_of_merit_has_its_limits) {
  const TextbookRotor textbook;
  Aircraft<double> a = textbook.aircraft();
  for (const double drag : {0.0, 0.01}) {
    const double alpha[2] = {-180, 180};
    const double mach[2] = {0, 2};
    const double cd[16] = {drag, 0, 0, 0, drag, 0, 0, 0, drag, 0, 0, 0, drag, 0, 0, 0};
    for (auto& table : a.rotor.section_drag)
      table = Table<double, 2>{{{2, alpha}, {2, mach}}, {{0, nullptr}}, cd};
    Configuration<double> c = with_uniform_inflow(a, 0, 1);
    c.coning = 0;
    for (const double collective : {0.05, 0.1, 0.15, 0.2}) {
      const RotorFigures<double> f = settled_in(c, collective, 0, 0).figures;
      const double ideal = std::pow(f.thrust_coefficient, 1.5) / std::sqrt(2.0);
      const double merit = ideal / (ideal + kSolidity * drag / 8);
      CHECK_REL(f.figure_of_merit, merit, drag > 0 ? 0.01 : 1e-3);
    }
  }
  const Configuration<double> real = configuration(0);
  double last = 0;
  for (const double collective : {0.02, 0.06, 0.10, 0.14}) {
    const double merit = settled_in(real, collective, 0, 0).figures.figure_of_merit;
    CHECK(merit > last && merit < 1);
    last = merit;
  }
  CHECK_LT(settled_in(real, 0.02, 0, 0).figures.figure_of_merit, 0.3);
}

// Glauert (1926): v = kappa T / (2 rho A V') with V' the speed of the air through the disk; far from hover
// v -> kappa T / (2 rho A V).
TEST(rotor_inflow_in_forward_flight_is_glauerts) {
  const double kappa = 1.1;
  const Configuration<double> c = with_uniform_inflow(aircraft(), 0, kappa);
  for (const double mu : {0.03, 0.08, 0.15, 0.25, 0.35}) {
    for (const double climb : {0.0, 0.02, 0.05}) {
      const double in_plane = mu * c.tip_speed;
      const double axial = climb * c.tip_speed;
      const IsolatedRotor<double> r = settled_in(c, 0.15 + climb, in_plane, axial);
      const double v = r.input.state.lambda_0 * c.tip_speed;
      const double through = std::hypot(in_plane, axial + v);
      CHECK_REL(v, kappa * r.figures.thrust / (2 * c.air.density * kDiskArea * through), 2e-3);
      if (mu > 0.3 && climb == 0)
        CHECK_REL(v, kappa * r.figures.thrust / (2 * c.air.density * kDiskArea * in_plane), 0.01);
    }
  }
}

// A blade hinged at the centre, untwisted, with uniform inflow (Gessow and Myers 1952, ch. 8; Johnson,
// Helicopter Theory, 1980, ch. 5): backward tilt a1 = mu (8/3 theta - 2 lambda) / (1 - mu^2/2), tilt to the
// advancing side b1 = 4/3 mu a0 / (1 + mu^2/2). Their blade has no reverse flow and small angles.
TEST(rotor_hinged_at_the_centre_flaps_as_theory_says) {
  const TextbookRotor textbook;
  const Configuration<double> c = with_uniform_inflow(textbook.aircraft(), 0, 1);
  for (const double mu : {0.0, 0.05, 0.1, 0.15}) {
    for (const double collective : {0.08, 0.12}) {
      const double axial = -0.01 * c.tip_speed * (mu > 0);  // disk tilted back, as in level flight with wing
      const IsolatedRotor<double> r = settled_in(c, collective, mu * c.tip_speed, axial);
      const double lambda = axial / c.tip_speed + r.input.state.lambda_0;
      const double back = mu * (8.0 / 3 * collective - 2 * lambda) / (1 - mu * mu / 2);
      const double side = 4.0 / 3 * mu * c.coning / (1 + mu * mu / 2);
      CHECK_NEAR(r.input.state.b1c, -back, 0.01 * back + 1e-9);
      CHECK_NEAR(r.input.state.b1s, -side, 0.05 * side + 1e-9);
    }
  }
}

// A pitching rotor in hover: the disk lags by 16/(gamma Omega), and the force in its plane takes back part of
// what a thrust normal to it would damp. Kept of it: 3/2 - a/12 theta / (CT/sigma) for the untwisted blade
// with uniform inflow: blades of constant angle-of-attack change A have A lambda / 2 in the plane against
// A (theta/3 - lambda/2) of thrust (Amer, NACA TN 2136, 1950).
TEST(rotor_in_plane_force_takes_back_pitch_damping) {
  const TextbookRotor textbook;
  Configuration<double> c = with_uniform_inflow(textbook.aircraft(), 0, 1);
  c.coning = 0;
  const double rate = 1e-3;
  for (const double collective : {0.1, 0.15, 0.2}) {
    const IsolatedRotor<double> hover = settled_in(c, collective, 0, 0);
    RotorInput<double> pitching = hover.input;
    pitching.rates_a.y = rate;
    pitching = settled(c, pitching, true);
    const double tilt = pitching.state.b1c - hover.input.state.b1c;
    CHECK_REL(tilt / rate, 16 / (textbook.lock_number(c) * c.setup.rotor_speed), 0.02);
    const double back =
        rotor_response(c, pitching, c.azimuth).loads.force_a.x - hover.response.loads.force_a.x;
    const double kept =
        1.5 - TextbookRotor::kLiftSlope / 12 * collective / (hover.figures.thrust_coefficient / kSolidity);
    CHECK_NEAR(-back / (hover.figures.thrust * tilt), kept, 0.01);
  }
}

// The same of this rotor in the hover of the 1975 estimate, 565 rpm: half of the damping is kept. Amer's
// figure for blades with twist and tip loss: 1 - 0.29 theta / (CT/sigma) of 18/(gamma Omega).
TEST_OF_XV15(rotor_of_the_xv15_keeps_half_of_its_pitch_damping) {
  FlightSetup<double> setup = flight_setup(aircraft(), 0.0);
  setup.rotor_speed = 565 * kPi<double> / 30;
  setup.options.radial_inflow = RadialInflow::constant;  // as in Amer's theory
  Configuration<double> c;
  if (!CHECK(prepare(aircraft(), setup, c) == Status::ok)) return;
  const RotorInput<double> hover = settled_at_thrust(c, hover_input(c), 7000 * kPound);
  RotorInput<double> pitching = hover;
  const double rate = 1e-4;
  pitching.rates_a.y = rate;
  pitching = settled(c, pitching);
  const MastLoads<double> still = rotor_response(c, hover, c.azimuth).loads;
  const MastLoads<double> moved = rotor_response(c, pitching, c.azimuth).loads;
  const double tilt = pitching.state.b1c - hover.state.b1c;
  const double kept = -(moved.force_a.x - still.force_a.x) / (still.force_a.z * tilt);
  const double ct = still.force_a.z / (c.air.density * kDiskArea * c.tip_speed * c.tip_speed);
  NOTE("tilt per rate " + std::to_string(tilt / rate) + " s, kept " + std::to_string(kept));
  CHECK_NEAR(kept, 1 - 0.29 * hover.collective / (ct / 0.0891), 0.04);
  CHECK_NEAR(kept, 0.52, 0.03);
  // Harmonic inflow of hover: the Lock number acts as gamma / (1 + a sigma / (16 lambda)) (Curtiss and Shupe
  // 1971); spring and pitch-flap coupling move the tilt by a few per cent.
  const double lock = 3.83 / (1 + 5.73 * 0.0891 / (16 * hover.state.lambda_0));
  CHECK_REL(tilt / rate, 16 / (lock * setup.rotor_speed), 0.06);
}

// Airplane mode without drag: P = T (V + v) and T = 2 rho A (V + v) v (momentum theory), driven and driving.
// The rotor of this aircraft needs power without thrust and turns by itself while it brakes.
TEST(rotor_windmills_in_airplane_mode) {
  const TextbookRotor textbook;
  Configuration<double> c = with_uniform_inflow(textbook.aircraft(), 90, 1);
  c.coning = 0;
  const double speed = 80 * this_aircraft::speed();
  int driving = 0;
  for (const double collective : {0.46, 0.50, 0.52, 0.54, 0.58}) {
    const IsolatedRotor<double> r = settled_in(c, collective, 0, speed);
    const double v = r.input.state.lambda_0 * c.tip_speed;
    CHECK_REL(r.figures.power, r.figures.thrust * (speed + v), 1e-4);
    CHECK_REL(r.figures.thrust, 2 * c.air.density * kDiskArea * (speed + v) * v, 1e-3);
    driving += r.figures.power < 0;
  }
  CHECK_EQ(driving, 3);

  const Configuration<double> real = configuration(90);
  const auto zero_of = [&](double RotorFigures<double>::*what) {
    double low = 0.35;
    double high = 0.6;
    for (int k = 0; k < 40; ++k) {
      const double middle = 0.5 * (low + high);
      (settled_in(real, middle, 0, speed).figures.*what < 0 ? low : high) = middle;
    }
    return settled_in(real, high, 0, speed).figures;
  };
  const RotorFigures<double> no_thrust = zero_of(&RotorFigures<double>::thrust);
  const RotorFigures<double> no_power = zero_of(&RotorFigures<double>::power);
  CHECK_LT(0.0, no_thrust.power);
  CHECK_LT(no_power.thrust, 0.0);
  // The brake takes from the air what the profile drag needs.
  CHECK_NEAR(-no_power.thrust * speed / no_thrust.power, 1.0, 0.1);
}
