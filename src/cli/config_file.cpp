#include "cli/config_file.hpp"

#include "cli/errors.hpp"
#include "cli/line_reader.hpp"
#include "text/csv_line.hpp"

namespace tiltrotor::cli {

namespace {

std::string without_comment(const std::string& line) {
  for (std::size_t i = 0; i < line.size(); ++i)
    if (line[i] == '#' && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t')) return line.substr(0, i);
  return line;
}

}  // namespace

Option config_option() {
  return {"--config", "FILE", "more options, one a line: `speed = 80`; those given here win"};
}

std::vector<ConfigLine> read_config(const std::string& path) {
  LineReader lines(path);
  std::vector<ConfigLine> all;
  std::string line;
  while (lines.next(line)) {
    const char* fault = lines.number() == 1 ? csv::begin_file(line) : nullptr;
    if (fault == nullptr && line.find('\0') != std::string::npos) fault = "the line holds a NUL byte";
    if (fault == nullptr && !csv::is_utf8(line)) fault = "the text is not UTF-8";
    if (fault != nullptr) throw UsageError(lines.where() + ": " + fault);
    const std::string text(csv::trimmed(without_comment(line)));
    if (text.empty()) continue;
    const std::size_t end = text.find_first_of("= \t");
    ConfigLine one{text.substr(0, end), "", false, lines.where()};
    if (end != std::string::npos) {
      std::string value(csv::trimmed(std::string_view(text).substr(end)));
      if (value[0] == '=') value = csv::trimmed(std::string_view(value).substr(1));
      one.value = value;
      one.has_value = true;
    }
    if (one.name.empty()) throw UsageError(one.where + ": no name before '='; write name = value");
    if (one.name.rfind("--", 0) != 0) one.name.insert(0, "--");
    all.push_back(one);
  }
  return all;
}

}  // namespace tiltrotor::cli
