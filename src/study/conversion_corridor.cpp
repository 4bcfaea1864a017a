// The conversion corridor: where level flight is possible, what ends it, and how stable it is inside.

#include <algorithm>
#include <cmath>

#include "plot/plot.hpp"
#include "study/corridor_edges.hpp"
#include "study/drawn_with.hpp"
#include "study/linear_models.hpp"
#include "study/missing.hpp"
#include "study/reference_points.hpp"
#include "study/sections.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

using namespace plot;

namespace {

constexpr double kMastStep = 2.5;  // deg
constexpr double kEdgeStep = 5;    // deg
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

// ok, power (trimmed, beyond the transmission), the limit exceeded, or why there is no trim.
std::string state_word(const Configured& c, const Trimmed& t) {
  if (t.status == TrimStatus::ok && total_power_kw(t) > kWatt * transmission_power(c)) return "power";
  return trim_status_word(t.status);
}

std::vector<Table::Cell> grid_row(const Configured& c, double mast, double speed, const Trimmed& t) {
  const std::string state = state_word(c, t);
  const Slowest s = state == "ok" ? slowest(modes_of(c, t)) : Slowest{kMissing, "", kMissing, ""};
  const bool has_trim = is_trimmed(t.status);
  return {mast,
          speed,
          state,
          static_cast<double>(t.iterations),
          has_trim ? total_power_kw(t) : kMissing,
          has_trim ? degrees(t.state.pitch) : kMissing,
          has_trim ? degrees(t.wing_angle_of_attack) : kMissing,
          s.real,
          s.mode,
          s.damping_ratio,
          s.oscillation};
}

// From cold starts: outwards from the middle of the corridor and up from hover, in each run to the second
// point in a row that does not fly. What lies beyond is not tried.
Table grid_table() {
  Table table({"mast_deg", "speed_mps", "state", "iterations", "power_kw", "pitch_deg", "wing_alpha_deg",
               "least_stable_real", "least_stable_mode", "least_damping_ratio", "least_damped_mode"});
  table.comment(
      "state: ok, power (needs more than the transmission takes), the limit that a trim exceeds, why there "
      "is no trim, or beyond (not tried).");
  const int last = static_cast<int>(kHighestSpeed / kSpeedStep);
  for (double mast = 0; mast <= 90; mast += kMastStep) {
    const Configured c = configured(mast);
    std::vector<std::vector<Table::Cell>> rows(static_cast<std::size_t>(last + 1));
    const auto run = [&](int from, int direction) {
      int failures = 0;
      for (int k = from; k >= 0 && k <= last && failures < 2; k += direction) {
        std::vector<Table::Cell>& row = rows[static_cast<std::size_t>(k)];
        if (!row.empty()) return;
        const Trimmed t = trimmed(c, k * kSpeedStep);
        row = grid_row(c, mast, k * kSpeedStep, t);
        failures = std::get<std::string>(row[2]) == "ok" ? 0 : failures + 1;
      }
    };
    const int middle = static_cast<int>(middle_speed(mast) / kSpeedStep);
    run(middle, 1);
    run(middle - 1, -1);
    run(0, 1);
    for (int k = 0; k <= last; ++k) {
      std::vector<Table::Cell>& row = rows[static_cast<std::size_t>(k)];
      if (row.empty()) {
        row = {mast,     k * kSpeedStep, std::string("beyond"), kMissing, kMissing,     kMissing,
               kMissing, kMissing,       std::string(),         kMissing, std::string()};
      }
      table.add(row);
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
  const Table part =
      std::string(boundary) == "design_minimum" ? rows.where("mass_lb", std::string("13000")) : rows;
  return line_of(name, color, Line::dashed, marker, part.numbers("speed_mps"), part.numbers("mast_deg"));
}

Plot corridor_plot(const char* id, const char* title, const Table& grid, const Table& edges,
                   const char* column) {
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
  plot.note = drawn_with();
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
  std::vector<double> continuous = edges.numbers("power_mps");
  for (std::size_t i = 0; i < continuous.size(); ++i) {
    const std::string reason = edges.text(i, "power_reason");
    if (reason != "power" && reason != "torque") continuous[i] = kMissing;
  }
  plot.series = {
      line_of("wing stall", kBlack, Line::solid, Marker::none, edges.numbers("stall_mps"), mast),
      line_of("continuous rating", kBlack, Line::dotted, Marker::none, continuous, mast),
      line_of("take-off rating", kOrange, Line::solid, Marker::none, edges.numbers("takeoff_mps"), mast),
      published("1975 design", "design_minimum", kPurple, Marker::circle),
      published("", "design_vc", kPurple, Marker::circle),
      published("in use 1980", "corridor_minimum", kGreen, Marker::triangle),
      published("", "corridor_maximum", kGreen, Marker::triangle)};
  return plot;
}

Picture growth_picture(const Table& grid, const Table& edges) {
  Plot plot = corridor_plot("corridor_growth", "Corridor: real part of the least stable root", grid, edges,
                            "least_stable_real");
  plot.cells.level = {-0.1, -0.05, -0.02, 0, 0.05, 0.15};
  plot.cells.color = {"#2b7bba", "#6fb0d9", "#b0d5ea", "#e3f0f7", "#fde3c8", "#f9b878", "#e8823a"};
  plot.cells.label = "1/s";
  return {plot.id, svg(plot)};
}

Picture damping_picture(const Table& grid, const Table& edges) {
  Plot plot = corridor_plot("corridor_damping", "Corridor: damping ratio of the worst oscillation", grid,
                            edges, "least_damping_ratio");
  plot.cells.level = {-0.2, 0, 0.1, 0.2, 0.3, 0.5};
  plot.cells.color = {"#e8823a", "#fbcfa0", "#e3f0f7", "#b0d5ea", "#6fb0d9", "#2b7bba", "#145a91"};
  plot.cells.label = "Damping ratio";
  return {plot.id, svg(plot)};
}

Finding minimum_speeds(const Table& compared) {
  constexpr double tolerance = 4.1;  // m/s, 8 kt
  std::string found;
  bool good = true;
  for (std::size_t i = 0; i < compared.rows(); ++i) {
    const double difference = compared.number(i, "difference_mps");
    good = good && std::fabs(difference) <= tolerance;
    found += (i ? "; " : "") + std::string("mast ") + compared.text(i, "mast_deg") + ", " +
             compared.text(i, "mass_lb") + " lb: " + fixed(compared.number(i, "here_mps"), 1) + " against " +
             fixed(compared.number(i, "design_mps"), 1);
  }
  return {good ? Finding::holds : Finding::partly,
          "Minimum speeds of the 1975 design, same flap and rotor speed (8 kt).",
          found +
              " m/s. Here stall is a wing angle of attack of 16 deg; the design adds what the rotors can "
              "carry, which depends "
              "on mass."};
}

Finding convergence(const Table& grid) {
  const Table inside = grid.where("state", std::string("ok"));
  std::string reasons;
  for (const std::string& state : grid.different("state")) {
    if (state == "ok" || state == "beyond") continue;
    reasons +=
        (reasons.empty() ? "" : ", ") + state + " " + std::to_string(grid.where("state", state).rows());
  }
  const std::vector<double> iterations = inside.numbers("iterations");
  const double most = *std::max_element(iterations.begin(), iterations.end());
  // A hole would be a point without trim between two with.
  std::size_t holes = 0;
  for (std::size_t i = 1; i + 1 < grid.rows(); ++i) {
    const auto flies = [&](std::size_t k) { return grid.text(k, "state") == "ok"; };
    const bool same_mast = grid.text(i - 1, "mast_deg") == grid.text(i + 1, "mast_deg");
    holes += same_mast && flies(i - 1) && flies(i + 1) && grid.text(i, "state") == "not_converged";
  }
  return {holes == 0 ? Finding::holds : Finding::differs,
          "Trim converges from a cold start everywhere in the corridor.",
          std::to_string(inside.rows()) + " grid points inside, at most " + fixed(most, 0) +
              " Newton steps, no hole. Points tried outside, by reason: " + reasons + "."};
}

Finding stops(const Table& edges) {
  std::string names;
  for (const std::string& name : edges.different("stop_name")) {
    if (!name.empty()) names += (names.empty() ? "" : ", ") + name;
  }
  return {Finding::remark,
          "On the slow side it is the wing that ends level flight at every mast angle from 25 deg on.",
          names.empty() ? "No control reaches its stop before."
                        : "Controls that reach their stop before: " + names + "."};
}

}  // namespace

Section conversion_corridor() {
  Section section{"corridor", "Conversion corridor", "", {}, {}, {}};
  section.reading =
      "Level flight is possible where the picture is filled: too slow on the left, the wing stalls; too fast "
      "on the right, "
      "the transmission has no more power (at mast 90, with its lower rotor speed, torque). That is the "
      "continuous rating, of engines and transmission alike; the orange line is the take-off rating of the "
      "engines. Blue is stable. Dashed on the left the published least speeds, on the right the greatest "
      "(1975: Vc). "
      "At low mast "
      "angles flight below the stall of the wing is possible, nose high. Flap and rotor speed change at mast "
      "0 and 90.";
  const Table grid = grid_table();
  const Table edges = corridor_edges(kEdgeStep);
  const Table compared = compared_minimum_speeds();
  section.pictures = {growth_picture(grid, edges), damping_picture(grid, edges)};
  section.findings = {minimum_speeds(compared), stops(edges), convergence(grid)};
  section.tables.push_back({"corridor", "every point of the grid", grid});
  section.tables.push_back({"corridor_edges", "wing stall, control stops, power", edges});
  section.tables.push_back({"corridor_compared", "minimum speed against the 1975 design", compared});
  section.tables.push_back(
      {"corridor_in_use_compared", "against the corridor in use in 1980", compared_corridor_in_use()});
  return section;
}

}  // namespace tiltrotor::study
