// The ways in which reading and writing end early, each with one line for the user.
#pragma once

#include <stdexcept>
#include <string>

namespace tiltrotor::text {

// The user asked for something that cannot be.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Results could not be written, for example to a full disk.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Whoever read standard output has seen enough, as `head` does: no word is said.
class ReaderLeft : public OutputError {
 public:
  using OutputError::OutputError;
};

}  // namespace tiltrotor::text
