// Who carries the weight: vertical force of rotors, wing, tail and fuselage through conversion.

#include <array>
#include <cmath>

#include "plot/plot.hpp"
#include "study/drawn_with.hpp"
#include "study/missing.hpp"
#include "study/sections.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

using namespace plot;

namespace {

// What carries: columns of the tables and curves of the pictures, where the wing has both its parts.
enum Carrier { rotors, wing, wake_on_wing, tail, rest, carrier_count };
constexpr struct {
  const char *column, *curve, *color;
} kCarriers[carrier_count] = {{"rotors", "rotors", kBlue},
                              {"wing", "wing", kGreen},
                              {"wake_on_wing", "", kGreen},
                              {"tail", "tail", kOrange},
                              {"rest", "fuselage, pylons, fins", kGrey}};

constexpr Carrier carrier_of(Component component) {
  switch (component) {
    case Component::rotor_right:
    case Component::rotor_left:
      return rotors;
    case Component::wing_free:
      return wing;
    case Component::wing_wake_right:
    case Component::wing_wake_left:
      return wake_on_wing;
    case Component::htail:
      return tail;
    case Component::engine_jets:
    case Component::pylon:
    case Component::spinners:
    case Component::pylon_side:
    case Component::fuselage:
    case Component::fin_right:
    case Component::fin_left:
      return rest;
    case Component::count:
      break;
  }
  throw "a component without a carrier";  // reached by the compiler alone
}

struct CarrierTable {
  Carrier of[component_count];
};
constexpr CarrierTable carrier_table() {
  CarrierTable table{};
  for (int k = 0; k < component_count; ++k) table.of[k] = carrier_of(static_cast<Component>(k));
  return table;
}
constexpr CarrierTable kCarrier = carrier_table();

// Upward force over weight, for each carrier.
using Shares = std::array<double, carrier_count>;

Shares shares_of(const Configured& c, const Trimmed& t) {
  const Evaluation<double> e = evaluated(c, t.state, t.controls);
  const double weight = c.mass.mass * kGravity<double>;
  const double sp = std::sin(t.state.pitch);
  const double cp = std::cos(t.state.pitch);
  Shares shares{};
  for (int k = 0; k < component_count; ++k) {
    const Vec3<double>& f = e.loads.component[k].force;
    shares[kCarrier.of[k]] += (f.x * sp - f.z * cp) / weight;  // level wings
  }
  return shares;
}

std::vector<std::string> table_columns() {
  std::vector<std::string> columns = {"mast_deg", "speed_mps"};
  for (const auto& carrier : kCarriers) columns.emplace_back(carrier.column);
  return columns;
}

std::vector<Table::Cell> table_row(double mast, double speed, const Shares& shares) {
  std::vector<Table::Cell> row = {mast, speed};
  for (const double share : shares) row.emplace_back(share);
  return row;
}

// The wing as a whole: how its lift is split into a part in the wakes and one outside is bookkeeping of the model.
std::vector<Series> curves(const Table& rows, const char* x) {
  std::vector<Series> all;
  const std::vector<double> immersed = rows.numbers(kCarriers[wake_on_wing].column);
  for (int k = 0; k < carrier_count; ++k) {
    if (k == wake_on_wing) continue;
    Series s;
    s.name = kCarriers[k].curve;
    s.color = kCarriers[k].color;
    s.x = rows.numbers(x);
    s.y = rows.numbers(kCarriers[k].column);
    for (std::size_t i = 0; k == wing && i < s.y.size(); ++i) s.y[i] += immersed[i];
    all.push_back(s);
  }
  return all;
}

Picture shares_picture(const Table& table, double mast) {
  Plot plot;
  plot.id = "load_sharing_" + fixed(mast, 0);
  plot.title = "Share of the weight, " + mast_text(mast);
  plot.note = drawn_with();
  plot.x.label = "Speed, m/s";
  plot.y.label = "Upward force over weight";
  plot.y.zero_line = true;
  plot.axes_height = 200;
  plot.series = curves(table.where("mast_deg", mast), "speed_mps");
  return {plot.id, svg(plot)};
}

// One way through conversion: mast angle and speed together, along the middle of the corridor.
Table conversion_table() {
  std::vector<std::string> columns = table_columns();
  columns.emplace_back("power_kw");
  Table table(columns);
  table.comment(
      "Steady flights along the middle of the conversion corridor; flap 20/12.5 and 589 rpm between.");
  constexpr double step = 5;
  for (double mast = 0; mast <= 90; mast += step) {
    const Configured c = configured(mast);
    const double speed = middle_speed(mast);
    const Trimmed t = trimmed_persistently(c, speed);
    if (!is_trimmed(t.status)) continue;
    std::vector<Table::Cell> row = table_row(mast, speed, shares_of(c, t));
    row.emplace_back(total_power_kw(t));
    table.add(row);
  }
  return table;
}

Picture conversion_picture(const Table& table) {
  Plot plot;
  plot.id = "load_sharing_conversion";
  plot.title = "Share of the weight through conversion";
  plot.note = drawn_with();
  plot.x.label = "Mast angle, deg (speed " + fixed(table.number(0, "speed_mps"), 0) + " to " +
                 fixed(table.number(table.rows() - 1, "speed_mps"), 0) + " m/s)";
  plot.y.label = "Upward force over weight";
  plot.x.low = 0;
  plot.x.high = 90;
  plot.y.zero_line = true;
  plot.series = curves(table, "mast_deg");
  return {plot.id, svg(plot)};
}

}  // namespace

Section load_sharing(const Sweeps& sweeps) {
  Section section{"sharing", "Load sharing between rotors and wing", "", {}, {}, {}};
  section.reading =
      "In hover the rotors carry the weight and the download of their wake on the wing; through conversion "
      "the wing takes "
      "over until the rotors only pull.";
  Table table(table_columns());
  table.comment(
      "Upward forces over weight. wing: outside the rotor wake; wake_on_wing: the part in the wake.");
  for (const SpeedSweep& sweep : sweeps) {
    for (const LevelFlight& f : sweep.flights)
      table.add(table_row(sweep.mast_deg, f.speed_mps, shares_of(sweep.c, f.trim)));
  }
  const Table conversion = conversion_table();
  section.pictures = {conversion_picture(conversion), shares_picture(table, 0), shares_picture(table, 30),
                      shares_picture(table, 60)};
  double handover = kMissing;
  for (std::size_t i = 1; i < conversion.rows() && !std::isfinite(handover); ++i) {
    const auto rotors_ahead = [&](std::size_t row) {
      return conversion.number(row, "rotors") - conversion.number(row, "wing") -
             conversion.number(row, "wake_on_wing");
    };
    const double before = rotors_ahead(i - 1);
    const double after = rotors_ahead(i);
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
                                  " in hover, where the wake on the wing takes " +
                                  fixed(-table.number(0, "wake_on_wing"), 3) + "."});
  section.tables.push_back({"load_sharing", "along speed at each mast angle", table});
  section.tables.push_back({"load_sharing_conversion", "through conversion", conversion});
  return section;
}

}  // namespace tiltrotor::study
