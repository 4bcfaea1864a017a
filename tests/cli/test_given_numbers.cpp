// What the user gave is printed with the digits he gave, whatever the format, and numbers too small for their
// square are no trap.
// Expected: the numbers of the command line; the same flight at speed 0.
#include <cmath>
#include <cstdlib>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"

using check::CsvText;
using check::run_tiltrotor;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

struct Given {
  const char* option;
  const char* column;
  std::string number;
};

// The double next to that of the XV-15, above or below, for this aircraft.
std::string next_to(const char* option, double written, double towards) {
  return this_aircraft::shortest(std::nextafter(this_aircraft::given(option, written), towards));
}

// Each alone with the command: the column repeats it, in CSV and in JSON.
void check_repeated(const std::string& command, const std::vector<Given>& given) {
  for (const Given& one : given) {
    const std::string line = command + " " + one.option + " " + one.number;
    const CsvText csv(run_tiltrotor(line + " --format csv").out);
    if (!CHECK(!csv.rows.empty())) {
      NOTE(line);
      continue;
    }
    if (!CHECK_EQ(csv.text(0, one.column), one.number)) NOTE(line);
    const std::string json = run_tiltrotor(line + " --format json").out;
    if (!CHECK(contains(json, std::string("\"") + one.column + "\": " + one.number + ","))) NOTE(line);
    CHECK(contains(run_tiltrotor(line + " --format table").out, one.number));
  }
}

// Digits beyond those of a double's conversion to SI and back; the least numbers there are.
const std::vector<Given> settings = {{"--altitude", "altitude_m", "1234.5678901234567"},
                                     {"--altitude", "altitude_m", "1e-320"},
                                     {"--mass", "mass_kg", next_to("--mass", 6000, 0)},
                                     {"--cg-sl", "cg_sl_in", next_to("--cg-sl", 300, 0)},
                                     {"--flap", "flap_deg", "19.999999999999996"}};
const std::vector<Given> flight = {{"--mast", "mast_deg", "0.30000000000000004"},
                                   {"--mast", "mast_deg", "1e-320"},
                                   {"--speed", "speed_mps", "39.99999999999999"},
                                   {"--speed", "speed_mps", "1e-320"}};

}  // namespace

TEST(cli_numbers_given_are_printed_as_given) {
  check_repeated("trim --speed 40", {{"--climb", "climb_deg", "5.000000000000001"},
                                     {"--climb", "climb_deg", "1e-320"},
                                     {"--sideslip", "sideslip_deg", "5.999999999999999"},
                                     {"--sideslip", "sideslip_deg", "-1e-320"},
                                     {"--turn-rate", "turn_rate_degps", "2.9999999999999996"},
                                     {"--turn-rate", "turn_rate_degps", "1e-320"},
                                     {"--rotor-rpm", "rotor_rpm", next_to("--rotor-rpm", 589, 1e3)}});
  check_repeated("trim --speed 5",
                 {{"--climb", "climb_deg", "90"}, {"--climb", "climb_deg", "-89.99999999999999"}});
  for (const char* command : {"trim", "modes"}) {
    check_repeated(command, flight);
    check_repeated(std::string(command) + " --speed 40", settings);
  }
  const std::string respond = "respond --speed 40 --duration 0.01";
  check_repeated(respond, settings);
  check_repeated(respond,
                 {{"--rotor-rpm", "rotor_rpm", next_to("--rotor-rpm", 589, 1e3)}, flight[0], flight[1]});
  check_repeated("loads --speed 40", {flight[0], flight[1]});
  check_repeated("linearize --speed 40", {flight[0], flight[1]});
  check_repeated("linearize", {flight[2], flight[3]});
  check_repeated("rotor --collective75 8",
                 {{"--speed-axial", "speed_axial_mps", "1e-320"},
                  {"--speed-inplane", "speed_inplane_mps", "-9.999999999999999e-10"},
                  {"--rpm", "rotor_rpm", next_to("--rpm", 589, 1e3)},
                  {"--lateral-cyclic", "lateral_cyclic_deg", "1e-320"},
                  {"--long-cyclic", "long_cyclic_deg", "1.0000000000000002"}});
  check_repeated("rotor", {{"--collective75", "collective75_deg", "7.999999999999999"}});
}

// Slower than 1e-15 m/s is rest: no climb, no sideslip, and the numbers of speed 0.
TEST(cli_numbers_slower_than_rest_are_rest) {
  for (const char* speed : {"1e-320", "1e-170", "1e-154", "9e-16"}) {
    for (const std::string path : {"--climb 90", "--climb -90", "--climb 3", "--sideslip 5"}) {
      const std::string flight = path + " --speed " + speed;
      for (const std::string command : {"trim ", "modes ", "linearize "}) {
        const check::ProgramResult refused = run_tiltrotor(command + flight);
        if (!CHECK(refused.exit_status == 2 && refused.out.empty())) NOTE(command + flight);
        CHECK(contains(refused.err, "speed 0 (below 1e-15 m/s)"));
      }
      const check::ProgramResult among = run_tiltrotor("trim --format csv " + flight + ",2");
      CHECK(among.exit_status == 1 && contains(among.out, ",out_of_range,"));
      const check::ProgramResult respond = run_tiltrotor("respond " + flight);
      CHECK(respond.exit_status == 2 && contains(respond.err, "(below 1e-15 m/s)"));
    }
    const auto without_speed = [](std::string text, const std::string& number) {
      for (std::size_t at; (at = text.find(number)) != std::string::npos;)
        text.replace(at, number.size(), "0");
      return text;
    };
    const bool is_nothing = std::strtod(speed, nullptr) < 1e-100;  // beside any other number
    for (const std::string command : {"trim", "modes", "linearize", "loads", "respond --duration 0.01"})
      if (is_nothing &&
          !CHECK(without_speed(run_tiltrotor(command + " --speed " + speed + " --format csv").out, speed) ==
                 run_tiltrotor(command + " --format csv").out))
        NOTE(command << " at " << speed);
    for (const std::string option : {" --speed-axial ", " --speed-inplane "}) {
      const CsvText slow(run_tiltrotor("rotor --collective75 8" + option + speed).out);
      const CsvText rest(run_tiltrotor("rotor --collective75 8").out);
      CHECK_EQ(slow.text(0, "figure_of_merit"), rest.text(0, "figure_of_merit"));
      CHECK_EQ(slow.text(0, "efficiency"), std::string());
    }
  }
  // A little faster the path has its direction.
  const CsvText climb(run_tiltrotor("trim --climb 90 --speed 1e-14 --format csv").out);
  CHECK_NEAR(climb.number(0, "sideslip_deg"), 0, 1e-3);
}

// Heading is an integral: what is left of the yaw rate's rounding, seconds long, is no heading.
TEST(cli_numbers_of_a_long_symmetric_flight_have_no_rounding) {
  const CsvText flight(run_tiltrotor("respond --speed 40 --duration 120 --dt 0.02 --grid realtime --option "
                                     "position_states=on --format csv")
                           .out);
  if (!CHECK_EQ(flight.rows.size(), 6001u)) return;
  for (const char* column : {"v_mps", "p_degps", "r_degps", "roll_deg", "yaw_deg", "east_m"})
    for (std::size_t row = 0; row < flight.rows.size(); row += 100)
      if (!CHECK_EQ(flight.text(row, column), std::string("0"))) NOTE(column << " at row " << row);
}
