// Actuators: lag, largest rate, stop; and the blades stand where they are.
#include "vehicle_case.hpp"

using namespace vehicle_case;

namespace {

const SystemTables<double>& tables() { return aircraft_data<double>().systems; }

constexpr Actuator<double> kMiddling = {-0.3, 0.5, 0.6};

}  // namespace

TEST(actuators_are_a_lag_of_a_largest_rate) {
  const double w = tables().actuator.bandwidth, near = 1e-3;
  CHECK_REL(actuator_rate(tables(), kMiddling, 0.1 + near, 0.1), w * near, 1e-3);
  CHECK_REL(actuator_rate(tables(), kMiddling, 0.3, 0.1), kMiddling.rate, 1e-3);
  CHECK_REL(actuator_rate(tables(), kMiddling, -0.2, 0.1), -kMiddling.rate, 1e-3);
  CHECK_LE(std::fabs(actuator_rate(tables(), kMiddling, 0.3, 0.1)), kMiddling.rate);
}

// Whatever is asked, an actuator comes to rest inside its stop by less than the width of its smoothing, and one that
// stands beyond its stop comes back.
TEST(actuators_stop_at_their_stops) {
  const double width = tables().smooth.actuator_angle;
  for (const double command : {0.5, 0.52, 0.8, 5.0, -0.3, -0.31, -5.0}) {
    double angle = 0;
    for (int k = 0; k < 20000; ++k) {
      angle += 1e-4 * actuator_rate(tables(), kMiddling, command, angle);
      CHECK_LE(kMiddling.low, angle);
      CHECK_LE(angle, kMiddling.high);
    }
    CHECK_NEAR(angle, std::clamp(command, kMiddling.low, kMiddling.high), width);
  }
  CHECK_LT(actuator_rate(tables(), kMiddling, 5.0, 0.51), 0);
  CHECK_LT(0, actuator_rate(tables(), kMiddling, -5.0, -0.31));
}

// Angles of blades and surfaces by the gearing of the model: states of the actuators, and the rigging.
TEST(actuators_are_where_blades_and_surfaces_are) {
  for (const double mast : {0.0, 30.0, 75.0, 90.0}) {
    const Configuration<double> c = flown_configuration(mast, 0, realtime());
    SystemState<double> s{};
    s.collective[right] = 0.21;
    s.collective[left] = 0.17;
    s.long_cyclic[right] = 0.03;
    s.long_cyclic[left] = -0.02;
    s.elevator = 0.04;
    s.aileron = -0.05;
    s.rudder = 0.06;
    Controls<double> pilot{};  // hands do not reach past the actuators
    pilot.long_stick = 2;
    pilot.lat_stick = -1;
    pilot.pedal = 1.5;
    pilot.collective = 0.3;
    pilot.lateral_cyclic = 0.01;
    pilot.gust = {1, 2, 3};
    const Controls<double> at = actuated_controls(s, pilot);
    CHECK(same_bits(at.gust, pilot.gust));
    const BladeControls<double> b = mix_controls(c, at, Vec3<double>{40, 3, 2});
    for (const Side side : {right, left}) {
      CHECK_NEAR(b.collective[side], s.collective[side], 1e-15);
      CHECK_NEAR(b.long_cyclic[side], s.long_cyclic[side] + c.gearing.rigging, 1e-15);
      CHECK_NEAR(b.lateral_cyclic[side], pilot.lateral_cyclic, 1e-15);
    }
    CHECK_EQ(b.elevator, s.elevator);
    CHECK_EQ(b.aileron, s.aileron);
    CHECK_EQ(b.rudder, s.rudder);
  }
}

// What the actuators are asked for is what the gearing makes of the pilot's controls, less the rigging: at rest there
// the airframe feels the pilot's controls themselves.
TEST(actuators_at_rest_change_no_rate) {
  for (const double mast : {0.0, 30.0, 90.0}) {
    SystemSwitches on{};
    on.actuators = true;
    Flight f = begun(mast, level(20 + mast), on);
    State<double> bare;
    derivative(f.c, f.s.state, f.s.controls, bare);
    double expected[state_count];
    flatten(bare, expected);
    const Rates found = rates(f);
    for (int i = 0; i < state_count; ++i)
      CHECK_NEAR(found.of[i], expected[i], 1e-10 * (1 + vehicle_variable(i).facts().bend));
  }
}
