// One number for one quantity: messages, columns and echoes agree, and zero is printed as zero.
// Expected: what was given, decimals counted by hand, the load factor of the flight path in closed form.
#include <cmath>
#include <regex>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/sweep.hpp"
#include "run_program.hpp"
#include "text/number.hpp"
#include "this_aircraft.hpp"
#include "tiltrotor/math/scalar.hpp"

using check::CsvText;
using check::run_tiltrotor;

// The message about the stick and the column beside it count from the same zero, and so do the stops.
TEST(cli_columns_and_messages_count_the_stick_alike) {
  const std::regex stick("longitudinal stick (\\S+) in is beyond (\\S+) in");
  int found = 0;
  for (const char* flight :
       {"--mast 0 --speed 5:5:50 --climb -20", "--mast 0,10,20 --speed 0:10:50 --cg-sl 280",
        "--mast 0:10:40 --speed 30 --cg-sl 312"}) {
    const check::ProgramResult result =
        run_tiltrotor(this_aircraft::flown(std::string("trim --format csv ") + flight));
    const CsvText trims(result.out);
    std::size_t row = 0;
    std::smatch match;
    std::istringstream messages(result.err);
    for (std::string line; std::getline(messages, line);) {
      if (!std::regex_search(line, match, stick)) continue;
      while (row < trims.rows.size() && trims.text(row, "status") != "control_limit") ++row;
      while (row < trims.rows.size() &&
             std::abs(std::stod(match[1]) - trims.number(row, "long_stick_in")) > 0.0051)
        do ++row;
        while (row < trims.rows.size() && trims.text(row, "status") != "control_limit");
      if (!CHECK_LT(row, trims.rows.size())) NOTE(line);
      CHECK(match[2] == "0.00" || match[2] == "9.60");
      ++found;
    }
  }
  CHECK_LT(0, found);
}

// What was given stands in the output as it was given, also in JSON with all its digits.
TEST(cli_columns_echo_what_was_given) {
  const struct {
    const char *option, *column;
    double number;
  } flight[] = {{"--speed", "speed_mps", 50.1},      {"--climb", "climb_deg", 5.7},
                {"--sideslip", "sideslip_deg", 7.3}, {"--turn-rate", "turn_rate_degps", 3.3},
                {"--cg-sl", "cg_sl_in", 300.7},      {"--rotor-rpm", "rotor_rpm", 561.1},
                {"--mass", "mass_kg", 5999.9},       {"--altitude", "altitude_m", 333.3}},
    rotor[] = {{"--collective75", "collective75_deg", 7.3},
               {"--rpm", "rotor_rpm", 561.1},
               {"--lateral-cyclic", "lateral_cyclic_deg", 0.7},
               {"--long-cyclic", "long_cyclic_deg", 2.3}};
  const auto check_echoes = [](const std::string& command, const auto& given) {
    std::string line = command;
    const auto text = [](const auto& one) {
      return this_aircraft::shortest(this_aircraft::given(one.option, one.number));
    };
    for (const auto& one : given) line += std::string(" ") + one.option + " " + text(one);
    const std::string out = run_tiltrotor(line + " --format json").out;
    for (const auto& one : given)
      if (!CHECK(out.find(std::string("\"") + one.column + "\": " + text(one) + ",") != std::string::npos))
        NOTE(line << ": " << one.column);
  };
  check_echoes("trim --mast 60", flight);
  check_echoes("rotor", rotor);
  const std::string station = this_aircraft::shortest(this_aircraft::given("--cg-sl", 300.7));
  CHECK(run_tiltrotor("modes --speed 40 --cg-sl " + station + " --format json")
            .out.find("\"cg_sl_in\": " + station + ",") != std::string::npos);
}

// A range holds the numbers that a list of the same decimals holds.
TEST(cli_numbers_of_a_range_are_those_of_a_list) {
  using tiltrotor::cli::parse_sweep;
  const tiltrotor::cli::Range all{-1000, 1000, ""};
  const struct {
    const char *range, *list;
  } pairs[] = {{"0:0.1:0.8", "0,0.1,0.2,0.3,0.4,0.5,0.6,0.7,0.8"},
               {"-0.3:0.1:0.3", "-0.3,-0.2,-0.1,0,0.1,0.2,0.3"},
               {"149.7:0.1:150", "149.7,149.8,149.9,150"},
               {"1:-0.25:0", "1,0.75,0.5,0.25,0"},
               {"0:5:20", "0,5,10,15,20"},
               {"0.05:1.1:3", "0.05,1.15,2.25"}};
  for (const auto& pair : pairs)
    if (!CHECK(parse_sweep(pair.range, "", all) == parse_sweep(pair.list, "", all))) NOTE(pair.range);
  CHECK_NEAR(parse_sweep("0:1e-1:1", "", all)[3], 0.3, 1e-15);
  CHECK(run_tiltrotor("linearize --mast 90 --speed 80.1:0.1:80.4 --reduce rigid").out.find(",80.3,ok,") !=
        std::string::npos);
}

// Every number of up to four decimals within 150 comes back from radians, inches and revolutions per minute.
TEST(cli_numbers_survive_their_unit) {
  const double degree = tiltrotor::kRadPerDeg<double>;
  for (const double unit : {degree, 0.0254, tiltrotor::kPi<double> / 30}) {
    int changed = 0;
    for (int i = -1500000; i <= 1500000; i += 7) {
      const double given = i / 10000.0;
      if (tiltrotor::cli::given_as(given * unit, unit) != given) ++changed;
    }
    CHECK_EQ(changed, 0);
  }
  // A number that no short text stands for keeps all its bits.
  const double computed = 1.0 / 3;
  CHECK_NEAR(tiltrotor::cli::given_as(computed, degree), computed / degree, 1e-14);
}

// In symmetric flight the lateral columns are zero, not the rounding of a sum.
TEST(cli_columns_print_zero_as_zero) {
  const std::regex tiny("-?[0-9.]+e-(1[3-9]|[2-9][0-9])");
  for (const char* command : {"trim --mast 0,30 --speed 0,40", "respond --speed 40 --duration 0.1",
                              "rotor --collective75 4,8", "modes --mast 30 --speed 60"}) {
    const CsvText csv(run_tiltrotor(std::string(command) + " --format csv").out);
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
      for (const std::string& column : csv.columns) {
        const std::string& cell = csv.text(row, column);
        if (!CHECK(column == "residual" || !std::regex_match(cell, tiny)))
          NOTE(command << " " << column << " " << cell);
      }
    }
  }
  const std::string json = run_tiltrotor("trim --mast 0,30 --speed 0,40 --format json").out;
  CHECK(!std::regex_search(json, std::regex("(_deg|_in|_mps|_degps)\": -?[0-9.]+e-1[3-9]")));
  const CsvText trim(run_tiltrotor("trim --mast 0,30,90 --speed 80,90 --format csv").out);
  for (std::size_t row = 0; row < trim.rows.size(); ++row) {
    if (trim.text(row, "status") != "ok") continue;
    for (const char* column : {"roll_deg", "lat_stick_in", "pedal_in", "aileron_deg", "rudder_deg", "v_mps"})
      CHECK_EQ(trim.text(row, column), std::string("0"));
    CHECK_LT(0.0, trim.number(row, "residual"));
  }
}

// Normal to the flight path: one in level flight at any pitch angle, cos(climb) in a straight climb, and in a
// level turn without sideslip the root of 1 + (V turn rate / g)^2.
TEST(cli_trim_load_factor_is_that_of_the_flight_path) {
  const CsvText level(run_tiltrotor("trim --mast 0,30 --speed 0,20,40 --format csv").out);
  for (std::size_t row = 0; row < level.rows.size(); ++row)
    CHECK_NEAR(level.number(row, "load_factor"), 1, 1e-9);
  const double degree = std::acos(-1.0) / 180;
  const CsvText climb(run_tiltrotor("trim --mast 60 --speed 60 --climb 10 --format csv").out);
  CHECK_NEAR(climb.number(0, "load_factor"), std::cos(10 * degree), 1e-9);
  const CsvText turn(run_tiltrotor("trim --mast 90 --speed 90 --turn-rate 8 --format csv").out);
  const double lateral = 90 * 8 * degree / 9.80665;
  CHECK_NEAR(turn.number(0, "load_factor"), std::sqrt(1 + lateral * lateral), 1e-9);
}
