// Columns of a time response.
#pragma once

#include <string>
#include <vector>

#include "cli/trimmed_flights.hpp"
#include "text/records.hpp"

namespace tiltrotor::cli {

// With those that complete the state (state_columns.hpp).
std::vector<std::string> response_columns(bool with_modes, const Options& options = {});

// State now and the controls that act from now on; `flight` is where it began.
Row response_row(const TrimmedFlight& flight, const Configuration<double>& now,
                 const Simulation<double>& simulation);

// Name, real and imaginary part and branch of the body's and the downwash's modes; the rotors' are left out.
// Empty cells when `set` is null.
void append_modes(Row& row, const ModeSet<double>* set);

}  // namespace tiltrotor::cli
