#include "cli/chosen_model.hpp"

namespace tiltrotor::cli {

namespace {

void put_airframe(const LinearModel<double>& model, VehicleMatrices& m) {
  m.shape.states = model.states;
  m.shape.inputs = model.controls;
  for (int j = 0; j < model.controls; ++j) m.shape.input[j] = model.control[j];
  for (int i = 0; i < model.states; ++i) {
    m.shape.state[i] = model.state[i];
    for (int j = 0; j < model.states; ++j) m.a(i, j) = model.a(i, j);
    for (int j = 0; j < model.controls; ++j) m.b(i, j) = model.b(i, j);
  }
}

}  // namespace

ChosenModel::ChosenModel(const Arguments& arguments, const Options& options)
    : rigid_(wants_rigid(arguments)),
      order_(reduction_order(arguments)),
      controls_(control_set(arguments)),
      scas_(wants_scas(arguments)),
      feedback_(arguments, options, scas_),
      outputs_(chosen_outputs(arguments)) {
  for (const NamedOutput& output : outputs_)
    if (output.reading < 0) airframe_.push_back(output);
}

Status ChosenModel::find(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
                         bool with_outputs, Analyses& work, ShownModel& shown) {
  Controls<double> at = u;
  const SystemFlight<double> flight = governed(c, x, at, scas_);
  const bool reads = with_outputs || !outputs_.empty();
  if (c.setup.options.governor == Governor::off && !scas_) {
    OutputMatrices* const outputs = reads ? instruments_.get() : nullptr;
    Status status = find_airframe_model(c, x, u, outputs, work);
    if (status == Status::ok) status = find_rows(flight, c, x, at);
    if (status == Status::ok && rigid_) status = reduce_to_rigid(*model_, order_, outputs, &rows_);
    shown = ShownModel(*model_);
    if (status != Status::ok) return status;
    put_airframe(*model_, *matrices_);
    if (reads) show_outputs(*outputs, shown);
    return status;
  }
  VehicleOutputs* const outputs = reads ? governed_instruments_.get() : nullptr;
  Status status = feedback_.linearize_governed(c, x, u, controls_, work, *matrices_, scas_, outputs);
  if (status == Status::ok) status = find_rows(flight, c, x, at);
  if (status == Status::ok && rigid_) status = reduce_to_rigid(*matrices_, order_, outputs, &rows_);
  shown = ShownModel(*matrices_, x, flight.state, at, flight.vehicle.commands);
  if (status == Status::ok && reads) show_outputs(*outputs, shown);
  return status;
}

Status ChosenModel::find_airframe_model(const Configuration<double>& c, const State<double>& x,
                                        const Controls<double>& u, OutputMatrices* outputs, Analyses& work) {
  if (feedback_.is_given()) return feedback_.linearize(c, x, u, controls_, work, *model_, outputs);
  const Status status = linearize(c, x, u, controls_, work, *model_);
  return status == Status::ok && outputs != nullptr ? linearize_outputs(c, x, u, controls_, work, *outputs)
                                                    : status;
}

// Outputs that no instrument reads, of the model found last.
Status ChosenModel::find_rows(const SystemFlight<double>& flight, const Configuration<double>& c,
                              const State<double>& x, const Controls<double>& u) {
  return airframe_.empty() ? Status::ok
                           : feedback_.linearize_rows(flight, c, x, u, controls_, scas_, airframe_, rows_);
}

// All that instruments read, or what was chosen.
template <class Instrumental>
void ChosenModel::show_outputs(const Instrumental& found, ShownModel& shown) const {
  if (outputs_.empty()) return shown.add_outputs(found);
  int row = 0;
  for (const NamedOutput& output : outputs_) {
    if (output.reading >= 0) shown.add_output(output, found, output.reading);
    if (output.reading < 0) shown.add_output(output, rows_, row++);
  }
}

ShownModel ChosenModel::names(const Options& options) const {
  const auto matrices = std::make_unique<VehicleMatrices>();
  matrices->shape = governed_shape(options, controls_, scas_);
  if (rigid_) keep_slow_states(matrices->shape);
  ShownModel shown(*matrices, {}, {}, {}, {});
  shown.name_outputs(outputs_);
  return shown;
}

void ChosenModel::tell(LinearSettings& settings) const {
  settings.switches.emplace_back("reduce", reduce_word(rigid_, order_));
  settings.switches.emplace_back("feedback", feedback_.name());
  settings.switches.emplace_back("scas", scas_ ? "on" : "off");
}

}  // namespace tiltrotor::cli
