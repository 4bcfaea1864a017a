// Linear models and flights of an aircraft whose rotor speed is governed: option governor of the model.
#pragma once

#include "cli/arguments.hpp"
#include "library/analyses.hpp"
#include "tiltrotor/analysis/flight/right_side.hpp"

namespace tiltrotor::cli {

// A and B at (x, u) of the airframe in a balance of power: the columns of a set, and with a governor the throttles of both
// engines. Without governor and SCAS those of the airframe.
Status linearize_governed(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
                          const ControlSet& columns, Analyses& work, VehicleMatrices& matrices,
                          bool scas = false);
// What its rows and columns are, throttles only with a governor.
VehicleShape governed_shape(const Options& options, const ControlSet& columns, bool scas);

// The augmentation in a linear model.
OptionList scas_option();
bool wants_scas(const Arguments& arguments);

// The same of a flight with systems, as they stand, with the columns of these commands.
enum class CommandColumns : unsigned char { none, throttles, all };
CommandColumns governed_commands(const Options& options);
Status linearize_flight(const Configuration<double>& c, const SystemFlight<double>& flight,
                        const State<double>& x, const Controls<double>& u, const ControlSet& columns,
                        CommandColumns commands, Analyses& work, VehicleMatrices& matrices,
                        double azimuth = 0);

// Collective that the governor adds at this moment, rad. An ideal one is asked anew: it answers a lever at once.
double governed_collective(const Configuration<double>& c, const SystemFlight<double>& flight,
                           const State<double>& x, const Controls<double>& u, double azimuth);

// Throws UsageError when an option is given that goes with governor=off alone.
void require_no_governor(const Options& options, const Arguments& arguments, const char* option);

}  // namespace tiltrotor::cli
