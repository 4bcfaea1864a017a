#include "plot/drawing.hpp"

#include <sstream>

#include "plot/svg.hpp"

namespace tiltrotor::plot {

std::string text_at(double x, double y, const std::string& text, const char* anchor, const std::string& color,
                    const std::string& more) {
  return "<text" + attribute("x", x) + attribute("y", y) + attribute("text-anchor", std::string(anchor)) +
         attribute("fill", color) + more + ">" + escaped(text) + "</text>\n";
}

std::string name_at(double x, double y, const std::string& text, const char* anchor, const std::string& color,
                    const char* weight) {
  return text_at(x, y, text, anchor, color,
                 attribute("font-size", kNameFont) + attribute("font-weight", std::string(weight)) +
                     " paint-order=\"stroke\" stroke=\"#ffffff\" stroke-width=\"3\"");
}

std::string line_at(double x1, double y1, double x2, double y2, const std::string& color, double width) {
  return "<line" + attribute("x1", x1) + attribute("y1", y1) + attribute("x2", x2) + attribute("y2", y2) +
         attribute("stroke", color) + attribute("stroke-width", width) + "/>\n";
}

std::string dash_of(Line line) {
  return line == Line::dashed   ? attribute("stroke-dasharray", std::string("7 4"))
         : line == Line::dotted ? attribute("stroke-dasharray", std::string("2 3"))
                                : "";
}

std::vector<std::string> wrapped(const std::string& text, double font_size, double width) {
  constexpr double running = 0.87;  // over the estimate, which is for short words and numbers
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool fits = !lines.empty() && running * text_width(lines.back() + " " + word, font_size) <= width;
    if (fits) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

}  // namespace tiltrotor::plot
