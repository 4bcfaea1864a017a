// What counts as agreement with published numbers: validation_tolerances.csv of the published numbers.
#pragma once

#include <string>

namespace tiltrotor::study {

struct Tolerance {
  enum class Demand : unsigned char {
    equal,
    at_least,
    at_most
  };                          // what the reference is: the number, or a bound
  bool judged;                // false: information
  double absolute, fraction;  // the larger counts
  Demand demand;
  std::string cause;  // of what is left
};

// The first rule for it; mast_deg may be NaN. Throws std::runtime_error when there is none.
Tolerance tolerance_of(const std::string& set, const std::string& quantity, double mast_deg);

// What explains the difference from the published number: of a tolerance, where validation_causes.csv has
// nothing for that side.
std::string cause_of(const Tolerance& tolerance, const std::string& set, const std::string& quantity,
                     double mast_deg, double difference);

// What may remain; the fraction is of `scale`, as a rule the size of the reference. NaN: not judged.
double allowed(const Tolerance& tolerance, double scale);

// How far outside what is demanded a number lies, never negative. NaN when it is NaN.
double shortfall(const Tolerance& tolerance, double here, double reference);

}  // namespace tiltrotor::study
