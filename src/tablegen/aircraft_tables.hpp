// Which files fill which tables of struct Aircraft, and how they are put together.
#pragma once

#include <string>
#include <vector>

#include "tablegen/entries.hpp"

namespace tablegen {

// One table, ready to be written: axes, and values with the linear axes outermost, then the smooth ones in
// order.
struct TableArray {
  std::string field;   // member of Aircraft
  std::string source;  // files it comes from
  std::vector<std::vector<double>> smooth;
  std::vector<std::vector<double>> linear;
  std::vector<double> value;
  std::vector<double> half;            // of each value: Curve::half
  std::vector<double> end_width = {};  // of each smooth axis: tiltrotor::Axis::end_width
  bool over_mach = false;              // the second smooth axis is the Mach number
  std::vector<double> fitted = {};     // nodes of the C2 fit; empty: values, and slopes of the C1 interpolant
};

// Flap angles of flap_setting_1, _2, ..., deg: two at least, increasing.
std::vector<double> flap_settings(const Entries& entries);

// Reads every table of the folder, also those the product does not use yet.
std::vector<TableArray> compose_tables(const std::string& folder, const Entries& entries);

}  // namespace tablegen
