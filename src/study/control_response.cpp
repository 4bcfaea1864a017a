// Control sensitivity, control power and damping about the three axes.

#include <algorithm>
#include <cmath>

#include "plot/plot.hpp"
#include "study/compared_aircraft.hpp"
#include "study/drawn_with.hpp"
#include "study/linear_models.hpp"
#include "study/missing.hpp"
#include "study/reference_points.hpp"
#include "study/sections.hpp"
#include "study/validation_rules.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

using namespace plot;

namespace {

constexpr double kShownMasts[] = {0, 30, 60, 90};

struct AxisOfControl {
  const char* name;
  const char* inceptor;
  int rate;
  int control;
  double sign;  // makes sensitivity positive
  double ControlTables<double>::*travel;
};
constexpr AxisOfControl kAxes[] = {
    {"pitch", "stick forward", kStateIndex.rates.y, kControlIndex.long_stick, -1,
     &ControlTables<double>::long_travel},
    {"roll", "stick right", kStateIndex.rates.x, kControlIndex.lat_stick, 1,
     &ControlTables<double>::lat_travel},
    {"yaw", "pedal right", kStateIndex.rates.z, kControlIndex.pedal, 1, &ControlTables<double>::pedal_travel},
};

constexpr const char* kPitchDamping =
    " The estimate takes thrust normal to the disk; at this collective the force in the disk takes back half "
    "(Amer, NACA TN 2136).";

Table empty_table() {
  return Table({"mast_deg", "speed_mps", "axis", "sensitivity_rad_s2_per_in", "control_power_rad_s2",
                "damping_1_per_s"});
}

void add_axes(const Configured& c, double speed_mps, const Trimmed& t, Table& table) {
  const Linear model = quasi_steady(linear_model(c, t.state, t.controls, kInceptors));
  for (const AxisOfControl& axis : kAxes) {
    const double sensitivity = axis.sign * control_derivative(model, axis.rate, axis.control);
    const double travel = c.aircraft->controls.*axis.travel;
    table.add({c.setup.mast_deg, speed_mps, std::string(axis.name), sensitivity, sensitivity * travel,
               -state_derivative(model, axis.rate, axis.rate)});
  }
}

Table response_table(const Sweeps& sweeps) {
  Table table = empty_table();
  table.comment(
      "Quasi-steady derivatives. sensitivity: angular acceleration for one inch (pitch: nose down for stick");
  table.comment("forward); control power: for full travel to one side; damping: minus the rate derivative.");
  for (const SpeedSweep& sweep : sweeps) {
    if (std::find(std::begin(kShownMasts), std::end(kShownMasts), sweep.mast_deg) == std::end(kShownMasts))
      continue;
    for (const LevelFlight& f : sweep.flights) add_axes(sweep.c, f.speed_mps, f.trim, table);
  }
  return table;
}

// Hover with inertia and rotor speed of the estimate.
Table estimated_hover() {
  Table table = empty_table();
  const Configured c = configured(setup_of(compared_aircraft("hover_control_response"), 0));
  add_axes(c, 0, trimmed_persistently(c, 0), table);
  return table;
}

Picture picture(const Table& table, const AxisOfControl& axis, const char* column, const char* what,
                const char* unit, const Table& estimate) {
  Plot plot;
  plot.id = std::string("control_") + axis.name + "_" + what;
  plot.title =
      capitalized(axis.name) + " " + what + (column[0] == 's' ? std::string(", ") + axis.inceptor : "");
  plot.note = drawn_with() + " Marks: hover; of the standards the least value.";
  plot.x.label = "Speed, m/s";
  plot.y.label = unit;
  plot.x.low = 0;
  plot.y.zero_line = true;
  plot.axes_height = 200;
  const Table rows = table.where("axis", std::string(axis.name));
  for (std::size_t i = 0; i < std::size(kShownMasts); ++i) {
    const Table branch = rows.where("mast_deg", kShownMasts[i]);
    Series s;
    s.name = "mast " + fixed(kShownMasts[i], 0);
    s.color = kLineColor[i];
    s.x = branch.numbers("speed_mps");
    s.y = branch.numbers(column);
    plot.series.push_back(s);
  }
  const auto mark = [&](const std::string& name, Marker marker, bool filled, double value) {
    Series s;
    s.name = name;
    s.color = kBlack;
    s.line = Line::none;
    s.marker = marker;
    s.filled = filled;
    s.x = {0};
    s.y = {value};
    plot.series.push_back(s);
  };
  const Table estimated = estimate.where("axis", std::string(axis.name));
  if (estimated.rows() > 0) mark("1975 estimate", Marker::diamond, false, estimated.number(0, column));
  const Table limits = reference_points("handling_limits")
                           .where("mode", std::string(axis.name))
                           .where("kind", std::string(column))
                           .where("where", std::string("hover"));
  for (std::size_t i = 0; i < limits.rows(); ++i)
    mark(limits.text(i, "label"), i == 0 ? Marker::triangle : Marker::square, true,
         limits.number(i, "value"));
  return {plot.id, svg(plot)};
}

}  // namespace

Section control_response(const Sweeps& sweeps) {
  Section section{"control", "Control sensitivity and damping", "", {}, {}, {}};
  section.reading =
      "Angular acceleration for one inch of stick or pedal, and the damping that opposes the rate it builds "
      "up; rotors and "
      "inflow in quasi-steady balance; rotor speed and collective held.";
  const Table table = response_table(sweeps);
  const Table estimate = reference_points("hover_control_response");
  for (const AxisOfControl& axis : kAxes) {
    section.pictures.push_back(picture(table, axis, "sensitivity_rad_s2_per_in", "sensitivity",
                                       "Acceleration per inch, rad/s²/in", estimate));
    section.pictures.push_back(picture(table, axis, "damping_1_per_s", "damping", "Damping, 1/s", estimate));
  }
  const Table hover = estimated_hover();
  Table compared({"axis", "quantity", "here", "estimate"});
  compared.comment("Hover. Estimate: NASA TM X-62407 (1975), table 8.3.2, without stability augmentation;");
  compared.comment("here with its inertia and rotor speed, 565 rpm.");
  for (std::size_t i = 0; i < estimate.rows(); ++i) {
    const Table here = hover.where("axis", estimate.text(i, "axis"));
    const auto compare = [&](const char* column) {
      return fixed(here.number(0, column), 3) + " against " + fixed(estimate.number(i, column), 3);
    };
    for (const std::string column :
         {"sensitivity_rad_s2_per_in", "control_power_rad_s2", "damping_1_per_s"}) {
      compared.add({estimate.text(i, "axis"), estimate.text(i, "axis") + "_" + column, here.number(0, column),
                    estimate.number(i, column)});
    }
    const auto close = [&](const std::string& column) {
      const double there = estimate.number(i, column);
      const Tolerance rule =
          tolerance_of("hover_control_response", estimate.text(i, "axis") + "_" + column, kMissing);
      return std::fabs(here.number(0, column) - there) <= allowed(rule, there);
    };
    const int held =
        close("sensitivity_rad_s2_per_in") + close("control_power_rad_s2") + close("damping_1_per_s");
    section.findings.push_back(
        {verdict_of(held, 3),
         "Hover, " + estimate.text(i, "axis") + ": the 1975 design estimate (30 %, yaw damping 50 %).",
         "Sensitivity " + compare("sensitivity_rad_s2_per_in") + " rad/s² per inch, control power " +
             compare("control_power_rad_s2") + " rad/s², damping " + compare("damping_1_per_s") + " 1/s." +
             (close("damping_1_per_s") || estimate.text(i, "axis") != "pitch" ? "" : kPitchDamping)});
  }
  section.tables.push_back({"control_response", "sensitivity, control power, damping", table});
  section.tables.push_back({"control_compared", "hover against the 1975 design estimate", compared});
  return section;
}

}  // namespace tiltrotor::study
