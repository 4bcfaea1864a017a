#include "cli/line_reader.hpp"

#include <cerrno>
#include <cstring>

#include "cli/errors.hpp"

namespace tiltrotor::cli {

LineReader::LineReader(const std::string& path)
    : path_(path == "-" ? "standard input" : path),
      file_(path == "-" ? stdin : std::fopen(path.c_str(), "rb")) {
  if (!file_) fail();
  if (std::fseek(file_.get(), 0, SEEK_SET) != 0) copy();
}

LineReader::LineReader(const std::string& name, const std::string& text)
    : path_(name), file_(std::tmpfile()) {
  if (!file_ || std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) fail();
  std::rewind(file_.get());
}

bool LineReader::next(std::string& line) {
  constexpr std::size_t longest = 1 << 20;
  line.clear();
  int c = getc_unlocked(file_.get());
  if (c == EOF && std::ferror(file_.get()) != 0) fail();
  if (c == EOF) return false;
  ++number_;
  for (; c != EOF && c != '\n'; c = getc_unlocked(file_.get())) {
    if (line.size() == longest)
      throw UsageError(
          where() + ": the line is longer than a megabyte" +
          (line.find('\r') == std::string::npos ? "" : "; end lines with LF or CRLF, not with CR alone"));
    line += static_cast<char>(c);
  }
  if (std::ferror(file_.get()) != 0) fail();
  return true;
}

void LineReader::rewind() {
  std::rewind(file_.get());
  number_ = 0;
}

void LineReader::copy() {
  std::unique_ptr<std::FILE, Close> whole(std::tmpfile());
  if (!whole) fail();
  char block[1 << 16];
  for (std::size_t size; (size = std::fread(block, 1, sizeof block, file_.get())) > 0;)
    if (std::fwrite(block, 1, size, whole.get()) != size) fail();
  if (std::ferror(file_.get()) != 0) fail();
  file_ = std::move(whole);
  std::rewind(file_.get());
}

void LineReader::fail() const { throw UsageError(path_ + ": cannot be read: " + std::strerror(errno)); }

}  // namespace tiltrotor::cli
