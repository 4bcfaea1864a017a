// The generated C++ file.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "tablegen/aircraft_tables.hpp"
#include "tablegen/entries.hpp"
#include "tablegen/identity.hpp"

namespace tablegen {

// How those of the airframe's tables of two smooth axes are stored.
enum class Slopes { as_values, single };

void emit(std::ostream& out, const Identity& aircraft, const Entries& entries,
          const std::vector<TableArray>& tables, Slopes slopes);

}  // namespace tablegen
