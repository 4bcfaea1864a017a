// The ways in which a command ends early; main.cpp turns each into an exit status and, but for the last, one
// line on stderr.
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

// Results could not be written, for example to a full disk: exit status 1.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Whoever read standard output has seen enough, as `head` does: exit status 1 and no word.
class ReaderLeft : public OutputError {
 public:
  using OutputError::OutputError;
};

}  // namespace tiltrotor::cli
