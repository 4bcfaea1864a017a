// The plot writer: well-formed whatever the text, points where they belong.
// Expected: well-formed XML, fractions of the axes by hand.
#include "plot/plot.hpp"

#include <cstdlib>

#include "check.hpp"
#include "plot/svg.hpp"
#include "plot/ticks.hpp"
#include "plot/xml_check.hpp"

using namespace tiltrotor::plot;

namespace {

// Number of an attribute in the first tag that begins with `tag`.
double attribute_of(const std::string& text, const std::string& tag, const std::string& name) {
  const std::size_t start = text.find(tag);
  if (start == std::string::npos) return double(NAN);
  const std::string element = text.substr(start, text.find('>', start) - start);
  const std::size_t place = element.find(" " + name + "=\"");
  return place == std::string::npos ? double(NAN) : std::atof(element.c_str() + place + name.size() + 3);
}

Plot plot_of(const Series& series) {
  Plot plot;
  plot.id = "test";
  plot.title = "Title";
  plot.x.label = "Speed, m/s";
  plot.y.label = "Power, kW";
  plot.series = {series};
  return plot;
}

}  // namespace

TEST(report_xml_checker_finds_faults) {
  CHECK_EQ(check::XmlChecker::fault("<a b=\"1\"><c/>x &amp; y</a>"), "");
  for (const char* bad : {"<a>", "<a></b>", "<a b=1/>", "<a>&</a>", "<a b=\"<\"/>", "<a/><b/>", "x",
                          "<a b=\"1\"c=\"2\"/>", "<a b=\"1\" b=\"2\"/>", "<a>&nbsp;</a>"}) {
    CHECK(!check::XmlChecker::fault(bad).empty());
  }
}

TEST(report_plot_is_well_formed_with_any_text) {
  Series s;
  s.name = "a < b & \"c\" 'd'";
  s.marker = Marker::triangle;
  s.x = {0, 1, double(NAN), 3};
  s.y = {0, -1, 2, double(INFINITY)};
  s.tip = {"<1>", "&2", "", "\x01"};
  Plot plot = plot_of(s);
  plot.title = "<script>&</script>\x02";
  plot.labels = {{1, -1, "1 < 2 & 3", "#000"}};
  plot.cells = {{0, 1, 2}, {0, 1}, {0.5, double(NAN)}, {0}, {"#fff", "#000"}, "<0 & >0"};
  CHECK_EQ(check::XmlChecker::fault(svg(plot)), "");
}

TEST(report_plot_of_nothing_is_well_formed) {
  CHECK_EQ(check::XmlChecker::fault(svg(plot_of({}))), "");
  Series one;
  one.x = {5};
  one.y = {7};
  CHECK_EQ(check::XmlChecker::fault(svg(plot_of(one))), "");
}

// The frame of the axes gives the mapping; a point at given fractions of given axes must stand there.
TEST(report_plot_puts_a_point_where_it_belongs) {
  Series s;
  s.marker = Marker::circle;
  s.x = {30};
  s.y = {100};
  Plot plot = plot_of(s);
  plot.x.low = 10;
  plot.x.high = 90;
  plot.y.low = -100;
  plot.y.high = 700;
  const std::string text = svg(plot);
  const double left = attribute_of(text, "<rect class=\"axes\"", "x");
  const double top = attribute_of(text, "<rect class=\"axes\"", "y");
  const double width = attribute_of(text, "<rect class=\"axes\"", "width");
  const double height = attribute_of(text, "<rect class=\"axes\"", "height");
  CHECK_NEAR(attribute_of(text, "<circle", "cx"), left + 0.25 * width, 0.01);
  CHECK_NEAR(attribute_of(text, "<circle", "cy"), top + 0.75 * height, 0.01);
}

// A rectangle of half widths 1 and 2 about a level line, interrupted once; the axes reach around it.
TEST(report_plot_band_lies_between_its_curves) {
  Series s;
  s.x = {0, 10};
  s.y = {5, 5};
  Plot plot = plot_of(s);
  plot.x.low = 0;
  plot.x.high = 10;
  plot.y.low = 0;
  plot.y.high = 10;
  Band band;
  band.x = {0, 4, 5, 6, 10};
  band.low = {4, 4, double(NAN), 4, 4};
  band.high = {7, 7, 7, 7, 7};
  plot.bands = {band};
  const std::string text = svg(plot);
  CHECK_EQ(check::XmlChecker::fault(text), "");
  const std::string box = "<rect class=\"axes\"";
  const double left = attribute_of(text, box, "x");
  const double right = left + attribute_of(text, box, "width");
  const double top = attribute_of(text, box, "y");
  const double high = top + 0.3 * attribute_of(text, box, "height");
  const double low = top + 0.6 * attribute_of(text, box, "height");
  const auto corner = [](const char* pen, double x, double y) {
    return pen + coordinate(x) + " " + coordinate(y);
  };
  const double width = right - left;
  const std::string path = corner("M", left, high) + corner("L", left + 0.4 * width, high) +
                           corner("L", left + 0.4 * width, low) + corner("L", left, low) + "z" +
                           corner("M", left + 0.6 * width, high) + corner("L", right, high) +
                           corner("L", right, low) + corner("L", left + 0.6 * width, low) + "z";
  CHECK(text.find("d=\"" + path + "\"") != std::string::npos);
  CHECK(text.find("class=\"band\"") < text.find("fill=\"none\" stroke=\"" + s.color));

  plot.y = {};
  plot.bands[0].high.assign(5, 50);
  CHECK(svg(plot).find(">50<") != std::string::npos);
  plot.bands = {Band{}};
  CHECK(svg(plot).find("class=\"band\"") == std::string::npos);
}

TEST(report_plot_on_logarithmic_axes) {
  Series s;
  s.marker = Marker::circle;
  s.x = {1};
  s.y = {0};
  Plot plot = plot_of(s);
  plot.x.logarithmic = true;
  plot.x.low = 0.01;
  plot.x.high = 10;
  plot.y.low = -1;
  plot.y.high = 1;
  const std::string text = svg(plot);
  const double left = attribute_of(text, "<rect class=\"axes\"", "x");
  const double width = attribute_of(text, "<rect class=\"axes\"", "width");
  CHECK_NEAR(attribute_of(text, "<circle", "cx"), left + width * 2 / 3, 0.01);
}

TEST(report_plot_leaves_out_markers_beyond_the_axes) {
  Series s;
  s.marker = Marker::circle;
  s.x = {5};
  s.y = {5};
  Plot plot = plot_of(s);
  plot.x.low = 0;
  plot.x.high = 1;
  CHECK(svg(plot).find("<circle") == std::string::npos);
}

TEST(report_ticks_are_round) {
  const Scale scale = linear_scale(-0.37, 1.02, 6, false);
  CHECK_NEAR(scale.low, -0.4, 1e-12);
  CHECK_NEAR(scale.high, 1.2, 1e-12);
  CHECK_EQ(scale.ticks.front().text, "\u22120.4");
  CHECK_EQ(scale.ticks[2].text, "0");
  CHECK_EQ(linear_scale(0, 0.3, 3, false).ticks.back().text, "0.3");
  CHECK_EQ(linear_scale(0, 2000, 5, false).ticks.back().text, "2000");
  CHECK_EQ(logarithmic_scale(0.1, 100).ticks.front().text, "0.1");
  const Scale wide = logarithmic_scale(1e-13, 0.1);
  CHECK_EQ(wide.ticks.size(), std::size_t{13});
  CHECK_EQ(wide.ticks[1].text, "1e-12");
  CHECK_EQ(wide.ticks[2].text, "");
  CHECK_EQ(coordinate(-0.001), "0");
}
