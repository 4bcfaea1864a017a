#include "study/trim_sensitivity.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>

#include "study/linear_models.hpp"
#include "tiltrotor/analysis/trim/trim_equations.hpp"
#include "tiltrotor/math/algebra/lu.hpp"

namespace tiltrotor::study {

namespace {

using T = SensitivityWorkspace<double>::T;
template <int Columns>
using UnknownMatrix = Matrix<double, kMaxTrimUnknowns, Columns>;
using StateSlopes = std::array<double, state_count>;

struct WorkAreas {
  SensitivityWorkspace<double> sensitivity;
  ConfigurationSensitivity<double> rates;
  TrimEquations<double> equations;
  LU<double, kMaxTrimUnknowns> lu;
};
WorkAreas& work() {
  static const auto areas = std::make_unique<WorkAreas>();
  return *areas;
}

void require(Status status) {
  if (status != Status::ok) throw std::runtime_error(std::string("trim sensitivity: ") + status_text(status));
}

// d state / d unknown: the unknown itself, and the velocity that follows roll and pitch.
StateSlopes state_slopes(const TrimEquation<double>& unknown, const Trimmed& trim) {
  StateSlopes slopes{};
  if (unknown.state < 0) return slopes;
  slopes[static_cast<std::size_t>(unknown.state)] = 1;
  const bool rolls = unknown.state == kStateIndex.roll;
  if (!rolls && unknown.state != kStateIndex.pitch) return slopes;
  using D = Dual<double, 1>;
  SteadyFlight<double> flight{};
  flight.speed = std::sqrt(dot(trim.state.velocity, trim.state.velocity));
  const D roll = rolls ? D::variable(trim.state.roll, 0) : D(trim.state.roll);
  const D pitch = rolls ? D(trim.state.pitch) : D::variable(trim.state.pitch, 0);
  const Vec3<D> velocity = steady_velocity(flight, roll, pitch);
  slopes[static_cast<std::size_t>(kStateIndex.velocity.x)] = velocity.x.d.get(0);
  slopes[static_cast<std::size_t>(kStateIndex.velocity.y)] = velocity.y.d.get(0);
  slopes[static_cast<std::size_t>(kStateIndex.velocity.z)] = velocity.z.d.get(0);
  return slopes;
}

// d rate / d unknown, from A and B.
double rate_slope(const Linear& model, int row, const TrimEquation<double>& unknown,
                  const StateSlopes& slopes) {
  double sum = 0;
  for (int k = 0; k < model.states; ++k)
    sum += model.a(row, k) * slopes[static_cast<std::size_t>(model.state[k])];
  for (int k = 0; k < model.controls; ++k)
    if (model.control[k] == unknown.control) sum += model.b(row, k);
  return sum;
}

int row_of(const Linear& model, int state) {
  for (int i = 0; i < model.states; ++i)
    if (model.state[i] == state) return i;
  throw std::logic_error("trim sensitivity: a rate without a row in the linear model");
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
  trim_equations(c, w.equations);
  const int n = w.equations.count;

  UnknownMatrix<kMaxTrimUnknowns> by_unknown;
  UnknownMatrix<kParameterDirections> by_parameter;
  std::vector<StateSlopes> slopes;
  for (int j = 0; j < n; ++j) slopes.push_back(state_slopes(w.equations.row[j], trim));
  for (int i = 0; i < n; ++i) {
    const int rate = w.equations.row[i].rate;
    const double scale = w.equations.row[i].rate_scale;
    const int row = row_of(model, rate);
    for (int j = 0; j < n; ++j)
      by_unknown(i, j) =
          scale * rate_slope(model, row, w.equations.row[j], slopes[static_cast<std::size_t>(j)]);
    for (int k = 0; k < parameters.count; ++k) by_parameter(i, k) = -scale * w.rates.rates(rate, k);
  }
  require(lu_factor(by_unknown, n, w.lu));
  UnknownMatrix<kParameterDirections> unknown;  // dz/dp
  require(lu_solve(w.lu, by_parameter, parameters.count, unknown));

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
    for (int j = 0; j < n; ++j) {
      const TrimEquation<double>& row = w.equations.row[j];
      if (row.control >= 0) u[row.control].d.set(k, unknown(j, k));
      for (std::size_t i = 0; i < state_count; ++i)
        x[i].d.set(k, x[i].d.get(k) + slopes[static_cast<std::size_t>(j)][i] * unknown(j, k));
    }
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
