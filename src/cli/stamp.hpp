// --stamp: who made a CSV file and how, in comment lines at its beginning.
#pragma once

#include <string>

#include "cli/arguments.hpp"

namespace tiltrotor::cli {

Option stamp_option();

// "# tiltrotor 0.2.0, aircraft XV-15, ..." and "# tiltrotor trim --speed 40", the command that makes the same results
// anywhere; nothing without --stamp. `format`: that of the output, csv, table or matlab, whose comments
// begin with %; json holds none.
std::string stamp_of(const Arguments& arguments, const std::string& format = "csv");

}  // namespace tiltrotor::cli
