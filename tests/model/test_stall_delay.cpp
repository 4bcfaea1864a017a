// Stall delay by rotation: the factor of the radius, the law by hand, where it acts and where not, its derivatives.
#include "settled_rotor.hpp"
#include "tiltrotor/analysis/isolated_rotor.hpp"
#include "tiltrotor/math/hyperbolic_tangent.hpp"

using namespace flight_cases;

namespace {

Configuration<double> delayed(double mast_deg = 0) {
  Options options;
  options.stall_delay = true;
  return configuration(mast_deg, options);
}

}  // namespace

// Expected: the C library's.
TEST(stall_delay_hyperbolic_tangent) {
  for (double x = -5; x <= 5; x += 0.03125) CHECK_NEAR(hyperbolic_tangent(x), std::tanh(x), 4e-16);
}

// tanh(3 (c/r)^2) at each station.
TEST(stall_delay_is_strong_inboard) {
  const Configuration<double> c = delayed();
  for (int i = 0; i < c.blade.count; ++i) {
    const BladeStation<double>& s = c.blade.station[i];
    const double chord =
        blade_chord(c.aircraft->rotor, ChordSource::cutout, s.radius / c.aircraft->rotor.radius);
    CHECK_NEAR(kept_by_rotation(c, s), std::tanh(3 * chord * chord / (s.radius * s.radius)), 1e-15);
    if (i > 0) CHECK_LT(kept_by_rotation(c, s), kept_by_rotation(c, c.blade.station[i - 1]));
  }
}

// Zero lift and slope of the sections, read off their tables at low speed by another program: deg, 1/deg.
TEST_OF_XV15(stall_delay_knows_the_sections) {
  const Configuration<double> c = delayed();
  const double zero[] = {-2.4, -0.31, -0.76, -0.87};
  const double slope[] = {0.1095, 0.1124, 0.1096, 0.1119};
  for (int k = 0; k < kSectionRegions; ++k) {
    CHECK_NEAR(potential_lift(c.aircraft->rotor, k).zero_deg, zero[k], 0.05);
    CHECK_NEAR(potential_lift(c.aircraft->rotor, k).slope, slope[k], 0.003);
  }
}

// Nothing at zero lift and behind 50 deg; in between what is lacking to potential lift.
TEST(stall_delay_restores_what_stall_takes) {
  const Configuration<double> c = delayed();
  for (int k = 0; k < kSectionRegions; ++k) {
    const PotentialLift<double> p = potential_lift(c.aircraft->rotor, k);
    CHECK_EQ(lift_lost_by_stall(c, k, p.zero_deg * kRadPerDeg<double>, 0.0), 0.0);
    CHECK_EQ(lift_lost_by_stall(c, k, 50.1 * kRadPerDeg<double>, 0.5), 0.0);
    CHECK_EQ(lift_lost_by_stall(c, k, -20 * kRadPerDeg<double>, -0.5), 0.0);
    const double potential = p.slope * (20 - p.zero_deg);
    CHECK_NEAR(lift_lost_by_stall(c, k, 20 * kRadPerDeg<double>, 1.0), potential - 1.0, 2e-4);
    CHECK_NEAR(lift_lost_by_stall(c, k, 40 * kRadPerDeg<double>, 1.0), (p.slope * (40 - p.zero_deg) - 1) / 2,
               2e-4);
    CHECK_LT(lift_lost_by_stall(c, k, 6 * kRadPerDeg<double>, p.slope * (6 - p.zero_deg)), 0.011);
  }
}

// Dual numbers against a complex step, through stall.
TEST(stall_delay_has_exact_derivatives) {
  const Configuration<double> c = delayed();
  for (double alpha_deg = -10; alpha_deg < 55; alpha_deg += 1.7) {
    using T = Dual<double, 2>;
    const T exact =
        lift_lost_by_stall(c, 1, T::variable(alpha_deg * kRadPerDeg<double>, 0), T::variable(1.1, 1));
    const double h = 1e-30;
    using Z = std::complex<double>;
    CHECK_NEAR(exact.d.get(0),
               lift_lost_by_stall(c, 1, Z(alpha_deg * kRadPerDeg<double>, h), Z(1.1)).imag() / h,
               1e-13 * (1 + std::abs(exact.d.get(0))));
    CHECK_NEAR(exact.d.get(1),
               lift_lost_by_stall(c, 1, Z(alpha_deg * kRadPerDeg<double>), Z(1.1, h)).imag() / h, 1e-13);
  }
}

// The root, set at 40 deg and more, stalls at every thrust: some more of it in hover; most at the highest, which rises
// from C_T/sigma 0.166 towards the 0.178 that another program with this law finds.
TEST_OF_XV15(stall_delay_adds_thrust_to_a_stalled_rotor) {
  static IsolatedRotorWorkspace<double> work;
  const auto thrust = [](const Configuration<double>& c, double collective_deg) {
    RotorFlow<double> flow{};
    flow.collective = collective_deg * kRadPerDeg<double>;
    IsolatedRotor<double> rotor;
    CHECK(isolated_rotor(c, flow, work, rotor) == Status::ok);
    return rotor.figures.thrust_coefficient;
  };
  const Configuration<double> c = delayed();
  const Configuration<double> plain = configuration(0);
  CHECK_REL(thrust(c, 8), thrust(plain, 8), 0.06);
  CHECK_LT(1.05 * thrust(plain, 20), thrust(c, 20));
  CHECK_NEAR(thrust(c, 20) / 0.0891, 0.178, 0.005);
}
