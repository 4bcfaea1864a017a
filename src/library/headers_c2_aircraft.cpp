// The aircraft with C2 tables, for C++ programs.
#include "c2_tables.inc"
#include "tiltrotor/model/aircraft/c2_aircraft.hpp"

namespace tiltrotor {

namespace {

constexpr Aircraft<double> kC2Aircraft = c2_tables::make_aircraft<double>();

}  // namespace

const Aircraft<double>& c2_aircraft_data() { return kC2Aircraft; }

}  // namespace tiltrotor
