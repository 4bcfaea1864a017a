// --columns of trim, respond and fly: own columns and outputs by the names of linear models. Expected: the same numbers
// where another command or column has them.
#include <cmath>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/exported_model.hpp"
#include "cli/scratch_folder.hpp"

using check::ExportedModel;
using check::run_tiltrotor;

namespace {

std::string all_outputs(const ExportedModel& model) {
  std::string list;
  for (const std::string& name : model.outputs) list += "," + name;
  return list;
}

}  // namespace

TEST(cli_columns_of_trim_and_respond_are_the_outputs_of_linearize) {
  const std::string flight = "--mast 60 --speed 60 --grid realtime --sideslip 3 ";
  const ExportedModel model(flight);
  CHECK_LE(20u, model.outputs.size());
  const std::string chosen = " --format csv --columns speed_mps" + all_outputs(model);
  const check::CsvText trim(run_tiltrotor("trim " + flight + chosen).out);
  const check::CsvText flown(run_tiltrotor("respond --duration 0.1 --dt 0.1 " + flight + chosen).out);
  for (const check::CsvText* const rows : {&trim, &flown}) {
    CHECK_EQ(rows->columns.size(), 1 + model.outputs.size());
    for (std::size_t k = 0; k < model.outputs.size(); ++k)
      CHECK_NEAR(rows->number(0, model.outputs[k]), model.y0[k], 1e-11 * std::fabs(model.y0[k]) + 1e-8);
  }
  CHECK_EQ(trim.columns[0], "speed_mps");
  CHECK_EQ(trim.columns[1], model.outputs[0]);
}

// Power and thrust follow a lever, and angles those that are printed in degrees.
TEST(cli_columns_of_respond_follow_the_flight) {
  const check::CsvText f(
      run_tiltrotor(
          "respond --mast 90 --speed 100 --grid realtime --duration 0.2 --dt 0.1 --input collective=1deg@0 "
          "--format csv --columns time_s,speed_mps,airspeed,power_right,collective_right,collective75_deg,"
          "climb_rate,climb_rate_mps,limits")
          .out);
  const check::CsvText at_rest(
      run_tiltrotor("trim --mast 90 --speed 100 --grid realtime --format csv --columns power_right").out);
  CHECK_LT(1.2 * at_rest.number(0, "power_right"), f.number(0, "power_right"));
  for (std::size_t row = 0; row < 3; ++row) {
    CHECK_NEAR(f.number(row, "airspeed"), f.number(row, "speed_mps"), 1e-9);
    CHECK_NEAR(f.number(row, "climb_rate"), f.number(row, "climb_rate_mps"), 1e-9);
    CHECK_NEAR(f.number(row, "collective_right"), f.number(row, "collective75_deg") * std::acos(-1.0) / 180,
               1e-9);
  }
}

// An ideal governor holds the power: its collective is in what the instruments read.
TEST_OF_XV15(cli_columns_of_a_governed_flight_see_the_governor) {
  const check::CsvText f(
      run_tiltrotor(
          "respond --mast 90 --speed 100 --grid realtime --duration 0.1 --dt 0.1 --option governor=ideal "
          "--input collective=1deg@0 --format csv --columns power_right,collective_right,collective75_deg")
          .out);
  const check::CsvText trim(run_tiltrotor("trim --mast 90 --speed 100 --grid realtime --format csv --columns "
                                          "power_right,collective75_deg")
                                .out);
  CHECK_NEAR(f.number(0, "power_right"), trim.number(0, "power_right"), 1e-5 * trim.number(0, "power_right"));
  CHECK_NEAR(f.number(0, "collective75_deg"), trim.number(0, "collective75_deg"), 1e-4);
  CHECK_NEAR(f.number(0, "collective_right"), f.number(0, "collective75_deg") * std::acos(-1.0) / 180, 1e-9);
}

TEST(cli_columns_of_fly_have_the_outputs) {
  const check::ScratchFolder folder;
  const check::CsvText f(
      run_tiltrotor(
          "fly --script " + check::quoted(folder.write("flight.txt", "0.5 end\n")) +
          " --mast 90 --speed 100 --every 0.25 --format csv --columns "
          "airspeed,airspeed_mps,power_right,power_left,rotor_power_kw,elevator,elevator_deg,specific_force_z")
          .out);
  if (!CHECK_EQ(f.rows.size(), 3u)) return;
  for (std::size_t row = 0; row < 3; ++row) {
    CHECK_NEAR(f.number(row, "airspeed"), f.number(row, "airspeed_mps"), 1e-9);
    CHECK_NEAR(f.number(row, "power_right") + f.number(row, "power_left"),
               1e3 * f.number(row, "rotor_power_kw"), 1e3);  // shafts carry what speeds the rotors up, too
    CHECK_NEAR(f.number(row, "elevator"), f.number(row, "elevator_deg") * std::acos(-1.0) / 180, 1e-9);
  }
  CHECK_NEAR(f.number(0, "specific_force_z"), -9.80665, 0.1);
}

// What is printed of outputs beside the states is passed over where these are read back.
TEST(cli_columns_of_outputs_are_read_back) {
  const check::ScratchFolder folder;
  const std::string whole = check::first_line(run_tiltrotor("trim --speed 40 --format csv").out);
  const check::ProgramResult chosen =
      run_tiltrotor("trim --speed 40 --grid realtime --format csv --columns elevator,airspeed," + whole);
  CHECK_EQ(chosen.exit_status, 0);
  const std::string states = check::quoted(folder.write("states.csv", chosen.out));
  const check::ProgramResult read = run_tiltrotor("derivative --grid realtime --states " + states);
  if (!CHECK_EQ(read.exit_status, 0)) NOTE(read.err);
}

TEST(cli_bad_columns_are_refused) {
  const check::ScratchFolder folder;
  const std::string script = check::quoted(folder.write("flight.txt", "0.1 end\n"));
  for (const std::string& command : {std::string("trim --speed 40"), std::string("respond --speed 40"),
                                     "fly --speed 40 --script " + script}) {
    const auto refused = [&](const std::string& columns, const std::string& what) {
      const check::ProgramResult r = run_tiltrotor(command + " --columns " + check::quoted(columns));
      if (!CHECK(r.exit_status == 2 && r.out.empty() && r.err.find(what) != std::string::npos))
        NOTE(command << ": " << r.err);
    };
    refused("pitch_deg,powr_right",
            ": --columns: no column 'powr_right' (did you mean power_right?); choose ");
    refused("ptch_deg", ": --columns: no column 'ptch_deg' (did you mean pitch_deg?); choose ");
    refused("airspeed,airspeed", ": --columns: airspeed stands there twice");
    refused("pitch_deg,", ": --columns: no column ''");
  }
}
