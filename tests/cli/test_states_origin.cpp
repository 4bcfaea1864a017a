// Files of states tell which model made them, and rows beyond a stop come back; text that is no CSV is told.
// Expected: the same command on the same model; one output against another.
#include <algorithm>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/scratch_folder.hpp"
#include "cli/states_refused.hpp"
#include "run_program.hpp"

using check::check_states_refused;
using check::contains;
using check::CsvText;
using check::lines;
using check::run_tiltrotor;
using check::ScratchFolder;

// One line for the file, not one a row; the numbers are computed.
TEST(cli_states_of_another_model_are_told) {
  const ScratchFolder folder;
  const char* const options[] = {"",
                                 "--grid realtime",
                                 "--tables linear",
                                 "--tables c2",
                                 "--option wake=gtrs_empirical",
                                 "--option azimuth_stations=12 --option hub_spring_factor=1.5"};
  for (const std::string command : {"trim --speed 20,40 ", "respond --speed 40 --duration 0.01 "}) {
    for (const std::string made : options) {
      const std::string path = folder.write("s.csv", run_tiltrotor(command + made).out);
      for (const std::string used : options) {
        for (const std::string reader : {"derivative", "loads", "linearize"}) {
          const check::ProgramResult read = run_tiltrotor(reader + " --states " + path + " " + used);
          CHECK_EQ(read.exit_status, 0);
          if (!CHECK_EQ(lines(read.err), made == used ? 0 : 1))
            NOTE(made << " | " << used << ": " << read.err);
          if (made != used) CHECK(contains(read.err, path + ":2: made with another model, '"));
        }
      }
    }
  }
  const std::string trim = run_tiltrotor("trim --speed 40 --grid realtime").out;
  const std::string model = CsvText(trim).text(0, "model");
  CHECK(contains(model, " grid=realtime") && !contains(model, "tables"));
  // Another aircraft, and a file that does not say.
  std::string other = trim;
  other.replace(other.find(model), model.size(), "V-280");
  const std::string told = run_tiltrotor("loads --states " + folder.write("o.csv", other)).err;
  CHECK(contains(told, "'V-280'") && lines(told) == 1);
  const std::string silent = check::quoted(check::source_path("tests/reference/state_derivatives_c1.csv"));
  CHECK_EQ(run_tiltrotor("loads --grid realtime --states " + silent).err, std::string());
}

// A trim on a hot day is at rest in the air of its own row, whatever the options do not say; an option may say the same.
TEST(cli_states_are_in_the_air_of_their_row) {
  const ScratchFolder folder;
  const std::string flight = " --speed 30,40 --grid realtime --format csv";
  for (const std::string command : {"trim", "respond --duration 0.01 --dt 0.01"}) {
    const std::string speeds = command == "trim" ? flight : " --speed 30 --grid realtime --format csv";
    const std::string hot =
        folder.write("hot.csv", run_tiltrotor(command + speeds + " --isa-offset 30 --engines 1").out);
    const std::string given = " --grid realtime --format csv --states " + hot;
    const check::ProgramResult rates = run_tiltrotor("derivative" + given);
    CHECK_EQ(rates.exit_status, 0);
    CHECK_EQ(rates.err, std::string());
    const CsvText rows(rates.out);
    CHECK_LT(0u, rows.rows.size());
    for (std::size_t i = 0; i < rows.rows.size(); ++i)
      for (const std::string& column : rows.columns)
        if (column.compare(0, 2, "d_") == 0) CHECK_NEAR(rows.number(i, column), 0, 1e-6);
    for (const std::string reader : {"derivative", "loads", "linearize"}) {
      const check::ProgramResult same = run_tiltrotor(reader + given + " --isa-offset 30 --engines 1");
      CHECK_EQ(same.err, std::string());
      CHECK_EQ(same.out, run_tiltrotor(reader + given).out);
      for (const std::string other : {" --isa-offset 10", " --isa-offset 0", " --engines 2"}) {
        const check::ProgramResult refused = run_tiltrotor(reader + given + other);
        CHECK_EQ(refused.exit_status, 2);
        CHECK_EQ(refused.out, std::string());
        CHECK(lines(refused.err) == 1 && contains(refused.err, hot + ":2 was made with "));
      }
    }
    CHECK(contains(run_tiltrotor("linearize --grid realtime --format json --states " + hot).out,
                   "\"isa_offset_k\": 30, \"engines\": 1,"));
  }
  // Rows of a standard day are no rows of a hot one; a file that does not say is in the air of the options.
  const std::string plain = run_tiltrotor("trim" + flight).out;
  const std::string path = folder.write("plain.csv", plain);
  CHECK_EQ(run_tiltrotor("loads --grid realtime --isa-offset 30 --states " + path).exit_status, 2);
  const std::string silent = check::quoted(check::source_path("tests/reference/state_derivatives_c1.csv"));
  CHECK(run_tiltrotor("loads --grid realtime --isa-offset 30 --states " + silent).out !=
        run_tiltrotor("loads --grid realtime --states " + silent).out);
  const std::string model = CsvText(plain).text(0, "model");
  for (const char* const bad : {" isa_offset=warm", " isa_offset=1e3", " engines=3"}) {
    std::string text = plain;
    text.replace(text.find(model), model.size(), model + bad);
    check_states_refused(folder, text, ":2: column model: ", "--grid realtime");
  }
}

// Every row of a flight that begins beyond a stop, and of one that is driven to a stop, is read.
TEST(cli_states_of_a_flight_beyond_its_stops_are_read) {
  const ScratchFolder folder;
  for (const std::string flight :
       {"--mast 60 --speed 0", "--mast 90 --speed 60 --climb -20", "--speed 40 --input lat_stick=4.8@0",
        "--speed 40 --input elevator=0.5rad@0",
        "--speed 40 --input elevator=-0.5rad@0 --input gust_v=-50@0"}) {
    const std::string out = run_tiltrotor("respond --duration 0.05 " + flight).out;
    const CsvText csv(out);
    if (!CHECK_LT(1u, csv.rows.size())) NOTE(flight);
    const std::string path = folder.write("r.csv", out);
    for (const std::string reader : {"derivative", "loads", "linearize"}) {
      const check::ProgramResult read = run_tiltrotor(reader + " --states " + path);
      if (!CHECK(read.exit_status == 0 && read.err.empty()))
        NOTE(flight << ": " << reader << ": " << read.err);
    }
  }
  const CsvText beyond(run_tiltrotor("respond --mast 60 --speed 0 --duration 0.01").out);
  CHECK(contains(beyond.text(0, "limits"), "long_stick"));
  CHECK_EQ(CsvText(run_tiltrotor("respond --speed 40 --duration 0.01").out).text(0, "limits"), std::string());
}

TEST(cli_states_that_are_no_csv_are_told) {
  const ScratchFolder folder;
  check_states_refused(folder, run_tiltrotor("trim --speed 40 --format json").out,
                       ":1: the file is JSON; CSV is read");
  check_states_refused(folder, "  {\"u\": 40}\n", ":1: the file is JSON; CSV is read");
  std::string lines_of_mac = run_tiltrotor("trim --speed 20:1:40").out;
  std::replace(lines_of_mac.begin(), lines_of_mac.end(), '\n', '\r');
  check_states_refused(folder, lines_of_mac, ":1: the lines end with CR alone; end them with LF or CRLF");
  std::string long_one;
  while (long_one.size() < (1 << 20)) long_one += lines_of_mac;
  check_states_refused(folder, long_one, "not with CR alone");
}

// The file of states names its rows; every format of the linear models says which is which.
TEST(cli_linearize_names_the_case_in_every_format) {
  const ScratchFolder folder;
  const CsvText trim(run_tiltrotor("trim --speed 20,40").out);
  std::string named = "case," + check::first_line(run_tiltrotor("trim --speed 20").out) + "\n";
  for (std::size_t row = 0; row < 2; ++row) {
    named += row == 0 ? "pilot's" : "cruise";
    for (const std::string& cell : trim.rows[row]) named += "," + cell;
    named += "\n";
  }
  const std::string path = folder.write("named.csv", named);
  const auto out = [&](const std::string& format) {
    return run_tiltrotor("linearize --states " + path + " --format " + format).out;
  };
  CHECK(contains(out("table"), "case pilot's: mast 0 deg, 20 m/s: ok\n"));
  CHECK(contains(out("table"), "case cruise: mast 0 deg, 40 m/s: ok\n"));
  CHECK(contains(out("matlab"), "model(1).case_name = 'pilot''s';\n"));
  CHECK(contains(out("matlab"), "model(2).case_name = 'cruise';\n"));
  CHECK(contains(out("matlab"), "% case cruise: mast 0 deg"));
  CHECK(contains(out("json"), "\"case\": \"cruise\""));
  CHECK(contains(out("csv"), "\ncruise,0,40,ok,A,"));
  CHECK(
      contains(run_tiltrotor("linearize --speed 20,40 --format matlab").out, "model(2).case_name = '1';\n"));
}

// The mode of a file that is replaced, and no more rights while it is written.
TEST(cli_file_that_is_replaced_keeps_its_mode) {
  const ScratchFolder folder;
  const auto mode = [](const std::string& path) { return check::run_program("stat -c %a " + path).out; };
  for (const char* given : {"600", "640", "444", "660", "755"}) {
    const std::string path = folder.write(std::string("m") + given, "old");
    check::run_program("chmod " + std::string(given) + " " + path);
    const check::ProgramResult run = run_tiltrotor("trim --speed 20 --output " + path);
    if (run.exit_status != 0) continue;  // not writable, unless one may all
    CHECK_EQ(mode(path), std::string(given) + "\n");
    CHECK(contains(folder.read(std::string("m") + given), "mast_deg,"));
  }
  const std::string folder_of_matrices = folder.path("matrices");
  const std::string respond = "respond --speed 40 --duration 0.01 --matrices " + folder_of_matrices;
  CHECK_EQ(run_tiltrotor(respond).exit_status, 0);
  check::run_program("chmod 600 " + folder_of_matrices + "/a.csv");
  CHECK_EQ(run_tiltrotor(respond).exit_status, 0);
  CHECK_EQ(mode(folder_of_matrices + "/a.csv"), "600\n");
  const std::string fresh = folder.path("fresh.csv");
  CHECK_EQ(
      check::run_program("umask 027 && " + check::built("tiltrotor") + " trim --output " + fresh).exit_status,
      0);
  CHECK_EQ(mode(fresh), "640\n");
}
