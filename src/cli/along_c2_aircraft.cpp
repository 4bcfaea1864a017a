#include "c2_tables.inc"
#include "cli/along_aircraft.hpp"

namespace tiltrotor::cli {

namespace {

constexpr Aircraft<Along> kC2AlongAircraft = c2_tables::make_aircraft<Along>();

}  // namespace

const Aircraft<Along>& c2_along_aircraft() { return kC2AlongAircraft; }

}  // namespace tiltrotor::cli
