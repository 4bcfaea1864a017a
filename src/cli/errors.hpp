// How a command ends. One that ends early throws an error of text/errors.hpp: main.cpp turns UsageError into exit
// status 2, every other into 1, and each but ReaderLeft into one line on stderr.
#pragma once

#include "text/errors.hpp"

namespace tiltrotor::cli {

using namespace text;  // the command line is made of what is read and written as text

inline constexpr int exit_success = 0;
inline constexpr int exit_case_failed = 1;
inline constexpr int exit_bad_usage = 2;

}  // namespace tiltrotor::cli
