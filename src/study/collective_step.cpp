#include "study/collective_step.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>

namespace tiltrotor::study {

namespace {

void require(Status status) {
  if (status != Status::ok)
    throw std::runtime_error(std::string("response to collective: ") + status_text(status));
}

}  // namespace

Motion motion_of(const State<double>& x) {
  const double sp = std::sin(x.pitch);
  const double cp = std::cos(x.pitch);
  const double forward = x.velocity.x * cp + x.velocity.z * sp;
  const double climb = x.velocity.x * sp - x.velocity.z * cp;
  return {climb, forward, degrees(x.rates.y), degrees(x.pitch)};
}

Simulation<double> collective_step(const Configured& c, const Trimmed& trim, double step_s) {
  Simulation<double> flight;
  require(start(c, trim.state, trim.controls, step_s, Integrator::rk4, flight));
  require(add_input(flight, {InputShape::step, kControlIndex.collective, kRadPerDeg<double>, 0.0, 0.0}));
  return flight;
}

std::vector<Motion> motion_after_step(const Configured& c, const Trimmed& trim, double step_s) {
  static const auto work = std::make_unique<SimulationWorkspace<double>>();
  Simulation<double> flight = collective_step(c, trim, step_s);
  const long record_steps = std::lround(kStepRecordEvery / step_s);
  const long steps = std::lround(kStepDuration / step_s);
  std::vector<Motion> motion;
  for (long k = 0; k <= steps; ++k) {
    if (k % record_steps == 0) motion.push_back(motion_of(flight.state));
    if (k < steps) require(advance(c, *work, flight));
  }
  return motion;
}

}  // namespace tiltrotor::study
