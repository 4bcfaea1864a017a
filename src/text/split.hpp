// Parts of a text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tiltrotor::text {

// Parts of `text` between the separators; an empty text is one empty part.
inline std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

}  // namespace tiltrotor::text
