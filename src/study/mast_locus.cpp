// Root loci over mast angle at constant speed.

#include "study/drawn_with.hpp"
#include "study/linear_models.hpp"
#include "study/mode_table.hpp"
#include "study/sections.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

namespace {

constexpr double kSpeeds[] = {45, 60, 75};  // m/s
constexpr double kMastStep = 1;             // deg
constexpr double kHighestMast = 89;         // deg: at 90 rotor speed and flap change
constexpr double kFurthestRoot = -3;        // 1/s: those further left are not drawn

Table locus_table() {
  Table table = mode_table({"speed_mps", "mast_deg"});
  table.comment("Flap 20/12.5 and 589 rpm at every mast angle; points inside every limit of trim.");
  for (const double speed : kSpeeds) {
    Tracker tracker;
    bool follows = false;
    for (double mast = 0; mast <= kHighestMast; mast += kMastStep) {
      Setup setup = default_setup(mast);
      setup.flap_deg = aircraft_data<double>().wing.flap_deg[1];
      const Configured c = configured(setup);
      const Trimmed t = trimmed(c, speed);
      if (t.status != TrimStatus::ok) {
        follows = false;
        continue;
      }
      add_modes(table, {speed, mast}, modes_of(linear_model(c, t), tracker, follows));
      follows = true;
    }
  }
  return table;
}

}  // namespace

Section mast_locus() {
  Section section{"locus", "Roots over mast angle at constant speed", "", {}, {}, {}};
  section.reading =
      "The masts tilt, the speed stays: numbers along each branch are mast angles in deg. Flap 20/12.5 and "
      "589 rpm throughout, rotor speed and collective held, so that only the masts move. Every speed has the "
      "same axes; beside each the phugoid, enlarged. Lateral roots hardly move: they are in the table.";
  const Table table = locus_table();
  const Table rows = table.where("axis", std::string("longitudinal"));
  for (const double speed : kSpeeds) {
    ModePlot plot;
    plot.id = "locus_" + fixed(speed, 0);
    plot.title = "Longitudinal roots at " + fixed(speed, 0) + " m/s";
    plot.parameter = "mast_deg";
    plot.unit = "deg";
    plot.window = window_around(rows, "", kFurthestRoot);
    plot.note = drawn_with();
    section.pictures.push_back(mode_picture(plot, rows.where("speed_mps", speed)));
    plot.id += "_phugoid";
    plot.title += ", near the origin";
    plot.window = window_around(rows, "phugoid", kFurthestRoot);
    section.pictures.push_back(mode_picture(plot, rows.where("speed_mps", speed)));
  }
  section.tables.push_back({"mast_locus", "eigenvalues along mast angle", table});
  return section;
}

}  // namespace tiltrotor::study
