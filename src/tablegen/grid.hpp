// A table file as a checked grid, and its columns as curves.
#pragma once

#include <string>
#include <vector>

#include "tablegen/csv.hpp"

namespace tablegen {

// Values over strictly increasing knots, and how far print rounded each: half a unit of its last digit, infinite where
// no number is printed.
struct Curve {
  std::vector<double> knot;
  std::vector<double> value;
  std::vector<double> half;
};

struct Grid {
  Csv csv;
  std::vector<double> knot;    // first column; empty when it holds names
  std::vector<Curve> columns;  // the others, each where it is defined

  // Column `name`, turned from the unit the comments state to the unit the product wants.
  Curve column(const std::string& name, const std::string& unit, const std::string& wanted) const;
  // Names of the columns after the first.
  std::vector<std::string> names() const { return {csv.header.begin() + 1, csv.header.end()}; }
  // The numbers in the names of columns, strictly increasing: {"M020", "M040"} with prefix "M" gives 20, 40;
  // an m after the prefix is a minus.
  std::vector<double> labels(const std::vector<std::string>& from, const std::string& prefix) const;
};

// Refuses knots that do not increase, cells that are no finite number, holes inside a column, more knots than
// a table may have, and empty cells when no comment begins the rule "Empty = ...".
Grid read_grid(const std::string& file);

}  // namespace tablegen
