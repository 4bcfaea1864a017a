// Trim curves with every published point of the same quantity over them.
#pragma once

#include <vector>

#include "study/section.hpp"

namespace tiltrotor::study {

// From the curves (columns of trim_curves.csv) of the default aircraft and of the simulated one. The latter are
// drawn where all published points are of the simulation. Mast angles in deg.
std::vector<Picture> trim_pictures(const Table& standard, const Table& simulated,
                                   const std::vector<double>& masts);

}  // namespace tiltrotor::study
