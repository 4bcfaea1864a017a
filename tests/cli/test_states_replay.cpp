// Given states through the whole program, against the outputs of an independent second implementation
// (tests/reference): every derivative and every component load.
#include <cmath>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/scratch_folder.hpp"
#include "csv_file.hpp"
#include "run_program.hpp"

using check::CsvFile;
using check::CsvText;
using check::run_tiltrotor;

namespace {

// The two programs differ in the last digits of converted constants: 6e-8 where large loads nearly cancel
// (one d_w), below 1e-8 for the loads themselves.
constexpr double tolerance = 1e-6;

const char* const states[] = {"u",     "v",     "w",      "p",      "q",      "r",    "phi",  "theta",
                              "psi",   "b1c_R", "b1s_R",  "db1c_R", "db1s_R", "n0_R", "nc_R", "ns_R",
                              "b1c_L", "b1s_L", "db1c_L", "db1s_L", "n0_L",   "nc_L", "ns_L", "eps"};

std::string reference(const std::string& kind, const std::string& tables) {
  return "tests/reference/" + kind + "_" + tables + ".csv";
}

std::string replay(const std::string& command, const std::string& tables) {
  return command + " --preset reference --tables " + tables + " --states " +
         check::quoted(check::source_path(reference("state_derivatives", tables)));
}

struct Worst {
  double error = 0;
  std::string where;
  void see(double actual, double expected, const std::string& place) {
    const double relative = std::abs(actual - expected) / std::abs(expected);
    if (actual == expected || relative <= error) return;
    error = relative;
    where = place;
  }
};

}  // namespace

TEST_OF_XV15(cli_derivative_replays_the_reference) {
  for (const char* tables : {"c1", "linear"}) {
    const CsvFile expected(reference("state_derivatives", tables));
    const CsvText actual(run_tiltrotor(replay("derivative", tables)).out);
    if (!CHECK_EQ(actual.rows.size(), static_cast<std::size_t>(expected.rows()))) return;
    Worst worst;
    for (int row = 0; row < expected.rows(); ++row) {
      for (const char* state : states) {
        const std::string column = std::string("d_") + state;
        worst.see(actual.number(static_cast<std::size_t>(row), column), expected.number(row, column),
                  "case " + expected.text(row, "case") + " " + column);
      }
    }
    NOTE(tables << ": largest relative difference " << worst.error << ", " << worst.where);
    CHECK_LE(worst.error, tolerance);
  }
}

TEST_OF_XV15(cli_loads_replay_the_reference) {
  for (const char* tables : {"c1", "linear"}) {
    const CsvFile expected(reference("component_loads", tables));
    const CsvText actual(run_tiltrotor(replay("loads", tables)).out);
    if (!CHECK_EQ(actual.rows.size(), static_cast<std::size_t>(expected.rows()))) return;
    const char* const columns[][2] = {{"X_n", "x_n"},   {"Y_n", "y_n"},   {"Z_n", "z_n"},
                                      {"L_nm", "l_nm"}, {"M_nm", "m_nm"}, {"N_nm", "n_nm"}};
    Worst worst;
    for (int row = 0; row < expected.rows(); ++row) {
      const auto line = static_cast<std::size_t>(row);
      CHECK_EQ(actual.text(line, "case"), expected.text(row, "case"));
      CHECK_EQ(actual.text(line, "component"), expected.text(row, "component"));
      CHECK_EQ(actual.number(line, "mast_deg"), expected.number(row, "mast_deg"));
      for (const auto& column : columns) {
        worst.see(
            actual.number(line, column[1]), expected.number(row, column[0]),
            "case " + expected.text(row, "case") + " " + expected.text(row, "component") + " " + column[0]);
      }
    }
    NOTE(tables << ": largest relative difference " << worst.error << ", " << worst.where);
    CHECK_LE(worst.error, tolerance);
  }
}

TEST(cli_derivative_repeats_the_columns_of_the_file) {
  const std::string path = check::source_path("tests/reference/state_derivatives_c1.csv");
  const CsvText actual(run_tiltrotor("derivative --states " + check::quoted(path)).out);
  const CsvFile file("tests/reference/state_derivatives_c1.csv");
  CHECK_EQ(actual.columns.size(), 2u + 24u + 4u + 24u);
  for (std::size_t i = 0; i < 24; ++i) CHECK_EQ(actual.columns[30 + i], std::string("d_") + states[i]);
  for (int row = 0; row < file.rows(); ++row) {
    for (std::size_t i = 0; i < 30; ++i) {
      CHECK_EQ(actual.rows[static_cast<std::size_t>(row)][i], file.text(row, actual.columns[i]));
    }
  }
}

// Columns may stand in any order; without mast_deg the option applies. Expected: the file as it is.
TEST(cli_states_may_stand_in_any_order) {
  const CsvFile file("tests/reference/state_derivatives_c1.csv");
  std::string header = "ped_in,lat_in,lon_in,th75_rad";
  std::string cells;
  const int row = 1;
  for (const char* control : {"ped_in", "lat_in", "lon_in", "th75_rad"})
    cells += file.text(row, control) + ",";
  for (int i = 23; i >= 0; --i) {
    header += std::string(",") + states[i];
    cells += file.text(row, states[i]) + (i > 0 ? "," : "");
  }
  const check::ScratchFolder folder;
  const std::string path = folder.write("states.csv", header + "\n" + cells + "\n");
  const CsvText actual(run_tiltrotor("derivative --preset reference --mast " + file.text(row, "mast_deg") +
                                     " --states " + path)
                           .out);
  const CsvText expected(run_tiltrotor(replay("derivative", "c1")).out);
  for (const char* state : states) {
    const std::string column = std::string("d_") + state;
    CHECK_EQ(actual.text(0, column), expected.text(row, column));
  }
}
