// Exact derivatives of a trim with respect to the configuration.
//
// By tiltrotor/analysis/trim/trim_motion.hpp and configuration_sensitivity.hpp.
#pragma once

#include <array>
#include <vector>

#include "study/flights.hpp"
#include "tiltrotor/analysis/linear/configuration_sensitivity.hpp"

namespace tiltrotor::study {

// What the figures of trim show.
inline constexpr int kTrimQuantities = 4;
inline constexpr const char* kTrimQuantity[kTrimQuantities] = {"pitch_deg", "long_stick_in",
                                                               "collective_root_deg", "power_kw"};
using TrimNumbers = std::array<double, kTrimQuantities>;

TrimNumbers trim_numbers(const Trimmed& trim);

// One entry for each of up to kParameterDirections parameters, over the unit of the parameter. `trim`: level flight
// in still air. Throws when a number is not finite or the trim is singular.
std::vector<TrimNumbers> trim_sensitivity(const Configured& c, const Trimmed& trim,
                                          const ParameterSet& parameters);

}  // namespace tiltrotor::study
