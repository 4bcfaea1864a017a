// Which aircraft a published number is compared with: that of its source.
//
// A simulation had its own controls, inertia and factors, the flown aircraft had others: a number of the one
// says nothing about a model of the other. One table says which kind of evidence goes with which.
#pragma once

#include <string>
#include <vector>

#include "study/comparison.hpp"
#include "study/flights.hpp"

namespace tiltrotor::study {

enum class ComparedAircraft : unsigned char {
  standard,      // the default of the program
  as_simulated,  // the reference simulation with the controls of its printed runs
  as_flown,
  as_designed  // inertia and rotor speed of the 1975 design
};

const char* word(ComparedAircraft aircraft);

// By set and kind of evidence (validation_sets.csv).
ComparedAircraft compared_aircraft(const std::string& set);

// The other of simulation and flight; of the rest itself.
ComparedAircraft other_aircraft(ComparedAircraft aircraft);

// The default setup at a mast angle with what that aircraft has of its own.
Setup setup_of(ComparedAircraft aircraft, double mast_deg);

// The comparisons of a set with its own aircraft, and beside each the number of the other one.
// `compare(aircraft)` gives them in the same order for both.
template <class Compare>
void add_compared(const std::string& set, Compare&& compare, std::vector<Comparison>& out) {
  const ComparedAircraft own = compared_aircraft(set);
  const ComparedAircraft other = other_aircraft(own);
  std::vector<Comparison> rows = compare(own);
  if (other != own) {
    const std::vector<Comparison> others = compare(other);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].other = others[i].here;
  }
  out.insert(out.end(), rows.begin(), rows.end());
}

}  // namespace tiltrotor::study
