// Lines of a comma-separated file as RFC 4180 has them, for every reader of such files.
//
// UTF-8, with or without byte-order mark, lines ended by LF or CRLF. A cell in double quotes may hold commas,
// and a doubled quote stands for itself; it ends on its own line. Blanks around a cell do not count.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace csv {

inline constexpr std::string_view kBlanks = " \t\r";

inline std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// Length of the UTF-8 character at `place`, 0 where there is none: overlong forms, surrogates and numbers
// beyond U+10FFFF are none.
inline std::size_t utf8_length(std::string_view text, std::size_t place) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return place + i < text.size() ? static_cast<unsigned char>(text[place + i]) : 0u;
  };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const unsigned second = byte(1);
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool not_a_character = (first == 0xed && second > 0x9f) || (first == 0xf4 && second > 0x8f);
  return overlong || not_a_character ? 0 : length;
}

inline bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

// What is wrong with the first line of a file, or null; takes the byte-order mark of UTF-8 away.
inline const char* begin_file(std::string& first_line) {
  const std::string_view two = std::string_view(first_line).substr(0, 2);
  if (two == "\xff\xfe" || two == "\xfe\xff") return "the file is UTF-16; save it as UTF-8";
  if (first_line.compare(0, 3, "\xef\xbb\xbf") == 0) first_line.erase(0, 3);
  const std::string_view text = trimmed(first_line);
  if (!text.empty() && (text[0] == '{' || text[0] == '[')) return "the file is JSON; CSV is read";
  if (text.find('\r') != std::string_view::npos)
    return "the lines end with CR alone; end them with LF or CRLF";
  return nullptr;
}

// What is wrong with the line, or null; fills `cells`.
inline const char* split_line(std::string_view line, std::vector<std::string>& cells) {
  cells.clear();
  if (line.find('\0') != std::string_view::npos) return "the line holds a NUL byte";
  if (!is_utf8(line)) return "the text is not UTF-8";
  std::size_t i = 0;
  for (;;) {
    while (i < line.size() && kBlanks.find(line[i]) != std::string_view::npos) ++i;
    cells.emplace_back();
    if (i < line.size() && line[i] == '"') {
      for (++i;; ++i) {
        if (i >= line.size()) return "a quotation mark is not closed on its line";
        const bool quote = line[i] == '"';
        if (quote && (i + 1 >= line.size() || line[i + 1] != '"')) break;
        if (quote) ++i;
        cells.back() += line[i];
      }
      ++i;
      const std::size_t end = line.find(',', i);
      if (!trimmed(line.substr(i, end == std::string_view::npos ? end : end - i)).empty())
        return "text follows a closed quotation mark";
      i = end;
    } else {
      const std::size_t end = line.find(',', i);
      cells.back() = trimmed(line.substr(i, end == std::string_view::npos ? end : end - i));
      if (cells.back().find('"') != std::string::npos)
        return "a quotation mark stands inside a cell; double it and put the cell in quotation marks";
      i = end;
    }
    if (i == std::string_view::npos) return nullptr;
    ++i;
  }
}

}  // namespace csv
