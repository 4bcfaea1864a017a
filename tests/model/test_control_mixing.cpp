// Gearing: the printed tables of NASA CR-166536 (8a-I to 8a-IV), signs, superposition.
#include <utility>

#include "flight_cases.hpp"

using namespace flight_cases;

namespace {

constexpr double kDeg = kRadPerDeg<double>;

BladeControls<double> mixed(double mast, const Controls<double>& u, double speed_kt,
                            Options options = Options{}) {
  options.cyclic_rigging = false;
  return mix_controls(configuration(mast, options), u, Vec3<double>{speed_kt * 1852 / 3600, 0, 0});
}

Controls<double> only(double Controls<double>::*inceptor) {
  Controls<double> u{};
  u.*inceptor = 1;
  return u;
}

}  // namespace

TEST_OF_XV15(control_mixing_printed_gearing) {
  // Degrees per inch at mast 0, 10, ..., 90.
  const double long_cyclic[] = {2.100, 2.090, 1.980, 1.810, 1.600, 1.350, 1.040, 0.710, 0.362, 0};
  const double pedal_60[] = {1.600, 1.580, 1.510, 1.390, 1.225, 1.035, 0.803, 0.550, 0.280, 0};
  const double pedal_80[] = {1.040, 1.025, 0.975, 0.900, 0.795, 0.670, 0.520, 0.325, 0.180, 0};
  const double pedal_100[] = {0.400, 0.394, 0.375, 0.345, 0.305, 0.257, 0.200, 0.137, 0.069, 0};
  const double lateral[] = {0.625, 0.606, 0.575, 0.541, 0.500, 0.438, 0.365, 0.293, 0.209, 0.121};
  for (int k = 0; k < 10; ++k) {
    const double mast = 10.0 * k;
    const BladeControls<double> stick = mixed(mast, only(&Controls<double>::long_stick), 40);
    for (const int side : {right, left}) CHECK_NEAR(stick.long_cyclic[side] / kDeg, long_cyclic[k], 1e-12);
    CHECK_NEAR(stick.elevator / kDeg, 4.167, 1e-12);  // not phased
    const BladeControls<double> roll = mixed(mast, only(&Controls<double>::lat_stick), 40);
    CHECK_NEAR(roll.collective[right] / kDeg, -lateral[k], 1e-12);
    CHECK_NEAR(roll.collective[left] / kDeg, lateral[k], 1e-12);
    CHECK_NEAR(roll.aileron / kDeg, 3.92, 1e-12);
    for (const auto& [speed, table] :
         {std::pair<double, const double*>{30, pedal_60}, {80, pedal_80}, {130, pedal_100}}) {
      const BladeControls<double> pedal = mixed(mast, only(&Controls<double>::pedal), speed, linear_tables());
      // The speed is smoothed by 0.1 m/s.
      CHECK_NEAR(pedal.long_cyclic[right] / kDeg, -table[k], 2e-4);
      CHECK_NEAR(pedal.long_cyclic[left] / kDeg, table[k], 2e-4);
      CHECK_NEAR(pedal.rudder / kDeg, 8.0, 1e-12);
    }
  }
}

TEST(control_mixing_superposition_of_increments) {
  Generator random(3);
  const Configuration<double> c = configuration(35);
  const StateAndControls<double> s = random_case(random, c);
  const Controls<double>& u = s.u;
  const BladeControls<double> b = mix_controls(c, u, s.x.velocity);
  // Averages and half differences are the direct increments plus the geared inceptors.
  const double pedal_cyclic =
      mix_controls(c, only(&Controls<double>::pedal), s.x.velocity).long_cyclic[left] - c.gearing.rigging;
  CHECK_NEAR((b.collective[right] + b.collective[left]) / 2, u.collective, 1e-15);
  CHECK_NEAR((b.collective[right] - b.collective[left]) / 2,
             u.diff_collective - c.gearing.lateral_collective * u.lat_stick, 1e-15);
  CHECK_NEAR((b.long_cyclic[right] + b.long_cyclic[left]) / 2,
             u.long_cyclic + c.gearing.rigging + c.gearing.long_cyclic * u.long_stick, 1e-15);
  CHECK_NEAR((b.long_cyclic[right] - b.long_cyclic[left]) / 2, u.diff_long_cyclic - pedal_cyclic * u.pedal,
             1e-15);
  CHECK_EQ(b.lateral_cyclic[right], u.lateral_cyclic);
  CHECK_EQ(b.lateral_cyclic[left], u.lateral_cyclic);
  CHECK_NEAR(b.elevator, u.elevator + c.gearing.elevator * u.long_stick, 1e-15);
  CHECK_NEAR(b.rudder, u.rudder + c.gearing.rudder * u.pedal, 1e-15);
}

// Each inceptor by the sign of the aircraft's answer (helicopter mode in hover, airplane mode in cruise).
TEST(control_mixing_signs_of_the_aircraft) {
  struct Sign {
    double Controls<double>::*inceptor;
    int rate;  // 0 roll, 1 pitch, 2 yaw acceleration
    double sign;
  };
  for (const double mast : {0.0, 90.0}) {
    const Configuration<double> c = configuration(mast);
    StateAndControls<double> s{};
    s.x.velocity = mast > 0 ? Vec3<double>{90, 0, 4} : Vec3<double>{0, 0, 0};
    for (int side = 0; side < 2; ++side) s.x.rotor[side].lambda_0 = mast > 0 ? 0.002 : 0.07;
    s.u.collective = mast > 0 ? 0.54 : 0.2;
    for (const Sign& test :
         {Sign{&Controls<double>::long_stick, 1, -1}, Sign{&Controls<double>::lat_stick, 0, 1},
          Sign{&Controls<double>::pedal, 2, 1}}) {
      // With the disks tilted as far as the cyclic asks: the gimbal follows within a revolution.
      State<double> rates[2];
      for (int k = 0; k < 2; ++k) {
        StateAndControls<double> moved = s;
        moved.u.*test.inceptor = k == 0 ? -1 : 1;
        const BladeControls<double> b = mix_controls(c, moved.u, moved.x.velocity);
        for (int side = 0; side < 2; ++side) moved.x.rotor[side].b1c = b.long_cyclic[side];
        derivative(c, moved.x, moved.u, rates[k]);
      }
      const Vec3<double> change = rates[1].rates - rates[0].rates;
      const double answer = test.rate == 0 ? change.x : test.rate == 1 ? change.y : change.z;
      CHECK_LT(0.01, answer * test.sign);
    }
  }
}
