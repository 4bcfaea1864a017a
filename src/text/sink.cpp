#include "text/sink.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <vector>

#include "text/errors.hpp"

namespace tiltrotor::text {

namespace {

std::string reason() { return std::strerror(errno); }

// The process number keeps two programs that write the same file apart.
std::string temporary_name(const std::string& path) { return path + ".part" + std::to_string(getpid()); }

constexpr int kInterruptions[] = {SIGINT, SIGTERM, SIGHUP};

// The handler may look at the list at any moment, so it changes only while these signals wait.
std::vector<std::string> unfinished_files;

class SignalsWait {
 public:
  SignalsWait() {
    sigset_t waiting;
    sigemptyset(&waiting);
    for (const int signal : kInterruptions) sigaddset(&waiting, signal);
    sigprocmask(SIG_BLOCK, &waiting, &before_);
  }
  ~SignalsWait() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;

 private:
  sigset_t before_;
};

// With owner and mode of the file that it will replace, where there is one and as far as the system allows.
std::FILE* open_unfinished(const std::string& path, const std::string& replaced) {
  const SignalsWait wait;
  struct stat old = {};
  const bool replaces = stat(replaced.c_str(), &old) == 0;
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, replaces ? 0600 : 0666);
  if (file < 0) return nullptr;
  unfinished_files.push_back(path);
  if (replaces) {
    const bool is_owner = fchown(file, old.st_uid, old.st_gid) == 0;
    (void)fchmod(file, old.st_mode & (is_owner ? 07777 : 0777));
  }
  return fdopen(file, "wb");
}

// Gives the file its name, or removes it when `name` is empty or cannot be given; errno tells why.
bool settle(const std::string& path, const std::string& name) {
  const SignalsWait wait;
  unfinished_files.erase(std::remove(unfinished_files.begin(), unfinished_files.end(), path),
                         unfinished_files.end());
  if (!name.empty() && std::rename(path.c_str(), name.c_str()) == 0) return true;
  const int why = errno;
  std::remove(path.c_str());
  errno = why;
  return false;
}

// Calls nothing that is not allowed in a signal handler.
extern "C" void on_interruption(int signal) {
  for (const std::string& path : unfinished_files) unlink(path.c_str());
  constexpr char message[] = "tiltrotor: interrupted; nothing was written under its final name\n";
  (void)!write(STDERR_FILENO, message, sizeof message - 1);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void clean_up_when_interrupted() {
  for (const int signal : kInterruptions) {
    struct sigaction action = {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler == SIG_IGN) continue;  // under nohup
    action = {};
    action.sa_handler = on_interruption;
    sigaction(signal, &action, nullptr);
  }
}

Sink::Sink(const std::string& path, const std::string& where) : path_(path), file_(stdout) {
  if (path == "-") return;
  if (path.empty()) throw UsageError(where + ": the name is empty; give a file, or - for standard output");
  std::error_code error;
  const std::filesystem::file_status existing = std::filesystem::status(path, error);
  if (std::filesystem::is_directory(existing)) throw UsageError(where + ": " + path + " is a folder");
  if (std::filesystem::is_regular_file(existing)) {
    path_ = std::filesystem::canonical(path).string();  // behind links
    if (access(path_.c_str(), W_OK) != 0)
      throw UsageError(where + ": cannot write " + path + ": " + reason());
  }
  if (!std::filesystem::exists(existing)) {
    const std::filesystem::path folder =
        std::filesystem::canonical(std::filesystem::absolute(path).parent_path(), error);
    if (!error) path_ = (folder / std::filesystem::path(path).filename()).string();  // one name a file
  }
  if (!std::filesystem::is_other(existing)) temporary_path_ = temporary_name(path_);
  if (std::count(unfinished_files.begin(), unfinished_files.end(), temporary_path_) > 0)
    throw UsageError(where + ": " + path + " is written twice in one run");
  file_ = temporary_path_.empty() ? std::fopen(path_.c_str(), "wb") : open_unfinished(temporary_path_, path_);
  if (file_ == nullptr) throw UsageError(where + ": cannot write " + path + ": " + reason());
}

Sink::~Sink() {
  if (file_ == nullptr || file_ == stdout) return;
  std::fclose(file_);
  if (!temporary_path_.empty()) settle(temporary_path_, "");
}

void Sink::write(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail();
}

void Sink::finish() {
  if (std::fflush(file_) != 0) fail();
  if (file_ == stdout) return;
  const bool closed = std::fclose(file_) == 0;
  file_ = nullptr;
  std::string why = reason();
  if (!temporary_path_.empty()) {
    const bool named = settle(temporary_path_, closed ? path_ : "");
    if (named) return;
    if (closed) why = reason();
  } else if (closed) {
    return;
  }
  throw OutputError("cannot write " + path_ + ": " + why);
}

bool Sink::is_terminal() const { return isatty(fileno(file_)) != 0; }

void Sink::fail() {
  if (file_ == stdout && errno == EPIPE) throw ReaderLeft("the reader of standard output left");
  throw OutputError("cannot write " + (file_ == stdout ? std::string("to standard output") : path_) + ": " +
                    reason());
}

void require_writable_folder(const std::string& folder, const std::string& where) {
  if (folder.empty()) throw UsageError(where + ": the name is empty; give a folder");
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder)) {
    throw UsageError(where + ": cannot create folder " + folder + (error ? ": " + error.message() : ""));
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    throw UsageError(where + ": cannot write in folder " + folder + ": " + reason());
  }
}

}  // namespace tiltrotor::text
