// A linear model as it is written: names and units of rows and columns, rounding taken for what it is.
#pragma once

#include <vector>

#include "cli/named_outputs.hpp"
#include "cli/output_names.hpp"
#include "library/vehicle_outputs.hpp"

namespace tiltrotor::cli {

class ShownModel {
 public:
  ShownModel() = default;
  explicit ShownModel(const LinearModel<double>& model);
  // At (x, s, u) and the commands of `v`.
  ShownModel(const VehicleMatrices& matrices, const State<double>& x, const SystemState<double>& s,
             const Controls<double>& u, const Commands<double>& commands);

  // The outputs of the same point beside it; none before.
  void add_outputs(const OutputMatrices& found);
  void add_outputs(const VehicleOutputs& found);
  // One more, of a row there.
  void add_output(const NamedOutput& which, const OutputMatrices& found, int row);
  void add_output(const NamedOutput& which, const VehicleOutputs& found, int row);
  void add_output(const NamedOutput& which, const VehicleRows& found, int row);
  // Names without numbers; none: those of all instruments.
  void name_outputs(const std::vector<NamedOutput>& all);

  int states = 0, controls = 0, outputs = 0;
  std::vector<double> x, u, y;

  double a(int i, int j) const { return a_[place(i, states, j)]; }
  double b(int i, int j) const { return b_[place(i, controls, j)]; }
  double c(int i, int j) const { return c_[place(i, states, j)]; }
  double d(int i, int j) const { return d_[place(i, controls, j)]; }
  const char* state_name(int i) const { return state(i).name; }
  const char* state_unit(int i) const { return state(i).unit(); }
  const char* control_name(int j) const { return control(j).name; }
  const char* control_unit(int j) const { return control(j).unit(); }
  // All of the instruments in their order, or those that were added one by one.
  const char* output_name(int i) const {
    return named_.empty() ? kOutputNames[i].name : named(i).name.c_str();
  }
  const char* output_unit(int i) const {
    return named_.empty() ? kOutputNames[i].unit : named(i).unit.c_str();
  }

 private:
  static std::size_t place(int row, int width, int column) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
  template <class Outputs>
  void add(const Outputs& found, int row);
  const NamedOutput& named(int i) const { return named_[static_cast<std::size_t>(i)]; }
  const Variable& state(int i) const { return vehicle_variable(state_[static_cast<std::size_t>(i)]); }
  const Variable& control(int j) const { return vehicle_input(control_[static_cast<std::size_t>(j)]); }

  std::vector<int> state_, control_;
  std::vector<NamedOutput> named_;
  std::vector<double> a_, b_, c_, d_;
};

}  // namespace tiltrotor::cli
