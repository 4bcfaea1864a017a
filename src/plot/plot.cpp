#include "plot/plot.hpp"

#include <algorithm>

#include "plot/axes.hpp"
#include "plot/curve_names.hpp"
#include "plot/drawing.hpp"
#include "plot/legend.hpp"
#include "plot/marks.hpp"
#include "plot/svg.hpp"

namespace tiltrotor::plot {

namespace {

// Named series without a name at their curve. One that has no points stands for others; one that has all of
// them beyond the axes is not to be seen.
std::vector<const Series*> keyed(const Plot& plot, const std::vector<CurveName>& names, const Layout& at) {
  std::vector<const Series*> rest;
  for (const Series& s : plot.series) {
    bool seen = s.x.empty();
    for (std::size_t i = 0; i < s.x.size(); ++i) seen = seen || at.inside(s.x[i], s.y[i]);
    const bool at_curve =
        std::any_of(names.begin(), names.end(), [&](const CurveName& n) { return n.series == &s; });
    if (seen && !s.name.empty() && !at_curve) rest.push_back(&s);
  }
  return rest;
}

}  // namespace

std::string svg(const Plot& plot) {
  constexpr double kTitleFont = 14;
  constexpr double kNoteRow = 14;
  constexpr double kNoteGap = 8;  // to the label of the axis
  double bar_bottom = 0;
  double axes_top = 0;
  const std::string bar = draw_color_bar(plot.cells, plot.width, kMargin + kTitleFont + 8, bar_bottom);
  // The height of the key moves the axes and all names alike.
  const Layout bare = layout(plot, 0);
  const std::vector<CurveName> names = curve_names(plot, bare);
  const std::vector<KeyEntry> entries = key(keyed(plot, names, bare), plot.width, bar_bottom, axes_top);
  const Layout at = layout(plot, axes_top + 8);
  const std::vector<std::string> note = wrapped(plot.note, kSmallFont, plot.width - 2 * kMargin);
  const std::string box = attribute("x", at.left) + attribute("y", at.top) +
                          attribute("width", at.right - at.left) + attribute("height", at.bottom - at.top);

  const double bold = 1.06;
  const double title_font = std::min(
      kTitleFont, kTitleFont * (plot.width - 2 * kMargin) / (bold * text_width(plot.title, kTitleFont) + 1));
  std::string out =
      open_svg(plot.width, at.height + kNoteGap + kNoteRow * static_cast<double>(note.size()), plot.title);
  out +=
      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n<g" + attribute("font-size", kFont) + ">\n";
  out += "<clipPath" + attribute("id", plot.id + "_clip") + "><rect" + box + "/></clipPath>\n";
  out += text_at(kMargin, kMargin + kTitleFont, plot.title, "start", "#111111",
                 attribute("font-size", title_font) + " font-weight=\"600\"");
  out += bar + draw_key(entries) + draw_axes(plot, at);
  out += "<g" + attribute("clip-path", "url(#" + plot.id + "_clip)") + ">\n" + draw_cells(plot.cells, at);
  for (const Band& b : plot.bands) out += draw_band(b, at);
  out += draw_zero_lines(plot, at);
  for (const Series& s : plot.series) out += draw_line(s, at);
  out += "</g>\n<rect class=\"axes\"" + box + " fill=\"none\"" + attribute("stroke", kGrey) + "/>\n";
  for (const Series& s : plot.series) out += draw_markers(s, at);
  for (const Label& l : plot.labels) {
    if (!at.inside(l.x, l.y)) continue;
    out += name_at(at.px(l.x) + l.dx, at.py(l.y) + l.dy, l.text, l.dx < 0 ? "end" : "start", l.color, "400");
  }
  for (const CurveName& n : names)
    out += name_at(n.x, n.y + at.top - bare.top, n.series->name, "start", n.series->color, "600");
  for (std::size_t i = 0; i < note.size(); ++i) {
    out += text_at(kMargin, at.height + kNoteGap + kNoteRow * static_cast<double>(i), note[i], "start", kGrey,
                   attribute("font-size", kSmallFont));
  }
  return out + "</g>\n</svg>\n";
}

}  // namespace tiltrotor::plot
