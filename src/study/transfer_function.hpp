// Frequency responses of a linear model, and of published transfer functions.
#pragma once

#include <complex>
#include <string>

#include "study/linear_models.hpp"

namespace tiltrotor::study {

using Complex = std::complex<double>;

// x(s) / u(s) at s = i omega of the state and the control with these places in State and Controls, or of the
// state's rate.
Complex response_of(const Linear& model, int output, int input, double omega, bool derivative = false);

// Of coefficients in falling powers, with spaces between.
Complex polynomial(const std::string& coefficients, Complex s);
// The first of them.
double leading_coefficient(const std::string& coefficients);

double decibel(Complex value);
double phase_deg(Complex value);

// The phase in the branch nearest to another, deg.
double nearest_turn(double phase, double to);

}  // namespace tiltrotor::study
