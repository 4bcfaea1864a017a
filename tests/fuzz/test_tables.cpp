// Any text as a table of the table generator: a checked grid, or a fault with file and line.
// Expected: the contract: a grid or one line.
#include <cmath>

#include "fuzz/target.hpp"
#include "tablegen/compose.hpp"
#include "tablegen/entries.hpp"
#include "tablegen/fault.hpp"
#include "tablegen/grid.hpp"

namespace {

void check_grid(const tablegen::Grid& grid) {
  const bool named = grid.csv.header[0] == "flap";  // rows by name have no knots
  for (std::size_t i = 1; i < grid.knot.size(); ++i) REQUIRE(grid.knot[i - 1] < grid.knot[i]);
  for (const tablegen::Curve& curve : grid.columns) {
    REQUIRE(!curve.value.empty() && curve.knot.size() == (named ? 0 : curve.value.size()));
    for (const double value : curve.value) REQUIRE(std::isfinite(value));
    if (!named) REQUIRE(std::isfinite(tablegen::at(curve, 0.5)));
  }
}

}  // namespace

FUZZ_TARGET(tables) {
  static fuzz::InputFile input;
  fuzz::Bytes in(data, size);
  const int reader = in.below(3);
  const std::string& path = input.holding(in.rest());
  try {
    tablegen::Entries entries;
    switch (reader) {
      case 0:
        check_grid(tablegen::read_grid(path));
        break;
      case 1:
        entries.read_aircraft(path);
        break;
      default:
        entries.read_choices(path);
    }
  } catch (const tablegen::Fault& fault) {
    REQUIRE(fault.file == path && fault.line >= 1 && !fault.message.empty());
  }
}
