#include "study/mode_speeds.hpp"

#include <algorithm>

#include "plot/plot.hpp"
#include "study/drawn_with.hpp"
#include "study/missing.hpp"
#include "study/reference_points.hpp"
#include "study/spread.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

using namespace plot;

namespace {

struct ModeQuantity {
  const char* mode;
  const char* title;
  const char* kind;  // of the limits
  const char* axis;
};
constexpr ModeQuantity kQuantities[] = {
    {"phugoid", "Phugoid: damping ratio", "damping_ratio", "Damping ratio"},
    {"phugoid", "Phugoid: frequency", "frequency_rad_s", "Frequency, rad/s"},
    {"short_period", "Short period: damping ratio", "damping_ratio", "Damping ratio"},
    {"short_period", "Short period: frequency", "frequency_rad_s", "Frequency, rad/s"},
    {"dutch_roll", "Dutch roll: damping ratio", "damping_ratio", "Damping ratio"},
    {"dutch_roll", "Dutch roll: frequency", "frequency_rad_s", "Frequency, rad/s"},
    {"roll", "Roll subsidence: root", "real_1_per_s", "Real part, 1/s"},
    {"spiral", "Spiral: root", "real_1_per_s", "Real part, 1/s"},
};

// Along speed, interrupted where the flight has no mode of that name.
Series curve_of(const Table& modes, const std::string& mast, const std::string& mode,
                const std::string& column) {
  Series s;
  const Table flights = modes.where("mast_deg", mast);
  const Table rows = flights.where("mode", mode);
  for (const std::string& speed : flights.different("speed_mps")) {
    const Table at = rows.where("speed_mps", speed);
    s.x.push_back(flights.where("speed_mps", speed).number(0, "speed_mps"));
    s.y.push_back(at.rows() > 0 ? at.number(0, column) : kMissing);
  }
  return s;
}

// A level over the speeds to which it applies.
Series limit_of(const Table& limits, std::size_t row, const Table& modes) {
  constexpr double slow = 20;  // m/s: as long is the line of a limit in hover
  const bool hover = limits.text(row, "where") == "hover";
  const std::vector<double> airplane = modes.where("mast_deg", 90.0).numbers("speed_mps");
  Series s;
  s.name = limits.text(row, "label");
  s.color = kBlack;
  s.width = 1.3;
  s.line = s.name.find("level 2") == std::string::npos ? Line::dashed : Line::dotted;
  if (airplane.empty()) return s;
  s.x = hover ? std::vector<double>{0, slow} : std::vector<double>{airplane.front(), airplane.back()};
  s.y.assign(2, limits.number(row, "value"));
  return s;
}

Plot plot_of(const ModeQuantity& q, const Table& modes, const Table& limits, const Table& spreads,
             const Table& ideal) {
  const std::string kind = q.kind;
  Plot plot;
  plot.id = std::string("mode_speed_") + q.mode + "_" + kind.substr(0, kind.find('_'));
  plot.title = q.title;
  const Table lines = limits.where("mode", std::string(q.mode)).where("kind", kind);
  plot.note = drawn_with();
  if (lines.rows() > 0)
    plot.note += " Dashed and dotted: limits of handling qualities in hover or airplane mode.";
  plot.x.label = "Speed, m/s";
  plot.y.label = q.axis;
  plot.x.low = 0;
  plot.y.zero_line = true;
  plot.axes_height = 220;
  const std::string column = kind == "real_1_per_s" ? "real" : kind;
  const Table of_mode = spreads.where("mode", std::string(q.mode)).where("quantity", column);
  if (of_mode.rows() > 0) plot.note += kBandNote;
  const bool has_second = ideal.where("mode", std::string(q.mode)).rows() > 0;
  if (has_second) plot.note += " In colour dashed: governor ideal, rotor speed and power held.";
  int color = 0;
  for (const std::string& mast : modes.different("mast_deg")) {
    Series s = curve_of(modes, mast, q.mode, column);
    s.name = "mast " + mast;
    s.color = kLineColor[color++];
    plot.bands.push_back(band_around(s, of_mode.where("mast_deg", mast), "speed_mps"));
    plot.series.push_back(s);
    if (!has_second) continue;
    Series second = curve_of(ideal, mast, q.mode, column);
    second.color = s.color;
    second.line = Line::dashed;
    second.width = 1.3;
    plot.series.push_back(second);
  }
  for (std::size_t i = 0; i < lines.rows(); ++i) plot.series.push_back(limit_of(lines, i, modes));
  const bool grows = std::any_of(plot.series.begin(), plot.series.end(), [](const Series& s) {
    return std::any_of(s.y.begin(), s.y.end(), [](double y) { return y < 0; });
  });
  if (!grows) plot.y.low = 0;
  return plot;
}

}  // namespace

std::vector<Picture> mode_speed_pictures(const Table& modes, const Table& spreads, const Table& ideal) {
  const Table limits = reference_points("handling_limits");
  std::vector<Picture> pictures;
  for (const ModeQuantity& q : kQuantities) {
    const Plot plot = plot_of(q, modes, limits, spreads, ideal);
    pictures.push_back({plot.id, svg(plot)});
  }
  return pictures;
}

}  // namespace tiltrotor::study
