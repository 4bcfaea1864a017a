// Net thrust of the engine jets: printed jet thrusts of other flights than those that gave its numbers, momentum,
// similarity of a turbine with altitude, its place in the sum of the aircraft.
#include "printed_runs.hpp"
#include "tiltrotor/math/differentiation/dual.hpp"
#include "tiltrotor/model/airframe/engine_jet.hpp"
#include "tiltrotor/model/derivative.hpp"

using namespace flight_cases;
using printed_runs::kFoot;
using printed_runs::kPound;

namespace {

constexpr double kHorsepower = 745.69987158227;
constexpr double kSlug = kPound / kFoot;

Options with_jets() {
  Options options;
  options.engine_jets = true;
  return options;
}

double thrust(const Configuration<double>& c, double power, double speed) {
  return dot(engine_jet_loads(c, power, speed).force, c.nacelle_axis_b);
}

}  // namespace

// Jet thrust of both engines at mast 0, printed at 40, 60 and 100 kt (NASA CR-166537 pp. ), at the
// powers of the same runs as read off a figure (trim_gtrs_figures.csv: to 22 kW, 43 kW at 40 kt). Up, at the conversion
// axis 1.2 in before the centre of gravity.
TEST_OF_XV15(engine_jets_printed_in_helicopter_mode) {
  const struct {
    double u_fps, w_fps, power_kw, z_lb, m_lbft;
  } points[] = {{67.45, -2.967, 900, -102.672, 10.267},
                {100.8, -10.04, 828.6, -74.196, 7.420},
                {164.7, -36.86, 1328.6, -80.659, 8.066}};
  const Configuration<double> c = configuration(0);
  for (const auto& p : points) {
    const double speed = std::hypot(p.u_fps, p.w_fps) * kFoot;
    const printed_runs::Printed jets = printed_runs::in_pounds(engine_jet_loads(c, 1e3 * p.power_kw, speed));
    CHECK_NEAR(jets.x, 0.0, 1e-9);
    CHECK_NEAR(jets.z, p.z_lb, 5);
    CHECK_REL(jets.m / jets.z, p.m_lbft / p.z_lb, 1e-3);
  }
}

// Gross thrust less momentum of the airflow: 39.0 lb and 0.0829 lb/hp, 0.445 slug/s and 1.16e-4 slug/s for a
// horsepower, by hand; derivatives with respect to speed and power are the airflow and what is left of a
// horsepower's jet.
TEST_OF_XV15(engine_jets_follow_momentum) {
  const Configuration<double> c = configuration(90);
  const double power = 1400 * kHorsepower;
  const double speed = 300 * kFoot;
  const double airflow = 0.445 + 1.16e-4 * 1400;
  CHECK_NEAR(thrust(c, power, speed) / kPound, 39.0 + 0.0829 * 1400 - airflow * 300, 0.02);
  using D = Dual<double, 2>;
  const Loads<D> jets = engine_jet_loads(c, D::variable(power, 0), D::variable(speed, 1));
  CHECK_REL(jets.force.x.d.get(0), (0.0829 - 1.16e-4 * 300) * kPound / kHorsepower, 1e-4);
  CHECK_REL(jets.force.x.d.get(1), -airflow * kSlug, 1e-4);
  // Driven by the rotors the engines idle: no power, however much they are driven.
  CHECK_NEAR(thrust(c, -1e6, speed) / kPound, 39.0 - 0.445 * 300, 0.01);
}

// A turbine at equal Mach numbers: at altitude, with power times delta sqrt(theta) and speed times sqrt(theta), its
// thrust is delta times that at sea level.
TEST(engine_jets_of_a_similar_turbine_go_with_pressure) {
  FlightSetup<double> setup = flight_setup(aircraft(), 60.0);
  setup.altitude = 5000;
  Configuration<double> high;
  CHECK(prepare(aircraft(), setup, high) == Status::ok);
  const Configuration<double> low = configuration(60);
  const double theta = (288.15 - 0.0065 * 5000) / 288.15;  // ISO 2533
  const double delta = 54019.9 / 101325;
  for (const double speed : {0.0, 70.0, 130.0}) {
    const double here = thrust(low, 9e5, speed);
    CHECK_NEAR(thrust(high, 9e5 * delta * std::sqrt(theta), speed * std::sqrt(theta)), delta * here, 0.1);
  }
}

// In the aircraft they are force over mass and moment over inertia, and nothing else changes.
TEST(engine_jets_accelerate_the_aircraft) {
  for (const double mast : {0.0, 45.0, 90.0}) {
    Generator random(11);
    const Configuration<double> c = configuration(mast, with_jets());
    const StateAndControls<double> s = random_case(random, c);
    Evaluation<double> with;
    Evaluation<double> without;
    evaluate_aircraft(c, s.x, s.u, with);
    evaluate_aircraft(configuration(mast), s.x, s.u, without);
    const Loads<double>& jets = with.loads[Component::engine_jets];
    const double power =
        (with.rotor[right].loads.torque + with.rotor[left].loads.torque) * c.setup.rotor_speed;
    const Vec3<double> air = s.x.velocity - s.u.gust;
    CHECK_NEAR(dot(jets.force, c.nacelle_axis_b), thrust(c, power, std::sqrt(dot(air, air))), 0.01);
    const Vec3<double> gained = with.rates.velocity - without.rates.velocity;
    CHECK_NEAR(gained.x * c.setup.mass, jets.force.x, 1e-8);
    CHECK_NEAR(gained.z * c.setup.mass, jets.force.z, 1e-8);
    CHECK_NEAR((with.rates.rates.y - without.rates.rates.y) * c.mass.inertia.yy, jets.moment.y, 1e-8);
    CHECK_EQ(without.loads[Component::engine_jets].force.x, 0.0);
  }
}
