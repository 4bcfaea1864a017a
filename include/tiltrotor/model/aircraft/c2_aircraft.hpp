// The aircraft compiled into the library, with another set of table nodes: the smoothest curves and surfaces that print
// allows, two derivatives continuous inside the grid (src/tablegen/c2_fit.hpp). Looked up as any table, with
// Interpolation::c1, at the same cost:
//
//   prepare(c2_aircraft_data(), flight_setup(c2_aircraft_data(), mast_deg), configuration)
//
// In libtiltrotor-aircraft.a, linked by who asks. Not in the C interface.
#pragma once

#include "tiltrotor/model/aircraft/aircraft.hpp"

namespace tiltrotor {

const Aircraft<double>& c2_aircraft_data();

// Whether these are its tables, in whatever else it was changed.
inline bool has_c2_tables(const Aircraft<double>& aircraft) {
  return aircraft.wing.moment.node == c2_aircraft_data().wing.moment.node;
}

}  // namespace tiltrotor
