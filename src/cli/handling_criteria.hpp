// Criteria of handling qualities: limits as published (tables/xv15/published/handling_qualities.csv), and their levels.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "cli/handling_quantities.hpp"

namespace tiltrotor::cli {

// Between which a quantity must lie for a level.
struct Limit {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool given = false;
};

struct Criterion {
  std::string name;      // "MIL-F-8785C dutch roll damping ratio"
  std::string quantity;  // of HandlingQuantities
  std::string unit;
  bool in_hover;    // for hover and low speed, or for forward flight
  bool has_levels;  // else a requirement that is met or not
  Limit level[3];
  std::string source, confidence;
};

// Speeds up to this are hover and low speed (45 kt, ADS-33E).
inline constexpr double kLowSpeed = 23.15;  // m/s

// Those that the file holds with high or medium confidence, flight phase category A, B or C. Throws UsageError where the
// aircraft comes without published numbers.
std::vector<Criterion> handling_criteria(char category, const std::string& where);

// "1", "2", "3", "below 2" (worse than the last that is given); "met", "not met".
std::string level_of(const Criterion& criterion, double value);

}  // namespace tiltrotor::cli
