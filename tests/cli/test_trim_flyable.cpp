// What `trim` prints and says of flights straight up and down, and of the stick.
// Expected: momentum theory for the order of cases, travel of the stick (GTRS).
#include <cstdlib>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"

using check::CsvText;
using check::run_tiltrotor;
using this_aircraft::flown;

// 5 m/s straight up and down is within the limits, up with more power. Descending faster is vortex ring, a
// shallow approach is not.
TEST(cli_trim_flies_straight_up_and_down) {
  double power[2];
  for (const int up : {0, 1}) {
    const auto run =
        run_tiltrotor(flown(std::string("trim --speed 5 --grid realtime --climb ") + (up ? "90" : "-90")));
    if (!CHECK_EQ(run.exit_status, 0)) NOTE(run.err);
    const CsvText csv(run.out);
    CHECK_EQ(csv.text(0, "status"), std::string("ok"));
    CHECK_EQ(csv.number(0, "climb_deg"), up ? 90 : -90);
    power[up] = csv.number(0, "power_kw");
  }
  CHECK_LT(power[0], power[1]);
  const auto steep = run_tiltrotor(flown("trim --speed 16 --climb -90 --grid realtime"));
  CHECK_EQ(steep.exit_status, 1);
  CHECK_EQ(CsvText(steep.out).text(0, "status"), std::string("vortex_ring"));
  CHECK(steep.err.find("is beyond vortex ring from 0.45 v_h") != std::string::npos);
  const auto shallow = run_tiltrotor(flown("trim --speed 40 --climb -6 --grid realtime"));
  CHECK_EQ(CsvText(shallow.out).text(0, "status"), std::string("ok"));
}

// In the sentence as in the column: from the rear stop, 0, to the front stop, 9.6.
TEST(cli_trim_counts_the_stick_like_its_column) {
  const char* flights[] = {"--mast 0 --speed 45 --climb -60", "--mast 60 --speed 20 --climb 45"};
  for (const char* flight : flights) {
    const auto run = run_tiltrotor(flown(std::string("trim --grid realtime ") + flight));
    const CsvText csv(run.out);
    CHECK_EQ(csv.text(0, "status"), std::string("control_limit"));
    const std::string name = "longitudinal stick ";
    const std::size_t at = run.err.find(name);
    if (!CHECK(at != std::string::npos)) continue;
    CHECK_NEAR(std::strtod(run.err.c_str() + at + name.size(), nullptr), csv.number(0, "long_stick_in"),
               0.0051);
    CHECK(run.err.find("is beyond 0.00 in") != std::string::npos);
  }
}
