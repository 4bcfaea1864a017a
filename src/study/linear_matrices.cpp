// The matrices that the reference simulation printed at 200 kt beside those of this program, term by term.

#include <cmath>
#include <cstring>

#include "study/printed_linear_model.hpp"
#include "study/sections.hpp"
#include "study/validation_rules.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

namespace {

constexpr double kAlike = 0.15;  // of the printed term: nothing is explained that differs by less
constexpr const char* kRows[2][3] = {{"u", "w", "q"}, {"v", "p", "r"}};
constexpr const char* kColumns[2][6] = {{"u", "w", "q", "theta", "long_stick", "power_lever"},
                                        {"v", "p", "r", "phi", "lat_stick", "pedal"}};
constexpr const char* kAxis[2] = {"longitudinal", "lateral"};

// The same aircraft with the dynamic pressure at the tail that flight data need.
std::vector<double> terms_with_tail_of_flight(Setup setup) {
  setup.options.tail_pressure = TailPressure::by_mast;
  return terms_of(printed_states(setup, aircraft_data<double>(), DownwashDelay::first_order));
}

bool is_alike(double ratio) { return std::fabs(ratio - 1) <= kAlike; }

Table term_table() {
  const Setup setup = printed_model_setup(compared_aircraft("linear_model_gtrs"));
  const std::vector<double> here =
      terms_of(printed_states(setup, aircraft_data<double>(), DownwashDelay::first_order));
  const std::vector<double> without_lag =
      terms_of(printed_states(setup, aircraft_data<double>(), DownwashDelay::none));
  const std::vector<double> flight_tail = terms_with_tail_of_flight(setup);
  Table table(
      {"matrix", "row", "column", "printed", "here", "ratio", "flight_tail", "without_lag", "explanation"});
  table.comment(
      "Units of the print: ft, s, rad, in of stick, pedal and lever. flight_tail: with K_HNU of 0.8");
  table.comment(
      "at the horizontal tail, as flown; without_lag: with its downwash at once. The lever's column is scaled");
  table.comment("to its first term.");
  for (std::size_t i = 0; i < here.size(); ++i) {
    const LinearTerm& term = printed_terms()[i];
    const double ratio = here[i] / term.printed;
    table.add({term.matrix, term.row, term.column, fixed(term.printed, 4), fixed(here[i], 4), fixed(ratio, 3),
               fixed(flight_tail[i], 4), fixed(without_lag[i], 4),
               is_alike(ratio) ? "" : tolerance_of("linear_model_gtrs", term.quantity(), 90).cause});
  }
  return table;
}

// [A B] printed and here, side by side: a row of the table for each row of the matrices.
Table matrix_table(const Table& terms, int axis) {
  std::vector<std::string> columns = {"row"};
  for (const char* which : {"printed", "here"}) {
    for (const char* column : kColumns[axis]) columns.push_back(std::string(which) + "_" + column);
  }
  Table table(columns);
  table.comment("Blank: not printed, zero or nearly so.");
  for (const char* row : kRows[axis]) {
    const Table of_row = terms.where("row", std::string(row));
    std::vector<Table::Cell> cells = {std::string(row)};
    for (const char* which : {"printed", "here"}) {
      for (const char* column : kColumns[axis]) {
        const Table term = of_row.where("column", std::string(column));
        cells.emplace_back(term.rows() > 0 ? term.text(0, which) : "");
      }
    }
    table.add(cells);
  }
  return table;
}

int count_alike(const Table& terms, const char* column) {
  int alike = 0;
  for (std::size_t i = 0; i < terms.rows(); ++i)
    alike += is_alike(terms.number(i, column) / terms.number(i, "printed"));
  return alike;
}

// Longitudinal terms outside; the lever's hang on engine and governor.
std::string longitudinal_outside(const Table& terms) {
  std::string names;
  for (std::size_t i = 0; i < terms.rows(); ++i) {
    const bool along = std::strchr("uwq", terms.text(i, "row")[0]) != nullptr;
    const bool alike = is_alike(terms.number(i, "here") / terms.number(i, "printed"));
    if (!along || alike || terms.text(i, "column") == "power_lever") continue;
    names += (names.empty() ? "" : ", ") + terms.text(i, "row") + " by " + terms.text(i, "column");
  }
  return names.empty() ? "none" : names;
}

}  // namespace

Section linear_matrices() {
  Section section{"matrices", "Linear model at 200 kt, printed and here", "", {}, {}, {}};
  section.reading =
      "A and B of the GTRS simulation at mast 90, as printed, beside those of this program: the aircraft as "
      "simulated, rotor speed held, rotors and inflow in balance and the downwash at the tail late by its lag, "
      "since the print has the eight states of the rigid body alone. Its altitude is taken as sea level; its "
      "centre of gravity is not stated. A term that differs by more than 15 % has its explanation, and whether "
      "that is known.";
  const Table terms = term_table();
  const int of = static_cast<int>(terms.rows());
  const int alike = count_alike(terms, "here");
  section.findings.push_back(
      {verdict_of(alike, of), "The printed matrices at 200 kt, each term within 15 %.",
       std::to_string(alike) + " of " + std::to_string(of) + " terms, " +
           std::to_string(count_alike(terms, "flight_tail")) +
           " with the tail as flown. Longitudinal terms outside, those of the lever apart: " +
           longitudinal_outside(terms) + "."});
  for (const int axis : {0, 1}) {
    section.tables.push_back({std::string("linear_200kt_") + kAxis[axis],
                              std::string("[A B], ") + kAxis[axis] + ": printed, and here",
                              matrix_table(terms, axis), true});
  }
  section.tables.push_back({"linear_200kt_terms", "term by term", terms, true});
  return section;
}

}  // namespace tiltrotor::study
