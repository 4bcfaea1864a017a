// Units of the source files and of the product, each with its exact factor to SI.
#pragma once

#include <string>

namespace tablegen {

struct Unit {
  const char* name;
  double to_si;
  const char* si;  // name of the SI unit
};

// nullptr when there is no such unit.
const Unit* find_unit(const std::string& name);

// A value in another unit of the same kind; unchanged when the units are the same.
double converted(double value, const Unit& from, const Unit& to);

}  // namespace tablegen
