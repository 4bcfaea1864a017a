// Flight through the vertical: against steps with the attitude as nine direction cosines, on the same equations of
// motion, and geometry of the conversions.
#include <algorithm>

#include "analysis_case.hpp"

using namespace analysis_case;

namespace {

using V = Vec3<double>;
SimulationWorkspace<double> work;

Options realtime() {
  Options options;
  options.grid = BladeGrid::realtime;
  options.position_states = true;
  return options;
}

// Attitude as a matrix, earth to body, by rows; its rate is -w x each column.
struct Cosines {
  V row[3];
};
Cosines of_angles(double roll, double pitch, double yaw) {
  const double cr = std::cos(roll), sr = std::sin(roll), cp = std::cos(pitch), sp = std::sin(pitch);
  const double cy = std::cos(yaw), sy = std::sin(yaw);
  // Product of the three turns, yaw first.
  return {{V{cp * cy, cp * sy, -sp}, V{sr * sp * cy - cr * sy, sr * sp * sy + cr * cy, sr * cp},
           V{cr * sp * cy + sr * sy, cr * sp * sy - sr * cy, cr * cp}}};
}
Cosines plus(const Cosines& a, double h, const Cosines& b) {
  Cosines c;
  for (int k = 0; k < 3; ++k) c.row[k] = a.row[k] + h * b.row[k];
  return c;
}
Cosines rate(const Cosines& a, const V& w) {
  // d(row_x)/dt = r row_y - q row_z, ..
  return {
      {w.z * a.row[1] - w.y * a.row[2], w.x * a.row[2] - w.z * a.row[0], w.y * a.row[0] - w.x * a.row[1]}};
}

// The state but for its angles, and the attitude beside it.
struct Whole {
  State<double> x;
  Cosines attitude;
};
State<double> plus(const State<double>& a, double h, const State<double>& b) {
  double x[state_count], y[state_count];
  flatten(a, x);
  flatten(b, y);
  for (int i = 0; i < state_count; ++i) x[i] += h * y[i];
  State<double> c;
  unflatten(x, c);
  return c;
}
Whole plus(const Whole& a, double h, const Whole& b) {
  return {plus(a.x, h, b.x), plus(a.attitude, h, b.attitude)};
}
Whole rates_of(const Configuration<double>& c, const Controls<double>& u, const Whole& w) {
  State<double> at = w.x, xdot;
  at.roll = std::atan2(w.attitude.row[1].z, w.attitude.row[2].z);
  at.pitch = std::asin(std::fmax(-1, std::fmin(1, -w.attitude.row[0].z)));
  at.yaw = std::atan2(w.attitude.row[0].y, w.attitude.row[0].x);
  derivative(c, at, u, xdot);
  xdot.roll = xdot.pitch = xdot.yaw = 0;
  return {xdot, rate(w.attitude, w.x.rates)};
}
Whole rk4(const Configuration<double>& c, const Controls<double>& u, const Whole& w, double h) {
  const Whole k1 = rates_of(c, u, w), k2 = rates_of(c, u, plus(w, h / 2, k1));
  const Whole k3 = rates_of(c, u, plus(w, h / 2, k2)), k4 = rates_of(c, u, plus(w, h, k3));
  return plus(plus(plus(plus(w, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
}

double difference(const Cosines& a, const Cosines& b) {
  double worst = 0;
  for (int k = 0; k < 3; ++k) {
    const V d = a.row[k] - b.row[k];
    worst = std::max(worst, std::sqrt(dot(d, d)));
  }
  return worst;
}

}  // namespace

TEST(steep_angles_and_cosines_are_inverse) {
  for (double roll = -3; roll < 3.1; roll += 0.7) {
    for (const double pitch : {-kPi<double> / 2, -1.57, -1.2, 0.0, 0.5, 1.5, 1.5707, kPi<double> / 2}) {
      for (double yaw = -3; yaw < 3.1; yaw += 0.9) {
        const Rotation<double> c = earth_to_body(EulerAngles<double>{roll, pitch, yaw});
        const Cosines by_hand = of_angles(roll, pitch, yaw);
        CHECK_LT(difference({{c.row_x, c.row_y, c.row_z}}, by_hand), 1e-15);
        const EulerAngles<double> back = euler_angles(c, roll);
        CHECK_LT(difference(of_angles(back.roll, back.pitch, back.yaw), by_hand), 1e-12);
        if (std::fabs(pitch) < 1.5) CHECK_NEAR(back.pitch, pitch, 1e-14);
      }
    }
  }
}

// A steady turn about a fixed axis: s = tan(angle/4) axis, and the cosines are Rodrigues' formula.
TEST(steep_turns_follow_rodrigues) {
  const V axis = (1 / std::sqrt(14.0)) * V{1, -2, 3};
  const Rotation<double> start = earth_to_body(EulerAngles<double>{0.3, 1.4, -2});
  for (const double angle : {0.01, 0.5, 2.0, 4.0}) {
    const V s = std::tan(angle / 4) * axis;
    const Rotation<double> c = turned_by(s, start);
    const auto by_formula = [&](const V& a) {  // axes turn by the angle, components by minus it
      return std::cos(angle) * a - std::sin(angle) * cross(axis, a) +
             ((1 - std::cos(angle)) * dot(axis, a)) * axis;
    };
    const V expected = by_formula({start.row_x.z, start.row_y.z, start.row_z.z});
    CHECK_NEAR(c.row_x.z, expected.x, 1e-14);
    CHECK_NEAR(c.row_y.z, expected.y, 1e-14);
    CHECK_NEAR(c.row_z.z, expected.z, 1e-14);
    // s' at a rate w about the axis is w/(4 cos^2(angle/4)) along it.
    const V rate = turn_rate(s, 0.7 * axis);
    const double size = 0.7 / (4 * square(std::cos(angle / 4)));
    CHECK_NEAR(rate.x, size * axis.x, 1e-14);
    CHECK_NEAR(rate.y, size * axis.y, 1e-14);
    CHECK_NEAR(rate.z, size * axis.z, 1e-14);
  }
}

// The rate of a turn about any axis, by a small step: the axes go on turning at w, C' = -w x C.
TEST(steep_turn_rate_is_that_of_the_axes) {
  const Rotation<double> start = earth_to_body(EulerAngles<double>{0.3, 1.4, -2});
  const double h = 1e-5;
  for (const V& s : {V{0.1, -0.2, 0.3}, V{-0.4, 0.1, 0.2}}) {
    for (const V& w : {V{1, 0.5, -0.7}, V{-0.3, 2, 0.4}}) {
      const V rate = turn_rate(s, w);
      const Rotation<double> ahead = turned_by(s + h * rate, start), behind = turned_by(s - h * rate, start);
      const Rotation<double> now = turned_by(s, start);
      const auto column = [](const Rotation<double>& c) { return V{c.row_x.y, c.row_y.y, c.row_z.y}; };
      const V found = (1 / (2 * h)) * (column(ahead) - column(behind));
      const V expected = -1.0 * cross(w, column(now));
      CHECK_NEAR(found.x, expected.x, 1e-9);
      CHECK_NEAR(found.y, expected.y, 1e-9);
      CHECK_NEAR(found.z, expected.z, 1e-9);
    }
  }
}

// A pull-up over the vertical and on its back, with bank and heading on the way. The other route: nine direction
// cosines, steps of a tenth.
TEST(steep_flight_goes_through_the_vertical) {
  const Configuration<double> c = configuration(90, realtime());
  const TrimResult<double> r = trimmed(c, level(110));
  State<double> x = r.state;
  x.pitch = 1.25;
  x.roll = 0.15;
  x.yaw = 2;
  x.rates = {0.1, 1.1, -0.05};
  Controls<double> u = r.controls;
  u.long_stick -= 2.5;
  for (const Integrator integrator : {Integrator::rk3, Integrator::rk4}) {
    Simulation<double> s;
    CHECK(start(c, x, u, 0.0025, integrator, s) == Status::ok);
    Whole exact{x, of_angles(x.roll, x.pitch, x.yaw)};
    exact.x.roll = exact.x.pitch = exact.x.yaw = 0;
    double steepest = 0, upside_down = 1;
    for (int k = 0; k < 320; ++k) {
      if (!CHECK(advance(c, work, s) == Status::ok)) return;
      for (int j = 0; j < 10; ++j) exact = rk4(c, u, exact, 0.00025);
      steepest = std::max(steepest, std::fabs(s.state.pitch));
      upside_down = std::min(upside_down, std::cos(s.state.roll));
    }
    const Cosines found = of_angles(s.state.roll, s.state.pitch, s.state.yaw);
    const double tolerance = integrator == Integrator::rk3 ? 2e-5 : 2e-6;
    CHECK_LT(difference(found, exact.attitude), tolerance);
    CHECK_NEAR(s.state.velocity.x, exact.x.velocity.x, 30 * tolerance);
    CHECK_NEAR(s.state.velocity.z, exact.x.velocity.z, 30 * tolerance);
    CHECK_NEAR(s.state.position.z, exact.x.position.z, 30 * tolerance);
    CHECK_NEAR(s.state.position.x, exact.x.position.x, 30 * tolerance);
    CHECK_LT(1.4, steepest);
    CHECK_LT(upside_down, -0.5);  // over the top
  }
}

// Straight over the top in the plane of symmetry, which meets 90 deg exactly: heading and bank turn round, nothing else.
TEST(steep_flight_in_the_plane_of_symmetry_turns_the_heading_round) {
  const Configuration<double> c = configuration(90, realtime());
  const TrimResult<double> r = trimmed(c, level(110));
  State<double> x = r.state;
  x.pitch = 1.5;
  x.rates.y = 1;
  Simulation<double> s;
  CHECK(start(c, x, r.controls, 0.005, Integrator::rk4, s) == Status::ok);
  for (int k = 0; k < 60; ++k) CHECK(advance(c, work, s) == Status::ok);
  CHECK_LT(s.state.pitch, 1.56);
  CHECK_NEAR(std::fabs(s.state.roll), kPi<double>, 1e-6);
  CHECK_NEAR(std::fabs(s.state.yaw), kPi<double>, 1e-6);
  CHECK_NEAR(s.state.velocity.y, 0, 1e-6);
}

// Below the limit nothing differs from Euler angles but rounding and the method's error.
TEST(steep_flight_meets_the_other_at_its_beginning) {
  const Configuration<double> c = configuration(90, realtime());
  const TrimResult<double> r = trimmed(c, level(110));
  State<double> below = r.state;
  below.pitch = 0.9999;
  below.roll = 0.4;
  below.rates = {0.2, -0.3, 0.1};
  State<double> above = below;
  above.pitch = 1.0001;
  State<double> after[2];
  for (int k = 0; k < 2; ++k) {
    Simulation<double> s;
    CHECK(start(c, k == 0 ? below : above, r.controls, 0.001, Integrator::rk4, s) == Status::ok);
    CHECK(advance(c, work, s) == Status::ok);
    after[k] = s.state;
  }
  CHECK_NEAR(after[1].pitch - after[0].pitch, 0.0002, 1e-6);
  CHECK_NEAR(after[1].roll, after[0].roll, 1e-6);
  CHECK_NEAR(after[1].yaw, after[0].yaw, 1e-6);
}
