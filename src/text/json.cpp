#include "text/json.hpp"

#include <cmath>
#include <utility>

#include "text/csv_line.hpp"
#include "text/number.hpp"

namespace tiltrotor::text {

std::string json_text(const std::string& text) {
  constexpr char hex[] = "0123456789abcdef";
  std::string out = "\"";
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (code < 0x20) {
      out += "\\u00";
      out += hex[code >> 4];
      out += hex[code & 15];
    } else if (const std::size_t length = csv::utf8_length(text, i); length > 0) {
      out += text.substr(i, length);
      i += length - 1;
    } else {
      out += "\\ufffd";
    }
  }
  return out + '"';
}

std::string json_number(double value) { return std::isfinite(value) ? number_text(value) : "null"; }

std::string json_array(const std::vector<double>& values) {
  std::string out = "[";
  for (std::size_t i = 0; i < values.size(); ++i) out += (i > 0 ? ", " : "") + json_number(values[i]);
  return out + "]";
}

std::string json_object(const std::vector<JsonMember>& members) {
  std::string out = "{";
  for (std::size_t i = 0; i < members.size(); ++i) {
    out += (i > 0 ? ", " : "") + json_text(members[i].first) + ": " + members[i].second;
  }
  return out + "}";
}

}  // namespace tiltrotor::text
