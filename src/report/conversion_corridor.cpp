// The conversion corridor: where level flight is possible, what ends it, and how stable it is inside.

#include <algorithm>
#include <cmath>

#include "report/corridor_edges.hpp"
#include "report/linear_models.hpp"
#include "report/reference_points.hpp"
#include "report/sections.hpp"
#include "report/svg_plot.hpp"
#include "report/wording.hpp"

namespace tiltrotor::report {

namespace {

constexpr double kMastStep = 2.5;  // deg
constexpr double kSpeedStep = 2;   // m/s
constexpr double kHighestSpeed = 140;

struct Slowest {
  double real = -1e9;
  std::string mode;
  double damping_ratio = 1;
  std::string oscillation;
};
Slowest slowest(const Modes& modes) {
  Slowest found;
  for (int k = 0; k < modes.count; ++k) {
    const Mode<double>& m = modes.mode[k];
    if (!is_body_mode(m)) continue;
    if (m.real > found.real) {
      found.real = m.real;
      found.mode = m.name;
    }
    if (m.imag > 0 && m.damping_ratio < found.damping_ratio) {
      found.damping_ratio = m.damping_ratio;
      found.oscillation = m.name;
    }
  }
  return found;
}

// ok, power (trimmed, beyond the transmission), or the reason why there is no flight.
std::string state_word(const Configured& c, const Trimmed& t) {
  if (t.status == TrimStatus::ok && total_power_kw(t) > kWatt * transmission_power(c)) return "power";
  return trim_status_word(t.status);
}

Table grid_table() {
  Table table({"mast_deg", "speed_mps", "state", "iterations", "power_kw", "pitch_deg", "wing_alpha_deg", "least_stable_real",
               "least_stable_mode", "least_damping_ratio", "least_damped_mode"});
  table.comment("state: ok, power (needs more than the transmission takes), or why there is no trim. Roots of the body alone.");
  for (double mast = 0; mast <= 90; mast += kMastStep) {
    const Configured c = configured(mast);
    for (double speed = 0; speed <= kHighestSpeed; speed += kSpeedStep) {
      const Trimmed t = trimmed(c, speed);
      const std::string state = state_word(c, t);
      const bool flies = state == "ok";
      const Slowest s = flies ? slowest(modes_of(c, t)) : Slowest{NAN, "", NAN, ""};
      const double missing = NAN;
      const bool has_trim = is_trimmed(t.status);
      table.add({mast, speed, state, static_cast<double>(t.iterations), has_trim ? total_power_kw(t) : missing,
                 has_trim ? degrees(t.state.pitch) : missing, has_trim ? degrees(t.wing_angle_of_attack) : missing, s.real,
                 s.mode, s.damping_ratio, s.oscillation});
    }
  }
  return table;
}

std::vector<double> edges_around(double low, double high, double step) {
  std::vector<double> edges = {low};
  for (double x = low + step / 2; x < high; x += step) edges.push_back(x);
  edges.push_back(high);
  return edges;
}

Series line_of(const char* name, const char* color, Line line, Marker marker, const std::vector<double>& x,
               const std::vector<double>& y) {
  Series s;
  s.name = name;
  s.color = color;
  s.line = line;
  s.marker = marker;
  s.filled = false;
  s.x = x;
  s.y = y;
  return s;
}

Series published(const char* name, const char* boundary, const char* color, Marker marker) {
  const Table rows = reference_points("conversion_corridor").where("boundary", std::string(boundary));
  const Table part = std::string(boundary) == "design_minimum" ? rows.where("mass_lb", std::string("13000")) : rows;
  return line_of(name, color, Line::dashed, marker, part.numbers("speed_mps"), part.numbers("mast_deg"));
}

Plot corridor_plot(const char* id, const char* title, const Table& grid, const Table& edges, const char* column) {
  Plot plot;
  plot.id = id;
  plot.title = title;
  plot.x.label = "Speed, m/s";
  plot.y.label = "Mast angle, deg";
  plot.x.low = 0;
  plot.x.high = kHighestSpeed;
  plot.y.low = 0;
  plot.y.high = 90;
  plot.axes_height = 330;
  plot.cells.x_edge = edges_around(0, kHighestSpeed, kSpeedStep);
  plot.cells.y_edge = edges_around(0, 90, kMastStep);
  const std::size_t columns = plot.cells.x_edge.size() - 1;
  const std::size_t rows = plot.cells.y_edge.size() - 1;
  const std::vector<double> values = grid.numbers(column);  // mast by mast
  plot.cells.value.resize(rows * columns);
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) plot.cells.value[i * rows + j] = values[j * columns + i];
  }
  const std::vector<double> mast = edges.numbers("mast_deg");
  plot.series = {line_of("stall side", kBlack, Line::solid, Marker::none, edges.numbers("stall_mps"), mast),
                 line_of("power side", kBlack, Line::dotted, Marker::none, edges.numbers("power_mps"), mast),
                 published("1975 minimum", "design_minimum", kPurple, Marker::circle),
                 published("1975 Vc", "design_vc", kPurple, Marker::square),
                 published("1980 minimum", "corridor_minimum", kGreen, Marker::triangle),
                 published("1980 maximum", "corridor_maximum", kGreen, Marker::diamond)};
  return plot;
}

Picture growth_picture(const Table& grid, const Table& edges) {
  Plot plot = corridor_plot("corridor_growth", "Corridor, filled with the real part of the least stable root", grid, edges,
                            "least_stable_real");
  plot.cells.level = {-0.1, -0.05, -0.02, 0, 0.05, 0.15};
  plot.cells.color = {"#2b7bba", "#6fb0d9", "#b0d5ea", "#e3f0f7", "#fde3c8", "#f9b878", "#e8823a"};
  plot.cells.name = {"below −0.1", "to −0.05", "to −0.02", "to 0", "to 0.05", "to 0.15", "above 0.15 1/s"};
  return {plot.id, svg(plot)};
}

Picture damping_picture(const Table& grid, const Table& edges) {
  Plot plot = corridor_plot("corridor_damping", "Corridor, filled with the damping ratio of the least damped oscillation", grid,
                            edges, "least_damping_ratio");
  plot.cells.level = {-0.2, 0, 0.1, 0.2, 0.3, 0.5};
  plot.cells.color = {"#e8823a", "#fbcfa0", "#e3f0f7", "#b0d5ea", "#6fb0d9", "#2b7bba", "#145a91"};
  plot.cells.name = {"below −0.2", "to 0", "to 0.1", "to 0.2", "to 0.3", "to 0.5", "above 0.5"};
  return {plot.id, svg(plot)};
}

Finding minimum_speeds(const Table& compared) {
  constexpr double tolerance = 4.1;  // m/s, 8 kt
  std::string found;
  bool good = true;
  for (std::size_t i = 0; i < compared.rows(); ++i) {
    const double difference = compared.number(i, "difference_mps");
    good = good && std::fabs(difference) <= tolerance;
    found += (i ? "; " : "") + std::string("mast ") + compared.text(i, "mast_deg") + ", " + compared.text(i, "mass_lb") +
             " lb: " + fixed(compared.number(i, "here_mps"), 1) + " against " + fixed(compared.number(i, "design_mps"), 1);
  }
  return {good ? Finding::holds : Finding::partly, "Minimum speeds of the 1975 design, same flap and rotor speed (8 kt).",
          found + " m/s. Stall is taken at a wing angle of attack of 16 deg."};
}

Finding convergence(const Table& grid, const Table& edges) {
  std::size_t inside = 0;
  std::size_t found = 0;
  double most = 0;
  for (std::size_t i = 0; i < grid.rows(); ++i) {
    const Table edge = edges.where("mast_deg", grid.number(i, "mast_deg"));
    const double speed = grid.number(i, "speed_mps");
    const double low = edge.number(0, "stall_mps");
    if (speed < (std::isfinite(low) ? low : 0) || speed > edge.number(0, "power_mps")) continue;
    ++inside;
    if (grid.text(i, "state") != "ok") continue;
    ++found;
    most = std::max(most, grid.number(i, "iterations"));
  }
  return {found == inside ? Finding::holds : Finding::differs, "Trim converges from a cold start everywhere in the corridor.",
          std::to_string(found) + " of " + std::to_string(inside) + " grid points between the edges, at most " +
              fixed(most, 0) + " Newton steps."};
}

}  // namespace

Section conversion_corridor() {
  Section section{"corridor", "Conversion corridor", "", {}, {}, {}};
  section.reading =
      "Level flight is possible where the picture is filled: too slow on the left, the wing stalls; too fast on the right, "
      "the transmission has no more power (at mast 90, with its lower rotor speed, torque). Blue is stable. At low mast "
      "angles flight below the stall of the wing is possible, nose high. Flap and rotor speed change at mast 0 and 90.";
  const Table grid = grid_table();
  const Table edges = corridor_edges(kMastStep);
  const Table compared = compared_minimum_speeds();
  section.pictures = {growth_picture(grid, edges), damping_picture(grid, edges)};
  section.findings = {minimum_speeds(compared), convergence(grid, edges)};
  section.tables.push_back({"corridor", "every point of the grid", grid});
  section.tables.push_back({"corridor_edges", "stall and power side", edges});
  section.tables.push_back({"corridor_compared", "minimum speed against the 1975 design", compared});
  return section;
}

}  // namespace tiltrotor::report
