// Lines of a file that may be read several times, without holding more than one.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

namespace tiltrotor::cli {

class LineReader {
 public:
  // "-" is standard input. A pipe is copied into a temporary file. Throws UsageError "<path>: cannot be read:
  // ...".
  explicit LineReader(const std::string& path);

  // Lines of a text under a name.
  LineReader(const std::string& name, const std::string& text);

  // The next line without its end, or false at the end of the file. Throws UsageError "<path>:<line>: ...".
  bool next(std::string& line);
  const std::string& path() const { return path_; }
  std::size_t number() const { return number_; }  // of the last line, from 1
  std::string where() const { return path_ + ":" + std::to_string(number_); }
  void rewind();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  [[noreturn]] void fail() const;
  void copy();

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::size_t number_ = 0;
};

}  // namespace tiltrotor::cli
