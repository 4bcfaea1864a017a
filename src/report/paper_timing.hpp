// Tables 1 and 2 of the paper, with the times of this run beside them.
#pragma once

#include "report/section.hpp"

namespace tiltrotor::report {

void add_paper_timing(Section& section);

}  // namespace tiltrotor::report
