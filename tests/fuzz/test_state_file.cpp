// Any text as a file of states: a complete table of finite numbers, or a UsageError that names file and line.
// Expected: the contract: a table or one line.
#include <cmath>

#include "cli/errors.hpp"
#include "cli/state_file.hpp"
#include "fuzz/target.hpp"
#include "tiltrotor/math/differentiation/preaccumulate.hpp"

FUZZ_TARGET(state_file) {
  using namespace tiltrotor;
  static fuzz::InputFile input;
  fuzz::Bytes in(data, size);
  Options options;
  options.coning_states = in.below(4) == 3;
  const std::string& path = input.holding(in.rest());
  try {
    cli::StateFile file(path, options);
    REQUIRE(file.size() > 0);
    std::size_t rows = 0;
    file.each(0, file.size(), [&](const cli::StateRow& row) {
      ++rows;
      bool finite = true;
      State<double>::each(row.state, [&](double x) { finite = finite && std::isfinite(x); });
      Controls<double>::each(row.controls, [&](double x) { finite = finite && std::isfinite(x); });
      REQUIRE(finite && row.cells.size() == file.columns().size() && row.line >= 2);
    });
    REQUIRE(rows == file.size());
  } catch (const cli::UsageError& error) {
    REQUIRE(std::string(error.what()).compare(0, path.size() + 1, path + ":") == 0);
  }
}
