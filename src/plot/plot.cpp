#include "plot/plot.hpp"

#include <algorithm>

#include "plot/axes.hpp"
#include "plot/drawing.hpp"
#include "plot/legend.hpp"
#include "plot/marks.hpp"
#include "plot/svg.hpp"

namespace tiltrotor::plot {

std::string svg(const Plot& plot) {
  constexpr double kTitleFont = 14;
  double axes_top = 0;
  const std::vector<LegendEntry> entries = legend(plot, kMargin + kTitleFont + 8, axes_top);
  const Layout at = layout(plot, axes_top + 8);
  const std::string box = attribute("x", at.left) + attribute("y", at.top) +
                          attribute("width", at.right - at.left) + attribute("height", at.bottom - at.top);

  const double bold = 1.06;
  const double title_font = std::min(
      kTitleFont, kTitleFont * (plot.width - 2 * kMargin) / (bold * text_width(plot.title, kTitleFont) + 1));
  std::string out = open_svg(plot.width, at.height, plot.title);
  out +=
      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n<g" + attribute("font-size", kFont) + ">\n";
  out += "<clipPath" + attribute("id", plot.id + "_clip") + "><rect" + box + "/></clipPath>\n";
  out += text_at(kMargin, kMargin + kTitleFont, plot.title, "start", "#111111",
                 attribute("font-size", title_font) + " font-weight=\"600\"");
  out += draw_legend(entries) + draw_axes(plot, at);
  out += "<g" + attribute("clip-path", "url(#" + plot.id + "_clip)") + ">\n" + draw_cells(plot.cells, at) +
         draw_zero_lines(plot, at);
  for (const Series& s : plot.series) out += draw_line(s, at);
  out += "</g>\n<rect class=\"axes\"" + box + " fill=\"none\"" + attribute("stroke", kGrey) + "/>\n";
  for (const Series& s : plot.series) out += draw_markers(s, at);
  for (const Label& l : plot.labels) {
    if (!at.inside(l.x, l.y)) continue;
    // A white rim keeps the text legible on lines.
    out += text_at(at.px(l.x) + l.dx, at.py(l.y) + l.dy, l.text, l.dx < 0 ? "end" : "start", l.color,
                   " font-size=\"12\" paint-order=\"stroke\" stroke=\"#ffffff\" stroke-width=\"3\"");
  }
  return out + "</g>\n</svg>\n";
}

}  // namespace tiltrotor::plot
