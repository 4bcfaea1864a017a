// A trim that reaches given results: each is held by a quantity of the flight that is searched.
//
// Search of one quantity: steps that grow, from where it is given, towards the target; then regula falsi (Illinois)
// between two trims on either side of it. Several are searched one inside the other. Every trim is one from a cold
// start, so that what is found does not depend on the way. At most some 100 trims for one target.
#pragma once

#include "cli/trimmed_flights.hpp"

namespace tiltrotor::cli {

// Names that can be held.
std::vector<std::string> held_quantities();

// `flight` comes in as it is given and goes out as it was found, trimmed; the sentence is then empty. Otherwise the
// status is not_converged and the sentence says how near it came, or the status is that of a trim which is none.
std::string trim_to_targets(const TrimTargets& targets, Analyses& work, TrimmedFlight& flight);

}  // namespace tiltrotor::cli
