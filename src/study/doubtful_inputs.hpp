// What of the aircraft is doubtful, and the aircraft with one of these inputs moved.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "study/copied_tables.hpp"
#include "study/flights.hpp"
#include "tiltrotor/analysis/linear/configuration_sensitivity.hpp"

namespace tiltrotor::study {

// The true value lies between value - below and value + above.
struct DoubtfulInput {
  std::string name;
  double below, above;  // in `unit`, not negative; of "%": of the value
  std::string unit;
  std::string reason;
};

// doubtful_inputs.csv among the published numbers. Throws std::runtime_error when a row names an input that
// nothing moves, in another unit, or by a negative amount.
const std::vector<DoubtfulInput>& doubtful_inputs();

// The parameter of the configuration that the input is, with respect to which derivatives are exact; `count`
// for a number or table of the aircraft.
ConfigurationParameter parameter_of(const DoubtfulInput& input);

// An amount in the unit of the input in that of its parameter.
double parameter_amount(const DoubtfulInput& input, const Configured& c, double by);

// The configuration of a setup with one input moved by an amount in its unit, and the numbers it refers to.
class MovedAircraft : public CopiedTables<double> {
 public:
  MovedAircraft(const Setup& setup, const DoubtfulInput& input, double by);
  MovedAircraft(const MovedAircraft&) = delete;
  MovedAircraft& operator=(const MovedAircraft&) = delete;

  const Configured& configuration() const { return c_; }

  // For the list of inputs: what it changes.
  Aircraft<double> aircraft;
  Setup setup;

 private:
  Configured c_;
};

}  // namespace tiltrotor::study
