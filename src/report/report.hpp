// The study of `tiltrotor report`.
#pragma once

#include <string>

namespace tiltrotor::report {

// Writes figures, tables and index.html to an existing folder and a summary to stdout. Returns the exit
// status of the program: 0, or 1 when a case failed.
int run_report(const std::string& folder);

}  // namespace tiltrotor::report
