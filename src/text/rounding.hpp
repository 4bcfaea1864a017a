// When a printed result is zero.
#pragma once

#include "tiltrotor/analysis/linear/linear_model.hpp"

namespace tiltrotor::text {

// What is left of terms that cancel is rounding: some units in the last place of their sum. Symmetric flight
// leaves at most 3e-15 where there is nothing; the least effect that there is, of the rudder on a hovering
// aircraft, has 7e-13 of the terms beside it.
inline constexpr double kRounding = 1e-14;

// Zero for a number that cannot be told from the rounding of its terms. `terms`: sum of their magnitudes.
double without_rounding(double value, double terms);
Vec3<double> without_rounding(const Vec3<double>& value, double terms);

// Size of what columns hold (m/s, deg, deg/s, kW), where their terms are not at hand: zero below 1e-12.
inline constexpr double kUsualTerms = 100;

// The terms of an entry of A or B are the others of its row, each over the distance at which the model bends
// (VariableKind). State and controls are as without the rule in the digits that trim prints.
LinearModel<double> without_rounding(const LinearModel<double>& model);

}  // namespace tiltrotor::text
