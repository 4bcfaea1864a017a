// Times of `respond`: inputs act when they were asked to, whatever the step, and the flight ends when it was
// asked to.
// Expected: runs whose steps have every edge on a boundary; the times asked for.
#include <cmath>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/refused.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"

using check::check_refused;
using check::CsvText;
using check::run_tiltrotor;

namespace {

CsvText respond(const std::string& arguments) {
  return CsvText(run_tiltrotor("respond --speed 40 --grid realtime --format csv " + arguments).out);
}

double change(const CsvText& flight, const char* column) {
  return flight.number(flight.rows.size() - 1, column) - flight.number(0, column);
}

}  // namespace

// Pulses of the same impulse anywhere in a step; the reference has the edges on its steps.
TEST(cli_respond_gives_short_inputs_their_impulse) {
  for (const char* times : {"0.1005..0.1015", "0.102..0.103", "0.0995..0.1005", "0.1005..0.1035:doublet"}) {
    const std::string input = std::string("--duration 0.3 --input collective=5deg@") + times;
    const double expected = change(respond(input + " --dt 0.0005"), "w_mps");
    CHECK_LT(1e-4, std::abs(expected));
    for (const char* step :
         {" --dt 0.005", " --dt 0.01", " --dt 0.02", " --dt 0.1", " --dt 0.1 --method rk3"})
      CHECK_REL(change(respond(input + step), "w_mps"), expected, 0.03);
  }
}

TEST(cli_respond_ends_when_it_was_asked_to) {
  const CsvText flight = respond("--duration 0.0175 --dt 0.005 --input pedal=1@0.0155");
  const double times[] = {0, 0.005, 0.01, 0.015, 0.0175};
  if (!CHECK_EQ(flight.rows.size(), 5u)) return;
  for (std::size_t i = 0; i < 5; ++i) CHECK_NEAR(flight.number(i, "time_s"), times[i], 1e-15);
  CHECK_NEAR(flight.number(3, "pedal_in"), flight.number(0, "pedal_in"), 1e-12);
  CHECK_NEAR(change(flight, "pedal_in"), 1, 1e-12);

  const CsvText shorter_than_a_step = respond("--duration 0.003 --dt 0.1 --input collective=1deg@0");
  if (CHECK_EQ(shorter_than_a_step.rows.size(), 2u)) CHECK_EQ(shorter_than_a_step.number(1, "time_s"), 0.003);
  CHECK_EQ(respond("--duration 0 --input collective=1deg@0").rows.size(), 1u);
  // Whole steps but for the rounding of decimals.
  const CsvText whole = respond("--duration 0.3 --dt 0.1");
  if (CHECK_EQ(whole.rows.size(), 4u)) CHECK_NEAR(whole.number(3, "time_s"), 0.3, 1e-15);
}

TEST(cli_respond_keeps_its_intervals_beside_a_shorter_last_step) {
  const check::ScratchFolder folder;
  const CsvText flight =
      respond("--duration 0.0175 --dt 0.005 --modes-every 0.01 --matrices " + folder.path("m"));
  if (!CHECK_EQ(flight.rows.size(), 5u)) return;
  for (std::size_t row = 0; row < 5; ++row) CHECK_EQ(flight.text(row, "mode1").empty(), row != 0 && row != 2);
  const CsvText matrices(folder.read("m/a.csv"));
  if (CHECK(!matrices.rows.empty())) CHECK_EQ(matrices.number(matrices.rows.size() - 1, "time_s"), 0.0175);
}

TEST(cli_bad_times_of_respond_are_refused) {
  check_refused("respond --modes-every 0.007",
                "--modes-every: 0.007 is no multiple of the time step; the nearest are 0.005 and 0.01 s");
  check_refused("respond --duration 1 --input pedal=1@0 --input collective=1deg@1.5",
                "--input collective=1deg@1.5: starts after the end of the flight, 1 s");
  check_refused("respond --input collective=1deg@0.5..0.5", "the end is not after the start");
  check_refused("respond --dt 0.2", "--dt: 0.2 lies outside");
}

// Steps beyond what the methods can do: the flight stays in trim.
TEST(cli_respond_is_stable_with_long_steps) {
  for (const char* method : {"rk3", "rk4", "rodas3", "exponential"}) {
    for (const char* dt : {"0.0145", "0.02", "0.1"}) {
      const CsvText flight(
          run_tiltrotor(std::string("respond --mast 90 --speed 120 --duration 1 --grid realtime "
                                    "--format csv --input gust_w=1@0..0.05 --method ") +
                        method + " --dt " + dt)
              .out);
      CHECK_EQ(flight.number(flight.rows.size() - 1, "time_s"), 1.0);
      CHECK_NEAR(change(flight, "n0_right"), 0, 1e-3);
    }
  }
}
