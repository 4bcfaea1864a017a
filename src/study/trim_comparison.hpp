// Every published trim point against a trim of this program at that speed.
#pragma once

#include <vector>

#include "study/section.hpp"

namespace tiltrotor::study {

// One row for each number, other models as information: set, mast_deg, speed_mps, quantity, here, reference,
// difference, tolerance, within, other.
Table trim_comparison();

// How many numbers of each set lie within the tolerance, and the worst of each quantity.
std::vector<Finding> trim_comparison_findings(const Table& compared);

}  // namespace tiltrotor::study
