// Accuracy of central differences over their step: the V-shaped curve.
#pragma once

#include "study/section.hpp"

namespace tiltrotor::study {

// Adds the curve, its table and a remark to a section.
void add_step_error(Section& section);

}  // namespace tiltrotor::study
