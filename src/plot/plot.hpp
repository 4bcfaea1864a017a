// A plot as an SVG drawing: axes with units, lines with their names at them, markers, filled cells, labels; above
// the axes a key of the markers and a bar of the colours, below them a note. One plot is one drawing, wide enough
// to be read on a phone.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "plot/colors.hpp"

namespace tiltrotor::plot {

enum class Marker : unsigned char { none, circle, square, triangle, diamond, cross, plus };
enum class Line : unsigned char { none, solid, dashed, dotted };

struct Series {
  std::string name;  // of a line at its curve where there is room, else in the key; may be empty
  std::string color = kBlue;
  Line line = Line::solid;
  double width = 2;  // of the line
  Marker marker = Marker::none;
  bool filled = true;            // markers
  double marker_size = 4;        // half their width
  std::vector<double> x, y;      // a value that is not finite interrupts the line
  std::vector<std::string> tip;  // text shown by a browser over each marker; may be empty
};

// An area between two curves, filled under the lines.
struct Band {
  std::string color = kBlue;
  std::vector<double> x, low, high;  // a value that is not finite interrupts it
};

// Text at a point of the plot.
struct Label {
  double x, y;
  std::string text;
  std::string color = kBlack;
  double dx = 6, dy = -6;  // distance from the point, drawing units
};

// Rectangles filled by value: value[i * (y_edge.size() - 1) + j] between x_edge[i..i+1] and y_edge[j..j+1].
struct Cells {
  std::vector<double> x_edge, y_edge;
  std::vector<double> value;       // not finite: left empty
  std::vector<double> level;       // limits between the colours, rising
  std::vector<std::string> color;  // one more than levels
  std::string label;               // of the bar of colours, with its unit
};

struct Axis {
  std::string label;  // with its unit
  bool logarithmic = false;
  double low = std::numeric_limits<double>::quiet_NaN(),
         high = std::numeric_limits<double>::quiet_NaN();  // not given: taken from the data
  bool zero_line = false;
};

struct Plot {
  std::string id;  // unique in a page: letters, digits, '_'
  std::string title;
  Axis x, y;
  Cells cells;
  std::vector<Band> bands;     // above the cells
  std::vector<Series> series;  // drawn in this order, above the bands
  std::vector<Label> labels;
  std::string note;  // below, small: with what it was drawn
  double width = 420;
  double axes_height = 250;  // of the area inside the axes
  bool equal_scale = false;  // a unit is as long along y as along x; the height follows
};

// Points outside the axes are clipped (lines, bands) or left out (markers, labels).
std::string svg(const Plot& plot);

}  // namespace tiltrotor::plot
