// Small parts of an SVG document.
#pragma once

#include <string>

namespace tiltrotor::plot {

// Text for the inside of an element or of an attribute: & < > " and ' replaced, control characters dropped.
std::string escaped(const std::string& text);

// A coordinate: two decimals, no trailing zeros.
std::string coordinate(double value);

// ` name="value"`
std::string attribute(const char* name, double value);
std::string attribute(const char* name, const std::string& value);

// Opening tag of a drawing of that size, with its title for screen readers.
std::string open_svg(double width, double height, const std::string& title);

// Width on paper, estimated: 0.58 em for a character.
double text_width(const std::string& text, double font_size);

}  // namespace tiltrotor::plot
