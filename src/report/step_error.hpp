// Accuracy of central differences over their step: the V-shaped curve.
#pragma once

#include "report/section.hpp"

namespace tiltrotor::report {

// Adds the curve, its table and a remark to a section.
void add_step_error(Section& section);

}  // namespace tiltrotor::report
