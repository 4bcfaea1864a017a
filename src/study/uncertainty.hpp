// The band that the doubtful inputs make around trim, modes and response.
//
// Each input is moved to either end of its range, alone; of the changes of a number those upwards and those downwards
// are combined as the root of the sum of their squares, as for independent inputs. Trim: exact derivatives where
// the input is a parameter of the configuration, another trim where it is a number or table of the aircraft.
#pragma once

#include <vector>

#include "study/section.hpp"
#include "study/spread.hpp"
#include "study/trim_sensitivity.hpp"

namespace tiltrotor::study {

struct Uncertainty {
  Table trim{{"mast_deg", "speed_mps", "quantity", "value", "below", "above"}};
  Table modes{{"mast_deg", "speed_mps", "mode", "quantity", "value", "below", "above"}};
  Table response{{"time_s", "quantity", "value", "below", "above"}};
  Table points{{"point", "quantity", "value", "below", "above"}};  // some of them
  // Of each input at these points: the change at both ends, and its share.
  Table parts{{"point", "quantity", "input", "at_low", "at_high", "share"}};
};

// Mast angles 0, 15, 30, 60 and 90 deg. Cost: some 10000 trims and linear models, 60 flights of 3 s.
Uncertainty uncertainty();

// Trim of a level flight: changes by input, in the order of doubtful_inputs().
std::vector<std::array<EndChange, kTrimQuantities>> trim_changes(const Setup& setup, double speed_mps);

}  // namespace tiltrotor::study
