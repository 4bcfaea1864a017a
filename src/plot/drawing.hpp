// Lines and words of a drawing, and the sizes that all its parts share.
#pragma once

#include <string>
#include <vector>

#include "plot/plot.hpp"

namespace tiltrotor::plot {

inline constexpr double kFont = 13;
inline constexpr double kNameFont = 12;
inline constexpr double kSmallFont = 11;
inline constexpr double kMargin = 10;
inline constexpr const char* kInk = "#333333";

// `more`: further attributes.
std::string text_at(double x, double y, const std::string& text, const char* anchor, const std::string& color,
                    const std::string& more = "");
// On lines and markers: with a white rim, which keeps it legible.
std::string name_at(double x, double y, const std::string& text, const char* anchor, const std::string& color,
                    const char* weight);
std::string line_at(double x1, double y1, double x2, double y2, const std::string& color, double width = 1);

// Attribute that interrupts a stroke; empty for a solid one.
std::string dash_of(Line line);

// A text in lines that are no wider than that, broken at its spaces.
std::vector<std::string> wrapped(const std::string& text, double font_size, double width);

}  // namespace tiltrotor::plot
