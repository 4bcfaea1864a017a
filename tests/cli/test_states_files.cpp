// Files of states: what the program prints it reads again; the forms of CSV that spreadsheets write; the
// ranges of the C interface; and files that do not fit into memory.
// Expected: rates of zero at a trim, slopes of columns, RFC 4180, the bounds of the C header.
#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/scratch_folder.hpp"
#include "cli/states_refused.hpp"
#include "run_program.hpp"
#include "text/csv_line.hpp"
#include "text/json.hpp"
#include "this_aircraft.hpp"

using check::built;
using check::check_states_refused;
using check::CsvText;
using check::run_program;
using check::run_tiltrotor;
using check::ScratchFolder;

namespace {

const std::string reference_states = check::source_path("tests/reference/state_derivatives_c1.csv");

std::string reference_text() {
  std::ifstream in(reference_states, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

// The header and the first rows.
std::string beginning(const std::string& text, int lines) {
  std::size_t end = 0;
  for (int i = 0; i < lines; ++i) end = text.find('\n', end) + 1;
  return text.substr(0, end);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t place = 0; (place = text.find(from, place)) != std::string::npos; place += to.size())
    text.replace(place, from.size(), to);
  return text;
}

std::string cell_replaced(const std::string& text, const std::string& column, const std::string& value) {
  const CsvText csv(text);
  std::string row;
  for (std::size_t i = 0; i < csv.columns.size(); ++i)
    row += (i > 0 ? "," : "") + (csv.columns[i] == column ? value : csv.rows[0][i]);
  return beginning(text, 1) + row + "\n";
}

void check_refused(const std::string& command, const std::string& message) {
  const check::ProgramResult result = run_program(command);
  const bool passed = result.exit_status == 2 && result.out.empty() &&
                      std::count(result.err.begin(), result.err.end(), '\n') == 1 &&
                      result.err.find(message) != std::string::npos;
  if (!CHECK(passed)) NOTE(message << ": exit " << result.exit_status << ", stderr: " << result.err);
}

}  // namespace

// A trim is an equilibrium: read again, with its loading, every rate but that of the heading is zero.
TEST(cli_states_of_trim_are_in_equilibrium) {
  for (const char* flight :
       {"--mast 0,30 --speed 0,40 --altitude 0,2000 --mass 5000,6000", "--mast 90 --speed 80,140 --cg-sl 298",
        "--mast 60 --speed 60 --turn-rate 5 --sideslip 4 --climb 3 --flap 40 --rotor-rpm 560",
        "--mast 30 --speed 50 --option coning_states=on --grid realtime"}) {
    const std::string switches = std::string(flight).find("coning") == std::string::npos
                                     ? ""
                                     : " --option coning_states=on --grid realtime";
    const std::string trim = this_aircraft::flown(std::string("trim ") + flight);
    const check::ProgramResult result = run_program(built("tiltrotor") + " " + trim + " | " +
                                                    built("tiltrotor") + " derivative --states -" + switches);
    CHECK_EQ(result.exit_status, 0);
    const CsvText rates(result.out);
    CHECK_LE(1u, rates.rows.size());
    for (std::size_t row = 0; row < rates.rows.size(); ++row) {
      for (const std::string& column : rates.columns) {
        if (column.compare(0, 2, "d_") != 0) continue;
        const double expected =
            column == "d_psi" ? rates.number(row, "turn_rate_degps") * std::acos(-1.0) / 180 : 0;
        if (!CHECK_NEAR(rates.number(row, column), expected, 1e-7)) NOTE(flight << " " << column);
      }
    }
  }
}

// Along a flight the rates are the slopes of the columns, by central differences; all kinds of controls act.
TEST(cli_states_of_respond_have_its_slopes) {
  const ScratchFolder folder;
  const std::string path = folder.path("flight.csv");
  CHECK_EQ(run_tiltrotor(
               "respond --mast 30 --speed 60 --altitude 2000 --input elevator=2deg@0 --input gust_w=3@0 "
               "--input long_stick=0.5@0 --input diff_collective=1deg@0 --duration 0.4 --modes-every 0.2 "
               "--output " +
               path)
               .exit_status,
           0);
  const CsvText flight(folder.read("flight.csv"));
  const CsvText rates(run_tiltrotor("derivative --states " + path).out);
  if (!CHECK_EQ(rates.rows.size(), 81u)) return;
  const double degree = std::acos(-1.0) / 180;
  const struct {
    const char *rate, *column;
    double unit;
  } pairs[] = {{"d_u", "u_mps", 1},
               {"d_w", "w_mps", 1},
               {"d_p", "p_degps", degree},
               {"d_q", "q_degps", degree},
               {"d_theta", "pitch_deg", degree},
               {"d_eps", "downwash_deg", degree},
               {"d_n0_R", "n0_right", 1}};
  for (const auto& pair : pairs) {
    const double slope =
        (flight.number(61, pair.column) - flight.number(59, pair.column)) * pair.unit / (2 * 0.005);
    CHECK_NEAR(rates.number(60, pair.rate), slope, 2e-3 * std::abs(slope) + 1e-6);
  }
}

// One file in the forms in which others write it.
TEST(cli_states_in_every_form_of_csv) {
  const ScratchFolder folder;
  const std::string plain = reference_text();
  const std::string command = "derivative --states ";
  const std::string expected = run_tiltrotor(command + folder.write("s.csv", plain)).out;
  CHECK_LT(1000u, expected.size());
  const std::string header = beginning(plain, 1);
  const std::string quoted = "\"" + replaced(replaced(plain, ",", "\",\""), "\n", "\"\n\"");
  for (const std::string& form :
       {"\xef\xbb\xbf" + plain, replaced(plain, "\n", "\r\n"),
        "\xef\xbb\xbf" + replaced(plain, "\n", "\r\n\r\n"), quoted.substr(0, quoted.size() - 1),
        replaced(plain, ",", " , "), "\n\n" + plain + " \t\r\n", plain.substr(0, plain.size() - 1)})
    CHECK(run_tiltrotor(command + folder.write("s.csv", form)).out == expected);
  CHECK(run_program(built("tiltrotor") + " derivative --states - <" + check::quoted(reference_states)).out ==
        expected);
  CHECK(run_program("cat " + check::quoted(reference_states) + " | " + built("tiltrotor") +
                    " derivative --states /dev/stdin")
            .out == expected);
}

// A name with commas and quotation marks comes back as such from every command.
TEST(cli_states_keep_odd_names) {
  const ScratchFolder folder;
  const std::string path = folder.write(
      "s.csv", cell_replaced(beginning(reference_text(), 2), "case", "\"gust, \"\"hard\"\" \xc3\xa9\""));
  const std::string in_csv = "\n\"gust, \"\"hard\"\" \xc3\xa9\",";
  for (const char* command : {"derivative", "loads", "linearize"}) {
    CHECK(run_tiltrotor(std::string(command) + " --states " + path).out.find(in_csv) != std::string::npos);
    CHECK(run_tiltrotor(std::string(command) + " --format json --states " + path)
              .out.find("\"case\": \"gust, \\\"hard\\\" \xc3\xa9\"") != std::string::npos);
  }
}

TEST(cli_json_text_is_utf8) {
  using tiltrotor::text::json_text;
  CHECK_EQ(json_text("a\xc3\xa9\n\"\\"), "\"a\xc3\xa9\\u000a\\\"\\\\\"");
  CHECK_EQ(json_text("caf\xe9"), "\"caf\\ufffd\"");                  // Latin-1
  CHECK_EQ(json_text("\xed\xa0\x80"), "\"\\ufffd\\ufffd\\ufffd\"");  // half of a surrogate pair
  for (const char* good : {"", "abc", "\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x9a\x81"})
    CHECK(csv::is_utf8(good));
  for (const char* bad :
       {"\x80", "\xc0\xaf", "\xc3", "\xe0\x80\x80", "\xed\xbf\xbf", "\xf4\x90\x80\x80", "\xff"})
    CHECK(!csv::is_utf8(bad));
}

TEST(cli_bad_states_text_is_named_with_line) {
  const ScratchFolder folder;
  const std::string good = beginning(reference_text(), 2);
  check_states_refused(folder, "\xff\xfeu\0,", "states.csv:1: the file is UTF-16; save it as UTF-8");
  check_states_refused(folder, cell_replaced(good, "case", "caf\xe9"), "states.csv:2: the text is not UTF-8");
  check_states_refused(folder, cell_replaced(good, "case", std::string("a\0b", 3)),
                       ":2: the line holds a NUL byte");
  check_states_refused(folder, cell_replaced(good, "case", "\"a"),
                       ":2: a quotation mark is not closed on its line");
  check_states_refused(folder, cell_replaced(good, "case", "\"a\"b"),
                       ":2: text follows a closed quotation mark");
  check_states_refused(folder, cell_replaced(good, "case", "a\"b"),
                       ":2: a quotation mark stands inside a cell");
  check_states_refused(folder, replaced(good, "\n", ",\n"), " has no name");
  check_states_refused(folder, replaced(good, ",", ";"), "separated by commas, not by ';'");
  check_states_refused(folder, replaced(good, ",", "\t"), "separated by commas, not by tabs");
  check_states_refused(folder, good + std::string(2000000, '1'), ":3: the line is longer than a megabyte");
  check_states_refused(folder, cell_replaced(good, "u", std::string(100000, '1')), ":2: column u: ");
  check_refused(built("tiltrotor") + " loads --states /dev/zero", "/dev/zero:1: the line is longer");
  check_refused(built("tiltrotor") + " loads --states ''", "--states: the name is empty");
  check_refused(built("tiltrotor") + " loads --states /tmp", "/tmp: cannot be read: Is a directory");
}

TEST(cli_bad_states_column_gets_the_nearest_name) {
  const ScratchFolder folder;
  const std::string good = beginning(reference_text(), 2);
  const auto renamed = [&](const char* from, const char* to) {
    return replaced(good, std::string(",") + from + ",", std::string(",") + to + ",");
  };
  check_states_refused(folder, renamed("theta", "thetta"),
                       ":1: unknown column 'thetta' (did you mean theta?)");
  check_states_refused(folder, renamed("th75_rad", "th75_rads"), "(did you mean th75_rad?)");
  check_states_refused(folder, renamed("b1c_R", "B1C_R"), "unknown column 'B1C_R' (did you mean b1c_R?)");
  check_states_refused(folder, renamed("theta", "pich_deg"), "(did you mean pitch_deg?)");
  check_states_refused(folder, renamed("theta", "quite_another_thing"), "'quite_another_thing'; `tiltrotor");
  check_states_refused(folder, renamed("v", "u_mps"), ":1: columns 'u' and 'u_mps' give the same quantity");
  check_states_refused(folder, renamed("v", "v_knots"), "unknown column 'v_knots'");
}

// The bounds of tr_set_state: tiltrotor.h states them.
TEST_OF_XV15(cli_bad_states_ranges_are_those_of_the_c_interface) {
  const ScratchFolder folder;
  const std::string good = beginning(reference_text(), 2);
  const auto with = [&](const char* column, const char* value) { return cell_replaced(good, column, value); };
  check_states_refused(folder, with("u", "1e5"), ":2: column u: 1e5 lies outside -300..300 m/s");
  check_states_refused(folder, with("q", "-20.1"), "-20.1 lies outside -20..20 rad/s");
  check_states_refused(folder, with("theta", "1.5707963267948966"),
                       "lies outside -1.5707945814656445..1.5707945814656445 rad");
  check_states_refused(folder, with("phi", "1001"), "1001 lies outside -1000..1000 rad");
  check_states_refused(folder, with("b1c_R", "2.1"), "2.1 lies outside -2..2 rad");
  check_states_refused(folder, with("db1s_L", "201"), "201 lies outside -200..200 rad/s");
  check_states_refused(folder, with("n0_L", "-3"), "-3 lies outside -2..2");
  check_states_refused(folder, with("eps", "2.5"), "2.5 lies outside -2..2 rad");
  check_states_refused(folder, with("lon_in", "4.9"), "4.9 lies outside -4.8..4.8 in");
  check_states_refused(folder, with("u", "1e999"),
                       ":2: column u: '1e999' is beyond the range of floating-point numbers");
  check_states_refused(folder, with("u", "0x10"), "'0x10' is not a number");
  const std::string printed = run_tiltrotor("trim --speed 40").out;
  const auto in_degrees = [&](const char* column, const char* value) {
    return cell_replaced(printed, column, value);
  };
  check_states_refused(folder, in_degrees("pitch_deg", "90"),
                       ":2: column pitch_deg: 90 lies outside -89.9999..89.9999 deg");
  check_states_refused(folder, in_degrees("mass_kg", "1"), "1 lies outside 3000..10000 kg");
  check_states_refused(folder, in_degrees("altitude_m", "12000"), "12000 lies outside -500..11000 m");
  const std::string path = folder.write("trim.csv", printed);
  for (const char* option :
       {"--mast 30", "--altitude 30", "--mass 6000", "--cg-sl 300", "--rotor-rpm 560", "--flap 40"})
    check_refused(built("tiltrotor") + " loads " + option + " --states " + path, "has its own column");
}

// 50,000 rows, one of them asked for: in less memory than the rows need. Before, 176 MB for 100,000 rows.
TEST(cli_states_are_read_row_by_row) {
  const ScratchFolder folder;
  const std::string good = beginning(reference_text(), 2);
  const std::string row = good.substr(good.find('\n') + 1);
  std::string text = good;
  for (int i = 0; i < 49999; ++i) text += row;
  const std::string few = folder.write("few.csv", good);
  const std::string many = folder.write("many.csv", text);
  const std::string command = "ulimit -v 60000; " + built("tiltrotor") + " derivative --states ";
  if (run_program(command + few).exit_status != 0) {
    NOTE("the program does not start in 60 MB here");
    return;
  }
  const check::ProgramResult last = run_program(command + many + " --shard 50000/50000");
  CHECK_EQ(last.exit_status, 0);
  const std::string whole = run_tiltrotor("derivative --states " + few).out;
  CHECK_EQ(replaced(last.out, "\n", ""), replaced(whole.substr(whole.find('\n') + 1), "\n", ""));
}
