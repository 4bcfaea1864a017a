// The two ways in which a command ends early; main.cpp turns each into one line on stderr and an exit status.
#pragma once

#include <stdexcept>
#include <string>

namespace tiltrotor::cli {

enum ExitStatus { exit_success = 0, exit_case_failed = 1, exit_bad_usage = 2 };

// The user asked for something that cannot be: exit status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Results could not be written, for example to a full disk or a closed pipe: exit status 1.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace tiltrotor::cli
