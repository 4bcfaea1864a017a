// Damping and frequency of the modes over speed, with limits of handling qualities.
#pragma once

#include <vector>

#include "study/mode_table.hpp"
#include "study/uncertainty.hpp"

namespace tiltrotor::study {

// Of a table of modes with the columns mast_deg and speed_mps: a picture for each mode and quantity.
// Bands where `spreads`, Uncertainty::modes, has rows.
// `ideal`: the same modes with an ideal governor, where there is a second curve; may be empty.
std::vector<Picture> mode_speed_pictures(const Table& modes, const Table& spreads = Uncertainty().modes,
                                         const Table& ideal = mode_table({"mast_deg", "speed_mps"}));

}  // namespace tiltrotor::study
