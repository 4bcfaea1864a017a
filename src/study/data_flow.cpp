// The block picture of the model: what one evaluation of xdot = f(x, u) does, in its order.

#include "plot/plot.hpp"
#include "plot/svg.hpp"
#include "study/sections.hpp"

namespace tiltrotor::study {

using namespace plot;

namespace {

struct Block {
  const char* name;
  const char* text;  // second line
  double x, y, width, height;
  const char* color;
};

constexpr const char* kInputColor = "#e8f1f8";
constexpr const char* kPartColor = "#fdf3e3";
constexpr const char* kBodyColor = "#e6f4ee";
constexpr double kTall = 46;

// Rows from top to bottom are the order of evaluation; no arrow points upwards but the last.
constexpr Block kBlocks[] = {
    {"State x", "motion, attitude, flapping, inflow, wash", 10, 44, 290, kTall, kInputColor},
    {"Controls u", "lever, sticks, pedal", 316, 44, 154, kTall, kInputColor},
    {"Control mixing", "gearing by mast angle", 316, 122, 154, kTall, kPartColor},
    {"Hub motion", "arm, mast tilt, mirror", 10, 122, 150, kTall, kPartColor},
    {"Blade elements", "24 × 20 a rotor", 10, 200, 150, kTall, kPartColor},
    {"Flapping", "gimbal, second order", 176, 200, 140, kTall, kPartColor},
    {"Inflow", "three states a rotor", 332, 200, 138, kTall, kPartColor},
    {"Rotor wake", "axis, contraction, area", 10, 278, 150, kTall, kPartColor},
    {"Wing and pylons", "in the wake, and free", 176, 278, 140, kTall, kPartColor},
    {"Fuselage", "", 332, 278, 138, kTall, kPartColor},
    {"Horizontal tail", "wing and rotor wash", 10, 356, 150, kTall, kPartColor},
    {"Fins", "sidewash", 176, 356, 140, kTall, kPartColor},
    {"Sum of loads", "about the CG", 332, 356, 138, kTall, kBodyColor},
    {"Rigid body", "six degrees of freedom", 332, 434, 138, kTall, kBodyColor},
    {"Rates of the state", "value and exact derivatives", 10, 434, 306, kTall, kInputColor},
};

struct Arrow {
  const char* from;
  const char* to;
  const char* carries;
  double x1, y1, x2, y2;
};
constexpr Arrow kArrows[] = {
    {"Controls u", "Control mixing", "inches", 393, 90, 393, 122},
    {"State x", "Hub motion", "speed, rates", 85, 90, 85, 122},
    {"Control mixing", "Blade elements", "blade pitch", 316, 152, 160, 206},
    {"Hub motion", "Blade elements", "hub speed", 70, 168, 70, 200},
    {"Blade elements", "Flapping", "hub moment", 160, 223, 176, 223},
    {"Flapping", "Inflow", "", 316, 223, 332, 223},
    {"Blade elements", "Rotor wake", "force", 85, 246, 85, 278},
    {"Rotor wake", "Wing and pylons", "wash", 160, 301, 176, 301},
    {"Wing and pylons", "Horizontal tail", "downwash", 216, 324, 130, 356},
    {"Wing and pylons", "Sum of loads", "loads", 300, 324, 350, 356},
    {"Fuselage", "Sum of loads", "loads", 420, 324, 420, 356},
    {"Rotor wake", "Horizontal tail", "rotor wash", 60, 324, 60, 356},
    {"Fins", "Sum of loads", "loads", 316, 379, 332, 379},
    {"Horizontal tail", "Fins", "", 160, 379, 176, 379},
    {"Sum of loads", "Rigid body", "total", 401, 402, 401, 434},
    {"Rigid body", "Rates of the state", "", 332, 457, 316, 457},
};

Table block_table() {
  Table table({"name", "text", "x", "y", "width", "height", "color"});
  for (const Block& b : kBlocks) {
    table.add({std::string(b.name), std::string(b.text), b.x, b.y, b.width, b.height, std::string(b.color)});
  }
  return table;
}

Table arrow_table() {
  Table table({"from", "to", "carries", "x1", "y1", "x2", "y2"});
  for (const Arrow& a : kArrows) {
    table.add({std::string(a.from), std::string(a.to), std::string(a.carries), a.x1, a.y1, a.x2, a.y2});
  }
  return table;
}

std::string text_at(double x, double y, const std::string& text, double size, const char* anchor,
                    const char* more = "") {
  return "<text" + attribute("x", x) + attribute("y", y) + attribute("font-size", size) +
         attribute("text-anchor", std::string(anchor)) + more + ">" + escaped(text) + "</text>\n";
}

Picture picture(const Table& blocks, const Table& arrows) {
  constexpr double width = 480;
  constexpr double height = 500;
  const std::string title = "Data flow of one evaluation";
  std::string out = open_svg(width, height, title);
  out += "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  out +=
      "<defs><marker id=\"data_flow_head\" viewBox=\"0 0 8 8\" refX=\"7\" refY=\"4\" markerWidth=\"7\" "
      "markerHeight=\"7\" orient=\"auto\"><path d=\"M0 0L8 4L0 8z\" fill=\"#555555\"/></marker></defs>\n";
  out += text_at(10, 24, title, 14, "start", " font-weight=\"600\"");
  for (std::size_t i = 0; i < blocks.rows(); ++i) {
    const double x = blocks.number(i, "x");
    const double y = blocks.number(i, "y");
    const double w = blocks.number(i, "width");
    const std::string& text = blocks.text(i, "text");
    out += "<rect" + attribute("x", x) + attribute("y", y) + attribute("width", w) +
           attribute("height", blocks.number(i, "height")) + attribute("fill", blocks.text(i, "color")) +
           " stroke=\"#888888\" rx=\"5\"/>\n";
    out += text_at(x + w / 2, y + (text.empty() ? 28 : 20), blocks.text(i, "name"), 13, "middle",
                   " font-weight=\"600\"");
    if (!text.empty()) out += text_at(x + w / 2, y + 37, text, 11.5, "middle");
  }
  for (std::size_t i = 0; i < arrows.rows(); ++i) {
    const double x1 = arrows.number(i, "x1");
    const double y1 = arrows.number(i, "y1");
    const double x2 = arrows.number(i, "x2");
    const double y2 = arrows.number(i, "y2");
    out += "<line" + attribute("x1", x1) + attribute("y1", y1) + attribute("x2", x2) + attribute("y2", y2) +
           " stroke=\"#555555\" stroke-width=\"1.4\" marker-end=\"url(#data_flow_head)\"/>\n";
    const std::string& carries = arrows.text(i, "carries");
    const bool has_room = y2 - y1 > 20;
    // Beside the line, on the side it leaves free.
    const double drop = x2 < x1 - 40 ? 13 : x2 > x1 + 20 ? 0 : 4;
    if (has_room && !carries.empty())
      out += text_at((x1 + x2) / 2 + 8, (y1 + y2) / 2 + drop, carries, 11.5, "start");
  }
  return {"data_flow", out + "</svg>\n"};
}

}  // namespace

Section data_flow() {
  Section section{"flow", "How the model works", "", {}, {}, {}};
  section.reading =
      "One evaluation runs from top to bottom; nothing is iterated, because flapping, inflow and the wing's "
      "downwash are "
      "states. The same code runs on plain numbers and on numbers that carry their derivatives, which makes "
      "trim, linear "
      "models and responses exact.";
  const Table blocks = block_table();
  const Table arrows = arrow_table();
  section.pictures = {picture(blocks, arrows)};
  section.tables.push_back({"data_flow_blocks", "the blocks", blocks});
  section.tables.push_back({"data_flow_arrows", "what flows between them", arrows});
  return section;
}

}  // namespace tiltrotor::study
