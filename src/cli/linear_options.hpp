// What goes into a linear model, chosen on the command line.
#pragma once

#include "cli/arguments.hpp"
#include "tiltrotor/analysis/linear/linear_model.hpp"

namespace tiltrotor::cli {

OptionList reduce_option();
bool wants_rigid(const Arguments& arguments);

OptionList control_set_option();
const ControlSet& control_set(const Arguments& arguments);

// The residualised model in place of the full one. Status as residualise().
Status reduce_to_rigid(LinearModel<double>& model);

}  // namespace tiltrotor::cli
