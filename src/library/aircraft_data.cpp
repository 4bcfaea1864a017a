#include "tiltrotor/model/aircraft/aircraft_data.hpp"

#include "aircraft_tables.inc"

namespace tiltrotor {

namespace {

constexpr Aircraft<double> kAircraftDouble = aircraft_tables::make_aircraft<double>();
constexpr Aircraft<float> kAircraftFloat = aircraft_tables::make_aircraft<float>();

}  // namespace

template <>
const Aircraft<double>& aircraft_data<double>() {
  return kAircraftDouble;
}
template <>
const Aircraft<float>& aircraft_data<float>() {
  return kAircraftFloat;
}
const AircraftIdentity& aircraft_identity() { return aircraft_tables::kAircraftIdentity; }
std::uint64_t aircraft_fingerprint() { return aircraft_tables::kAircraftFingerprint; }

}  // namespace tiltrotor
