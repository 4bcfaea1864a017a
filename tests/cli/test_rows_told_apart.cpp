// A condition of which several values are asked for stands in the rows; flights that cannot be are refused. Expected:
// the values of the command line, and for the rows those of each value alone.
#include <algorithm>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/refused.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"

using check::check_refused;
using check::CsvText;
using check::run_tiltrotor;

namespace {

struct List {
  const char *option, *column;
  const char* value[2];
};
constexpr List lists[] = {
    {"--climb", "climb_deg", {"-5", "5"}},         {"--sideslip", "sideslip_deg", {"0", "4"}},
    {"--azimuth", "azimuth_deg", {"0", "5"}},      {"--turn-rate", "turn_rate_degps", {"0", "3"}},
    {"--isa-offset", "isa_offset_k", {"0", "10"}}, {"--rotor-rpm", "rotor_rpm", {"500", "520"}},
    {"--bank", "roll_deg", {"5", "10"}},           {"--free climb_deg --hold", "power_kw", {"800", "900"}}};

// Rows of the first value, then those of the second, which are those of each alone with the column behind them.
void check_list(const std::string& command, const List& list) {
  const std::string equals = list.column == std::string("power_kw") ? " power_kw=" : "=";
  const std::string begin = command + " --format csv " + list.option + equals;
  const auto both = run_tiltrotor(begin + list.value[0] + "," + list.value[1]);
  const CsvText rows(both.out);
  const bool there = std::count(rows.columns.begin(), rows.columns.end(), std::string(list.column)) == 1 &&
                     !rows.rows.empty();
  if (!CHECK(there)) {
    NOTE(command << " " << list.option << ": " << both.err);
    return;
  }
  std::size_t row = 0;
  for (const char* value : list.value) {
    const CsvText alone(run_tiltrotor(begin + value).out);
    CHECK(alone.columns.size() == rows.columns.size() || alone.columns.size() + 1 == rows.columns.size());
    for (std::size_t i = 0; i < alone.rows.size() && row < rows.rows.size(); ++i, ++row) {
      if (!CHECK_NEAR(rows.number(row, list.column), std::stod(value), 1e-7))
        NOTE(command << " " << list.option);
      const std::string& first = alone.columns.at(alone.columns.size() / 2);
      CHECK_EQ(rows.text(row, first), alone.text(i, first));
    }
  }
  CHECK_EQ(row, rows.rows.size());
}

}  // namespace

TEST(cli_trim_rows_tell_every_list_apart) {
  for (const List& list : lists) check_list("trim --grid realtime --mast 90 --speed 90", list);
}

TEST(cli_modes_rows_tell_every_list_apart) {
  for (const List& list : lists) {
    const std::string flight = " --grid realtime --mast 90 --speed 90";
    check_list("modes" + flight, list);
    check_list("bode --show margins --from elevator --to theta" + flight, list);
    check_list("sensitivity --mode dutch_roll --to fin_area,mass" + flight, list);
    check_list("modes --show shapes" + flight, list);
    const std::string equals = list.column == std::string("power_kw") ? " power_kw=" : "=";
    const std::string levels = run_tiltrotor("qualities --format json" + flight + " " + list.option + equals +
                                             list.value[0] + "," + list.value[1])
                                   .out;
    for (const char* value : list.value)
      CHECK(levels.find(std::string("\"") + list.column + "\": " + value + ",") != std::string::npos);
  }
  const std::string json =
      run_tiltrotor("modes --format json --grid realtime --mast 90 --speed 90 --isa-offset 0,10").out;
  CHECK(json.find("\"isa_offset_k\": 10") != std::string::npos);
}

TEST(cli_linearize_rows_tell_lists_apart) {
  for (const List& list : {lists[0], lists[2], lists[6]}) {
    const std::string flight = " --grid realtime --mast 90 --speed 90";
    check_list("linearize --reduce rigid" + flight, list);
    check_list("loads" + flight, list);
  }
  const std::string two = "linearize --grid realtime --mast 90 --speed 90 --azimuth 0,5 --format ";
  CHECK(run_tiltrotor(two + "json").out.find("\"azimuth_deg\": 5") != std::string::npos);
  CHECK(run_tiltrotor(two + "table").out.find("case 1: mast 90 deg, 90 m/s, azimuth_deg 5: ok") !=
        std::string::npos);
}

// The file of a sweep is one of states all the same.
TEST(cli_trim_rows_of_lists_are_states) {
  const check::ScratchFolder folder;
  const std::string file = folder.path("trims.csv");
  for (const char* list :
       {"--azimuth 0,90", "--isa-offset 0,0.5", "--hold htail_force_z=0,20 --free climb_deg",
        "--hold nz@230/0/75=1.01,1.02 --free turn_rate_degps", "--hold theta=0.01,0.015 --free speed_mps"}) {
    (void)run_tiltrotor(std::string("trim --format csv --grid realtime --speed 5 --output ") + file + " " +
                        list);
    const auto run = run_tiltrotor("derivative --grid realtime --states " + file);
    if (!CHECK_EQ(run.exit_status, 0)) NOTE(list << run.err);
  }
}

TEST(cli_trim_refuses_a_flight_that_cannot_be) {
  const std::string climb = "0 at speed 0 (below 1e-15 m/s)", wind = "no azimuth in vertical flight";
  for (const std::string command : {"trim", "modes", "loads", "linearize", "respond", "sensitivity"}) {
    check_refused(command + " --speed 0 --climb 10",
                  "--climb: climb angle must be within 90 deg, and " + climb);
    check_refused(command + " --speed 0 --sideslip 5",
                  "--sideslip: sideslip must be within 60 deg, and " + climb);
    for (const char* azimuth : {"0", "90"})
      check_refused(command + " --speed 5 --climb 90 --azimuth " + azimuth,
                    "--azimuth: the wind has " + wind);
  }
  // Among others it is a row.
  for (const std::string flight : {"--speed 0,5 --climb 10", "--speed 5 --climb 80,90 --azimuth 90"}) {
    const auto run = run_tiltrotor("trim --format csv --grid realtime " + flight);
    CHECK_EQ(run.exit_status, 1);
    const CsvText rows(run.out);
    if (!CHECK_EQ(rows.rows.size(), 2u)) continue;
    const std::size_t possible = rows.text(0, "status") == "ok" ? 0 : 1;
    CHECK_EQ(rows.text(possible, "status"), std::string("ok"));
    CHECK_EQ(rows.text(1 - possible, "status"), std::string("out_of_range"));
  }
}

TEST(cli_sensitivity_refuses_a_mode_that_no_flight_has) {
  const std::string flight = "sensitivity --format csv --grid realtime --mast 90 --speed 90,100 --to mass ";
  check_refused(flight + "--mode dutchroll", "did you mean dutch_roll?); choose all, body, ");
  check_refused(flight + "--mode typo,typos", "no flight has a mode called 'typo'; choose ");
  const CsvText rows(run_tiltrotor(flight + "--mode dutch_roll").out);
  CHECK_EQ(rows.rows.size(), 2u);
}
