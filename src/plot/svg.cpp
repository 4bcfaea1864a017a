#include "plot/svg.hpp"

#include <cmath>

#include "text/number.hpp"

namespace tiltrotor::plot {

std::string escaped(const std::string& text) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t') result += c;
    }
  }
  return result;
}

std::string coordinate(double value) {
  const double rounded = std::round(value * 100) / 100;
  return text::number_text(rounded == 0 ? 0.0 : rounded);  // no minus zero
}

std::string attribute(const char* name, double value) { return attribute(name, coordinate(value)); }

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + escaped(value) + "\"";
}

std::string open_svg(double width, double height, const std::string& title) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\"" +
         attribute("viewBox", "0 0 " + coordinate(width) + " " + coordinate(height)) +
         " role=\"img\" font-family=\"system-ui, 'Segoe UI', Roboto, 'DejaVu Sans', sans-serif\">\n<title>" +
         escaped(title) + "</title>\n";
}

double text_width(const std::string& text, double font_size) {
  constexpr double em_per_character = 0.58;
  std::size_t characters = 0;
  for (const char c : text)
    characters += (static_cast<unsigned char>(c) & 0xC0) != 0x80;  // UTF-8 first bytes
  return em_per_character * font_size * static_cast<double>(characters);
}

}  // namespace tiltrotor::plot
