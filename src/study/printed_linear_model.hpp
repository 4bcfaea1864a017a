// The linear model that the reference simulation printed at mast 90, 200 kt, and that of this program in its
// states and units.
#pragma once

#include <string>
#include <vector>

#include "study/compared_aircraft.hpp"
#include "study/linear_models.hpp"

namespace tiltrotor::study {

struct LinearTerm {
  std::string matrix, row, column;
  double printed;
  std::string quantity() const { return matrix + "_" + row + "_" + column; }  // "A_q_w"
};
const std::vector<LinearTerm>& printed_terms();

// Setup of the print: its mast angle, flap and rotor speed.
Setup printed_model_setup(ComparedAircraft aircraft);

// The eight rigid-body states. Rotors and inflow in balance; the downwash late by its lag to first order:
// the rate of the angle of attack then acts on the tail as it does in a model without that state. Or not.
enum class DownwashDelay : unsigned char { first_order, none };
Linear printed_states(const Setup& setup, const Aircraft<double>& aircraft, DownwashDelay delay);

// Of that model, in the order and units of the printed terms; the power lever's column in proportion to its
// first term, since the lever works through engine and governor.
std::vector<double> terms_of(const Linear& model);

}  // namespace tiltrotor::study
