#include "cli/flight_figures.hpp"

#include <algorithm>

#include "cli/flight_options.hpp"
#include "plot/stack.hpp"

namespace tiltrotor::cli {

namespace {

using plot::Plot;
using plot::Series;

constexpr double kWidth = 640, kHeight = 130;  // of one of several plots

Plot over_time(const char* id, const char* title, const char* axis) {
  Plot plot;
  plot.id = id;
  plot.title = title;
  plot.x.label = "Time, s";
  plot.y.label = axis;
  plot.width = kWidth;
  plot.axes_height = kHeight;
  return plot;
}

template <class Value>
Series line(const std::vector<FlightMoment>& moments, const char* name, const char* color, Value&& value) {
  Series s;
  s.name = name;
  s.color = color;
  for (const FlightMoment& m : moments) {
    s.x.push_back(m.time);
    s.y.push_back(value(m));
  }
  return s;
}

// Modes of body and rotor speed that a pilot meets, by a colour of their own.
struct Shown {
  const char* name;
  const char* color;
  plot::Marker marker;
};
constexpr Shown kShown[] = {{"phugoid", plot::kBlue, plot::Marker::circle},
                            {"short_period", plot::kOrange, plot::Marker::square},
                            {"heave", plot::kAmber, plot::Marker::diamond},
                            {"pitch", plot::kSky, plot::Marker::plus},
                            {"dutch_roll", plot::kGreen, plot::Marker::triangle},
                            {"roll", plot::kPurple, plot::Marker::cross},
                            {"spiral", plot::kBlack, plot::Marker::diamond},
                            {"rotor_speed", plot::kGrey, plot::Marker::circle}};

std::string with_blanks(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace

void FlightFigures::add(const FlightMoment& moment) { moments_.push_back(moment); }

void FlightFigures::add_modes(double time, const VehicleModes<double>& modes) {
  for (int i = 0; i < modes.count; ++i)
    roots_.push_back({time, modes.mode[i].real, modes.mode[i].imag, modes.mode[i].name});
}

std::string FlightFigures::motion(const std::string& subject) const {
  std::vector<Plot> plots = {over_time("flight_height", "Height of the wheels above the ground", "Height, m"),
                             over_time("flight_speed", "True airspeed", "Airspeed, m/s"),
                             over_time("flight_mast", "Mast angle, and flaps", "Angle, deg"),
                             over_time("flight_power", "Power of both engines", "Power, kW")};
  constexpr double kilo = 1e3;
  plots[0].series = {line(moments_, "", plot::kBlue, [](const FlightMoment& m) { return m.height; })};
  plots[1].series = {line(moments_, "", plot::kBlue, [](const FlightMoment& m) { return m.airspeed; })};
  plots[2].series = {
      line(moments_, "mast", plot::kBlue, [](const FlightMoment& m) { return m.mast_deg; }),
      line(moments_, "flaps", plot::kOrange, [](const FlightMoment& m) { return m.flap_deg; })};
  plots[2].series[1].line = plot::Line::dashed;
  plots[3].series = {line(moments_, "engines", plot::kBlue,
                          [](const FlightMoment& m) { return (m.power[right] + m.power[left]) / kilo; }),
                     line(moments_, "take-off power", plot::kOrange,
                          [](const FlightMoment& m) { return 2 * m.power_allowed / kilo; })};
  plots[3].series[1].line = plot::Line::dashed;
  plots[3].y.low = 0;
  for (std::size_t i = 1; i < plots.size(); ++i) plots[i].y.low = 0;
  return plot::stacked_svg("Flight by " + subject, plots);
}

std::string FlightFigures::modes(const std::string& subject) const {
  std::vector<Plot> plots = {
      over_time("flight_modes_real", "Real part of the modes, systems within", "Real part, 1/s"),
      over_time("flight_modes_imag", "Imaginary part", "Imaginary part, rad/s")};
  for (Plot& plot : plots) plot.axes_height = 2 * kHeight;
  for (const Shown& shown : kShown) {
    Series real, imag;
    for (const Root& root : roots_) {
      if (root.name != shown.name) continue;
      real.x.push_back(root.time), real.y.push_back(root.real);
      imag.x.push_back(root.time), imag.y.push_back(root.imag);
    }
    if (real.x.empty()) continue;
    for (Series* const s : {&real, &imag}) {
      s->name = with_blanks(shown.name);
      s->color = shown.color;
      s->marker = shown.marker;
      s->marker_size = 2.5;
      s->line = plot::Line::none;
    }
    plots[0].series.push_back(real);
    plots[1].series.push_back(imag);
  }
  plots[0].y.zero_line = true;
  plots[0].y.low = -5;
  plots[0].y.high = 1;
  plots[1].y.low = 0;
  plots[1].y.high = 5;
  return plot::stacked_svg("Modes along the flight by " + subject, plots);
}

}  // namespace tiltrotor::cli
