// Numbers given and columns printed in other units. Expected: the same flights in the program's own units, converted by
// the definitions of the units (1 kt = 0.514 444 4 m/s as in the model).
#include <cmath>
#include <string>
#include <vector>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"

using check::run_tiltrotor;

namespace {

constexpr double kKnot = 0.5144444, kFoot = 0.3048, kPound = 0.45359237, kPoundForce = 4.4482216152605;
constexpr double kHorsepower = 0.74569987158227;  // kW

struct ColumnPair {
  const char *own, *shown;
  double size;
};

check::CsvText csv_of(const std::string& command) {
  return check::CsvText(run_tiltrotor(command + " --grid realtime --format csv").out);
}

void check_columns(const std::string& command, const std::string& units,
                   const std::vector<ColumnPair>& pairs) {
  const check::CsvText own = csv_of(command), shown = csv_of(command + " --units " + units);
  CHECK_EQ(own.columns.size(), shown.columns.size());
  CHECK_EQ(own.rows.size(), shown.rows.size());
  CHECK_LE(std::size_t{1}, own.rows.size());
  for (const ColumnPair& pair : pairs)
    for (std::size_t row = 0; row < own.rows.size(); ++row) {
      if (own.text(row, pair.own).empty()) {
        CHECK_EQ(shown.text(row, pair.shown), "");
        continue;
      }
      const double expected = own.number(row, pair.own) / pair.size;
      CHECK_NEAR(shown.number(row, pair.shown), expected, 1e-10 * std::fabs(expected) + 1e-11);
    }
}

}  // namespace

TEST(cli_units_of_columns_stand_in_their_names) {
  const std::string all = "knots,feet,pounds,horsepower";
  check_columns("trim --mast 60 --speed 60m/s --altitude 1000m", all,
                {{"speed_mps", "speed_kt", kKnot},
                 {"altitude_m", "altitude_ft", kFoot},
                 {"mass_kg", "mass_lb", kPound},
                 {"thrust_left_n", "thrust_left_lbf", kPoundForce},
                 {"power_kw", "power_hp", kHorsepower},
                 {"w_mps", "w_kt", kKnot},
                 {"pitch_deg", "pitch_deg", 1},
                 {"cg_sl_in", "cg_sl_in", 1}});
  check_columns("modes --mast 90 --speed 100m/s", "kt,ft",
                {{"speed_mps", "speed_kt", kKnot}, {"real", "real", 1}});
  check_columns("respond --mast 90 --speed 90m/s --duration 0.1 --dt 0.05 --input gust_w=2@0", "feet,knots",
                {{"climb_rate_mps", "climb_rate_kt", kKnot}, {"altitude_m", "altitude_ft", kFoot}});
  check_columns("sensitivity --mast 90 --speed 100m/s --of trim --to mass", all,
                {{"speed_mps", "speed_kt", kKnot}, {"d_power_kw", "d_power_hp", kHorsepower}});
  check_columns("loads --mast 30 --speed 60", "pounds", {{"x_n", "x_lbf", kPoundForce}, {"m_nm", "m_nm", 1}});
}

TEST(cli_units_of_a_flight_by_script) {
  const check::ScratchFolder folder;
  folder.write("script.txt", "0 hold speed 45\n0.2 end\n");
  check_columns("fly --script " + folder.path("script.txt") + " --speed 40m/s",
                "knots,feet,pounds,horsepower",
                {{"airspeed_mps", "airspeed_kt", kKnot},
                 {"height_m", "height_ft", kFoot},
                 {"fuel_burnt_kg", "fuel_burnt_lb", kPound},
                 {"power_1_kw", "power_1_hp", kHorsepower}});
}

// The number that was given comes back as it was given.
TEST(cli_units_of_options_are_those_chosen_or_written) {
  const std::string flight = "trim --mast 60 --columns speed_mps,altitude_m,mass_kg,pitch_deg,long_stick_in ";
  const check::CsvText own = csv_of(flight + "--speed 51.44444,56.588884 --altitude 914.4 --mass 5896.70081");
  const std::string imperial = "--altitude 3000ft --mass 13000lb ";
  for (const std::string& given :
       {"--speed 100kt,110kt " + imperial, "--speed 100:10:110kt " + imperial,
        std::string("--speed 100kt,56.588884m/s --altitude 914.4m --mass 5896.70081kg"),
        std::string("--speed '100 kt,110kt' --altitude 3000ft --mass 13000lb")}) {
    const check::CsvText rows = csv_of(flight + given);
    CHECK_EQ(rows.rows.size(), 2u);
    for (std::size_t row = 0; row < 2 && rows.rows.size() == 2; ++row)
      for (const std::string& column : own.columns)
        CHECK_NEAR(rows.number(row, column), own.number(row, column),
                   1e-8 * std::fabs(own.number(row, column)));
  }
  const check::CsvText shown = csv_of(
      "trim --mast 60 --units knots,feet,pounds --speed 100,110 --altitude 3000 "
      "--mass 13000 --columns speed_mps,altitude_m,mass_lb,pitch_deg");
  CHECK_EQ(shown.columns[0], "speed_kt");
  CHECK_EQ(shown.text(1, "speed_kt"), "110");
  CHECK_EQ(shown.text(1, "altitude_ft"), "3000");
  CHECK_EQ(shown.text(1, "mass_lb"), "13000");
  CHECK_NEAR(shown.number(0, "pitch_deg"), own.number(0, "pitch_deg"), 1e-7);
}

TEST(cli_units_of_angles_and_times_and_rotor_speed_may_be_written) {
  const auto trim = [](const std::string& given) {
    return csv_of("trim --columns mast_deg,climb_deg,rotor_rpm,pitch_deg --speed 60 " + given);
  };
  const check::CsvText own = trim("--mast 45 --climb 5 --rotor-rpm 540");
  const check::CsvText written =
      trim("--mast 0.78539816339744831rad --climb 5deg --rotor-rpm 56.548667764616278rad/s");
  for (const std::string& column : own.columns)
    CHECK_NEAR(written.number(0, column), own.number(0, column), 1e-9 * std::fabs(own.number(0, column)));
  const std::string respond = "respond --mast 90 --speed 90 --columns time_s,pitch_deg ";
  CHECK_EQ(run_tiltrotor(respond + "--duration 0.1s --dt 0.05s --grid realtime").out,
           run_tiltrotor(respond + "--duration 0.1 --dt 0.05 --grid realtime").out);
}

TEST(cli_units_of_single_columns_and_of_what_is_held) {
  check_columns("trim --mast 90 --speed 100 --columns speed_kt,power_hp,altitude_ft,pitch_rad", "feet", {});
  const check::CsvText own = csv_of("trim --mast 90 --speed 100 --columns speed_mps,power_kw,pitch_deg");
  const check::CsvText chosen = csv_of("trim --mast 90 --speed 100 --columns power_hp,speed_kt,pitch_rad");
  CHECK_EQ(chosen.columns[1], "speed_kt");
  CHECK_NEAR(chosen.number(0, "speed_kt"), 100 / kKnot, 1e-9);
  CHECK_NEAR(chosen.number(0, "power_hp"), own.number(0, "power_kw") / kHorsepower, 1e-8);
  CHECK_NEAR(chosen.number(0, "pitch_rad"), own.number(0, "pitch_deg") * std::acos(-1.0) / 180, 1e-12);
  const std::string held = "trim --mast 90 --speed 100 --free climb_deg --columns climb_deg,power_kw ";
  const check::CsvText kilowatts = csv_of(held + "--hold power_kw=1044");
  const check::CsvText horsepower = csv_of(held + "--hold power_hp=1400.0270656");
  CHECK_NEAR(horsepower.number(0, "climb_deg"), kilowatts.number(0, "climb_deg"), 1e-6);
}

TEST(cli_units_of_performance_stand_beside_its_figures) {
  const std::string command = "performance --mast 90 --altitude 1000m --grid realtime --format csv";
  const check::CsvText own(run_tiltrotor(command).out),
      shown(run_tiltrotor(command + " --units knots,feet").out);
  for (std::size_t row = 0; row < own.rows.size(); ++row) {
    const std::string unit = own.text(row, "unit");
    CHECK_EQ(shown.text(row, "unit"), unit == "m/s" ? "kt" : unit == "m" ? "ft" : unit);
    if (own.text(row, "value").empty()) continue;
    const double expected = own.number(row, "value") / (unit == "m/s" ? kKnot : unit == "m" ? kFoot : 1);
    CHECK_NEAR(shown.number(row, "value"), expected, 1e-10 * std::fabs(expected));
  }
}

// What is printed in any unit is read again, and what follows from it agrees with it.
TEST(cli_units_of_columns_are_read_by_states) {
  const check::ScratchFolder folder;
  const std::string trim = "trim --mast 30 --speed 40,60 --altitude 500 --grid realtime --format csv";
  const auto rates = [&](const std::string& units, const char* name) {
    folder.write(name, run_tiltrotor(trim + units).out);
    const check::ProgramResult result =
        run_tiltrotor("derivative --grid realtime --format csv --states " + folder.path(name));
    CHECK_EQ(result.err, "");
    CHECK_EQ(result.exit_status, 0);
    return check::CsvText(result.out);
  };
  const check::CsvText own = rates("", "own.csv");
  const check::CsvText read = rates(" --units knots,feet,pounds,horsepower", "shown.csv");
  for (std::size_t row = 0; row < 2; ++row)
    for (const char* rate : {"d_u", "d_w", "d_q", "d_n0_R"})
      CHECK_NEAR(read.number(row, rate), own.number(row, rate), 1e-8);
  CHECK_EQ(read.text(1, "altitude_ft"),
           check::CsvText(run_tiltrotor(trim + " --units feet").out).text(1, "altitude_ft"));
}

TEST(cli_bad_units_are_told_with_those_that_are_there) {
  const auto refused = [](const std::string& arguments, const std::string& message) {
    const check::ProgramResult result = run_tiltrotor(arguments);
    CHECK_EQ(result.exit_status, 2);
    CHECK_EQ(result.out, "");
    CHECK_EQ(result.err, "tiltrotor: " + message + "\n");
  };
  refused(
      "trim --units knot",
      "trim: --units: 'knot' (did you mean knots?) is not one of mps, knots, metres, feet, kilograms, pounds, "
      "newtons, kilowatts or horsepower");
  refused("trim --units feet,metres",
          "trim: --units: metres and feet are units of the same quantity; choose one");
  refused("trim --climb 5kt",
          "trim: --climb: '5kt' is not a number, alone or with deg or rad; give -90..90 deg");
  refused("respond --duration 3m",
          "respond: --duration: '3m' is not a number, alone or with s; give 0..3600 s");
}

// Named apart: the ranges are those of this aircraft.
TEST_OF_XV15(cli_bad_units_tell_the_range_in_the_unit) {
  const auto complaint = [](const std::string& arguments) { return run_tiltrotor(arguments).err; };
  CHECK_EQ(complaint("trim --speed 400kt"), "tiltrotor: trim: --speed: 400 lies outside 0..291.576 kt\n");
  CHECK_EQ(complaint("trim --units knots --speed 400"),
           "tiltrotor: trim: --speed: 400 lies outside 0..291.576 kt\n");
  CHECK_EQ(
      complaint("trim --speed 40kn"),
      "tiltrotor: trim: --speed: '40kn' is not a number, alone or with m/s or kt (did you mean kt?); give "
      "0..150 m/s\n");
}
