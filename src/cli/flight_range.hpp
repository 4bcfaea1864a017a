// Ranges of test inputs and of the states of a flight: those of the C interface.
#pragma once

#include <string>
#include <vector>

#include "tiltrotor/analysis/flight/response.hpp"

namespace tiltrotor::cli {

// What no input of a control inside its range can exceed: the width of the range, rad, in or m/s.
double largest_amplitude(int control);

// The controls that stand outside their range, as printed.
std::vector<std::string> controls_beyond_stops(const Controls<double>& u);
// "long_stick elevator", for the column `limits`.
std::string words_of(const std::vector<std::string>& limits);

// Throws UsageError "<where>: ..." when the inputs together drive a control out of its range, or further out
// where the trim itself is beyond it.
void require_inputs(const Simulation<double>& simulation, const std::string& where);

// Where a flight ended, for a message: ", state theta, 1.55 rad in the last good step, range
// -1.56207..1.56207 rad".
std::string fault_text(const Simulation<double>& simulation);

}  // namespace tiltrotor::cli
