#include "plot/drawing.hpp"

#include "plot/svg.hpp"

namespace tiltrotor::plot {

std::string text_at(double x, double y, const std::string& text, const char* anchor, const std::string& color,
                    const std::string& more) {
  return "<text" + attribute("x", x) + attribute("y", y) + attribute("text-anchor", std::string(anchor)) +
         attribute("fill", color) + more + ">" + escaped(text) + "</text>\n";
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

}  // namespace tiltrotor::plot
