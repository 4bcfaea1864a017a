// Responses of an aircraft whose rotors have a governor: masts that move, matrices and modes along the way.
// Expected: the way of the masts in closed form; linear models and modes of the commands that take a trim; the law of the
// governor, power or rotor speed.
#include <cmath>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"

using check::CsvText;
using check::run_tiltrotor;

namespace {

CsvText run(const std::string& command, const std::string& governor, const std::string& arguments) {
  const check::ProgramResult result = run_tiltrotor(
      command + " --mast 60 --speed 60 --grid realtime --format csv --option governor=" + governor + " " +
      arguments);
  if (!CHECK_EQ(result.exit_status, 0)) NOTE(result.err);
  return CsvText(result.out);
}

}  // namespace

TEST(cli_respond_with_a_governor_moves_the_masts) {
  const std::string moves = "--duration 0.6 --dt 0.02 --input mast=3deg@0.1..0.5";
  for (const char* governor : {"ideal", "pi"}) {
    const CsvText flight = run("respond", governor, moves + " --input collective=1deg@0.2");
    if (!CHECK_EQ(flight.rows.size(), 31u)) continue;
    const bool is_ideal = governor == std::string("ideal");
    double slowest = 1e9;
    for (std::size_t row = 0; row < flight.rows.size(); ++row) {
      const double t = flight.number(row, "time_s");
      CHECK_NEAR(flight.number(row, "mast_deg"), 60 + 7.5 * std::fmin(std::fmax(t - 0.1, 0), 0.4), 1e-9);
      slowest = std::fmin(slowest, flight.number(row, "rotor_rpm"));
      if (is_ideal) CHECK_NEAR(flight.number(row, "rotor_rpm"), flight.number(0, "rotor_rpm"), 1e-9);
    }
    // More pitch slows rotors at equal power; an ideal governor takes it back at once.
    if (is_ideal) {
      const double before = flight.number(9, "collective75_deg"),
                   after = flight.number(10, "collective75_deg");
      CHECK_NEAR(after, before, 0.05);
      CHECK_NEAR(flight.number(10, "governor_deg") - flight.number(9, "governor_deg"), -1, 0.05);
    } else {
      CHECK_LT(slowest, flight.number(0, "rotor_rpm") - 3);
    }
  }
}

// At its beginning a flight is the trim, whose linear model and modes other commands give.
TEST(cli_respond_with_a_governor_writes_matrices_and_modes) {
  for (const char* governor : {"ideal", "pi"}) {
    const check::ScratchFolder folder;
    const CsvText flight =
        run("respond", governor,
            "--duration 0.04 --dt 0.02 --modes-every 0.04 --matrices " + check::quoted(folder.path("m")));
    const CsvText a(folder.read("m/a.csv")), b(folder.read("m/b.csv")), trim = run("linearize", governor, "");
    std::size_t states = 0;
    while (states < a.rows.size() && a.number(states, "time_s") == 0) ++states;
    CHECK_EQ(a.rows.size(), 3 * states);
    CHECK_EQ(b.rows.size(), 3 * states);
    CHECK_EQ(a.columns.size(), states + 2);
    std::size_t compared = 0;
    for (std::size_t k = 0; k < trim.rows.size(); ++k) {
      const bool is_a = trim.text(k, "matrix") == "A";
      if (!is_a && trim.text(k, "matrix") != "B") continue;
      const CsvText& of = is_a ? a : b;
      for (std::size_t i = 0; i < states; ++i) {
        if (of.text(i, "row") != trim.text(k, "row")) continue;
        const double expected = trim.number(k, "value");
        CHECK_NEAR(of.number(i, trim.text(k, "column").c_str()), expected, 1e-7 * (1 + std::fabs(expected)));
        ++compared;
      }
    }
    CHECK_LE(states * states, compared);
    const CsvText modes = run("modes", governor, "");
    int found = 0;
    for (int shown = 1; shown <= 9; ++shown) {
      const std::string name = "mode" + std::to_string(shown);
      for (std::size_t k = 0; k < modes.rows.size(); ++k) {
        if (flight.text(0, name.c_str()).empty() || flight.text(0, name.c_str()) != modes.text(k, "mode"))
          continue;
        const double real = modes.number(k, "real");
        CHECK_NEAR(flight.number(0, (name + "_real").c_str()), real, 1e-6 * (1 + std::fabs(real)));
        ++found;
      }
      CHECK(flight.text(1, name.c_str()).empty());
    }
    CHECK_LE(6, found);
    CHECK(!flight.text(2, "mode1").empty());
  }
}
