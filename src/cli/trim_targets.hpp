// What a trim shall reach, each with a quantity of the flight that is let go for it: --bank, --load-factor, --ball,
// --hold and --free.
#pragma once

#include <string>
#include <vector>

#include "cli/arguments.hpp"

namespace tiltrotor::cli {

// `held`: a column of `trim` that follows from the trim, ny, or an output (named_outputs.hpp). `freed`: see freed_quantities().
struct TrimTarget {
  std::string held;
  double value;
  std::string freed;
  std::string option;  // that asked for it, for messages: "--bank"
};
using TrimTargets = std::vector<TrimTarget>;

// A quantity of the flight that may be let go: its column, the option that gives where the search begins, the range
// of the search, and its first step.
struct FreedQuantity {
  const char* column;
  const char* option;
  Range range;
  double step;
};
const std::vector<FreedQuantity>& freed_quantities();
const FreedQuantity& freed_quantity(const std::string& column);

OptionList target_list();

// Every combination of what the options ask for; one empty set where they ask for nothing. Throws UsageError for
// names that are none, for a quantity freed twice, and for one that is freed and given several values.
std::vector<TrimTargets> target_sets(const Arguments& arguments);

}  // namespace tiltrotor::cli
