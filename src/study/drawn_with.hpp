// What a figure was drawn with: the line below each that says so.
#pragma once

#include <string>

#include "study/compared_aircraft.hpp"

namespace tiltrotor::study {

// Aircraft with its loading and altitude, governor and inflow of a setup; its mast angle, flap and rotor speed
// belong to the figure.
std::string drawn_with(ComparedAircraft aircraft, const Setup& setup);

// The default aircraft of the program.
std::string drawn_with();
std::string drawn_with(Governor governor);

// Where doubtful inputs make a band around the curves.
inline constexpr const char* kBandNote = " Band: doubtful inputs.";

// A rotor alone, its inflow in equilibrium.
std::string drawn_with_rotor_alone();

}  // namespace tiltrotor::study
