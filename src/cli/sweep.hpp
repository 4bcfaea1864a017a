// Several values in one argument.
#pragma once

#include <vector>

#include "cli/number.hpp"

namespace tiltrotor::cli {

// Parts of `text` between the separators; an empty text is one empty part.
std::vector<std::string> split(std::string_view text, char separator);

// A number, a list `a,b,c`, or a range `from:step:to` with both ends; items of a list may be ranges.
// Throws UsageError "<where>: ..." for an empty range and for values outside `range`.
std::vector<double> parse_sweep(std::string_view text, const std::string& where, const Range& range);

// All combinations of sweeps of these sizes stand in memory: throws UsageError "<command>: ..." for more than
// a million.
void require_few(const std::string& command, const std::vector<std::size_t>& sizes);

}  // namespace tiltrotor::cli
