// Several values in one argument.
#pragma once

#include <vector>

#include "cli/errors.hpp"
#include "text/number.hpp"
#include "text/split.hpp"

namespace tiltrotor::cli {

// A number, a list `a,b,c`, or a range `from:step:to` with both ends; items of a list may be ranges.
// Throws UsageError "<where>: ..." for an empty range and for values outside `range`.
std::vector<double> parse_sweep(std::string_view text, const std::string& where, const Range& range);

// Throws UsageError "<where>: ..." for more values than a list may have.
void require_few_values(std::size_t count, const std::string& where);

// All combinations of sweeps of these sizes stand in memory: throws UsageError "<command>: ..." for more than
// a million.
void require_few(const std::string& command, const std::vector<std::size_t>& sizes);

}  // namespace tiltrotor::cli
