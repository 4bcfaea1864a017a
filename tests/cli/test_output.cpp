// Files appear whole or not at all; a reader that leaves and a full disk are reported; formats and shards.
// Expected: the grammar of RFC 8259, the unsharded run, one output form against another.
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <vector>

#include "check.hpp"
#include "cli/csv_text.hpp"
#include "cli/json_grammar.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"
#include "this_aircraft.hpp"

using check::built;
using check::JsonGrammar;
using check::run_program;
using check::run_tiltrotor;
using check::ScratchFolder;
using this_aircraft::flown;

namespace {

const std::string reference_states = check::source_path("tests/reference/state_derivatives_c1.csv");

// The commands with rows, each with several.
const std::string commands_with_rows[] = {
    flown("trim --mast 90 --speed 50:10:80"),
    "modes --mast 30,90 --speed 60:5:70",
    "linearize --mast 90 --speed 80,90 --reduce rigid",
    "loads --mast 30 --speed 50,60",
    "derivative --states " + check::quoted(reference_states),
    "loads --states " + check::quoted(reference_states),
    "rotor --collective75 4:2:12",
};

}  // namespace

TEST(cli_json_grammar_knows_json) {
  for (const char* good : {"[]", "{}", "[1, -0.5e-7, \"a\\\"b\", null, true]", "{\"a\": {\"b\": []}}"}) {
    CHECK(JsonGrammar::accepts(good));
  }
  for (const char* bad :
       {"", "[1,]", "{a: 1}", "[nan]", "[01]", "[1.]", "[1] 2", "[+1]", "{\"a\" 1}", "[inf]"}) {
    CHECK(!JsonGrammar::accepts(bad));
  }
}

TEST(cli_json_of_every_command_parses) {
  for (const std::string& command : commands_with_rows) {
    const check::ProgramResult result = run_tiltrotor(command + " --format json");
    CHECK_EQ(result.exit_status, command.compare(0, 6, "trim -") == 0 ? 1 : 0);
    if (!CHECK(JsonGrammar::accepts(result.out))) NOTE(command);
  }
  CHECK(JsonGrammar::accepts(run_tiltrotor("linearize --mast 90 --speed 80 --format json").out));
  CHECK(JsonGrammar::accepts(run_tiltrotor("linearize --mast 90 --speed 20 --format json").out));  // no trim
  CHECK(JsonGrammar::accepts(
      run_tiltrotor("respond --speed 40 --duration 0.1 --modes-every 0.05 --format json").out));
}

TEST(cli_linearize_json_has_the_promised_members) {
  const std::string text = run_tiltrotor("linearize --mast 90 --speed 80 --format json").out;
  for (const char* member : {"mast_deg", "speed_mps", "states", "controls", "x0", "u0", "A", "B"}) {
    CHECK(text.find("\"" + std::string(member) + "\": ") != std::string::npos);
  }
  CHECK(text.find("{\"name\": \"theta\", \"unit\": \"rad\"}") != std::string::npos);
  CHECK(text.find("{\"name\": \"long_stick\", \"unit\": \"in\"}") != std::string::npos);
}

TEST(cli_shards_join_to_the_whole) {
  for (const std::string& command : commands_with_rows) {
    const std::string whole = run_tiltrotor(command + " --format csv").out;
    CHECK_LT(0, static_cast<int>(whole.size()));
    for (const int parts : {2, 3, 7}) {
      std::string joined;
      for (int k = 1; k <= parts; ++k) {
        joined += run_tiltrotor(command + " --format csv --shard " + std::to_string(k) + "/" +
                                std::to_string(parts))
                      .out;
      }
      if (!CHECK(joined == whole)) NOTE(command << " in " << parts << " parts");
    }
  }
}

TEST(cli_output_file_equals_stdout) {
  const ScratchFolder folder;
  for (const std::string& command : commands_with_rows) {
    const std::string whole = run_tiltrotor(command).out;
    CHECK_EQ(run_tiltrotor(command + " --output " + folder.path("out.csv")).out, std::string());
    CHECK(folder.read("out.csv") == whole);
    CHECK_EQ(folder.files(), 1);  // nothing left beside it
  }
}

TEST(cli_matrices_are_written_at_every_step) {
  const ScratchFolder folder;
  const std::string flight = "respond --speed 40 --duration 0.02 --dt 0.01 --matrices " + folder.path("m");
  CHECK_EQ(run_tiltrotor(flight).exit_status, 0);
  const check::CsvText a(folder.read("m/a.csv"));
  const check::CsvText b(folder.read("m/b.csv"));
  CHECK_EQ(a.columns.size(), 25u);
  CHECK_EQ(a.rows.size(), 3u * 23u);
  CHECK_EQ(b.columns.size(), 6u);
  CHECK_EQ(b.rows.size(), 3u * 23u);
  CHECK_EQ(a.text(0, "row"), std::string("u"));
  CHECK_EQ(a.number(23, "time_s"), 0.01);
}

// As other programs do: `| head` ends a run without a word, and without a half-written file.
TEST(cli_closed_pipe_ends_without_a_word) {
  const ScratchFolder folder;
  for (const std::string& command :
       {std::string("trim --speed 0:1:50"),
        std::string("respond --speed 40 --duration 5 --matrices ") + folder.path("m"),
        std::string("rotor --collective75 0:0.1:16"), std::string("linearize --mast 90 --speed 80:1:90"),
        std::string("conventions"), std::string("trim --help")}) {
    const check::ProgramResult result =
        run_program("( " + built("tiltrotor") + " " + command + "; echo status $? >&2 ) | head -c 10");
    if (!CHECK(result.err == "status 1\n" || result.err == "status 0\n")) NOTE(command << ": " << result.err);
  }
  CHECK(run_program("( " + built("tiltrotor") + " trim --speed 0:1:50; echo status $? >&2 ) | true").err ==
        "status 1\n");
  CHECK(std::filesystem::is_empty(folder.path("m")));
}

TEST(cli_full_disk_is_reported) {
  for (const char* to : {" >/dev/full", " --output /dev/full"}) {
    const check::ProgramResult result = run_tiltrotor(std::string("trim --speed 0:10:50") + to);
    CHECK_EQ(result.exit_status, 1);
    CHECK(result.err.find("No space left") != std::string::npos);
  }
}

TEST(cli_numbers_do_not_depend_on_the_locale) {
  const std::string plain = run_tiltrotor("trim --speed 40").out;
  for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "C"}) {
    CHECK(run_program("LC_ALL=" + std::string(locale) + " " + built("tiltrotor") + " trim --speed 40").out ==
          plain);
  }
}

TEST(cli_table_has_one_line_a_row) {
  const std::string table = run_tiltrotor("trim --speed 0:10:50 --format table").out;
  CHECK_EQ(std::count(table.begin(), table.end(), '\n'), 7);
  CHECK_EQ(table.find(','), std::string::npos);
}

namespace {

// Numbers of "model(1).NAME = [ ... ];" in row order.
std::vector<double> matlab_numbers(const std::string& text, const std::string& name) {
  const std::size_t begin = text.find("model(1)." + name + " = [");
  std::vector<double> numbers;
  if (!CHECK(begin != std::string::npos)) return numbers;
  const std::size_t open = text.find('[', begin);
  std::string inside = text.substr(open + 1, text.find(']', open) - open - 1);
  std::replace(inside.begin(), inside.end(), ';', ' ');
  std::istringstream in(inside);
  for (double x; in >> x;) numbers.push_back(x);
  return numbers;
}

}  // namespace

// The file's states, as the derivative command takes them: one model a row, and none of them changes a state.
// A name with quotation marks and a control character stays itself in JSON.
TEST(cli_linearize_at_given_states) {
  const std::string states = " --states " + check::quoted(reference_states);
  const check::CsvText rates(run_tiltrotor("derivative" + states + " --format csv").out);
  const check::ProgramResult run = run_tiltrotor("linearize --reduce rigid --format csv" + states);
  CHECK_EQ(run.exit_status, 0);
  const check::CsvText models(run.out);
  std::size_t theta = 0;
  for (std::size_t row = 0; row < models.rows.size(); ++row) {
    if (models.text(row, "matrix") != "x0" || models.text(row, "row") != "theta") continue;
    if (!CHECK(theta < rates.rows.size())) return;
    CHECK_EQ(models.number(row, "value"), rates.number(theta, "theta"));
    CHECK(models.text(row, "case") == rates.text(theta, "case"));
    ++theta;
  }
  CHECK_EQ(theta, rates.rows.size());
}

// The same model in three forms: every number of the script stands in the CSV, in the order of A's and B's
// rows; the table has one row a state.
TEST(cli_linearize_forms_agree) {
  const std::string command = "linearize --mast 90 --speed 80 --reduce rigid --format ";
  const check::CsvText csv(run_tiltrotor(command + "csv").out);
  const check::ProgramResult script = run_tiltrotor(command + "matlab");
  CHECK_EQ(script.exit_status, 0);
  const std::vector<double> a = matlab_numbers(script.out, "A");
  const std::vector<double> b = matlab_numbers(script.out, "B");
  CHECK(a.size() == 64 && b.size() == 32);
  CHECK_EQ(matlab_numbers(script.out, "x0").size(), 8u);
  CHECK_EQ(matlab_numbers(script.out, "u0").size(), 4u);
  std::size_t in_a = 0, in_b = 0;
  for (std::size_t row = 0; row < csv.rows.size(); ++row) {
    const std::string which = csv.text(row, "matrix");
    if (which == "A" && in_a < a.size()) CHECK_EQ(csv.number(row, "value"), a[in_a++]);
    if (which == "B" && in_b < b.size()) CHECK_EQ(csv.number(row, "value"), b[in_b++]);
  }
  CHECK(in_a == 64 && in_b == 32);
  CHECK(script.out.find("model(1).states = {'u', ") != std::string::npos);
  const check::ProgramResult table = run_tiltrotor(command + "table");
  CHECK_EQ(std::count(table.out.begin(), table.out.end(), '\n'), 10);
  CHECK(table.out.find("mast 90 deg, 80 m/s: ok") != std::string::npos);
  CHECK(run_tiltrotor("linearize --mast 90 --speed 20 --format matlab").out.find("'not_converged'") !=
        std::string::npos);
}
