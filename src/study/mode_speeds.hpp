// Damping and frequency of the modes over speed, with limits of handling qualities.
#pragma once

#include <vector>

#include "study/section.hpp"

namespace tiltrotor::study {

// Of a table of modes with the columns mast_deg and speed_mps: a picture for each mode and quantity.
std::vector<Picture> mode_speed_pictures(const Table& modes);

}  // namespace tiltrotor::study
