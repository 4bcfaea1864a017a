// Damping and frequency of the modes over speed, with limits of handling qualities.
#pragma once

#include <vector>

#include "study/uncertainty.hpp"

namespace tiltrotor::study {

// Of a table of modes with the columns mast_deg and speed_mps: a picture for each mode and quantity.
// Bands where `spreads`, Uncertainty::modes, has rows.
std::vector<Picture> mode_speed_pictures(const Table& modes, const Table& spreads = Uncertainty().modes);

}  // namespace tiltrotor::study
