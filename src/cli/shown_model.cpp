#include "cli/shown_model.hpp"

#include <cmath>

#include "text/rounding.hpp"

namespace tiltrotor::cli {

using text::without_rounding;

ShownModel::ShownModel(const LinearModel<double>& exact) : states(exact.states), controls(exact.controls) {
  const LinearModel<double> model = without_rounding(exact);
  state_.assign(model.state, model.state + states);
  control_.assign(model.control, model.control + controls);
  x.assign(model.x, model.x + states);
  u.assign(model.u, model.u + controls);
  for (int i = 0; i < states; ++i) {
    for (int j = 0; j < states; ++j) a_.push_back(model.a(i, j));
    for (int j = 0; j < controls; ++j) b_.push_back(model.b(i, j));
  }
}

void ShownModel::add_outputs(const OutputMatrices& found) {
  for (int i = 0; i < OutputMatrices::outputs; ++i) add(found, i);
}
void ShownModel::add_outputs(const VehicleOutputs& found) {
  for (int i = 0; i < VehicleOutputs::outputs; ++i) add(found, i);
}
void ShownModel::add_output(const NamedOutput& which, const OutputMatrices& found, int row) {
  named_.push_back(which);
  add(found, row);
}
void ShownModel::add_output(const NamedOutput& which, const VehicleOutputs& found, int row) {
  named_.push_back(which);
  add(found, row);
}
void ShownModel::add_output(const NamedOutput& which, const VehicleRows& found, int row) {
  named_.push_back(which);
  add(found, row);
}

void ShownModel::name_outputs(const std::vector<NamedOutput>& all) {
  named_ = all;
  outputs = all.empty() ? OutputMatrices::outputs : static_cast<int>(all.size());
}

template <class Outputs>
void ShownModel::add(const Outputs& found, int row) {
  constexpr double point_terms = 1;
  double terms = 0;
  const auto state_size = [&](int j) { return state(j).facts().bend; };
  const auto control_size = [&](int j) { return control(j).facts().bend; };
  for (int j = 0; j < states; ++j) terms += std::abs(found.c(row, j)) * state_size(j);
  for (int j = 0; j < controls; ++j) terms += std::abs(found.d(row, j)) * control_size(j);
  y.push_back(without_rounding(found.y[static_cast<std::size_t>(row)], point_terms));
  for (int j = 0; j < states; ++j) c_.push_back(without_rounding(found.c(row, j), terms / state_size(j)));
  for (int j = 0; j < controls; ++j) d_.push_back(without_rounding(found.d(row, j), terms / control_size(j)));
  ++outputs;
}

ShownModel::ShownModel(const VehicleMatrices& m, const State<double>& of_airframe,
                       const SystemState<double>& s, const Controls<double>& of_pilot,
                       const Commands<double>& commands)
    : states(m.shape.states), controls(m.shape.inputs) {
  double all_states[vehicle_state_count], all_inputs[vehicle_input_count];
  flatten(of_airframe, all_states);
  flatten(s, all_states + state_count);
  flatten(of_pilot, all_inputs);
  flatten(commands, all_inputs + control_count);
  state_.assign(m.shape.state, m.shape.state + states);
  control_.assign(m.shape.input, m.shape.input + controls);
  constexpr double point_terms = 1;
  for (const int i : state_) x.push_back(without_rounding(all_states[i], point_terms));
  for (const int j : control_) u.push_back(without_rounding(all_inputs[j], point_terms));
  for (int i = 0; i < states; ++i) {
    double terms = 0;
    const auto state_size = [&](int j) { return state(j).facts().bend; };
    const auto control_size = [&](int j) { return control(j).facts().bend; };
    for (int j = 0; j < states; ++j) terms += std::abs(m.a(i, j)) * state_size(j);
    for (int j = 0; j < controls; ++j) terms += std::abs(m.b(i, j)) * control_size(j);
    for (int j = 0; j < states; ++j) a_.push_back(without_rounding(m.a(i, j), terms / state_size(j)));
    for (int j = 0; j < controls; ++j) b_.push_back(without_rounding(m.b(i, j), terms / control_size(j)));
  }
}

}  // namespace tiltrotor::cli
