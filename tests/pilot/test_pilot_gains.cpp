// Gains of the reference pilot.
// Expected: a body whose inverse is known by hand; numbers that are linear between points.
#include <vector>

#include "analysis/analysis_case.hpp"
#include "pilot/pilot_schedule.hpp"
#include "tiltrotor/model/rigid_body.hpp"

using namespace analysis_case;
using namespace tiltrotor::pilot;

// A body on springs of its own making, where the inverse is known: u' = -0.1 u - g theta, w' = -0.5 w - 50 collective,
// q' = -2 q - 0.3 stick.
TEST(pilot_gains_of_a_known_body) {
  static LinearModel<double> model;
  clear(model);
  model.states = kRigidStates;
  model.controls = 4;
  for (int j = 0; j < 4; ++j) model.control[j] = kInceptors.index[j];
  for (int i = 0; i < kRigidStates; ++i) model.state[i] = kRigidOrder[i];
  const double g = kGravity<double>;
  model.a(0, 0) = -0.1, model.a(0, 3) = -g, model.a(1, 1) = -0.5, model.b(1, 0) = -50;
  model.a(2, 2) = -2, model.b(2, 1) = -0.3, model.a(3, 2) = 1;
  model.a(4, 4) = -0.2, model.a(4, 6) = g, model.a(5, 5) = -1, model.b(5, 2) = 0.4, model.a(6, 5) = 1;
  model.a(7, 7) = -0.25, model.b(7, 3) = 0.2;
  PilotRule rule;
  PilotGains gains;
  if (!CHECK(pilot_gains(model, {}, rule, gains) == Status::ok)) return;
  // Steady: -0.1 u = g theta, climb 0.5/50 a m/s; changing: one g a rad, 1/50 a m/s^2.
  CHECK_NEAR(gains.longitudinal.steady.attitude[0], -0.1 / g, 1e-12);
  CHECK_NEAR(gains.longitudinal.steady.lever[1], 0.5 / 50, 1e-12);
  CHECK_NEAR(gains.longitudinal.changing.attitude[0], -1 / g, 1e-12);
  CHECK_NEAR(gains.longitudinal.changing.lever[1], 1.0 / 50, 1e-12);
  CHECK_NEAR(gains.longitudinal.changing.lever[0], 0, 1e-12);
  CHECK_NEAR(gains.lateral.steady.attitude[0], 0.2 / g, 1e-12);
  CHECK_NEAR(gains.lateral.steady.lever[1], 0.25 / 0.2, 1e-12);
  CHECK_NEAR(gains.lateral.changing.attitude[0], 1 / g, 1e-12);
  CHECK_NEAR(gains.lateral.changing.lever[1], 1 / 0.2, 1e-12);
  const double w = rule.attitude;
  CHECK_NEAR(gains.pitch_by_stick.angle, -w * w / 0.3, 1e-12);
  CHECK_NEAR(gains.pitch_by_stick.rate, -(2 * rule.damping * w - 2) / 0.3, 1e-12);
  CHECK_NEAR(gains.roll_by_stick.rate, (2 * rule.damping * w - 1) / 0.4, 1e-12);
  CHECK_NEAR(gains.yaw_damping, (rule.yaw_rate - 0.25) / 0.2, 1e-12);
  // Augmentation that does all of it leaves nothing to the pilot.
  CHECK(pilot_gains(model, {10, -10, -10}, rule, gains) == Status::ok);
  CHECK_EQ(gains.pitch_by_stick.rate, 0);
  CHECK_EQ(gains.yaw_damping, 0);

  PilotGains other = gains;
  PilotGains::each(other, [](double& x) { x += 2; });
  const PilotGains half = between(gains, other, 0.5);
  PilotGains::each(other, [](double& x) { x -= 1; });
  std::vector<double> expected;
  PilotGains::each(other, [&](double x) { expected.push_back(x); });
  CHECK_EQ(sizeof(PilotGains), expected.size() * sizeof(double));
  std::size_t i = 0;
  PilotGains::each(half, [&](double x) { CHECK_NEAR(x, expected[i++], 1e-12); });

  model.b(2, 1) = 0;
  CHECK(pilot_gains(model, {}, rule, gains) == Status::singular);
  model.control[2] = kControlIndex.aileron;
  CHECK(pilot_gains(model, {}, rule, gains) == Status::bad_argument);
}

// Numbers linear in mast angle and speed come back as they are between points, and stay at the ends of a row.
TEST(pilot_schedule_is_linear_between_its_points) {
  PilotSchedule schedule;
  CHECK(schedule.is_empty());
  const auto pitch = [](double mast, double speed) { return 0.3 - 0.01 * mast + 0.002 * speed; };
  for (const double mast : {0.0, 60.0, 90.0})
    for (const double speed : {mast, mast + 20, mast + 50}) {
      PilotGains point{};
      point.mast_deg = mast;
      point.speed = speed;
      point.pitch = pitch(mast, speed);
      schedule.add(point);
    }
  for (const double mast : {0.0, 17.0, 60.0, 72.0, 90.0})
    for (const double speed : {60.0, 65.0, 70.0}) {
      const PilotGains gains = schedule.at(mast, speed);
      CHECK_NEAR(gains.mast_deg, mast, 1e-12);
      // Rows of other mast angles may end before: held there.
      const double held = gains.speed;
      CHECK_NEAR(gains.pitch, pitch(mast, held), 1e-12);
    }
  CHECK_NEAR(schedule.at(60, 75).speed, 75, 1e-12);
  CHECK_NEAR(schedule.at(60, 75).pitch, pitch(60, 75), 1e-12);
  CHECK_EQ(schedule.at(60, 10).speed, 60);
  CHECK_EQ(schedule.at(0, 300).speed, 50);
  CHECK_EQ(schedule.at(120, 100).mast_deg, 90);
  CHECK_EQ(schedule.at(-10, 20).mast_deg, 0);
  CHECK_NEAR(schedule.at(45, 40).speed, 0.25 * 40 + 0.75 * 60, 1e-12);
}
