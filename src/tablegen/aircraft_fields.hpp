// Which entry of aircraft.csv or choices.csv fills which number of struct Aircraft, and in which unit.
#pragma once

#include <string>
#include <vector>

namespace tablegen {

struct Field {
  const char* field;  // member of Aircraft
  const char* entry;
  const char* unit;  // unit of the member
};

extern const std::vector<Field> kFields;

}  // namespace tablegen
