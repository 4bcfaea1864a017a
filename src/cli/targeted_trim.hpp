// A trim that reaches given results: each is held by a quantity of the flight that is searched.
//
// One quantity is searched all through its range, outward from where it is given (axis_search.hpp); of several solutions
// the nearest whose trim is within the limits, else the nearest. Several quantities are searched one inside the other;
// those inside begin where they were found last, look eight steps to each side and take the nearest. Where all that finds
// nothing, it is done once more, and where the window holds nothing the whole range is looked through, twenty times at
// most. Every trim is one from a cold start, so that what is found does not depend on the way. One target takes some 20
// to 300 trims, several at most 3000 together.
#pragma once

#include "cli/trimmed_flights.hpp"

namespace tiltrotor::cli {

// Names that can be held, apart from loads of components and load factors at stations (output_named()).
std::vector<std::string> held_quantities();

// `flight` comes in as it is given and goes out as it was found, trimmed; the sentence is then empty. Otherwise the
// status is not_converged and the sentence says how near it came, or the status is that of a trim which is none.
std::string trim_to_targets(const TrimTargets& targets, Analyses& work, TrimmedFlight& flight);

}  // namespace tiltrotor::cli
