// The printed flights of the reference simulation: what it printed of each trim, its rotors and its components.
#pragma once

#include "study/compared_aircraft.hpp"
#include "study/reference_points.hpp"

namespace tiltrotor::study {

inline constexpr double kFoot = 0.3048;                 // m
inline constexpr double kPoundForce = 4.4482216152605;  // N
inline constexpr double kPoundFoot = kFoot * kPoundForce;
inline constexpr double kKnot = 1852.0 / 3600;  // m/s

// Setup of a row with the columns mast_deg and, if it has them, flap_deg and rotor_rpm.
Setup printed_setup(ComparedAircraft aircraft, const Table& printed, std::size_t row);

// "mast_deg=15 speed_kt=40"
std::string point_of(const Table& printed, std::size_t row);

// Attitude, controls, rotors, mass, power and hub moments of the printed trims.
void compare_printed_trims(std::vector<Comparison>& out);

}  // namespace tiltrotor::study
