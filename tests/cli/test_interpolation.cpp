// Kinds of tables on the command line, and `interpolation`.
// Expected: models by the library with each set of tables; the variance of a number within equal chance of its range.
#include <algorithm>
#include <cmath>
#include <memory>

#include "c2_tables.inc"
#include "check.hpp"
#include "cli/analyses_workspace.hpp"
#include "cli/csv_text.hpp"
#include "cli/linear_options.hpp"
#include "cli/print_rounding.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"
#include "tiltrotor/model/aircraft/c2_aircraft.hpp"
#include "tiltrotor/model/preparation.hpp"

using namespace tiltrotor;
using check::CsvText;
using check::run_tiltrotor;

namespace {

// A stability derivative, "M_w", rotors and wash following, at the trim of these tables.
double derivative_of(const std::string& name, const Aircraft<double>& aircraft, Interpolation tables,
                     double mast_deg, double speed) {
  static const cli::AnalysesWorkspace work;
  FlightSetup<double> setup = flight_setup(aircraft, mast_deg);
  setup.options.tables = tables;
  const auto c = std::make_unique<Configuration<double>>();
  const auto trimmed = std::make_unique<TrimResult<double>>();
  const auto model = std::make_unique<LinearModel<double>>();
  CHECK(prepare(aircraft, setup, *c) == Status::ok);
  CHECK(is_trimmed(trim(*c, {speed, 0, 0, 0}, *work, *trimmed)));
  CHECK(linearize(*c, trimmed->state, trimmed->controls, kInceptors, *work, *model) == Status::ok);
  CHECK(cli::reduce_to_rigid(*model, Reduction::first_order) == Status::ok);
  const State<int>& at = kStateIndex;
  const int places[] = {at.velocity.x, at.velocity.y, at.velocity.z, at.rates.x, at.rates.y, at.rates.z};
  const int row = places[std::string("XYZLMN").find(name.front())];
  const int column = places[std::string("uvwpqr").find(name.back())];
  double found = NAN;
  for (int i = 0; i < model->states; ++i)
    for (int j = 0; j < model->states; ++j)
      if (model->state[i] == row && model->state[j] == column) found = model->a(i, j);
  return found;
}
double moment_by_w(const Aircraft<double>& aircraft, Interpolation tables, double mast_deg, double speed) {
  return derivative_of("M_w", aircraft, tables, mast_deg, speed);
}

std::size_t row_of(const CsvText& rows, const std::string& derivative) {
  for (std::size_t i = 0; i < rows.rows.size(); ++i)
    if (rows.text(i, "derivative") == derivative) return i;
  throw std::runtime_error("no row of " + derivative);
}

}  // namespace

TEST_OF_XV15(cli_interpolation_c2_smooths_the_moment_along_speed) {
  double rough[2] = {};
  double last[2][2] = {};
  for (int n = 0; n < 9; ++n) {
    const double speed = 34 + 2 * n;
    const double now[2] = {moment_by_w(aircraft_data<double>(), Interpolation::c1, 30, speed),
                           moment_by_w(c2_aircraft_data(), Interpolation::c1, 30, speed)};
    for (int k = 0; k < 2; ++k) {
      if (n > 1) rough[k] += std::pow(now[k] - 2 * last[k][0] + last[k][1], 2);
      last[k][1] = last[k][0];
      last[k][0] = now[k];
    }
  }
  NOTE("second differences of M_w, squared and summed: c1 " << rough[0] << ", c2 " << rough[1]);
  CHECK_LE(rough[1], rough[0] / 3);
}

TEST_OF_XV15(cli_interpolation_shows_all_three_kinds) {
  const std::string flown = this_aircraft::flown("interpolation --mast 30 --speed 46 --draws 4 --format csv");
  const check::ProgramResult result = run_tiltrotor(flown);
  CHECK_EQ(result.exit_status, 0);
  CHECK_EQ(result.err, std::string());
  const CsvText rows(result.out);
  for (const char* name : {"X_u", "Z_w", "M_w", "M_q", "Y_v", "L_p", "N_r"}) {
    const std::size_t i = row_of(rows, name);
    const double c1 = rows.number(i, "c1"), linear = rows.number(i, "linear"), c2 = rows.number(i, "c2");
    const auto [low, high] = std::minmax({c1, linear, c2});
    CHECK_NEAR(rows.number(i, "interpolation_band"), high - low, 1e-9 * (std::fabs(c1) + 1));
    CHECK(rows.number(i, "rounding") > 0);
    CHECK_NEAR(rows.number(i, "data_percent") + rows.number(i, "interpolation_percent") +
                   rows.number(i, "rounding_percent"),
               100, 1e-8);
  }
  CHECK_EQ(run_tiltrotor(flown).out, result.out);
}

TEST_OF_XV15(cli_interpolation_shows_the_models_of_linearize) {
  const CsvText rows(run_tiltrotor("interpolation --mast 30 --speed 46 --draws 2 --format csv").out);
  const std::size_t i = row_of(rows, "M_w");
  CHECK_REL(rows.number(i, "c1"), moment_by_w(aircraft_data<double>(), Interpolation::c1, 30, 46), 1e-9);
  CHECK_REL(rows.number(i, "linear"), moment_by_w(aircraft_data<double>(), Interpolation::linear, 30, 46),
            1e-9);
  CHECK_REL(rows.number(i, "c2"), moment_by_w(c2_aircraft_data(), Interpolation::c1, 30, 46), 1e-9);
}

// Shares of data, band and print from models of five aircraft, each prepared, trimmed and linearised here: the three
// kinds of tables, and the aircraft of two draws of the print.
TEST_OF_XV15(cli_interpolation_shares_are_those_of_five_aircraft) {
  constexpr double mast = 30, speed = 46;
  const CsvText rows(run_tiltrotor("interpolation --mast 30 --speed 46 --draws 2 --format csv").out);
  for (const std::string name : {"X_u", "Z_w", "M_w", "M_q", "L_v", "L_p", "N_v"}) {
    const double c1 = derivative_of(name, aircraft_data<double>(), Interpolation::c1, mast, speed);
    const double linear = derivative_of(name, aircraft_data<double>(), Interpolation::linear, mast, speed);
    const double c2 = derivative_of(name, c2_aircraft_data(), Interpolation::c1, mast, speed);
    double squares = 0;
    for (const std::uint64_t number : {0, 1}) {
      cli::PrintRounding rounding;
      Aircraft<double> drawn = aircraft_data<double>();
      rounding.draw(number, drawn);
      squares += std::pow(derivative_of(name, drawn, Interpolation::c1, mast, speed) - c1, 2);
    }
    const double print = std::sqrt(squares / 2);
    const double band = std::max(c1, std::max(linear, c2)) - std::min(c1, std::min(linear, c2));
    const double whole = std::fabs(c1) + band + print;
    CHECK(print > 1e-5 * whole && band > 1e-4 * whole);
    const std::size_t i = row_of(rows, name);
    const struct {
      const char* column;
      double expected;
    } columns[] = {{"interpolation_band", band},
                   {"rounding", print},
                   {"data_percent", 100 * std::fabs(c1) / whole},
                   {"interpolation_percent", 100 * band / whole},
                   {"rounding_percent", 100 * print / whole}};
    for (const auto& column : columns)
      if (!CHECK_REL(rows.number(i, column.column), column.expected, 1e-6))
        NOTE(name << " " << column.column);
  }
}

TEST(cli_interpolation_refuses_a_kind_of_tables) {
  const std::string refusal =
      "tiltrotor: interpolation: compares all kinds of tables: leave --tables and --option tables out\n";
  for (const char* kind : {"--tables c2", "--tables linear", "--option tables=c2"}) {
    const check::ProgramResult result = run_tiltrotor(std::string("interpolation ") + kind);
    CHECK_EQ(result.exit_status, 2);
    CHECK_EQ(result.err, refusal);
  }
  CHECK(run_tiltrotor("interpolation --draws 1").err.find("2..10000") != std::string::npos);
}

// Equal chance within half a unit: mean 0, mean square a third of its square.
TEST_OF_XV15(cli_interpolation_draws_are_within_print) {
  cli::PrintRounding rounding;
  Aircraft<double> drawn = aircraft_data<double>();
  Aircraft<double> usual = aircraft_data<double>();
  rounding.draw(3, drawn);
  std::vector<double> off;
  const auto each_value = [](Aircraft<double>& a, auto&& visit) {
    c2_tables::visit_print(a, [&](const char*, auto& t, const double* half) {
      constexpr int smooth = sizeof(t.smooth) / sizeof(t.smooth[0]);
      int values = 1;
      for (const auto& axis : t.smooth) values *= axis.count;
      for (const auto& axis : t.linear) values *= std::max(axis.count, 1);
      for (int i = 0; i < values; ++i) visit(t.node[i << smooth], half[i]);
    });
  };
  each_value(usual, [&](double value, double) { off.push_back(-value); });
  std::size_t k = 0;
  double sum = 0, squares = 0, count = 0;
  each_value(drawn, [&](double value, double half) {
    off[k] += value;
    CHECK_LE(std::fabs(off[k]), half * (1 + 1e-12) + 1e-15 * std::fabs(value));
    if (half > 0) {
      sum += off[k] / half;
      squares += off[k] * off[k] / (half * half);
      ++count;
    }
    ++k;
  });
  CHECK_EQ(k, off.size());
  CHECK_NEAR(sum / count, 0, 5 / std::sqrt(3 * count));
  CHECK_NEAR(squares / count, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / count));
}

// Every command flies with them, and says so.
TEST(cli_interpolation_c2_tables_are_told) {
  const std::string flight = " " + this_aircraft::flown("--mast 60 --speed 60 --grid realtime");
  const std::string c2 = run_tiltrotor("trim" + flight + " --tables c2 --format csv").out;
  CHECK(c2.find(" tables=c2 grid=realtime") != std::string::npos);
  CHECK(c2 != run_tiltrotor("trim" + flight + " --format csv").out);
  CHECK_EQ(run_tiltrotor("trim" + flight + " --option tables=c2 --format csv").out, c2);
  CHECK(run_tiltrotor("linearize" + flight + " --tables c2 --format json").out.find("\"tables\": \"c2\"") !=
        std::string::npos);
  const check::ProgramResult respond =
      run_tiltrotor("respond" + flight + " --tables c2 --duration 0.1 --format csv");
  CHECK_EQ(respond.exit_status, 0);
  CHECK(respond.out.find("tables=c2") != std::string::npos);
  const CsvText engine(run_tiltrotor("trim" + flight + " --tables c2 --engines 1 --format csv").out);
  CHECK_REL(engine.number(0, "pitch_deg"), CsvText(c2).number(0, "pitch_deg"), 1e-9);
}
