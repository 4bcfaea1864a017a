// Whether the processor can run what the program is compiled for.
#pragma once

#include <cstdio>

namespace tiltrotor::cli {

// True, and one line to `errors`, when one of `compiled` is not among `available` (library/processor.hpp).
bool cannot_run(unsigned compiled, unsigned available, std::FILE* errors);

}  // namespace tiltrotor::cli
