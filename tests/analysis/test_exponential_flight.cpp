// Flights by the exponential step against the classical method of order 4 at a tenth of the step and less.
#include <algorithm>
#include <cmath>

#include "analysis_case.hpp"

using namespace analysis_case;

namespace {

SimulationWorkspace<double> work;

struct Course {
  const char* name;
  double mast, speed;
  int control;
  double by;
};
const Course courses[] = {{"collective", 0, 40, kControlIndex.collective, kDeg},
                          {"hover, lateral stick", 0, 0, kControlIndex.lat_stick, 0.5},
                          {"pedal", 30, 50, kControlIndex.pedal, 0.5},
                          {"stick, airplane", 90, 100, kControlIndex.long_stick, 0.3}};

State<double> flown(const Configuration<double>& c, const TrimResult<double>& r, const Course& course,
                    Integrator integrator, double dt, double duration) {
  Simulation<double> s;
  CHECK(start(c, r.state, r.controls, dt, integrator, s) == Status::ok);
  CHECK(add_input(s, {InputShape::step, course.control, course.by, 0, 0}) == Status::ok);
  for (int k = 0; k < static_cast<int>(std::lround(duration / dt)); ++k)
    if (!CHECK(advance(c, work, s) == Status::ok)) break;
  return s.state;
}

// m/s; deg/s and deg
struct Error {
  double velocity, attitude;
};
Error error(const State<double>& a, const State<double>& b) {
  const auto worst = [](const Vec3<double>& d) {
    return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  };
  const Vec3<double> angles = {a.roll - b.roll, a.pitch - b.pitch, a.yaw - b.yaw};
  return {worst(a.velocity - b.velocity), std::max(worst(a.rates - b.rates), worst(angles)) / kDeg};
}

}  // namespace

// Halving the step divides the error by four, from 40 ms on, where the explicit methods diverge at once.
TEST(response_exponential_flight_has_order_2_up_to_40_ms) {
  Options options;
  options.position_states = true;
  for (const Course& course : courses) {
    const Configuration<double> c = configuration(course.mast, options);
    const TrimResult<double> r = trimmed(c, level(course.speed));
    const State<double> fine = flown(c, r, course, Integrator::rk4, 0.001, 2);
    Error previous{};
    for (const double dt : {0.04, 0.02, 0.01, 0.005}) {
      const State<double> x = flown(c, r, course, Integrator::exponential, dt, 2);
      const Error e = error(x, fine);
      NOTE(course.name << " " << dt * 1000 << " ms: " << e.velocity << " m/s, " << e.attitude
                       << " deg/s or deg");
      CHECK_LT(e.velocity, 1e-3 * (dt / 0.04) * (dt / 0.04) + 1e-6);
      CHECK_LT(e.attitude, 3e-3 * (dt / 0.04) * (dt / 0.04) + 1e-6);
      CHECK_NEAR(x.position.x, fine.position.x, 2e-3 * (dt / 0.04));
      CHECK_NEAR(x.position.z, fine.position.z, 2e-3 * (dt / 0.04));
      if (dt < 0.02 && previous.attitude > 1e-6) CHECK_LT(2.5, previous.attitude / e.attitude);
      previous = e;
    }
  }
}

// Masts on their way make the rates depend on time: the second order stays.
TEST(response_exponential_flight_with_moving_masts) {
  const Configuration<double> still = configuration(30);
  const TrimResult<double> r = trimmed(still, level(50));
  const auto at_end = [&](Integrator integrator, double dt) {
    Configuration<double> c = still;
    ConfigurationSetting<double> setting = c.setup;
    setting.mast_rate = 7.5 * kDeg;
    CHECK(reconfigure(setting, c) == Status::ok);
    MovingConfiguration<double> moving{&c, false, 0, {}, 0};
    Simulation<double> s;
    CHECK(start(c, r.state, r.controls, dt, integrator, s) == Status::ok);
    for (int k = 0; k < static_cast<int>(std::lround(1 / dt)); ++k)
      if (!CHECK(advance_moving(moving, work, s) == Status::ok)) break;
    return s.state;
  };
  const State<double> fine = at_end(Integrator::rk4, 0.001);
  const Error a = error(at_end(Integrator::exponential, 0.02), fine);
  const Error b = error(at_end(Integrator::exponential, 0.01), fine);
  NOTE("20 and 10 ms: " << a.velocity << " " << b.velocity << " m/s, " << a.attitude << " " << b.attitude);
  CHECK_LT(3, a.velocity / b.velocity);
  CHECK_LT(b.velocity, 1e-3);
}
