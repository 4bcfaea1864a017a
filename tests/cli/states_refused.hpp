// Files of states that no command takes, for tests.
#pragma once

#include <algorithm>
#include <string>

#include "check.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"

namespace check {

inline auto lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Every command that reads states refuses the text with one line that holds the message; nothing is computed.
inline void check_states_refused(const ScratchFolder& folder, const std::string& text,
                                 const std::string& message, const std::string& options = "") {
  const std::string path = folder.write("states.csv", text);
  for (const char* command : {"derivative", "loads", "linearize"}) {
    const ProgramResult result = run_tiltrotor(std::string(command) + " --states " + path + " " + options);
    const bool passed = result.exit_status == 2 && result.out.empty() && lines(result.err) == 1 &&
                        contains(result.err, message);
    if (!CHECK(passed)) NOTE(message << ": exit " << result.exit_status << ", stderr: " << result.err);
  }
}

}  // namespace check
