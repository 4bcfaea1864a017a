// Knots inside intervals where print repeats a value beside one where it does not: "1 from 120 kt to 350 kt". A C2 curve
// of one cubic an interval swings there; with more it stays within half a unit of the value at each added knot. Near the
// bend they are as close as half the interval beside, and twice as far each further on.
#pragma once

#include "tablegen/aircraft_tables.hpp"

namespace tablegen {

// The same table on more knots along its smooth axes but Mach number. Where a line is not flat its value at an added knot
// is free.
TableArray with_flat_knots(const TableArray& table);

}  // namespace tablegen
