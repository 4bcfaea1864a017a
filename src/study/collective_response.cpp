// Response to one degree more collective at 40 m/s in helicopter mode, with eigenvalues along the manoeuvre.

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "plot/plot.hpp"
#include "study/collective_step.hpp"
#include "study/drawn_with.hpp"
#include "study/linear_models.hpp"
#include "study/mode_table.hpp"
#include "study/sections.hpp"
#include "study/spread.hpp"
#include "study/wording.hpp"
#include "tiltrotor/analysis/flight/response.hpp"
#include "tiltrotor/model/variables/frames.hpp"

namespace tiltrotor::study {

using namespace plot;

namespace {

constexpr double kStep = 0.005;  // s

struct Case {
  const char* name;
  const char* short_name;  // at its curve
  double flap_deg;
  bool tail_wash;  // the rotors' wash at the horizontal tail
  Governor governor;
};
constexpr Case kCases[] = {
    {"flap 40/25", "flap 40/25", 40, true, Governor::off},
    {"flap 0/0", "flap 0/0", 0, true, Governor::off},
    {"flap 40/25, no rotor wash at the tail", "no wash at tail", 40, false, Governor::off},
    {"flap 40/25, ideal governor", "ideal governor", 40, true, Governor::ideal}};
constexpr const char* kIdealNote =
    " Case ideal governor: rotor speed held, and from 0 s on the power that the degree takes.";
constexpr Line kCaseLine[] = {Line::solid, Line::dashed, Line::dotted, Line::dashed};
constexpr Marker kCaseMarker[] = {Marker::circle, Marker::square, Marker::triangle, Marker::diamond};

// The aircraft with its table of rotor wash at the tail, whose sideslip factor multiplies all of it, set to
// zero.
struct WithoutTailWash {
  Aircraft<double> aircraft = aircraft_data<double>();
  std::vector<double> zeros;
  WithoutTailWash() {
    auto& factor = aircraft.htail.rotor_wash_beta;
    constexpr std::size_t numbers_per_knot = 2;  // value and slope
    zeros.assign(numbers_per_knot * static_cast<std::size_t>(factor.smooth[0].count) *
                     static_cast<std::size_t>(factor.linear[0].count),
                 0.0);
    factor.node = zeros.data();
  }
};

struct Records {
  Table motion{{"case", "time_s", "u_mps", "w_mps", "climb_mps", "ground_speed_mps", "q_degps", "pitch_deg"}};
  Table modes{
      {"case", "time_s", "axis", "mode", "real", "imag", "frequency_rad_s", "damping_ratio", "branch"}};
};

void record_motion(const std::string& name, const Simulation<double>& s, Table& table) {
  const State<double>& x = s.state;
  const Motion m = motion_of(x);
  table.add({name, current_time(s), x.velocity.x, x.velocity.z, m[0], m[1], m[2], m[3]});
}

void record_modes(const std::string& name, double time, const Linear& model, Tracker& tracker, Table& table) {
  const Modes& now = modes_of(model, tracker, true);
  for (int k = 0; k < now.count; ++k) {
    const Mode<double>& m = now.mode[k];
    if (!is_body_mode(m)) continue;
    table.add({name, time, std::string(axis_word(m.axis)), std::string(m.name), m.real, m.imag, m.frequency,
               m.damping_ratio, static_cast<double>(m.branch)});
  }
}

void fly(const Case& which, Records& records) {
  Setup setup = default_setup(0);
  setup.flap_deg = which.flap_deg;
  setup.options.governor = which.governor;
  const auto changed = std::make_unique<WithoutTailWash>();
  Configured c = configured(setup, which.tail_wash ? aircraft_data<double>() : changed->aircraft);
  const Trimmed trim = trimmed_persistently(c, kStepSpeed);
  if (!is_trimmed(trim.status))
    throw std::runtime_error("no trim at 40 m/s, mast 0, " + std::string(which.name));

  Simulation<double> flight = collective_step(c, trim, kStep);
  const bool is_governed = which.governor != Governor::off;
  Controls<double> stepped = current_controls(flight);
  SystemFlight<double> systems = governed(c, trim.state, stepped);  // the engines give what that takes
  const auto work = std::make_unique<SimulationWorkspace<double>>();
  Tracker tracker;
  Status status = Status::ok;
  const int steps = static_cast<int>(std::lround(kStepDuration / kStep));
  const int record_steps = static_cast<int>(std::lround(kStepRecordEvery / kStep));
  const int second = static_cast<int>(std::lround(1 / kStep));
  for (int k = 0; k <= steps && status == Status::ok; ++k) {
    if (k % record_steps == 0) record_motion(which.name, flight, records.motion);
    // The input acts from 0 s on: the roots before it are those of the trim.
    const Controls<double> controls = k > 0 ? current_controls(flight) : trim.controls;
    if (k % second == 0) {
      Controls<double> settled = controls;
      const Linear model = !is_governed ? linear_model(c, flight.state, controls, kInceptors)
                           : k > 0      ? linear_model(c, systems, flight.state, controls)
                                   : linear_model(c, governed(c, trim.state, settled), trim.state, settled);
      record_modes(which.name, current_time(flight), model, tracker, records.modes);
    }
    if (k < steps)
      status = is_governed ? advance_vehicle(c, systems, analyses(), flight) : advance(c, *work, flight);
  }
  if (status != Status::ok)
    throw std::runtime_error(std::string("response to collective: ") + status_text(status));
}

Picture motion_picture(const char* id, const char* title, const char* axis, const char* column,
                       const Table& motion, const Table& spreads) {
  Plot plot;
  plot.id = id;
  plot.title = title;
  plot.note = drawn_with() + kIdealNote;
  plot.x.label = "Time after +1 deg collective, s";
  plot.y.label = axis;
  plot.axes_height = 200;
  const Table of_column = spreads.where("quantity", std::string(column));
  if (of_column.rows() > 0) plot.note += kBandNote;
  for (std::size_t i = 0; i < std::size(kCases); ++i) {
    const Table rows = motion.where("case", std::string(kCases[i].name));
    Series s;
    s.name = kCases[i].short_name;
    s.color = kLineColor[i];
    s.line = kCaseLine[i];
    s.x = rows.numbers("time_s");
    s.y = rows.numbers(column);
    // Of the first case, the default aircraft.
    if (i == 0 && of_column.rows() > 0) plot.bands.push_back(band_around(s, of_column, "time_s"));
    plot.series.push_back(s);
  }
  return {id, svg(plot)};
}

// The least stable oscillation (or root) of an axis at a time.
struct Root {
  double real = -1e9, imag = 0;
  std::string mode;
};
Root least_stable(const Table& modes, const std::string& name, const char* axis, double time) {
  const Table rows = modes.where("case", name).where("axis", std::string(axis)).where("time_s", time);
  Root worst;
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    if (rows.number(i, "real") > worst.real) {
      worst = {rows.number(i, "real"), rows.number(i, "imag"), rows.text(i, "mode")};
    }
  }
  return worst;
}

std::vector<Finding> statements(const Records& records) {
  std::vector<Finding> findings;
  for (const Case& which : kCases) {
    const Table rows = records.motion.where("case", std::string(which.name));
    const std::size_t last = rows.rows() - 1;
    const double climb = rows.number(last, "climb_mps");
    const double slower = rows.number(last, "ground_speed_mps") - rows.number(0, "ground_speed_mps");
    const double nose = rows.number(last, "pitch_deg") - rows.number(0, "pitch_deg");
    const int held = (climb > 0) + (slower < 0) + (nose > 0);
    std::string found = capitalized(which.name) + ", after 3 s: climb " + with_sign(climb, 2) +
                        " m/s, speed " + with_sign(slower, 2) + " m/s, pitch " + with_sign(nose, 2) + " deg.";
    if (which.tail_wash && nose < 0) {
      found +=
          " Cause: more collective strengthens the rotor wash, and the sign of the wash at the horizontal tail "
          "is set by table 2-I, which makes it upwash: the tail pushes the nose down harder than the disks "
          "tilt back. The third case, without that wash, shows what is left; a closed-form wash "
          "(--option tail_wash=closed_form) gives nose up at every flap. The paper does not state its flap "
          "setting.";
    }
    findings.push_back({verdict_of(held, 3),
                        "After +1 deg collective at 40 m/s the aircraft climbs, slows and pitches up.",
                        found});
  }
  for (const Case& which : kCases) {
    std::string found = capitalized(which.name) + ":";
    int held = 0;
    for (const char* axis : {"longitudinal", "lateral"}) {
      const Root before = least_stable(records.modes, which.name, axis, 0);
      const Root after = least_stable(records.modes, which.name, axis, kStepDuration);
      const double change = after.real - before.real;
      held += change > 0;
      found += std::string(" ") + axis + " " + root_text(before.real, before.imag) + " becomes " +
               root_text(after.real, after.imag) + " (" + with_sign(change, 4) + "/s, " +
               (change > 0 ? "less" : "more") + " stable);";
    }
    found.back() = '.';
    findings.push_back(
        {verdict_of(held, 2), "The slow modes are less stable 3 s after the step than before it.", found});
  }
  return findings;
}

Picture root_picture(const char* axis, const Table& modes) {
  Plot plot;
  plot.id = std::string("response_modes_") + axis;
  plot.title = capitalized(axis) + " roots before (0) and 1, 2, 3 s after";
  plot.note = drawn_with() + kIdealNote;
  plot.x.label = "Real part, 1/s";
  plot.y.label = "Imaginary part, rad/s";
  plot.x.zero_line = true;
  plot.y.low = 0;
  for (std::size_t i = 0; i < std::size(kCases); ++i) {
    const Table rows = modes.where("case", std::string(kCases[i].name)).where("axis", std::string(axis));
    bool named = false;
    for (const std::string& mode : rows.different("mode")) {
      const Table branch = rows.where("mode", mode);
      Series s;
      if (!named) s.name = kCases[i].short_name;
      named = true;
      s.color = kLineColor[i];
      s.marker = kCaseMarker[i];
      s.filled = i == 0;
      s.marker_size = 3;
      s.x = branch.numbers("real");
      s.y = branch.numbers("imag");
      for (std::size_t k = 0; k < branch.rows(); ++k) {
        s.tip.push_back(mode + " at " + branch.text(k, "time_s") + " s: " + root_text(s.x[k], s.y[k]));
        const bool pair = s.y[k] > 0;
        if (pair && (k == 0 || k + 1 == branch.rows())) {
          plot.labels.push_back(
              {s.x[k], s.y[k], branch.text(k, "time_s"), s.color, k == 0 ? -6.0 : 6.0, i == 0 ? -6.0 : 14.0});
        }
      }
      plot.series.push_back(s);
    }
  }
  return {plot.id, svg(plot)};
}

}  // namespace

Section collective_response(const Uncertainty& bands) {
  Section section{"response", "Response to +1 deg collective at 40 m/s", "", {}, {}, {}};
  section.reading =
      "Mast 0, 40 m/s, level flight, then one degree more collective and nothing else; rotor speed is held "
      "at "
      "589 rpm, no governor acts but in the last case: there an ideal one keeps the power that the degree takes "
      "at the beginning, and the collective follows. Nonlinear model, Runge-Kutta, 5 ms. The roots at 0 s are those of the "
      "trim, "
      "before the input; later ones belong to the linear model at the state reached, which is no "
      "equilibrium.";
  Records records;
  for (const Case& which : kCases) fly(which, records);
  const Table& motion = records.motion;
  section.pictures = {
      motion_picture("response_climb", "Climb rate", "Climb, m/s", "climb_mps", motion, bands.response),
      motion_picture("response_speed", "Speed over ground", "Speed, m/s", "ground_speed_mps", motion,
                     bands.response),
      motion_picture("response_pitch", "Pitch attitude", "Pitch, deg", "pitch_deg", motion, bands.response),
      motion_picture("response_rate", "Pitch rate", "Pitch rate, deg/s", "q_degps", motion, bands.response),
      root_picture("longitudinal", records.modes),
      root_picture("lateral", records.modes)};
  section.findings = statements(records);
  section.tables.push_back({"response", "motion every 0.05 s", records.motion});
  section.tables.push_back(
      {"response_modes", "eigenvalues of the trim (0 s) and 1, 2, 3 s after the input", records.modes});
  return section;
}

}  // namespace tiltrotor::study
