// Published linear models, roots and lateral frequency responses against those of this program.
#pragma once

#include "study/comparison.hpp"

namespace tiltrotor::study {

// Term by term (printed_linear_model.hpp).
void compare_linear_model(std::vector<Comparison>& out);

// Roots of the reference simulation, those identified in flight, and as information those of a simpler model.
void compare_modes(std::vector<Comparison>& out);

// Yaw rate and sideslip to rudder, at the published frequencies.
void compare_lateral_frequencies(std::vector<Comparison>& out);

}  // namespace tiltrotor::study
