#include "tiltrotor/model/aircraft_data.hpp"

#include "aircraft_tables.inc"

namespace tiltrotor {

namespace {

constexpr Aircraft<double> kAircraftDouble = make_aircraft<double>();
constexpr Aircraft<float> kAircraftFloat = make_aircraft<float>();

}  // namespace

template <>
const Aircraft<double>& aircraft_data<double>() {
  return kAircraftDouble;
}
template <>
const Aircraft<float>& aircraft_data<float>() {
  return kAircraftFloat;
}
std::uint64_t aircraft_fingerprint() { return kAircraftFingerprint; }

}  // namespace tiltrotor
