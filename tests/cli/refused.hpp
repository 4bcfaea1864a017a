// Commands that are bad usage, for tests.
#pragma once

#include <algorithm>
#include <string>

#include "check.hpp"
#include "run_program.hpp"

namespace check {

/// Refused with one line on stderr that begins with the program's name and holds `message`; nothing is printed.
inline void check_refused(const std::string& arguments, const std::string& message) {
  const ProgramResult result = run_tiltrotor(arguments);
  const bool passed = result.exit_status == 2 && result.out.empty() &&
                      std::count(result.err.begin(), result.err.end(), '\n') == 1 &&
                      result.err.compare(0, 11, "tiltrotor: ") == 0 &&
                      result.err.find(message) != std::string::npos;
  if (!CHECK(passed)) NOTE(arguments << ": exit " << result.exit_status << ", stderr: " << result.err);
}

}  // namespace check
