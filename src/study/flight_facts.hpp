// What reports say of the aircraft in words and single numbers, against this program.
#pragma once

#include "study/comparison.hpp"

namespace tiltrotor::study {

// Ratios of the reference simulation to flight, stall, sideward flight, start of conversion, idle descent.
void compare_flight_facts(std::vector<Comparison>& out);

}  // namespace tiltrotor::study
