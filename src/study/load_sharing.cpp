// Who carries the weight: vertical force of rotors, wing, tail and fuselage through conversion.

#include <cmath>

#include "plot/plot.hpp"
#include "study/missing.hpp"
#include "study/sections.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

using namespace plot;

namespace {

struct Share {
  double rotors, wing, wake_on_wing, tail, rest;
};

// Upward force over weight.
Share share_of(const Configured& c, const Trimmed& t) {
  const Evaluation<double> e = evaluated(c, t.state, t.controls);
  const double weight = c.mass.mass * kGravity<double>;
  const double sp = std::sin(t.state.pitch);
  const double cp = std::cos(t.state.pitch);
  const auto up = [&](int component) {
    const Vec3<double>& f = e.loads.component[component].force;
    return (f.x * sp - f.z * cp) / weight;  // level wings
  };
  return {up(rotor_right) + up(rotor_left), up(wing_free), up(wing_wake_right) + up(wing_wake_left),
          up(htail), up(pylon) + up(spinners) + up(pylon_side) + up(fuselage) + up(fin_right) + up(fin_left)};
}

Series curve(const char* name, const char* color, const Table& rows, const char* x, const char* y) {
  Series s;
  s.name = name;
  s.color = color;
  s.x = rows.numbers(x);
  s.y = rows.numbers(y);
  return s;
}

Picture shares_picture(const Table& table, double mast) {
  Plot plot;
  plot.id = "load_sharing_" + fixed(mast, 0);
  plot.title = "Share of the weight, " + mast_text(mast);
  plot.x.label = "Speed, m/s";
  plot.y.label = "Upward force over weight";
  plot.y.zero_line = true;
  plot.axes_height = 200;
  const Table rows = table.where("mast_deg", mast);
  plot.series = {curve("rotors", kBlue, rows, "speed_mps", "rotors"),
                 curve("free wing", kGreen, rows, "speed_mps", "wing"),
                 curve("wing in the wake", kPurple, rows, "speed_mps", "wake_on_wing"),
                 curve("tail", kOrange, rows, "speed_mps", "tail"),
                 curve("rest", kGrey, rows, "speed_mps", "rest")};
  return {plot.id, svg(plot)};
}

// One way through conversion: mast angle and speed together, along the middle of the corridor.
Table conversion_table() {
  Table table({"mast_deg", "speed_mps", "rotors", "wing", "wake_on_wing", "tail", "rest", "power_kw"});
  table.comment(
      "Steady flights along the middle of the conversion corridor; flap 20/12.5 and 589 rpm between.");
  constexpr double step = 5;
  for (double mast = 0; mast <= 90; mast += step) {
    const Configured c = configured(mast);
    const double speed = middle_speed(mast);
    const Trimmed t = trimmed_persistently(c, speed);
    if (!is_trimmed(t.status)) continue;
    const Share s = share_of(c, t);
    table.add({mast, speed, s.rotors, s.wing, s.wake_on_wing, s.tail, s.rest, total_power_kw(t)});
  }
  return table;
}

Picture conversion_picture(const Table& table) {
  Plot plot;
  plot.id = "load_sharing_conversion";
  plot.title = "Share of the weight through conversion";
  plot.x.label = "Mast angle, deg (speed " + fixed(table.number(0, "speed_mps"), 0) + " to " +
                 fixed(table.number(table.rows() - 1, "speed_mps"), 0) + " m/s)";
  plot.y.label = "Upward force over weight";
  plot.x.low = 0;
  plot.x.high = 90;
  plot.y.zero_line = true;
  plot.series = {curve("rotors", kBlue, table, "mast_deg", "rotors"),
                 curve("free wing", kGreen, table, "mast_deg", "wing"),
                 curve("wing in the wake", kPurple, table, "mast_deg", "wake_on_wing"),
                 curve("tail", kOrange, table, "mast_deg", "tail"),
                 curve("rest", kGrey, table, "mast_deg", "rest")};
  return {plot.id, svg(plot)};
}

}  // namespace

Section load_sharing(const Sweeps& sweeps) {
  Section section{"sharing", "Load sharing between rotors and wing", "", {}, {}, {}};
  section.reading =
      "In hover the rotors carry the weight and the download of their wake on the wing; through conversion "
      "the wing takes "
      "over until the rotors only pull.";
  Table table({"mast_deg", "speed_mps", "rotors", "wing", "wake_on_wing", "tail", "rest"});
  table.comment(
      "Upward forces over weight. wing: outside the rotor wake; wake_on_wing: the part in the wake.");
  for (const SpeedSweep& sweep : sweeps) {
    for (const LevelFlight& f : sweep.flights) {
      const Share s = share_of(sweep.c, f.trim);
      table.add({sweep.mast_deg, f.speed_mps, s.rotors, s.wing, s.wake_on_wing, s.tail, s.rest});
    }
  }
  const Table conversion = conversion_table();
  section.pictures = {conversion_picture(conversion), shares_picture(table, 0), shares_picture(table, 30),
                      shares_picture(table, 60)};
  double handover = kMissing;
  for (std::size_t i = 1; i < conversion.rows() && !std::isfinite(handover); ++i) {
    const double before = conversion.number(i - 1, "rotors") - conversion.number(i - 1, "wing");
    const double after = conversion.number(i, "rotors") - conversion.number(i, "wing");
    if (before > 0 && after <= 0) {
      const double a = conversion.number(i - 1, "mast_deg");
      handover = a + (conversion.number(i, "mast_deg") - a) * before / (before - after);
    }
  }
  section.findings.push_back({Finding::remark,
                              "Along the middle of the corridor rotors and wing carry equal parts at mast " +
                                  fixed(handover, 0) + " deg.",
                              "The rotors lift " + fixed(conversion.number(0, "rotors"), 2) +
                                  " of the weight at mast 0, " + fixed(conversion.number(0, "speed_mps"), 0) +
                                  " m/s and " + fixed(table.number(0, "rotors"), 3) +
                                  " in hover, where the wing in the wake takes " +
                                  fixed(-table.number(0, "wake_on_wing"), 3) + "."});
  section.tables.push_back({"load_sharing", "along speed at each mast angle", table});
  section.tables.push_back({"load_sharing_conversion", "through conversion", conversion});
  return section;
}

}  // namespace tiltrotor::study
