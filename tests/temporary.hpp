// Temporary files and folders of the tests, in TMPDIR or /tmp.
#pragma once

#include <stdlib.h>
#include <unistd.h>

#include <stdexcept>
#include <string>

namespace check {

// What mkstemp() and mkdtemp() make a new name of.
inline std::string temporary_pattern() {
  const char* const folder = std::getenv("TMPDIR");
  return std::string(folder != nullptr && *folder != '\0' ? folder : "/tmp") + "/tiltrotor-" +
         std::string(6, 'X');
}

/// A new empty folder; the caller removes it.
inline std::string new_temporary_folder() {
  std::string path = temporary_pattern();
  if (mkdtemp(path.data()) == nullptr) throw std::runtime_error("no temporary folder: " + path);
  return path;
}

/// A new empty file; the caller removes it.
inline std::string new_temporary_file() {
  std::string path = temporary_pattern();
  const int descriptor = mkstemp(path.data());
  if (descriptor < 0) throw std::runtime_error("no temporary file: " + path);
  close(descriptor);
  return path;
}

}  // namespace check
