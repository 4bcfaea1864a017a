#include "cli/linear_options.hpp"

#include <memory>

#include "tiltrotor/analysis/linear/rigid_outputs.hpp"

namespace tiltrotor::cli {

OptionList reduce_option() {
  return {{"--reduce", "KIND",
           "none; rigid: the 8 rigid-body states and those of systems, rotors\n"
           "and wash to first order; quasi_steady: with them in balance (none)"}};
}

namespace {

std::size_t reduce_choice(const Arguments& arguments) {
  return arguments.choice("--reduce", "none", {"none", "rigid", "quasi_steady"});
}

}  // namespace

bool wants_rigid(const Arguments& arguments) { return reduce_choice(arguments) != 0; }

Reduction reduction_order(const Arguments& arguments) {
  return reduce_choice(arguments) == 2 ? Reduction::quasi_steady : Reduction::first_order;
}

const char* reduce_word(bool rigid, Reduction order) {
  return !rigid ? "none" : order == Reduction::first_order ? "rigid" : "quasi_steady";
}

void require_no_positions(const Options& options, const Arguments& arguments) {
  if (options.position_states)
    throw UsageError(arguments.where("--option") +
                     " position_states=on: positions are not in a linear model: nothing hangs on them");
}

OptionList control_set_option() {
  return {{"--control-set", "SET",
           "inceptors: collective, sticks, pedal; blades: blade angles and\n"
           "surfaces; all: both, lateral cyclic and gusts (inceptors)"}};
}

const ControlSet& control_set(const Arguments& arguments) {
  static const ControlSet sets[] = {kInceptors, kBladeControls, kAllControls};
  return sets[arguments.choice("--control-set", "inceptors", {"inceptors", "blades", "all"})];
}

Status reduce_to_rigid(LinearModel<double>& model, Reduction order) {
  return reduce_to_rigid(model, order, nullptr);
}

Status reduce_to_rigid(LinearModel<double>& model, Reduction order, OutputMatrices* outputs,
                       VehicleRows* rows) {
  const auto work = std::make_unique<RigidModelWorkspace<double>>();
  const auto reduced = std::make_unique<LinearModel<double>>();
  const Status status = rigid_model(model, order, *work, *reduced);
  if (status == Status::ok && outputs != nullptr)
    reduce_outputs(model, order, *work, *reduced, OutputMatrices::outputs, outputs->c, outputs->d);
  if (status == Status::ok && rows != nullptr)
    reduce_outputs(model, order, *work, *reduced, rows->outputs, rows->c, rows->d);
  model = *reduced;
  return status;
}

Status reduce_to_rigid(VehicleMatrices& model, Reduction order, VehicleOutputs* outputs, VehicleRows* rows) {
  const auto work = std::make_unique<VehicleReductionWorkspace<double>>();
  const int inputs = model.shape.inputs;
  const Status status = reduce_vehicle(order, model.shape, model.a, model.b, *work);
  if (status == Status::ok && outputs != nullptr)
    reduce_vehicle_outputs(order, inputs, *work, VehicleOutputs::outputs, outputs->c, outputs->d);
  if (status == Status::ok && rows != nullptr)
    reduce_vehicle_outputs(order, inputs, *work, rows->outputs, rows->c, rows->d);
  return status;
}

}  // namespace tiltrotor::cli
