// Names of lines: at their curve where they cover nothing, else in the key; notes in lines that fit; a bar of colours.
// Expected: geometry, and the rectangle that a name takes by the estimate of its width.
#include "plot/curve_names.hpp"

#include <cmath>

#include "check.hpp"
#include "plot/drawing.hpp"
#include "plot/plot.hpp"
#include "plot/svg.hpp"
#include "plot/xml_check.hpp"

using namespace tiltrotor::plot;

namespace {

Series line(const std::string& name, std::vector<double> x, std::vector<double> y) {
  Series s;
  s.name = name;
  s.x = std::move(x);
  s.y = std::move(y);
  return s;
}

Plot plot_of(std::vector<Series> series) {
  Plot plot;
  plot.id = "test";
  plot.title = "Title";
  plot.x = {"x", false, 0, 10, false};
  plot.y = {"y", false, 0, 10, false};
  plot.series = std::move(series);
  return plot;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

// Two lines far apart: each name lies inside the axes, nearer to its own line, and no line crosses it.
TEST(report_plot_names_each_line_at_its_curve) {
  const Plot plot = plot_of({line("lower", {0, 10}, {2, 3}), line("upper", {0, 10}, {7, 8})});
  const Layout at = layout(plot, 0);
  const std::vector<CurveName> names = curve_names(plot, at);
  if (!CHECK_EQ(names.size(), std::size_t{2})) return;
  for (const CurveName& n : names) {
    const double right = n.x + text_width(n.series->name, kNameFont);
    CHECK(n.x > at.left && right < at.right && n.y - 12 > at.top && n.y < at.bottom);
    for (const double x : {n.x, right}) {
      const double part = (x - at.left) / (at.right - at.left);
      const double low = at.py(2 + part);
      const double high = at.py(7 + part);
      const bool is_lower = n.series->name == "lower";
      CHECK(std::fabs(n.y - 5 - (is_lower ? low : high)) < std::fabs(n.y - 5 - (is_lower ? high : low)));
      CHECK(low < n.y - 10 || low > n.y);
      CHECK(high < n.y - 10 || high > n.y);
    }
  }
  // The key above the axes has neither: the axes begin as high as without names.
  CHECK_EQ(svg(plot).find("height=\"" + coordinate(250)) != std::string::npos, true);
  CHECK_EQ(count(svg(plot), ">lower</text>"), std::size_t{1});
}

// Lines so dense that no name has room: the key has it, with a sample of the line.
TEST(report_plot_puts_a_name_without_room_into_the_key) {
  std::vector<Series> series = {line("crowded", {0, 10}, {5, 5})};
  for (int k = 0; k <= 100; ++k) series.push_back(line("", {0, 10}, {0.1 * k, 0.1 * k}));
  const Plot plot = plot_of(series);
  CHECK(curve_names(plot, layout(plot, 0)).empty());
  const std::string text = svg(plot);
  CHECK_EQ(count(text, ">crowded</text>"), std::size_t{1});
  CHECK_EQ(count(text, "stroke=\"" + std::string(kBlue) + "\""),
           std::size_t{103});  // 102 lines and the sample
}

// Markers have their name in the key; a series without points stands there for others; one beyond the axes is
// not to be seen and has none.
TEST(report_plot_keys_what_is_to_be_seen) {
  Series marks = line("measured", {1, 2}, {1, 2});
  marks.line = Line::none;
  marks.marker = Marker::square;
  Series every = line("of every kind", {}, {});
  every.line = Line::none;
  every.marker = Marker::circle;
  const std::string text = svg(plot_of({marks, every, line("beyond", {20, 30}, {20, 30})}));
  CHECK_EQ(count(text, ">measured</text>"), std::size_t{1});
  CHECK_EQ(count(text, ">of every kind</text>"), std::size_t{1});
  CHECK_EQ(count(text, "beyond"), std::size_t{0});
}

// A unit is as long along both axes: a square of the plane is one of the drawing.
TEST(report_plot_of_equal_scale) {
  Plot plot = plot_of({line("", {-3, 1}, {0, 2})});
  plot.x = {"x", false, -3, 1, false};
  plot.y = {"y", false, 0, 2, false};
  plot.equal_scale = true;
  const Layout at = layout(plot, 40);
  CHECK_NEAR(at.px(1) - at.px(0), at.py(0) - at.py(1), 1e-9);
  CHECK_NEAR(at.bottom - at.top, 0.5 * (at.right - at.left), 1e-9);
}

TEST(report_plot_note_is_broken_into_lines_that_fit) {
  const std::string note = "Aircraft: any. Governor: none, rotor speed held. Inflow: uniform.";
  std::string joined;
  for (const std::string& row : wrapped(note, kSmallFont, 200)) {
    CHECK(0.8 * text_width(row, kSmallFont) <= 200);
    joined += (joined.empty() ? "" : " ") + row;
  }
  CHECK_EQ(joined, note);
  CHECK_EQ(wrapped("", kSmallFont, 200).size(), std::size_t{0});
  CHECK_EQ(wrapped("unbreakable", kSmallFont, 1).size(), std::size_t{1});
  Plot plot = plot_of({line("a", {0, 1}, {0, 1})});
  plot.note = "with <what> & \"where\"";
  CHECK_EQ(check::XmlChecker::fault(svg(plot)), "");
}

// The limits stand between their colours.
TEST(report_plot_bar_of_colours) {
  Plot plot = plot_of({});
  plot.cells = {{0, 5, 10}, {0, 10}, {-1, 1}, {-0.5, 0.5}, {"#a1a1a1", "#a2a2a2", "#a3a3a3"}, "1/s"};
  const std::string text = svg(plot);
  CHECK_EQ(check::XmlChecker::fault(text), "");
  for (const char* part : {">1/s</text>", ">\u22120.5</text>", ">0.5</text>"})
    CHECK_EQ(count(text, part), std::size_t{1});
  CHECK_EQ(count(text, "fill=\"#a2a2a2\""), std::size_t{1});  // in the bar alone
  CHECK_EQ(count(text, "fill=\"#a3a3a3\""), std::size_t{2});  // and a cell
}
