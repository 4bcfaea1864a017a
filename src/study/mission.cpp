#include "study/mission.hpp"

#include <algorithm>
#include <cmath>

#include "plot/stack.hpp"
#include "study/drawn_with.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

using namespace plot;

namespace {

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

Series line(const Table& motion, const char* name, const char* color, const char* column,
            Line style = Line::solid) {
  Series s;
  s.name = name;
  s.color = color;
  s.line = style;
  s.x = motion.numbers("time_s");
  s.y = motion.numbers(column);
  return s;
}

// Modes of body and rotor speed that a pilot meets, by a colour of their own.
struct Shown {
  const char* name;
  const char* color;
  Marker marker;
};
constexpr Shown kShown[] = {
    {"phugoid", kBlue, Marker::circle},       {"short_period", kOrange, Marker::square},
    {"heave", kAmber, Marker::diamond},       {"pitch", kSky, Marker::plus},
    {"dutch_roll", kGreen, Marker::triangle}, {"roll", kPurple, Marker::cross},
    {"spiral", kBlack, Marker::diamond},      {"rotor_speed", kGrey, Marker::circle}};

std::string with_blanks(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

// Least and most load factor while the masts move up, until the cruise.
struct Loads {
  double least = 1e9, most = -1e9;
};
Loads loads_in_conversion(const Table& motion) {
  constexpr double still = 0.01;  // deg from row to row
  Loads loads;
  for (std::size_t i = 1; i < motion.rows(); ++i) {
    if (motion.number(i, "mast_deg") - motion.number(i - 1, "mast_deg") < still) continue;
    loads.least = std::min(loads.least, motion.number(i, "load_factor"));
    loads.most = std::max(loads.most, motion.number(i, "load_factor"));
  }
  return loads;
}

Finding judged(bool holds, const char* statement, const std::string& found) {
  return {holds ? Finding::holds : Finding::differs, statement, found};
}

// One sentence of several lines.
std::string in_one_line(std::string lines) {
  while (!lines.empty() && lines.back() == '\n') lines.pop_back();
  std::string out;
  for (const char c : lines) out += c == '\n' ? std::string("; ") : std::string(1, c);
  return out + ".";
}

std::string growing(const Table& modes) {
  std::string text;
  for (const std::string& name : modes.different("mode")) {
    const Table rows = modes.where("mode", name);
    std::size_t count = 0;
    double fastest = 0;
    for (std::size_t i = 0; i < rows.rows(); ++i) {
      count += rows.number(i, "real") > 0;
      fastest = std::max(fastest, rows.number(i, "real"));
    }
    constexpr double slow = 1e-3;  // 1/s: doubles in more than ten minutes
    if (fastest > slow)
      text += (text.empty() ? "" : "; ") + with_blanks(name) + " at " + std::to_string(count) + ", up to " +
              with_sign(fastest, 2) + "/s";
  }
  return text.empty() ? "none" : text;
}

}  // namespace

Table motion_along_flight() {
  return Table({"time_s", "height_m", "airspeed_mps", "mast_deg", "flap_deg", "power_kw", "takeoff_power_kw",
                "load_factor"});
}
Table modes_along_flight() { return Table({"time_s", "mode", "real", "imag"}); }

std::string flight_picture(const std::string& title, const Table& motion, const std::string& note) {
  std::vector<Plot> plots = {over_time("flight_height", "Height of the wheels above the ground", "Height, m"),
                             over_time("flight_speed", "True airspeed", "Airspeed, m/s"),
                             over_time("flight_mast", "Mast angle, and flaps", "Angle, deg"),
                             over_time("flight_power", "Power of both engines", "Power, kW")};
  plots[0].series = {line(motion, "", kBlue, "height_m")};
  plots[1].series = {line(motion, "", kBlue, "airspeed_mps")};
  plots[2].series = {line(motion, "mast", kBlue, "mast_deg"),
                     line(motion, "flaps", kOrange, "flap_deg", Line::dashed)};
  plots[3].series = {line(motion, "engines", kBlue, "power_kw"),
                     line(motion, "take-off power", kOrange, "takeoff_power_kw", Line::dashed)};
  const std::vector<double>& heights = plots[0].series[0].y;
  constexpr double struts = 0.5;  // m, that wheels at rest may give way
  const bool above = std::all_of(heights.begin(), heights.end(), [](double h) { return h > -struts; });
  for (std::size_t i = above ? 0 : 1; i < plots.size(); ++i) plots[i].y.low = 0;
  plots.back().note = note;
  return stacked_svg(title, plots);
}

std::string flight_modes_picture(const std::string& title, const Table& modes, const std::string& note) {
  std::vector<Plot> plots = {
      over_time("flight_modes_real", "Real part of the modes, systems within", "Real part, 1/s"),
      over_time("flight_modes_imag", "Imaginary part", "Imaginary part, rad/s")};
  for (Plot& plot : plots) plot.axes_height = 2 * kHeight;
  for (const Shown& shown : kShown) {
    const Table rows = modes.where("mode", std::string(shown.name));
    if (rows.rows() == 0) continue;
    const char* const columns[] = {"real", "imag"};
    for (const int part : {0, 1}) {
      Series s = line(rows, "", shown.color, columns[part], Line::none);
      s.name = with_blanks(shown.name);
      s.marker = shown.marker;
      s.marker_size = 2.5;
      plots[static_cast<std::size_t>(part)].series.push_back(s);
    }
  }
  plots[0].y.zero_line = true;
  plots[0].y.low = -5;
  plots[0].y.high = 1;
  plots[1].y.low = 0;
  plots[1].y.high = 5;
  plots.back().note = note;
  return stacked_svg(title, plots);
}

Section mission(const FlownMission& flown) {
  Section section{"mission", "A mission, from the ground to the ground", "", {}, {}, {}};
  section.reading =
      "The whole vehicle with its conversion drive, engines, governor (pi: collective holds the rotor speed, the "
      "pilot flies with the throttle), actuators, augmentation, landing gear and ground effect, flown by the "
      "reference pilot as " +
      flown.name +
      " says, in calm air: hover, taxi, conversion at 7.5 deg/s, cruise with 517 rpm, a turn, back, and landing. "
      "Modes are those of the complete closed loop at the state of the moment, which is no equilibrium; what "
      "lies outside the axes is in the table.";
  const std::string note = drawn_with(Governor::pi) + " Real-time grid; every system on.";
  section.pictures = {
      {"mission", flight_picture("Mission: height, speed, masts, power", flown.motion, note)},
      {"mission_modes", flight_modes_picture("Mission: modes along the way", flown.modes, note)}};
  constexpr double close = 5, gentle = 1, light = 0.9, heavy = 1.1;
  const Loads loads = loads_in_conversion(flown.motion);
  section.findings = {
      {Finding::remark, "The flight in figures.", in_one_line(flown.summary)},
      judged(flown.height_error <= close, "A height that is held is held within 5 m, conversions included.",
             "Within " + fixed(flown.height_error, 2) + " m."),
      judged(loads.least >= light && loads.most <= heavy,
             "The conversion at 7.5 deg/s loads with 0.9 to 1.1.",
             "From " + fixed(loads.least, 3) + " to " + fixed(loads.most, 3) + "."),
      judged(flown.power_part <= 1, "No engine is asked for more than its take-off power.",
             "At most " + fixed(100 * flown.power_part, 1) + " % of it."),
      judged(flown.touch_down > 0 && flown.touch_down <= gentle, "It touches down with less than 1 m/s.",
             fixed(flown.touch_down, 2) + " m/s."),
      {Finding::remark, "Roots that grow along the way, with the augmentation and without the pilot.",
       "Of " + std::to_string(flown.models) + " moments: " + growing(flown.modes) + ". " +
           (flown.models_without_modes == 0
                ? "Every eigenvalue was found."
                : "At " + std::to_string(flown.models_without_modes) + " the eigenvalues were not found.")}};
  section.tables.push_back({"mission", "height, speed, masts, power, every half second", flown.motion});
  section.tables.push_back({"mission_modes", "modes of the complete closed loop, every 5 s", flown.modes});
  return section;
}

}  // namespace tiltrotor::study
