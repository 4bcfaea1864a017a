// What `trim --hold --free` finds does not depend on where it begins, and can be flown where anything can. Expected: plain
// trims at what was found and on both sides of it, and the page's own figures.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "run_program.hpp"

using check::CsvText;
using check::run_tiltrotor;

namespace {

CsvText trims(const std::string& options) {
  return CsvText(run_tiltrotor("trim --format csv " + options).out);
}

std::string exactly(double value) {
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

}  // namespace

// Power along speed at a climb of -30 deg is below zero between two speeds alone.
TEST_OF_XV15(cli_trim_reaches_what_is_held_from_any_start) {
  const std::string path = "--climb=-30 ";
  const CsvText power = trims(path + "--speed 30,32,36");
  CHECK(power.number(0, "power_kw") > 0 && power.number(1, "power_kw") < 0 &&
        power.number(2, "power_kw") > 0);
  for (const double start : {20, 28, 33, 36, 40, 45, 50}) {
    const CsvText held = trims(path + "--hold power_kw=0 --free speed_mps --speed " + exactly(start));
    if (!CHECK_EQ(held.text(0, "status"), std::string("ok"))) NOTE("from " << start);
    const double speed = held.number(0, "speed_mps");
    CHECK(start < 33.3 ? speed > 30 && speed < 32 : speed > 32 && speed < 36);
    CHECK_NEAR(trims(path + "--speed " + held.text(0, "speed_mps")).number(0, "power_kw"), 0, 1e-6);
  }
}

// Two of a pair of solutions that lie between the steps of the search, a tenth of a kilowatt above the least power.
TEST_OF_XV15(cli_trim_refines_the_least_before_it_gives_up) {
  for (const char* flight : {"--mast 90 --speed 100 --hold power_kw=520", "--speed 29 --hold power_kw=772"}) {
    const auto run = run_tiltrotor(std::string("trim --format csv --free speed_mps ") + flight);
    if (!CHECK_EQ(run.exit_status, 0)) NOTE(flight << ": " << run.err);
  }
  const auto run = run_tiltrotor("trim --format csv --speed 29 --hold power_kw=700 --free speed_mps");
  CHECK_EQ(run.exit_status, 1);
  double least = HUGE_VAL;
  const CsvText around = trims("--speed 29:0.02:30");
  for (std::size_t i = 0; i < around.rows.size(); ++i) least = std::min(least, around.number(i, "power_kw"));
  const std::string words = "nearest ";
  const std::size_t at = run.err.find(words);
  if (!CHECK(at != std::string::npos)) return;
  CHECK_NEAR(std::strtod(run.err.c_str() + at + words.size(), nullptr), least, 1e-2);
  CHECK(run.err.find("m/s by ") != std::string::npos && run.err.find(" trims\n") != std::string::npos);
}

// Steeper than -40 deg the stick is beyond its stop at every one of these powers.
TEST_OF_XV15(cli_trim_prefers_what_can_be_flown) {
  const auto run = run_tiltrotor("trim --format csv --speed 40 --hold power_kw=72,100 --free climb_deg");
  CHECK_EQ(run.exit_status, 0);
  const CsvText held(run.out);
  const CsvText flat = trims("--speed 40 --climb=-27,-25"), low = trims("--speed 40 --climb=-30");
  CHECK(low.number(0, "power_kw") < 72 && flat.number(0, "power_kw") > 100 - 1);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK_EQ(held.text(i, "status"), std::string("ok"));
    CHECK(held.number(i, "climb_deg") > -30 && held.number(i, "climb_deg") < -25);
    CHECK_NEAR(trims("--speed 40 --climb=" + held.text(i, "climb_deg")).number(0, "power_kw"),
               i == 0 ? 72 : 100, 1e-6);
  }
  // Where none can be flown, the nearest all the same.
  const CsvText stopped = trims("--speed 40 --hold power_kw=50 --free climb_deg");
  CHECK_EQ(stopped.text(0, "status"), std::string("control_limit"));
  CHECK_NEAR(stopped.number(0, "power_kw"), 50, 1e-6);
}

// Outputs by the names of --columns, in SI.
TEST_OF_XV15(cli_trim_holds_outputs_by_name) {
  struct Case {
    const char *name, *value, *flight, *freed, *option;
  };
  const Case cases[] = {{"power_right", "400000", "--speed 40", "climb_deg", "--climb"},
                        {"climb_rate", "2", "--speed 40", "climb_deg", "--climb"},
                        {"nz@230/0/75", "1.05", "--speed 40", "turn_rate_degps", "--turn-rate"},
                        {"htail_force_z", "500", "--mast 90 --speed 90", "cg_sl_in", "--cg-sl"}};
  for (const Case& one : cases) {
    const std::string flight = one.flight, columns = std::string(" --columns ") + one.freed + "," + one.name;
    const auto run = run_tiltrotor("trim --format csv " + flight + " --hold " + one.name + "=" + one.value +
                                   " --free " + one.freed + columns);
    const CsvText held(run.out);
    if (!CHECK_EQ(run.exit_status, 0)) NOTE(one.name << ": " << run.err);
    const CsvText plain = trims(flight + " " + one.option + "=" + held.text(0, one.freed) + columns);
    const double value = std::strtod(one.value, nullptr);
    CHECK_NEAR(plain.number(0, one.name), value, 1e-6 * std::max(1.0, value));
  }
  const auto unknown = run_tiltrotor("trim --hold airsped=3 --free speed_mps");
  CHECK_EQ(unknown.exit_status, 2);
  CHECK(unknown.err.find("did you mean airspeed?") != std::string::npos);
}

// Every line of "Any trim" on the page is run; what it says behind "->" comes out.
TEST_OF_XV15(cli_trim_examples_of_the_page) {
  std::ifstream page(check::source_path("src/cli/README.md"));
  std::string line;
  while (std::getline(page, line) && line != "## Any trim") continue;
  int count = 0, figures = 0;
  while (std::getline(page, line) && line.compare(0, 3, "## ") != 0) {
    if (line.compare(0, 6, "    --") != 0) continue;
    ++count;
    const std::size_t comment = line.find('#');
    const std::string options = line.substr(0, comment);
    const auto run = run_tiltrotor("trim --format csv " + options);
    const CsvText rows(run.out);
    const bool beyond = line.find("`power_limit`") != std::string::npos;
    const bool passed =
        run.exit_status == (beyond ? 1 : 0) && rows.text(0, "status") == (beyond ? "power_limit" : "ok");
    if (!CHECK(passed)) NOTE(line << ": exit " << run.exit_status << ", " << run.err);
    const std::size_t arrow = line.find("-> ", comment), free = options.find("--free ");
    if (arrow == std::string::npos || !CHECK(free != std::string::npos)) continue;
    ++figures;
    const std::string freed = options.substr(free + 7, options.find(' ', free + 7) - free - 7);
    if (!CHECK_NEAR(rows.number(0, freed), std::strtod(line.c_str() + arrow + 3, nullptr), 0.0051))
      NOTE(line);
  }
  CHECK_LT(5, count);
  CHECK_LT(2, figures);
}

// What is inside moves farther than its window from one value outside to the next: flights that are there are found.
TEST_OF_XV15(cli_trim_looks_beyond_the_window_inside) {
  const std::string common = "trim --grid realtime --format csv ";
  const struct {
    const char *flight, *there, *from, *outer, *of_outer, *inner, *of_inner;
  } cases[] = {
      {"--mast 90 --speed 84.7828 --climb 1.5396 --cg-sl 297.0193 --altitude 337.6985 --rotor-rpm 586.7294 "
       "--turn-rate -2.7088 --sideslip -1.2510 ",
       "--flap 8.95 --mass 5233", "--flap 19.5634 --mass 4806.94", "roll_deg", "flap_deg", "long_stick_in",
       "mass_kg"},
      {"--mast 30 --climb 7.3733 --mass 5236.5 --altitude 545.76 --rotor-rpm 527.0867 --turn-rate -0.3153 "
       "--sideslip 0.965 --flap 14.6083 ",
       "--speed 46.86 --cg-sl 292.48", "--speed 56.0978 --cg-sl 300.6575", "thrust_right_n", "speed_mps",
       "alpha_deg", "cg_sl_in"}};
  for (const auto& it : cases) {
    const CsvText there(run_tiltrotor(common + it.flight + it.there).out);
    const CsvText found(run_tiltrotor(common + it.flight + it.from + " --hold " + it.outer + "=" +
                                      there.text(0, it.outer) + " --free " + it.of_outer + " --hold " +
                                      it.inner + "=" + there.text(0, it.inner) + " --free " + it.of_inner)
                            .out);
    CHECK_EQ(found.text(0, "status"), std::string("ok"));
    for (const char* held : {it.outer, it.inner})
      CHECK_NEAR(found.number(0, held), there.number(0, held), 1e-6 * std::fabs(there.number(0, held)));
  }
}
