// Compiled without -march, so that it can answer everywhere.
#include "cli/processor_check.hpp"

#include <cstdlib>

#include "library/processor.hpp"

namespace tiltrotor::cli {

bool cannot_run(unsigned compiled, unsigned available, std::FILE* errors) {
  const char* const missing = missing_instructions(compiled, available);
  if (missing == nullptr) return false;
  std::fprintf(errors, "tiltrotor: compiled for %s, which this processor lacks; build with ARCH= (empty)\n",
               missing);
  return true;
}

namespace {

// Before constants with constructors, which use any instruction: these have priority 65535.
[[gnu::constructor(101)]] void refuse_other_processors() {
  if (cannot_run(compiled_instructions, processor_instructions(), stderr)) std::_Exit(1);
}

}  // namespace

}  // namespace tiltrotor::cli
