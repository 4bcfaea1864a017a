// Every comparison of the report with published numbers in one table, the worst first.
#pragma once

#include <vector>

#include "study/section.hpp"

namespace tiltrotor::study {

// What the comparison says, and whether the list of known exceedances is still true.
struct Validation {
  // set, point, quantity, here, reference, difference, tolerance, ratio (difference over tolerance), status
  // (within, known, exceeds, better, information), kind, source, cause. `better`: known as an exceedance, but
  // within tolerance now.
  Table rows;
  Table sets;                       // one row a set: kind, numbers, within, known, worst, source
  Table known;                      // the list of known exceedances as it would be true
  std::vector<std::string> faults;  // one line each; empty: passed
};

// From the tables of the finished sections.
Validation validate(const std::vector<Section>& sections);

// The same against a list of known exceedances with the columns set, point, quantity, reason.
Validation validate(const std::vector<Section>& sections, const Table& known);

Section validation_section(const Validation& validation);

// One line a number on stdout, the worst first, then the faults.
void print(const Validation& validation);

}  // namespace tiltrotor::study
