// Component loads that the reference simulation printed, against those of this program.
#pragma once

#include "study/comparison.hpp"

namespace tiltrotor::study {

// The airframe's in the printed state of flight, the rotors' and the sums' in a trim of this program at that
// speed.
void compare_component_loads(std::vector<Comparison>& out);

}  // namespace tiltrotor::study
