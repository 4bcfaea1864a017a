// Lines and words of a drawing, and the sizes that all its parts share.
#pragma once

#include <string>

#include "plot/plot.hpp"

namespace tiltrotor::plot {

inline constexpr double kFont = 13;
inline constexpr double kMargin = 10;
inline constexpr const char* kInk = "#333333";

// `more`: further attributes.
std::string text_at(double x, double y, const std::string& text, const char* anchor, const std::string& color,
                    const std::string& more = "");
std::string line_at(double x1, double y1, double x2, double y2, const std::string& color, double width = 1);

// Attribute that interrupts a stroke; empty for a solid one.
std::string dash_of(Line line);

}  // namespace tiltrotor::plot
