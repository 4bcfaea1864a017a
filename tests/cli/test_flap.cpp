// Flaps at any angle of the aircraft, as the C interface has them, and as an axis of sweeps.
#include <cmath>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"
#include "tiltrotor/tiltrotor.h"

using check::CsvText;
using check::run_tiltrotor;

// The C interface trims with the same flaps.
TEST(cli_trim_takes_any_flap) {
  static tr_sim sim;
  static tr_work work;
  const double last = this_aircraft::numbers().limits.flap_deg.high;
  for (const std::string flap : {"7.5", "30", "60", "75"}) {
    if (std::stod(flap) > last) continue;
    const CsvText trim(run_tiltrotor("trim --mast 30 --speed 50 --grid realtime --flap " + flap).out);
    tr_setup setup;
    CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), 30.0), TR_OK);
    setup.flap_deg = std::stod(flap);
    CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK);
    const tr_flight flight = {50.0, 0.0, 0.0, 0.0};
    const bool ok = tr_trim(&sim, &work, &flight, nullptr) == TR_OK;
    CHECK_EQ(ok, trim.text(0, "status") == "ok");
    tr_state state;
    CHECK_EQ(tr_get_state(&sim, &state), TR_OK);
    const double degree = std::acos(-1.0) / 180;
    CHECK_NEAR(trim.number(0, "pitch_deg"), static_cast<double>(state.x[TR_PITCH]) / degree, 1e-6);
    CHECK_EQ(trim.text(0, "flap_deg"), flap);
  }
}

TEST(cli_trim_and_modes_sweep_flaps) {
  const std::string flight = " --mast 30 --speed 60 --flap 0,20:10:40";
  const CsvText trims(run_tiltrotor("trim" + flight).out);
  if (!CHECK_EQ(trims.rows.size(), 4u)) return;
  CHECK_EQ(trims.text(2, "flap_deg"), "30");
  const double pitch[] = {trims.number(1, "pitch_deg"), trims.number(2, "pitch_deg"),
                          trims.number(3, "pitch_deg")};
  CHECK_LT(pitch[1], pitch[0]);  // more flap, less angle of attack
  CHECK_LT(pitch[2], pitch[1]);
  const CsvText modes(run_tiltrotor("modes" + flight).out);
  CHECK_EQ(modes.text(0, "flap_deg"), "0");
  CHECK_EQ(modes.text(modes.rows.size() - 1, "flap_deg"), "40");
  for (const char* command : {"linearize", "loads", "respond --duration 0.01"})
    CHECK_EQ(run_tiltrotor(std::string(command) + " --mast 30 --speed 60 --flap 30").exit_status, 0);
  const check::ProgramResult none = run_tiltrotor("trim --mast 90 --speed 20 --flap 33");
  CHECK(none.err.find("20 m/s, flaps 33 deg: ") != std::string::npos);
}
