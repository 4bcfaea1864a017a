// Test inputs as text: NAME=AMPLITUDE[UNIT]@START[..END][:SHAPE].
#pragma once

#include <string>

#include "tiltrotor/analysis/flight/input_signal.hpp"

namespace tiltrotor::cli {

// The grammar with an example, for the help.
extern const char* const kInputGrammar;

// "collective=1deg@0": a step. "pedal=0.5in@1..2": a pulse. "long_stick=1in@1..3:doublet": one second each
// way. Angles are in deg when no unit is given. Throws UsageError "<where>: ...".
InputSignal<double> parse_input(const std::string& text, const std::string& where);

}  // namespace tiltrotor::cli
