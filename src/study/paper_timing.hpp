// Tables 1 and 2 of the paper, with the times of this run beside them.
#pragma once

#include "study/section.hpp"

namespace tiltrotor::study {

void add_paper_timing(Section& section);

}  // namespace tiltrotor::study
