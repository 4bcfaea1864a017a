#include "study/trim_sensitivity.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>

#include "study/linear_models.hpp"
#include "tiltrotor/analysis/trim/trim_motion.hpp"

namespace tiltrotor::study {

namespace {

using T = SensitivityWorkspace<double>::T;

struct WorkAreas {
  SensitivityWorkspace<double> sensitivity;
  ConfigurationSensitivity<double> rates;
  TrimMotionWorkspace<double> trim;
};
WorkAreas& work() {
  static const auto areas = std::make_unique<WorkAreas>();
  return *areas;
}

void require(Status status) {
  if (status != Status::ok) throw std::runtime_error(std::string("trim sensitivity: ") + status_text(status));
}

}  // namespace

TrimNumbers trim_numbers(const Trimmed& trim) {
  return {degrees(trim.state.pitch), stick_position(trim), degrees(trim.collective_root),
          total_power_kw(trim)};
}

std::vector<TrimNumbers> trim_sensitivity(const Configured& c, const Trimmed& trim,
                                          const ParameterSet& parameters) {
  if (parameters.count > kParameterDirections)
    throw std::logic_error("trim sensitivity: too many parameters");
  WorkAreas& w = work();
  require(configuration_sensitivity(c, trim.state, trim.controls, parameters, w.sensitivity, w.rates));
  const Linear model = linear_model(c, trim);
  SteadyFlight<double> flight{};
  flight.speed = std::sqrt(dot(trim.state.velocity, trim.state.velocity));
  require(prepare_trim_motion(c, flight, trim.state, model, w.trim));

  // State, controls and configuration move together: one more pass gives the power.
  T x[state_count];
  T u[control_count];
  double state[state_count];
  double control[control_count];
  flatten(trim.state, state);
  flatten(trim.controls, control);
  for (int i = 0; i < state_count; ++i) x[i] = T(state[i]);
  for (int i = 0; i < control_count; ++i) u[i] = T(control[i]);
  T by[kParameterDirections];
  for (int k = 0; k < parameters.count; ++k) {
    by[k] = T::variable(0.0, k);
    double rates[state_count];
    for (int i = 0; i < state_count; ++i) rates[i] = w.rates.rates(i, k);
    TrimMotion<double> motion;
    require(trim_motion(rates, w.trim, motion));
    flatten(motion.x, state);
    flatten(motion.u, control);
    for (int i = 0; i < state_count; ++i) x[i].d.set(k, state[i]);
    for (int i = 0; i < control_count; ++i) u[i].d.set(k, control[i]);
  }
  SensitivityWorkspace<double>& s = w.sensitivity;
  moved_configuration(c, parameters.parameter, by, parameters.count, s.configuration);
  unflatten(x, s.x);
  unflatten(u, s.u);
  evaluate_aircraft(s.configuration, s.x, s.u, s.derivative, s.evaluation);
  const T power = s.configuration.setup.rotor_speed *
                  (s.evaluation.rotor[right].loads.torque + s.evaluation.rotor[left].loads.torque);

  std::vector<TrimNumbers> out;
  for (int k = 0; k < parameters.count; ++k)
    out.push_back({degrees(s.x.pitch.d.get(k)), s.u.long_stick.d.get(k), degrees(s.u.collective.d.get(k)),
                   kWatt * power.d.get(k)});
  return out;
}

}  // namespace tiltrotor::study
