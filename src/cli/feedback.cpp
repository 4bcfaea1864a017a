#include "cli/feedback.hpp"

#include <cmath>

#include "cli/output_names.hpp"

namespace tiltrotor::cli {

namespace {

ReadingNames reading_names(const Options& options, const VehicleShape& shape) {
  ReadingNames names;
  for (int i = 0; i < shape.states; ++i) {
    names.name.emplace_back(vehicle_variable(shape.state[i]).name);
    names.reading.push_back(shape.state[i]);
  }
  if (options.azimuth != AzimuthMode::averaged) {
    names.remark = "; outputs go with azimuth=averaged alone";
    return names;
  }
  for (int k = 0; k < OutputMatrices::outputs; ++k) {
    names.name.emplace_back(kOutputNames[k].name);
    names.reading.push_back(vehicle_state_count + k);
  }
  return names;
}

// The law at y_0.
FeedbackPoint<double> reference(const Configuration<double>& c, const State<double>& x,
                                const Controls<double>& u) {
  return {c.setup.mast_deg, x.velocity - u.gust, {}};
}

// Of the first columns, which are kAllControls, those of the set; what follows moves up. Returns how many are left.
template <class M>
int keep_columns(const ControlSet& set, int rows, int columns, M& matrix) {
  for (int i = 0; i < rows; ++i) {
    double kept[vehicle_input_count];
    int count = 0;
    for (int k = 0; k < set.count; ++k) kept[count++] = matrix(i, set.index[k]);
    for (int j = control_count; j < columns; ++j) kept[count++] = matrix(i, j);
    for (int j = 0; j < columns; ++j) matrix(i, j) = j < count ? kept[j] : 0;
  }
  return set.count + columns - control_count;
}

}  // namespace

OptionList feedback_option() {
  return {{"--feedback", "FILE",
           "closes the loop u = u_trim - K (y - y_trim): CSV with a row for every input and a\n"
           "column for every state or output, by the names and units of linearize; mast_deg and\n"
           "speed_mps beside them schedule it"}};
}

struct Feedback::Work {
  OutputMatrices outputs;
  VehicleOutputs vehicle;
  ClosedControlsWorkspace<double> search;
  ClosedControls<double> closed;
};

Feedback::Feedback(const Arguments& arguments, const Options& options, bool scas)
    : Feedback(arguments, options, governed_shape(options, kAllControls, scas)) {}
Feedback::Feedback(const Arguments& arguments, const Options& options, const VehicleShape& shape)
    : Feedback(arguments, reading_names(options, shape)) {}

Feedback::Feedback(const Arguments& arguments, const ReadingNames& names) {
  if (!arguments.given("--feedback")) return;
  name_ = arguments.text("--feedback", "");
  file_ = std::make_shared<FeedbackFile>(name_, names);
  work_ = std::make_shared<Work>();
}

std::vector<FeedbackGain> Feedback::gains(const Configuration<double>& c, const State<double>& x,
                                          const Controls<double>& u) const {
  std::vector<FeedbackGain> out;
  if (!is_given()) return out;
  const FeedbackPoint<double> at = reference(c, x, u);
  const GainShares<double> shares = gain_shares(law(), at.mast_deg, std::sqrt(dot(at.air, at.air)));
  for (int i = 0; i < law().inputs; ++i)
    for (int k = 0; k < law().readings; ++k) {
      const int reading = law().reading[k];
      const char* const output = is_instrument(reading) ? kOutputNames[reading - vehicle_state_count].name
                                                        : vehicle_variable(reading).name;
      out.push_back({kControlVariables[law().input[i]].name, output, shares.gain(law(), i, k)});
    }
  return out;
}

template <class Outputs>
Status Feedback::find_controls(const FeedbackPoint<double>& at, const VehicleShape& shape,
                               const Outputs* outputs) const {
  return close_controls(
      law(), at, shape, [outputs](int i, int j) { return outputs->c(i, j); },
      [outputs](int i, int j) { return outputs->d(i, j); }, work_->search, work_->closed);
}

Status Feedback::linearize(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
                           const ControlSet& columns, Analyses& work, LinearModel<double>& model,
                           OutputMatrices* outputs, const FeedbackPoint<double>* at, double azimuth) const {
  Status status = tiltrotor::linearize(c, x, u, kAllControls, work, model, azimuth);
  OutputMatrices* const seen = outputs != nullptr          ? outputs
                               : law().reads_instruments() ? &work_->outputs
                                                           : nullptr;
  if (status == Status::ok && seen != nullptr) status = linearize_outputs(c, x, u, kAllControls, work, *seen);
  if (status != Status::ok) return status;
  VehicleShape shape{};
  shape.states = model.states;
  for (int i = 0; i < model.states; ++i) shape.state[i] = model.state[i];
  status = find_controls(at != nullptr ? *at : reference(c, x, u), shape, seen);
  if (status != Status::ok) return status;
  close_rows(work_->closed, model.states, model.states, model.a, model.b);
  model.controls = keep_columns(columns, model.states, control_count, model.b);
  for (int j = 0; j < columns.count; ++j) {
    model.control[j] = columns.index[j];
    model.u[j] = model.u[columns.index[j]];
  }
  if (outputs == nullptr) return status;
  close_rows(work_->closed, OutputMatrices::outputs, model.states, outputs->c, outputs->d);
  keep_columns(columns, OutputMatrices::outputs, control_count, outputs->d);
  return status;
}

Status Feedback::linearize_flight(const Configuration<double>& c, const SystemFlight<double>& flight,
                                  const State<double>& x, const Controls<double>& u,
                                  const ControlSet& columns, CommandColumns commands, Analyses& work,
                                  VehicleMatrices& matrices, VehicleOutputs* outputs,
                                  const FeedbackPoint<double>* at, double azimuth) const {
  VehicleShape& shape = matrices.shape;
  const ControlSet& all = is_given() ? kAllControls : columns;
  const bool reads = is_given() && law().reads_instruments();
  VehicleOutputs* const seen = outputs != nullptr ? outputs : reads ? &work_->vehicle : nullptr;
  Status status = cli::linearize_flight(c, flight, x, u, all, commands, work, matrices, azimuth);
  if (status == Status::ok && seen != nullptr)
    status = linearize_vehicle_outputs(flight, c, x, u, shape, *seen, azimuth);
  if (status != Status::ok || !is_given()) return status;
  status = find_controls(at != nullptr ? *at : reference(c, x, u), shape, seen);
  if (status != Status::ok) return status;
  close_rows(work_->closed, shape.states, shape.states, matrices.a, matrices.b);
  if (outputs != nullptr) {
    close_rows(work_->closed, VehicleOutputs::outputs, shape.states, outputs->c, outputs->d);
    keep_columns(columns, VehicleOutputs::outputs, shape.inputs, outputs->d);
  }
  const int inputs = keep_columns(columns, shape.states, shape.inputs, matrices.b);
  for (int j = 0; j < columns.count; ++j) shape.input[j] = shape.input[columns.index[j]];
  for (int j = columns.count; j < inputs; ++j)
    shape.input[j] = shape.input[j + control_count - columns.count];
  shape.inputs = inputs;
  return status;
}

Status Feedback::linearize_governed(const Configuration<double>& c, const State<double>& x,
                                    const Controls<double>& u, const ControlSet& columns, Analyses& work,
                                    VehicleMatrices& matrices, bool scas, VehicleOutputs* outputs) const {
  Controls<double> at = u;
  const SystemFlight<double> flight = governed(c, x, at, scas);
  return linearize_flight(c, flight, x, at, columns, governed_commands(c.setup.options), work, matrices,
                          outputs);
}

Status Feedback::linearize_rows(const SystemFlight<double>& flight, const Configuration<double>& c,
                                const State<double>& x, const Controls<double>& u, const ControlSet& columns,
                                bool scas, const std::vector<NamedOutput>& outputs, VehicleRows& rows) const {
  const VehicleShape open = governed_shape(c.setup.options, is_given() ? kAllControls : columns, scas);
  std::vector<AirframeOutput> wanted;
  for (const NamedOutput& output : outputs) wanted.push_back(output.output);
  const Status status = linearize_airframe_outputs(flight, c, x, u, open, wanted, rows);
  if (status != Status::ok || !is_given()) return status;
  close_rows(work_->closed, rows.outputs, open.states, rows.c, rows.d);
  keep_columns(columns, rows.outputs, open.inputs, rows.d);
  return status;
}

}  // namespace tiltrotor::cli
