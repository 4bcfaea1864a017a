// Linear models and flights of an aircraft whose rotor speed is governed: option governor of the model.
#pragma once

#include "cli/arguments.hpp"
#include "library/analyses.hpp"
#include "tiltrotor/analysis/flight/right_side.hpp"

namespace tiltrotor::cli {

// A and B at (x, u) of the airframe in a balance of power: the columns of a set, and the throttles of both engines.
Status linearize_governed(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
                          const ControlSet& columns, Analyses& work, VehicleMatrices& matrices);

// The same of a flight with systems, as they stand, with the columns of every command where wanted.
enum class CommandColumns : unsigned char { throttles, all };
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
