// Runs a program for the tests of the command line (POSIX).
#pragma once

#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "temporary.hpp"

namespace check {

struct ProgramResult {
  int exit_status;  // as a shell counts: 128 + signal when the program was killed
  std::string out;
  std::string err;
};

/// One word of a shell command, whatever characters it holds.
inline std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char c : word) {
    if (c == '\'') {
      result += "'\\''";
    } else {
      result += c;
    }
  }
  return result + "'";
}

/// Command that starts a program the build made: built("tiltrotor"). Programs of another machine need an
/// emulator before them; the table generator is always one of this machine.
inline std::string built(const std::string& name) {
  const std::string path = quoted(std::string(TILTROTOR_BINARY_DIR "/") + name);
  const std::string runner = TILTROTOR_RUNNER;
  return runner.empty() || name == "tablegen" ? path : runner + " " + path;
}

/// Path of a file of the source tree: source_path("tests/states.csv").
inline std::string source_path(const std::string& name) {
  return std::string(TILTROTOR_SOURCE_DIR "/") + name;
}

/// Runs a shell command with an empty standard input; throws when it cannot be started.
inline ProgramResult run_program(const std::string& command) {
  const std::string error_path = new_temporary_file();
  // The newline ends a command that itself ends in a comment.
  FILE* const pipe = popen(("( " + command + "\n) </dev/null 2>" + error_path).c_str(), "r");
  if (pipe == nullptr) {
    unlink(error_path.c_str());
    throw std::runtime_error("run_program: cannot start " + command);
  }
  ProgramResult result{};
  char buffer[4096];
  for (std::size_t length; (length = fread(buffer, 1, sizeof buffer, pipe)) > 0;)
    result.out.append(buffer, length);
  const int status = pclose(pipe);
  constexpr int signal_base = 128;
  result.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : signal_base + WTERMSIG(status);
  std::ifstream errors(error_path, std::ios::binary);
  result.err.assign(std::istreambuf_iterator<char>(errors), std::istreambuf_iterator<char>());
  unlink(error_path.c_str());
  return result;
}

/// Runs the command line program: run_tiltrotor("trim --mast 0 --speed 0").
inline ProgramResult run_tiltrotor(const std::string& arguments) {
  return run_program(built("tiltrotor") + " " + arguments);
}

}  // namespace check
