#include "cli/along_aircraft.hpp"

#include "aircraft_tables.inc"
#include "tiltrotor/model/aircraft/c2_aircraft.hpp"

namespace tiltrotor::cli {

namespace {

constexpr Aircraft<Along> kAlongAircraft = aircraft_tables::make_aircraft<Along>();

}  // namespace

AlongAircraft::AlongAircraft(const Aircraft<double>& base)
    : aircraft(&base == &c2_aircraft_data() ? c2_along_aircraft() : kAlongAircraft) {}

}  // namespace tiltrotor::cli
