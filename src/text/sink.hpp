// Where results go: standard output, or a file that appears under its name only when it is complete.
#pragma once

#include <cstdio>
#include <string>

namespace tiltrotor::text {

class Sink {
 public:
  // "-" is standard output; a device or pipe is written in place. Throws UsageError "<where>: ..." when the
  // file cannot be created.
  explicit Sink(const std::string& path, const std::string& where);
  // A file that was not finished is removed.
  ~Sink();
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;

  // Throws OutputError on a full disk or a closed pipe.
  void write(const std::string& text);
  // Hands everything over and gives the file its name; without this call the file never existed.
  void finish();

  bool is_terminal() const;

 private:
  [[noreturn]] void fail();

  std::string path_;
  std::string temporary_path_;  // empty: written in place
  std::FILE* file_;             // null: finished
};

// From here on SIGINT, SIGTERM and SIGHUP remove unfinished files and say so before they end the program.
void clean_up_when_interrupted();

// Creates the folder, with its parents, and tries to write in it. Throws UsageError "<where>: ...".
void require_writable_folder(const std::string& folder, const std::string& where);

}  // namespace tiltrotor::text
