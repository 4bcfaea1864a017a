// Columns of a time response.
#pragma once

#include <string>
#include <vector>

#include "cli/trimmed_flights.hpp"
#include "text/records.hpp"

namespace tiltrotor::cli {

// With those that complete the state (state_columns.hpp).
std::vector<std::string> response_columns(bool with_modes, const Options& options = {});

// State now and the controls that act from now on, with the collective that a governor adds, rad; `flight` is where it
// began.
Row response_row(const TrimmedFlight& flight, const Configuration<double>& now,
                 const Simulation<double>& simulation, const Controls<double>& acting, double governed);

// Name, real and imaginary part and branch of the body's and the downwash's modes; the rotors' are left out.
// Empty cells when `set` is null.
void append_modes(Row& row, const ModeSet<double>* set);
// The same with a governor, whose modes follow those of the body; there are no branches.
void append_modes(Row& row, const VehicleModes<double>* set, const Options& options);

}  // namespace tiltrotor::cli
