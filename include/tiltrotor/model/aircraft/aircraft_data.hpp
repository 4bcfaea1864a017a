// The aircraft compiled into the library: constants in read-only memory, generated from tables/ at build
// time.
#pragma once

#include <cstdint>

#include "tiltrotor/model/aircraft/aircraft.hpp"

namespace tiltrotor {

// R is double or float. No initialisation at run time: may be called from anywhere, at any time.
template <class R>
const Aircraft<R>& aircraft_data();
template <>
const Aircraft<double>& aircraft_data<double>();
template <>
const Aircraft<float>& aircraft_data<float>();

// Its number in the C interface, name and description.
const AircraftIdentity& aircraft_identity();

// Hash of its numbers: libraries of equal tables have the same.
std::uint64_t aircraft_fingerprint();

}  // namespace tiltrotor
