// Trim curves with every published point of the same quantity over them.
#pragma once

#include <vector>

#include "study/compared_aircraft.hpp"
#include "study/section.hpp"

namespace tiltrotor::study {

inline constexpr double kTrimMasts[] = {0, 15, 30, 60, 90};

// The printed runs at mast 15 had the flap of helicopter mode.
Setup trim_setup(ComparedAircraft aircraft, double mast_deg);

// From the curves (columns of trim_curves.csv) of the default aircraft and of the simulated one. The latter are
// drawn where all published points are of the simulation. `spreads`: Uncertainty::trim, a band around the former.
std::vector<Picture> trim_pictures(const Table& standard, const Table& simulated, const Table& spreads);

}  // namespace tiltrotor::study
