#include "plot/marker.hpp"

#include "plot/svg.hpp"

namespace tiltrotor::plot {

namespace {

// "M x y" and relative moves, scaled by the size.
std::string outline(Marker marker, double x, double y, double s) {
  const auto from = [&](double dx, double dy) {
    return "M" + coordinate(x + dx * s) + " " + coordinate(y + dy * s);
  };
  const auto move = [&](double dx, double dy) { return "l" + coordinate(dx * s) + " " + coordinate(dy * s); };
  switch (marker) {
    case Marker::square:
      return from(-0.9, -0.9) + move(1.8, 0) + move(0, 1.8) + move(-1.8, 0) + "z";
    case Marker::triangle:
      return from(0, -1.15) + move(1.1, 2) + move(-2.2, 0) + "z";
    case Marker::diamond:
      return from(0, -1.25) + move(1.25, 1.25) + move(-1.25, 1.25) + move(-1.25, -1.25) + "z";
    case Marker::cross:
      return from(-1, -1) + move(2, 2) + from(-1, 1) + move(2, -2);
    case Marker::plus:
      return from(-1.2, 0) + move(2.4, 0) + from(0, -1.2) + move(0, 2.4);
    default:
      return "";
  }
}

}  // namespace

std::string marker_svg(Marker marker, double x, double y, double size, const std::string& color, bool filled,
                       const std::string& tip) {
  if (marker == Marker::none) return "";
  const std::string paint = attribute("fill", filled ? color : std::string("#ffffff")) +
                            attribute("stroke", color) + attribute("stroke-width", 1.4);
  const bool circle = marker == Marker::circle;
  const std::string shape =
      circle ? "<circle" + attribute("cx", x) + attribute("cy", y) + attribute("r", size) + paint
             : "<path" + attribute("d", outline(marker, x, y, size)) + paint;
  if (tip.empty()) return shape + "/>\n";
  return shape + "><title>" + escaped(tip) + "</title></" + (circle ? "circle" : "path") + ">\n";
}

}  // namespace tiltrotor::plot
