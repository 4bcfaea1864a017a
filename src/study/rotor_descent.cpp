// One rotor from climb through vortex ring and turbulent wake to the windmill: mean inflow, power and
// collective at constant thrust, against model rotors in a wind tunnel.

#include <algorithm>
#include <cmath>
#include <memory>

#include "plot/plot.hpp"
#include "study/drawn_with.hpp"
#include "study/flights.hpp"
#include "study/missing.hpp"
#include "study/reference_points.hpp"
#include "study/sections.hpp"
#include "study/wording.hpp"
#include "tiltrotor/analysis/isolated_rotor.hpp"

namespace tiltrotor::study {

using namespace plot;

namespace {

constexpr double kClimb = 16, kDescent = 44, kStep = 0.5;  // m/s
constexpr double kTolerance = 0.3;                         // v_h

// Collective at which the rotor has the thrust, by secants from a neighbour; the thrust is off where there is
// none.
IsolatedRotor<double> rotor_at_thrust(const Configured& c, double axial, double thrust, double& collective,
                                      IsolatedRotorWorkspace<double>& work) {
  constexpr int most_steps = 30;
  constexpr double first_step = 0.003, largest_step = 0.05;  // rad
  IsolatedRotor<double> rotor;
  RotorFlow<double> flow{};
  flow.axial = axial;
  double before = kMissing, at = kMissing;
  for (int k = 0; k < most_steps; ++k) {
    flow.collective = collective;
    (void)isolated_rotor(c, flow, work, rotor);
    const double off = rotor.figures.thrust - thrust;
    if (std::fabs(off) < 1e-6 * thrust) break;
    double step = k == 0 ? first_step : -off * (collective - at) / (off - before);
    if (!std::isfinite(step)) break;
    step = std::clamp(step, -largest_step, largest_step);
    before = off;
    at = collective;
    collective += step;
  }
  return rotor;
}

// From climb down, at the thrust of hover at gross weight. Speeds over v_h.
Table sweep() {
  const Configured c = configured(0);
  const double thrust = 0.5 * c.setup.mass * kGravity<double>;
  const double hover =
      std::sqrt(thrust / (2 * c.air.density * kPi<double> * std::pow(c.aircraft->rotor.radius, 2)));
  Table table({"descent_mps", "descent_over_vh", "induced_over_vh", "total_inflow_over_vh",
               "collective75_deg", "power_kw", "status"});
  table.comment("Isolated rotor, mast 0, sea level, thrust of hover at 13000 lb (" + fixed(thrust, 0) +
                " N), v_h " + fixed(hover, 2) + " m/s; inflow of the default option descent_inflow.");
  const auto work = std::make_unique<IsolatedRotorWorkspace<double>>();
  double collective = 0.3;
  for (double descent = -kClimb; descent <= kDescent; descent += kStep) {
    const IsolatedRotor<double> r = rotor_at_thrust(c, -descent, thrust, collective, *work);
    if (std::fabs(r.figures.thrust / thrust - 1) > 1e-4) continue;
    const double induced = r.input.state.lambda_0 * c.tip_speed / hover;
    const bool flagged = r.momentum != MomentumRange::holds;
    table.add({descent, descent / hover, induced, induced - descent / hover, degrees(r.input.collective),
               kWatt * r.figures.power, std::string(flagged ? "vortex_ring" : "ok")});
  }
  return table;
}

// Linear between the rows; NaN outside.
double at(const Table& table, const char* x, double value, const char* y) {
  for (std::size_t i = 1; i < table.rows(); ++i) {
    const double a = table.number(i - 1, x), b = table.number(i, x);
    if ((a - value) * (b - value) > 0) continue;
    return table.number(i - 1, y) + (table.number(i, y) - table.number(i - 1, y)) * (value - a) / (b - a);
  }
  return kMissing;
}

// Where y falls through zero for the last time.
double last_zero(const Table& table, const char* x, const char* y) {
  for (std::size_t i = table.rows(); i-- > 1;) {
    const double a = table.number(i - 1, y), b = table.number(i, y);
    if (!(a > 0 && b <= 0)) continue;
    return table.number(i - 1, x) + (table.number(i, x) - table.number(i - 1, x)) * a / (a - b);
  }
  return kMissing;
}

Series line(const char* name, const char* color, Line kind) {
  Series s;
  s.name = name;
  s.color = color;
  s.line = kind;
  return s;
}

Series marks(const std::string& name, const char* color, Marker marker) {
  Series s = line(name.c_str(), color, Line::none);
  s.marker = marker;
  s.filled = false;
  s.marker_size = 3;
  return s;
}

void mean_inflow(const Table& here, Section& section) {
  Plot plot;
  plot.id = "descent_inflow";
  plot.title = "Mean inflow of one rotor, climb to windmill";
  plot.note = drawn_with_rotor_alone();
  plot.x.label = "Climb speed over v_h";
  plot.y.label = "Induced velocity over v_h";
  plot.x.low = -2.7;
  plot.x.high = 1;
  plot.y.low = 0;
  plot.y.high = 3.5;
  const Table measured = reference_points("rotor_descent");
  Table compared({"twist_deg", "descent_over_vh", "here", "measured", "difference"});
  compared.comment(
      "Total inflow over v_h, positive down through the disk, at the descent of the measured point.");
  std::size_t within = 0;
  for (const std::string& twist : measured.different("twist_deg")) {
    Series s = twist == "0" ? marks("measured, no twist", kOrange, Marker::circle)
                            : marks("measured, twist " + twist + " deg", kGreen, Marker::square);
    const Table points = measured.where("twist_deg", twist);
    for (std::size_t i = 0; i < points.rows(); ++i) {
      const double d = points.number(i, "descent_over_vh"), there = points.number(i, "total_inflow_over_vh");
      s.x.push_back(-d);
      s.y.push_back(there + d);
      const double inflow = at(here, "descent_over_vh", d, "total_inflow_over_vh");
      compared.add({twist, d, inflow, there, inflow - there});
      within += std::fabs(inflow - there) <= kTolerance;
    }
    plot.series.push_back(s);
  }
  Series theory = line("momentum theory", kGrey, Line::dashed), windmill = line("", kGrey, Line::dashed);
  for (double z = 1; z >= -1.5; z -= 0.02) {
    theory.x.push_back(z);
    theory.y.push_back(-z / 2 + std::sqrt(z * z / 4 + 1));
  }
  for (double z = -2; z >= -2.7; z -= 0.01) {
    windmill.x.push_back(z);
    windmill.y.push_back(-z / 2 - std::sqrt(std::max(z * z / 4 - 1, 0.0)));
  }
  Series now = line("this program", kBlue, Line::solid);
  for (std::size_t i = 0; i < here.rows(); ++i) {
    now.x.push_back(-here.number(i, "descent_over_vh"));
    now.y.push_back(here.number(i, "induced_over_vh"));
  }
  plot.series.insert(plot.series.end(), {theory, windmill, now});
  section.pictures.push_back({plot.id, svg(plot)});
  section.tables.push_back({"descent_compared", "mean inflow against model rotors", compared});
  section.findings.push_back(
      {verdict_of(static_cast<int>(within), static_cast<int>(compared.rows())),
       "Mean inflow in vertical descent within 0.3 v_h of measured model rotors.",
       std::to_string(within) + " of " + std::to_string(compared.rows()) +
           " points. Where the ring opens, from 1.4 to 1.9 v_h, the two measured rotors differ by up to 1.3 v_h, and "
           "the curve lies between them; beyond 2 v_h they keep more inflow than momentum theory gives."});
}

void autorotation(const Table& here, Section& section) {
  Plot plot;
  plot.id = "descent_power";
  plot.title = "Power of one rotor at the thrust of hover";
  plot.note = drawn_with_rotor_alone();
  plot.x.label = "Descent, m/s";
  plot.y.label = "Power, kW";
  plot.x.low = -kClimb;
  plot.x.high = kDescent;
  plot.y.zero_line = true;
  Series power = line("this program", kBlue, Line::solid);
  power.x = here.numbers("descent_mps");
  power.y = here.numbers("power_kw");
  plot.series.push_back(power);
  const double descent = last_zero(here, "descent_mps", "power_kw");
  const double ratio = at(here, "descent_mps", descent, "descent_over_vh");
  plot.labels.push_back({descent, 0, "autorotation", kBlack, -6, 16});
  section.pictures.push_back({plot.id, svg(plot)});

  // Climb and induced power alone cancel where no air passes the disk.
  const double ideal = last_zero(here, "descent_over_vh", "total_inflow_over_vh");
  const Table runs = reference_points("rotor_descent_runs");
  Table compared({"run", "ct", "rotor_rpm", "here", "measured"});
  compared.comment(
      "Descent over v_h at which climb and induced power cancel; measured: torque that of zero thrust.");
  double least = HUGE_VAL, most = 0;
  for (const std::string& run : runs.different("run")) {
    Table torque({"descent_over_vh", "delta_cq"});
    const Table points = runs.where("run", run);
    for (std::size_t i = 0; i < points.rows(); ++i) {
      const double delta = points.number(i, "delta_cq");
      if (std::isfinite(delta)) torque.add({points.number(i, "descent_over_vh"), 1e6 * delta});
    }
    const double there = last_zero(torque, "descent_over_vh", "delta_cq");
    if (!std::isfinite(there)) continue;
    compared.add({run, points.number(0, "ct"), points.number(0, "rotor_rpm"), ideal, there});
    least = std::min(least, there);
    most = std::max(most, there);
  }
  section.tables.push_back({"autorotation_compared", "autorotation against model rotors", compared});
  section.findings.push_back({ideal >= least && ideal <= most ? Finding::holds : Finding::differs,
                              "Climb and induced power cancel at the descent measured on a model rotor.",
                              "here " + fixed(ideal, 2) + " v_h, measured " + fixed(least, 2) + " to " +
                                  fixed(most, 2) + " v_h in " + std::to_string(compared.rows()) + " runs."});
  section.findings.push_back(
      {Finding::remark, "The rotor alone in autorotation at the thrust of hover.",
       "It descends at " + fixed(descent, 1) + " m/s, " + fixed(ratio, 2) + " v_h, with " +
           fixed(at(here, "descent_mps", descent, "collective75_deg"), 1) + " deg of collective at 0.75 R."});
}

// Change of collective at constant thrust since hover, over v_h/(Omega R): the same for rotors of different
// loading as far as their blades are alike.
void collective(const Table& here, Section& section) {
  Plot plot;
  plot.id = "descent_collective";
  plot.title = "Collective that keeps the thrust; marks measured";
  plot.note = drawn_with_rotor_alone();
  plot.x.label = "Descent over v_h";
  plot.y.label = "Change over v_h/(Omega R)";
  plot.x.low = 0;
  plot.x.high = 2.2;
  plot.y.zero_line = true;
  const auto changed = [](Series& s, const std::vector<double>& d, const std::vector<double>& pitch_deg,
                          double hover_deg, double hover_inflow) {
    for (std::size_t i = 0; i < d.size(); ++i) {
      s.x.push_back(d[i]);
      s.y.push_back((pitch_deg[i] - hover_deg) * kRadPerDeg<double> / hover_inflow);
    }
  };
  const Table runs = reference_points("rotor_descent_runs");
  const Marker kinds[] = {Marker::circle, Marker::square, Marker::triangle};
  int k = 0;
  for (const char* run : {"14", "35", "36"}) {
    const Table points = runs.where("run", std::string(run));
    const double ct = points.number(0, "ct");
    Series s = marks("CT " + points.text(0, "ct") + ", " + points.text(0, "rotor_rpm") + " rpm",
                     kLineColor[k + 1], kinds[k]);
    changed(s, points.numbers("descent_over_vh"), points.numbers("collective75_deg"),
            points.number(0, "collective75_deg"), std::sqrt(ct / 2));
    plot.series.push_back(s);
    ++k;
  }
  const Configured c = configured(0);
  const double hover = here.number(0, "descent_mps") / here.number(0, "descent_over_vh");
  Series now = line("this program", kBlue, Line::solid);
  changed(now, here.numbers("descent_over_vh"), here.numbers("collective75_deg"),
          at(here, "descent_mps", 0, "collective75_deg"), hover / c.tip_speed);
  plot.series.push_back(now);
  section.pictures.push_back({plot.id, svg(plot)});
  const double onset = at(here, "descent_over_vh", 0.45, "collective75_deg");
  const double end = at(here, "descent_over_vh", 1.5, "collective75_deg");
  section.findings.push_back({onset < end ? Finding::holds : Finding::differs,
                              "In vortex ring more descent needs more collective: heave is unstable.",
                              "at 0.45 v_h " + fixed(onset, 1) + " deg, at 1.5 v_h " + fixed(end, 1) +
                                  " deg. Measured at CT 0.005: 9.8 deg at 0.43, 11.0 deg at 1.17 v_h; at "
                                  "CT 0.004 hardly any change until the windmill."});
}

}  // namespace

Section rotor_descent() {
  Section section{"descent", "The rotor alone, from climb to windmill", "", {}, {}, {}};
  section.reading =
      "In vertical descent between 0.2 and 2.3 v_h the rotor flies in its own wake, and the mean inflow "
      "follows measured rotors (Johnson, NASA/TP-2005-213477); outside it is momentum theory. Where "
      "the induced velocity grows faster than the descent, heave is unstable: the faster the rotor sinks, the more "
      "air it draws down.";
  const Table here = sweep();
  section.tables.push_back({"rotor_descent", "climb to windmill at constant thrust", here});
  mean_inflow(here, section);
  autorotation(here, section);
  collective(here, section);
  return section;
}

}  // namespace tiltrotor::study
