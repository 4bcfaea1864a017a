// What goes into a linear model, chosen on the command line.
#pragma once

#include "cli/arguments.hpp"
#include "library/vehicle_outputs.hpp"
#include "tiltrotor/analysis/linear/vehicle_reduction.hpp"

namespace tiltrotor::cli {

OptionList reduce_option();
bool wants_rigid(const Arguments& arguments);
Reduction reduction_order(const Arguments& arguments);  // of --reduce rigid and quasi_steady
const char* reduce_word(bool rigid, Reduction order);   // as given to --reduce

// Throws UsageError for position_states=on: no linear model has rows of them.
void require_no_positions(const Options& options, const Arguments& arguments);

OptionList control_set_option();
const ControlSet& control_set(const Arguments& arguments);

// The rigid-body model in place of the full one. Status as rigid_model().
Status reduce_to_rigid(LinearModel<double>& model, Reduction order);
// The same with outputs of the full model beside it, where there are some: the first columns of C are then those of the
// rigid body.
Status reduce_to_rigid(LinearModel<double>& model, Reduction order, OutputMatrices* outputs,
                       VehicleRows* rows = nullptr);
// Of a model with systems, whose states stay. Status as reduce_vehicle().
Status reduce_to_rigid(VehicleMatrices& model, Reduction order, VehicleOutputs* outputs = nullptr,
                       VehicleRows* rows = nullptr);

}  // namespace tiltrotor::cli
