// What acts on what in the model: one quantity is moved at a time, and every load and rate that changes is marked.

#include <algorithm>

#include "plot/colors.hpp"
#include "plot/drawing.hpp"
#include "plot/svg.hpp"
#include "study/drawn_with.hpp"
#include "study/missing.hpp"
#include "study/sections.hpp"

namespace tiltrotor::study {

using namespace plot;

namespace {

// A mark is there when it is at one of these flights; at the second the wing is in the rotors' wakes.
struct Flight {
  double mast_deg, speed_mps;  // 0: in the middle of the corridor
};
constexpr Flight kFlights[] = {{0, 0}, {0, 10}, {30, 0}, {90, 0}};
constexpr double kMove = 0.01;      // of the distance over which the model bends
constexpr double kNarrowest = 420;  // of a picture, as wide as the plots

// The model at one point: what may be moved, what may change.
struct Point {
  Configured c;
  State<double> x;
  Controls<double> u;
};

template <class Visit>
void each_moved(Point& at, Visit&& visit) {
  State<double>::describe(at.x, [&](double& value, const Variable& variable) {
    if (is_active(variable, at.c.setup.options)) visit(value, variable);
  });
  Controls<double>::describe(at.u, visit);
}

struct Effect {
  std::string name;
  std::vector<double> numbers;
};

std::vector<Effect> effects(const Point& at) {
  const Evaluation<double> e = evaluated(at.c, at.x, at.u);
  std::vector<Effect> all;
  for (int k = 0; k < component_count; ++k) {
    all.push_back({kComponentNames[k], {}});
    Loads<double>::each(e.loads.component[k],
                        [&](const double& number) { all.back().numbers.push_back(number); });
  }
  State<double>::describe(e.rates, [&](const double& rate, const Variable& variable) {
    if (is_active(variable, at.c.setup.options))
      all.push_back({std::string("rate_") + variable.name, {rate}});
  });
  return all;
}

// A flight with everything in motion and nothing alike left and right, so that nothing is zero by chance.
Point point(const Flight& flight) {
  Setup setup = default_setup(flight.mast_deg);
  setup.options.engine_jets = true;
  Point at{configured(setup), {}, {}};
  const double speed_mps = flight.speed_mps > 0 ? flight.speed_mps : middle_speed(flight.mast_deg);
  const Trimmed trim = trimmed_persistently(at.c, speed_mps);
  at.x = trim.state;
  at.u = trim.controls;
  double share = kMove;
  each_moved(at, [&](double& value, const Variable& variable) {
    value += share * variable.facts().bend;
    share = -0.97 * share;
  });
  return at;
}

Table effects_table() {
  std::vector<std::string> columns = {"moved"};
  std::vector<std::string> moved;
  Point any = point(kFlights[0]);
  for (const Effect& effect : effects(any)) columns.push_back(effect.name);
  each_moved(any, [&](double&, const Variable& variable) { moved.push_back(variable.name); });

  const std::size_t width = columns.size() - 1;
  std::vector<std::vector<bool>> acts(moved.size(), std::vector<bool>(width, false));
  for (const Flight& flight : kFlights) {
    Point at = point(flight);
    const std::vector<Effect> before = effects(at);
    std::size_t row = 0;
    each_moved(at, [&](double& value, const Variable& variable) {
      const double kept = value;
      value += kMove * variable.facts().bend;
      const std::vector<Effect> after = effects(at);
      value = kept;
      for (std::size_t k = 0; k < width; ++k)
        if (after[k].numbers != before[k].numbers) acts[row][k] = true;
      ++row;
    });
  }

  Table table(columns);
  table.comment(
      "1: moving this state or input changes that load, or that rate of a state, at one flight at least.");
  for (std::size_t i = 0; i < moved.size(); ++i) {
    std::vector<Table::Cell> cells = {moved[i]};
    for (std::size_t k = 0; k < width; ++k) cells.emplace_back(acts[i][k] ? 1.0 : kMissing);
    table.add(cells);
  }
  return table;
}

// Of the columns from `first` on, before `end`.
Picture picture(const Table& table, const char* id, const char* title, const char* color, std::size_t first,
                std::size_t end) {
  constexpr double left = 96;
  constexpr double top = 132;
  constexpr double cell = 12;
  const std::string small = " font-size=\"11\"";
  const double right = left + cell * static_cast<double>(end - first);
  const double bottom = top + cell * static_cast<double>(table.rows());
  const double wide = std::max(right + 12, kNarrowest);
  const std::vector<std::string> note = wrapped(drawn_with(), kSmallFont, wide - 2 * kMargin);
  constexpr double row = 14;
  std::string out = open_svg(wide, bottom + 12 + row * static_cast<double>(note.size()), title);
  out += "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  out += text_at(kMargin, 24, title, "start", kInk, " font-size=\"14\" font-weight=\"600\"");
  for (std::size_t k = first; k < end; ++k) {
    const double x = left + cell * (static_cast<double>(k - first) + 0.5);
    const std::string turned = "rotate(-90 " + coordinate(x + 4) + " " + coordinate(top - 5) + ")";
    out += text_at(x + 4, top - 5, table.columns()[k], "start", kInk, small + attribute("transform", turned));
  }
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double y = top + cell * (static_cast<double>(i) + 0.5);
    if (i % 2 == 0)
      out += "<rect" + attribute("x", left) + attribute("y", y - cell / 2) +
             attribute("width", right - left) + attribute("height", cell) + " fill=\"#f2f2f2\"/>\n";
    out += text_at(left - 6, y + 4, table.text(i, 0), "end", kInk, small);
    for (std::size_t k = first; k < end; ++k) {
      if (table.text(i, k).empty()) continue;
      out += "<circle" + attribute("cx", left + cell * (static_cast<double>(k - first) + 0.5)) +
             attribute("cy", y) + attribute("r", 3.5) + attribute("fill", std::string(color)) + "/>\n";
    }
  }
  for (std::size_t i = 0; i < note.size(); ++i)
    out += text_at(kMargin, bottom + 8 + row * static_cast<double>(i + 1), note[i], "start", kGrey, small);
  return {id, out + "</svg>\n"};
}

}  // namespace

Section data_flow() {
  Section section{"flow", "What acts on what in the model", "", {}, {}, {}};
  section.reading =
      "One evaluation takes the states and inputs at the left to the loads of the components (orange) and from "
      "there to the rates of the states (blue); nothing is iterated, because flapping, inflow and the wing's "
      "downwash are states. A mark: moving the one changes the other, in this run. The same code runs on plain "
      "numbers and on numbers that carry their derivatives, which makes trim, linear models and responses exact.";
  const Table table = effects_table();
  constexpr std::size_t rates = 1 + component_count;  // the first column of them
  section.pictures = {
      picture(table, "data_flow_loads", "What acts on the loads", kOrange, 1, rates),
      picture(table, "data_flow_rates", "What acts on the rates", kBlue, rates, table.columns().size())};
  section.tables.push_back({"data_flow", "what changes when one quantity moves", table});
  return section;
}

}  // namespace tiltrotor::study
