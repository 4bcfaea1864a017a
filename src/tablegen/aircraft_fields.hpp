// Which entry of aircraft.csv or choices.csv fills which number of struct Aircraft, and in which unit.
#pragma once

#include <vector>

#include "tablegen/entries.hpp"

namespace tablegen {

struct Field {
  const char* field;  // member of Aircraft
  const char* entry;
  const char* unit;  // unit of the member
};

extern const std::vector<Field> kFields;

// Refuses numbers that the model cannot take: an empty range, blades that make no gimballed rotor, a gross weight, CG
// or rotor speed outside its own range.
void check_fields(const Entries& entries);

}  // namespace tablegen
