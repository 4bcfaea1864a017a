// One published number beside that of this program.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "study/missing.hpp"

namespace tiltrotor::study {

struct Comparison {
  std::string set, point, quantity;
  double here, reference;
  double mast_deg = kMissing;  // NaN when it has none
  double scale = kMissing;     // what a fraction of tolerance is of; NaN: of the reference
  double other = kMissing;     // the number of the other of the two compared aircraft (compared_aircraft.hpp)
};

}  // namespace tiltrotor::study
