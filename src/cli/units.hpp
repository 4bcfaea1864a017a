// The units in which numbers may be given and columns printed: behind a number (80kt), at the end of a column's
// name (speed_kt), and for a whole command (--units knots,feet).
//
// Every quantity has a unit of its own, the first in the table, in which commands count and columns are named. Matrices,
// files of models and quantities without a unit in their name stay in SI.
#pragma once

#include <string>
#include <vector>

#include "cli/sweep.hpp"

namespace tiltrotor::cli {

inline constexpr double kFoot = 0.3048;  // m

struct UnitOfMeasure {
  const char* word;    // of --units; empty where it cannot be chosen
  const char* sign;    // behind a number
  const char* column;  // ends the name of a column, after '_'
  double size;         // of one, in the quantity's own unit
};

// A column or sign in another unit than it was, and the size of the new unit in the old.
struct InUnit {
  std::string name;
  double size = 1;
  const char* sign = "";
};

// speed_kt: speed_mps, and 0.514 "kt". The name itself, with size 1, where it ends in no other unit than its
// quantity's own.
InUnit in_own_unit(const std::string& column);

// Every word of --units.
std::vector<std::string> unit_words();

class Units {
 public:
  Units() = default;  // every quantity in its own
  // "knots,feet", in any order. Throws UsageError "<where>: ..." for what is no unit, or two of one quantity.
  Units(const std::string& text, const std::string& where);

  // A column named in its own unit, as it is printed.
  InUnit column(const std::string& own) const;
  // The same for a unit that stands in a cell, "m/s".
  InUnit sign(const std::string& own) const;

  // "80" in the unit chosen, or "80kt" in that written; range and result are in range.unit.
  double number(const std::string& text, const std::string& where, const Range& range) const;
  // A list or ranges, each item with its unit at its end: "0:20:100kt,60m/s".
  std::vector<double> sweep(const std::string& text, const std::string& where, const Range& range) const;

 private:
  bool is_chosen(const UnitOfMeasure& unit) const;
  // Takes the unit off the text; where there is none it is the one chosen.
  UnitOfMeasure take_unit(std::string& text, const std::string& where, const Range& range) const;

  std::vector<std::string> words_;
};

}  // namespace tiltrotor::cli
