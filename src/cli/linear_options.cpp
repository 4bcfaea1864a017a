#include "cli/linear_options.hpp"

#include <memory>

#include "tiltrotor/analysis/linear/reduction.hpp"

namespace tiltrotor::cli {

OptionList reduce_option() {
  return {{"--reduce", "KIND", "none, or rigid: the 8 rigid-body states, rotors quasi-steady (none)"}};
}

bool wants_rigid(const Arguments& arguments) {
  return arguments.choice("--reduce", "none", {"none", "rigid"}) == 1;
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

Status reduce_to_rigid(LinearModel<double>& model) {
  const auto work = std::make_unique<ResidualisationWorkspace<double>>();
  const auto reduced = std::make_unique<LinearModel<double>>();
  const Status status = residualise(model, *work, *reduced);
  model = *reduced;
  return status;
}

}  // namespace tiltrotor::cli
