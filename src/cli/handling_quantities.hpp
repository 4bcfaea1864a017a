// What handling qualities are judged by, of one trimmed flight: numbers of the linear model with or without systems.
#pragma once

#include <map>
#include <string>

#include "library/analyses.hpp"

namespace tiltrotor::cli {

// By name, in the unit of handling_unit(): "dutch_zeta". One that the flight has not is left out; infinite: a root that
// never halves or doubles.
using HandlingQuantities = std::map<std::string, double>;

// Status: those of vehicle_modes() and transfer_function(). `matrices`: with the inceptors among its inputs.
Status handling_quantities(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
                           const VehicleMatrices& matrices, Analyses& work, HandlingQuantities& out);

}  // namespace tiltrotor::cli
