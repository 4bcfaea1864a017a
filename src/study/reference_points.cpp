#include "study/reference_points.hpp"

#include <iterator>
#include <stdexcept>
#include <string_view>

namespace tiltrotor::study {

namespace {

struct ReferenceSet {
  std::string_view name;
  std::string_view text;
};

// Made from tables/<aircraft>/published by the build: one {"name", R"csv(text)csv"} for each file.
constexpr ReferenceSet kReferenceSets[] = {
#include "reference_points.inc"
    {"", ""},  // an aircraft may have none
};

}  // namespace

bool has_reference_points() { return std::size(kReferenceSets) > 1; }

Table reference_points(const std::string& name) {
  for (const ReferenceSet& set : kReferenceSets) {
    if (set.name == name) return Table::parse(set.text, name + ".csv");
  }
  throw std::logic_error("no reference points '" + name + "'");
}

}  // namespace tiltrotor::study
