// Eigenvalues in the complex plane at four mast angles, with the speed along each branch.

#include <algorithm>
#include <cmath>

#include "study/drawn_with.hpp"
#include "study/linear_models.hpp"
#include "study/mode_speeds.hpp"
#include "study/mode_table.hpp"
#include "study/sections.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

namespace {

constexpr double kShownMasts[] = {0, 30, 60, 90};
constexpr double kFurthestRoot = -3;        // 1/s: those further left are not drawn
constexpr double kFurthestSlowRoot = -0.5;  // of the enlarged part

Linear model_of(const SpeedSweep& sweep, const LevelFlight& f, Governor governor) {
  if (governor == Governor::off) return linear_model(sweep.c, f.trim);
  Configured c = sweep.c;
  c.setup.options.governor = governor;
  Controls<double> u = f.trim.controls;
  return linear_model(c, governed(c, f.trim.state, u), f.trim.state, u);
}

Table sweep_table(const Sweeps& sweeps, Governor governor) {
  Table table = mode_table({"mast_deg", "speed_mps"});
  for (const SpeedSweep& sweep : sweeps) {
    if (std::find(std::begin(kShownMasts), std::end(kShownMasts), sweep.mast_deg) == std::end(kShownMasts))
      continue;
    Tracker tracker;
    for (const LevelFlight& f : sweep.flights)
      add_modes(table, {sweep.mast_deg, f.speed_mps}, modes_of(model_of(sweep, f, governor), tracker, true));
  }
  return table;
}

constexpr double kLowSpeed = 30;  // m/s

// The fastest growth from a speed on, 1/s.
double fastest_growth(const Table& table, double from_speed) {
  double worst = -1e9;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (table.number(i, "speed_mps") >= from_speed) worst = std::max(worst, table.number(i, "real"));
  }
  return worst;
}

bool has_mode(const Table& rows, const char* mode) {
  return rows.where("mode", std::string(mode)).rows() > 0;
}

// Where each mode grows from a speed on.
std::string unstable_ranges(const Table& table, double from_speed) {
  std::string text;
  for (const double mast : kShownMasts) {
    const Table rows = table.where("mast_deg", mast);
    for (const std::string& mode : rows.different("mode")) {
      const Table branch = rows.where("mode", mode);
      double low = 1e9;
      double high = -1e9;
      double worst = 0;
      for (std::size_t i = 0; i < branch.rows(); ++i) {
        if (branch.number(i, "real") <= 0 || branch.number(i, "speed_mps") < from_speed) continue;
        low = std::min(low, branch.number(i, "speed_mps"));
        high = std::max(high, branch.number(i, "speed_mps"));
        worst = std::max(worst, branch.number(i, "real"));
      }
      if (worst > 0) {
        text += (text.empty() ? "" : "; ") + mast_text(mast) + " " + mode + " " + fixed(low, 0) + ".." +
                fixed(high, 0) + " m/s (up to " + with_sign(worst, 3) + "/s)";
      }
    }
  }
  return text.empty() ? "none" : text;
}

// Speeds of a mast angle, and those at which something grows, from a speed on.
struct Unstable {
  int speeds, growing;
};
Unstable count_unstable(const Table& table, double mast, double from_speed) {
  const Table rows = table.where("mast_deg", mast);
  Unstable count{0, 0};
  for (const std::string& speed : rows.different("speed_mps")) {
    const std::vector<double> real = rows.where("speed_mps", speed).numbers("real");
    if (rows.where("speed_mps", speed).number(0, "speed_mps") < from_speed) continue;
    ++count.speeds;
    count.growing += *std::max_element(real.begin(), real.end()) > 0;
  }
  return count;
}

std::string counts_of_unstable(const Table& table) {
  std::string text;
  for (const double mast : kShownMasts) {
    const Unstable all = count_unstable(table, mast, 0);
    const Unstable fast = count_unstable(table, mast, kLowSpeed);
    text += (text.empty() ? "" : ", ") + mast_text(mast) + " " + std::to_string(all.growing) + " of " +
            std::to_string(all.speeds) + " (from " + fixed(kLowSpeed, 0) + " m/s on " +
            std::to_string(fast.growing) + " of " + std::to_string(fast.speeds) + ")";
  }
  return text;
}

// A mast angle at which most speeds beyond the low ones are unstable contradicts the statement.
Finding::Verdict stability_verdict(const Table& table) {
  Finding::Verdict verdict = Finding::holds;
  for (const double mast : kShownMasts) {
    const Unstable fast = count_unstable(table, mast, kLowSpeed);
    if (2 * fast.growing > fast.speeds) return Finding::differs;
    if (fast.growing > 0) verdict = Finding::partly;
  }
  return verdict;
}

// What the governor makes of the phugoid in airplane mode.
Finding governed_phugoid(const Table& held, const Table& ideal) {
  constexpr double mast = 90, speed = 100;
  const auto phugoid = [&](const Table& table) {
    const Table at =
        table.where("mast_deg", mast).where("speed_mps", speed).where("mode", std::string("phugoid"));
    if (at.rows() == 0) return std::string("none");
    return root_text(at.number(0, "real"), at.number(0, "imag")) + "/s, damping ratio " +
           fixed(at.number(0, "damping_ratio"), 2);
  };
  return {
      Finding::remark, "The phugoid in airplane mode belongs to its governor.",
      "Mast 90, 100 m/s: rotor speed and collective held " + phugoid(held) + "; rotor speed and power held " +
          phugoid(ideal) +
          ". At fixed pitch and speed the proprotors brake every gain of airspeed; those of the aircraft, "
          "whose governor keeps the power, do not. The paper's states have no governor."};
}

std::vector<Finding> statements(const Table& table) {
  const Table hover = table.where("mast_deg", 0.0).where("speed_mps", 0.0);
  const Table cruise = table.where("mast_deg", 90.0).where("speed_mps", 100.0);
  std::vector<Finding> findings;
  const bool hover_set =
      has_mode(hover, "phugoid") && has_mode(hover, "heave") && has_mode(hover, "pitch_subsidence");
  const bool cruise_set = has_mode(cruise, "short_period") && has_mode(cruise, "phugoid");
  const auto list = [](const Table& rows, const char* axis) {
    std::string text;
    const Table part = rows.where("axis", std::string(axis));
    for (std::size_t i = 0; i < part.rows(); ++i) {
      text += (i ? "; " : "") + part.text(i, "mode") + " " +
              root_text(part.number(i, "real"), part.number(i, "imag"));
    }
    return text;
  };
  findings.push_back(
      {verdict_of(hover_set + cruise_set, 2),
       "Longitudinal modes: phugoid-like oscillation, pitch subsidence and heave in helicopter mode, which "
       "merge into a short period towards airplane mode.",
       "Hover: " + list(hover, "longitudinal") + ". Mast 90, 100 m/s: " + list(cruise, "longitudinal") +
           "."});
  const bool lateral_set =
      has_mode(cruise, "dutch_roll") && has_mode(cruise, "roll") && has_mode(cruise, "spiral");
  findings.push_back(
      {lateral_set ? Finding::holds : Finding::differs, "Lateral modes: spiral, roll subsidence, Dutch roll.",
       "Mast 90, 100 m/s: " + list(cruise, "lateral") + ". Hover: " + list(hover, "lateral") + "."});
  const double fast = fastest_growth(table, kLowSpeed);
  findings.push_back(
      {stability_verdict(table), "Unstable only in hover and at low speed.",
       "Speeds at which a mode grows: " + counts_of_unstable(table) + ". Fastest growth over all speeds " +
           with_sign(fastest_growth(table, 0), 2) + "/s, from " + fixed(kLowSpeed, 0) + " m/s on " +
           with_sign(fast, 2) + "/s. Growing from there: " + unstable_ranges(table, kLowSpeed) + "." +
           (fast <= 0 ? ""
                      : " Cause: the lateral growth in helicopter mode comes from the rotors' sidewash "
                        "at the fins, the growing oscillation near 50 m/s from the rotor wash at the tail, "
                        "which takes away more tail "
                        "lift with speed.")});
  return findings;
}

}  // namespace

Section mode_map(const Sweeps& sweeps, const Uncertainty& bands) {
  Section section{"modes", "Modes in the complex plane", "", {}, {}, {}};
  section.reading =
      "Each line is a branch followed through speed (numbers in m/s), in the colour of its mode's name, "
      "which depends on the flight alone; stable to the left of the grey line. Of a conjugate pair the upper "
      "root is drawn. Every mast angle has the same axes; beside them the phugoid, and the slow lateral roots "
      "of helicopter mode, enlarged. Rotor modes lie far to the left and are left out. Rotor speed and "
      "collective are held, no governor acts, as in the paper; the last four planes, and the dashed curves over "
      "speed, have an ideal governor, with which rotor speed and power of the engines are held. Lateral modes of "
      "level flight are the same with both.";
  const Table table = sweep_table(sweeps, Governor::off);
  const Table ideal = sweep_table(sweeps, Governor::ideal);
  for (const char* axis : {"longitudinal", "lateral"}) {
    const Table rows = table.where("axis", std::string(axis));
    const bool along = axis == std::string("longitudinal");
    const PlaneWindow whole = window_around(rows, "", kFurthestRoot);
    const PlaneWindow origin =
        along ? window_around(rows, "phugoid", kFurthestSlowRoot)
              : window_around(rows.where("mast_deg", 0.0), "dutch_roll", kFurthestSlowRoot);
    for (const double mast : kShownMasts) {
      ModePlot plot;
      plot.id = std::string("modes_") + axis + "_" + fixed(mast, 0);
      plot.title = capitalized(axis) + " modes, " + mast_text(mast);
      plot.parameter = "speed_mps";
      plot.unit = "m/s";
      plot.window = whole;
      plot.note = drawn_with();
      section.pictures.push_back(mode_picture(plot, rows.where("mast_deg", mast)));
      if (!along && mast > 0) continue;  // but for the spiral nothing is near the origin
      plot.id += "_origin";
      plot.title += ", near the origin";
      plot.window = origin;
      section.pictures.push_back(mode_picture(plot, rows.where("mast_deg", mast)));
    }
  }
  const Table along = ideal.where("axis", std::string("longitudinal"));
  for (const double mast : kShownMasts) {
    ModePlot plot;
    plot.id = "modes_ideal_" + fixed(mast, 0);
    plot.title = "Longitudinal, ideal governor, " + mast_text(mast);
    plot.parameter = "speed_mps";
    plot.unit = "m/s";
    plot.window = window_around(along, "", kFurthestRoot);
    plot.note = drawn_with(Governor::ideal);
    section.pictures.push_back(mode_picture(plot, along.where("mast_deg", mast)));
  }
  for (Picture& p : mode_speed_pictures(table, bands.modes, along)) section.pictures.push_back(std::move(p));
  section.findings = statements(table);
  section.findings.push_back(governed_phugoid(table, ideal));
  section.tables.push_back(
      {"modes", "eigenvalues of the complete linear model along speed, rotor speed and collective held",
       table});
  section.tables.push_back(
      {"modes_ideal", "the same with an ideal governor, rotor speed and power held", ideal});
  return section;
}

}  // namespace tiltrotor::study
