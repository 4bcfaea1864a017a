#include "cli/sink.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "cli/errors.hpp"

namespace tiltrotor::cli {

namespace {

std::string reason() { return std::strerror(errno); }

// The process number keeps two programs that write the same file apart.
std::string temporary_name(const std::string& path) { return path + ".part" + std::to_string(getpid()); }

}  // namespace

Sink::Sink(const std::string& path, const std::string& where) : path_(path), file_(stdout) {
  if (path == "-") return;
  std::error_code error;
  const std::filesystem::file_status existing = std::filesystem::status(path, error);
  if (std::filesystem::is_directory(existing)) throw UsageError(where + ": " + path + " is a folder");
  if (std::filesystem::is_regular_file(existing))
    path_ = std::filesystem::canonical(path).string();  // behind links
  if (!std::filesystem::is_other(existing)) temporary_path_ = temporary_name(path_);
  file_ = std::fopen(temporary_path_.empty() ? path_.c_str() : temporary_path_.c_str(), "wb");
  if (file_ == nullptr) throw UsageError(where + ": cannot write " + path + ": " + reason());
}

Sink::~Sink() {
  if (file_ == nullptr || file_ == stdout) return;
  std::fclose(file_);
  if (!temporary_path_.empty()) std::remove(temporary_path_.c_str());
}

void Sink::write(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail();
}

void Sink::finish() {
  if (std::fflush(file_) != 0) fail();
  if (file_ == stdout) return;
  const bool closed = std::fclose(file_) == 0;
  file_ = nullptr;
  if (closed && (temporary_path_.empty() || std::rename(temporary_path_.c_str(), path_.c_str()) == 0)) return;
  const std::string why = reason();
  if (!temporary_path_.empty()) std::remove(temporary_path_.c_str());
  throw OutputError("cannot write " + path_ + ": " + why);
}

bool Sink::is_terminal() const { return isatty(fileno(file_)) != 0; }

void Sink::fail() {
  throw OutputError("cannot write " + (file_ == stdout ? std::string("to standard output") : path_) + ": " +
                    reason());
}

void require_writable_folder(const std::string& folder, const std::string& where) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder)) {
    throw UsageError(where + ": cannot create folder " + folder + (error ? ": " + error.message() : ""));
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    throw UsageError(where + ": cannot write in folder " + folder + ": " + reason());
  }
}

}  // namespace tiltrotor::cli
