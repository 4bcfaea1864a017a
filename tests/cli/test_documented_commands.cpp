// Every command line of the pages and of the help is run as it stands there, found by its form: an indented
// line that holds build/tiltrotor, and what follows "Example: ". Each succeeds; what stands below one it prints.
// Expected: the pages' own text.
#include <filesystem>
#include <regex>
#include <sstream>
#include <type_traits>
#include <utility>

#include "check.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"
#include "tiltrotor/model/variables/options.hpp"

using check::run_program;
using check::run_tiltrotor;
using check::ScratchFolder;

namespace {

std::string file_text(const std::string& name) {
  std::ifstream in(check::source_path(name), std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

struct Documented {
  std::string command;
  std::string output;  // lines that follow it
};

// Indented lines that call the program; one that ends in a backslash goes on.
std::vector<Documented> documented_commands(const std::string& page) {
  std::vector<Documented> commands;
  std::string whole;
  bool follows = false;
  for (std::string line : lines_of(file_text(page))) {
    const bool indented = line.compare(0, 4, "    ") == 0;
    if (!indented || line[4] == '#') {
      follows = false;
      continue;
    }
    const bool goes_on = line.back() == '\\';
    if (goes_on) line.pop_back();
    whole += goes_on || !whole.empty() ? line : line.substr(4);
    if (goes_on) continue;
    if (whole.find("build/tiltrotor") != std::string::npos) {
      commands.push_back({whole.compare(0, 4, "    ") == 0 ? whole.substr(4) : whole, ""});
      follows = true;
    } else if (follows) {
      commands.back().output += whole + "\n";
    }
    whole.clear();
  }
  return commands;
}

std::string replaced(const std::string& text, const std::string& pattern, const std::string& by) {
  return std::regex_replace(text, std::regex(pattern), by);
}

// What GNU parallel and Slurm run: the quoted line for one shard, of so many that it is short.
std::string one_job(const std::string& command) {
  const std::size_t open = command.find('\'');
  std::string job = command.substr(open + 1, command.rfind('\'') - open - 1);
  job = replaced(job, "--shard \\S+", "--shard 1/5000");
  return replaced(job, "\\{\\}|\\$SLURM_ARRAY_TASK_ID", "1");
}

// Where commands of the tree's top level run: what they read is there, what they write is thrown away.
void show_sources(const ScratchFolder& folder) {
  std::filesystem::create_directory_symlink(check::source_path("src"), folder.path("src"));
}

void check_succeeds(const std::string& command, const std::string& name, const std::string& output = "") {
  const ScratchFolder folder;
  show_sources(folder);
  const std::string first = command.find("# after: ") == std::string::npos
                                ? ""
                                : command.substr(command.find("# after: ") + 9) + " && ";
  std::string line = replaced(first + command, "(^|[|(&] *)" + name + " ", "$1PROGRAM ");
  for (std::size_t place; (place = line.find("PROGRAM ")) != std::string::npos;)
    line.replace(place, 7, check::built("tiltrotor"));
  const check::ProgramResult result = run_program("cd " + check::quoted(folder.path("")) + " && " + line);
  const bool sums_up = command.find("tiltrotor fly ") != std::string::npos;
  const bool passed =
      result.exit_status == 0 && (sums_up ? result.err.compare(0, 9, "duration:") == 0 : result.err.empty());
  if (!CHECK(passed)) NOTE(command << ": exit " << result.exit_status << ", stderr: " << result.err);
  if (!output.empty()) CHECK_EQ(result.out, output);
}

// Fits every member: as many as an aggregate takes are its members.
struct Anything {
  template <class T>
  operator T() const;
};
template <class Aggregate, class Members, class = void>
struct TakesMembers : std::false_type {};
template <class Aggregate, std::size_t... I>
struct TakesMembers<Aggregate, std::index_sequence<I...>,
                    std::void_t<decltype(Aggregate{(static_cast<void>(I), Anything{})...})>>
    : std::true_type {};
template <class Aggregate, int Count = 100>
constexpr int member_count() {
  if constexpr (TakesMembers<Aggregate, std::make_index_sequence<Count>>::value) {
    return Count;
  } else {
    return member_count<Aggregate, Count - 1>();
  }
}

// Examples that the help shows: of the program, and of each command it lists.
std::vector<std::string> help_examples(const std::string& help) {
  std::vector<std::string> examples;
  for (const std::string& line : lines_of(help))
    if (line.compare(0, 9, "Example: ") == 0) examples.push_back(line.substr(9));
  return examples;
}

std::vector<std::string> listed_commands() {
  std::vector<std::string> names;
  const std::regex item("  ([a-z]+) +\\S.*");
  std::smatch match;
  for (const std::string& line : lines_of(run_tiltrotor("--help").out))
    if (std::regex_match(line, match, item)) names.push_back(match[1]);
  return names;
}

}  // namespace

TEST_OF_XV15(cli_help_commands_of_the_readme_succeed) {
  std::size_t count = 0, shown = 0;
  for (const char* const page : {"README.md", "src/cli/README.md"}) {
    for (const auto& [command, output] : documented_commands(page)) {
      ++count;
      const bool direct = command.compare(0, 15, "build/tiltrotor") == 0;
      shown += direct && !output.empty() ? 1 : 0;
      check_succeeds(direct ? command : "( " + one_job(command) + " )", "build/tiltrotor",
                     direct ? output : "");
    }
  }
  CHECK_EQ(count, 40u);
  CHECK_EQ(shown, 5u);
}

// `report` draws everything: its example is run by the slow test. Their flights are those of the XV-15; any
// aircraft takes them, though it may have no trim there.
TEST(cli_help_examples_are_taken) {
  const std::vector<std::string> names = listed_commands();
  CHECK_EQ(names.size(), 18u);
  for (const std::string& name : names) {
    const std::string example = help_examples(run_tiltrotor(name + " --help").out).at(0);
    if (name == "report") continue;
    const ScratchFolder folder;
    show_sources(folder);
    const std::size_t after = example.find("# after: ");
    for (const std::string& line :
         {after == std::string::npos ? std::string("tiltrotor version") : example.substr(after + 9),
          example.substr(0, example.find('#'))}) {
      const check::ProgramResult result = run_program("cd " + check::quoted(folder.path("")) + " && " +
                                                      check::built("tiltrotor") + line.substr(9));
      if (!CHECK_LT(result.exit_status, 2)) NOTE(line << ": " << result.err);
    }
  }
}

TEST_OF_XV15(cli_help_examples_succeed) {
  const std::vector<std::string> names = listed_commands();
  CHECK_EQ(names.size(), 18u);
  CHECK_EQ(help_examples(run_tiltrotor("--help").out).size(), 1u);
  check_succeeds(help_examples(run_tiltrotor("--help").out)[0], "tiltrotor");
  for (const std::string& name : names) {
    const std::vector<std::string> examples = help_examples(run_tiltrotor(name + " --help").out);
    if (!CHECK_EQ(examples.size(), 1u)) NOTE(name);
    for (const std::string& example : examples)
      if (name != "report") check_succeeds(example, "tiltrotor");
  }
}

TEST_OF_XV15(slow_cli_help_example_of_report_succeeds) {
  const ScratchFolder folder;
  const std::string example = help_examples(run_tiltrotor("report --help").out).at(0);
  const check::ProgramResult result =
      run_program("cd " + check::quoted(folder.path("")) + " && " +
                  replaced(example, "^tiltrotor", replaced(check::built("tiltrotor"), "\\$", "$$$$")));
  CHECK_EQ(result.exit_status, 0);
}

TEST(cli_help_examples_of_inputs_succeed) {
  const std::string help = run_tiltrotor("respond --help").out;
  const std::size_t begin = help.find("\nExamples: ") + 11;
  std::istringstream inputs(help.substr(begin, help.find('\n', begin) - begin));
  int count = 0;
  for (std::string input; inputs >> input; ++count)
    CHECK_EQ(run_tiltrotor("respond --speed 40 --duration 3 --input " + input).exit_status, 0);
  CHECK_EQ(count, 4);
}

// "--option NAME=VALUE (trim --help lists them)": every member of Options with its values, and each value is accepted.
TEST(cli_help_lists_the_switches_of_the_model) {
  const std::string help = run_tiltrotor("trim --help").out;
  CHECK(help.find("  tables=c1|linear|c2 ") != std::string::npos);
  const std::regex item("  ([a-z_]+)=(\\S+) +\\S.*");
  std::smatch match;
  int switches = 0;
  for (const std::string& line : lines_of(help)) {
    if (!std::regex_match(line, match, item)) continue;
    ++switches;
    const std::string first = replaced(match[2].str(), "(\\||\\.\\.).*", "");
    const check::ProgramResult result =
        run_tiltrotor("trim --speed 40 --option " + match[1].str() + "=" + first);
    if (!CHECK(result.exit_status != 2)) NOTE(result.err);
  }
  CHECK_EQ(switches, member_count<tiltrotor::Options>() + 1);  // and data_set, a name for two of them
  for (const char* command : {"linearize", "modes", "respond", "derivative", "loads", "rotor"})
    CHECK(run_tiltrotor(std::string(command) + " --help").out.find("  tables=c1|linear|c2 ") !=
          std::string::npos);
}

// The bounds of memory that the page of the tests names are those that `make budget` checks.
TEST(cli_help_bounds_of_the_readme_are_checked) {
  const std::string limits = file_text("tests/budget/limits.csv");
  const std::string readme = file_text("tests/README.md");
  const auto limit = [&](const std::string& name) {
    const std::size_t place = limits.find("\n" + name + ",");
    return std::strtod(limits.c_str() + place + name.size() + 2, nullptr);
  };
  const auto states = [&](const std::string& sentence) {
    if (!CHECK(replaced(readme, "\\s+", " ").find(sentence) != std::string::npos)) NOTE(sentence);
  };
  const auto kib = [&](const std::string& name) {
    return std::to_string(static_cast<int>(limit(name) / 1024)) + " KiB";
  };
  states(kib("code_and_constants") + " of ROM and " + kib("ram_with_stack") + " of RAM");
  double largest = 0;
  for (const std::string& line : lines_of(limits))
    if (line.compare(0, 14, "host_stack_tr_") == 0)
      largest = std::max(largest, limit(line.substr(0, line.find(','))));
  states("no call needs more than " + std::to_string(static_cast<int>(largest / 1024)) + " KiB of stack");
}
