// Help of every command, conventions, version.
// Expected: the list of commands, the names in the C header.
#include <sstream>

#include "check.hpp"
#include "run_program.hpp"
#include "tiltrotor/tiltrotor.h"

using check::run_program;
using check::run_tiltrotor;

namespace {

const char* const commands[] = {"trim",        "linearize", "modes",        "bode",       "qualities",
                                "performance", "respond",   "fly",          "derivative", "loads",
                                "rotor",       "report",    "conventions",  "completion", "version",
                                "sensitivity", "qlpv",      "interpolation"};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(cli_help_names_every_command) {
  const check::ProgramResult help = run_tiltrotor("--help");
  CHECK_EQ(help.exit_status, 0);
  CHECK_EQ(help.err, std::string());
  for (const char* command : commands) CHECK(contains(help.out, std::string("\n  ") + command + " "));
  CHECK(contains(help.out, "Example: tiltrotor"));
}

TEST(cli_every_command_explains_itself) {
  for (const char* command : commands) {
    const check::ProgramResult help = run_tiltrotor(std::string(command) + " --help");
    CHECK_EQ(help.exit_status, 0);
    CHECK_EQ(help.err, std::string());
    CHECK(contains(help.out, std::string("usage: tiltrotor ") + command));
    CHECK(contains(help.out, std::string("Example: tiltrotor ") + command));
    CHECK_EQ(run_tiltrotor(std::string("help ") + command).out, help.out);
  }
}

TEST(cli_help_lists_the_common_options) {
  const std::string help = run_tiltrotor("trim --help").out;
  for (const char* option :
       {"--mast", "--speed", "--altitude", "--flap", "--climb", "--sideslip", "--turn-rate", "--mass",
        "--cg-sl", "--rotor-rpm", "--tables", "--grid", "--option", "--format", "--output", "--shard"}) {
    CHECK(contains(help, std::string("\n  ") + option + " "));
  }
}

TEST(cli_version_tells_the_differentiation) {
  CHECK(contains(run_tiltrotor("version").out, "automatic"));
  CHECK(contains(run_program(check::built("tiltrotor-nd") + " version").out, "numerical"));
  CHECK_EQ(run_tiltrotor("--version").out, run_tiltrotor("version").out);
}

TEST(cli_conventions_state_axes_and_stick) {
  const check::ProgramResult text = run_tiltrotor("conventions");
  CHECK_EQ(text.exit_status, 0);
  CHECK(contains(text.out, "x forward, y right, z down"));
  CHECK(contains(text.out, "0..9.6, neutral 4.8"));
}

// In the order of arrays, as the library tells them.
TEST(cli_conventions_name_every_state_and_input) {
  const std::string text = run_tiltrotor("conventions").out;
  std::istringstream words(text.substr(text.find("\nStates ") + 8));
  std::string word;
  for (int i = 0; i < TR_MAST; ++i) CHECK(words >> word && word == tr_state_name(i));
  CHECK(words >> word && word == "Systems");
  for (int i = TR_MAST; i < TR_STATES; ++i) CHECK(words >> word && word == tr_state_name(i));
  CHECK(words >> word && word == "Inputs");
  for (int j = 0; j < TR_CONTROLS; ++j) CHECK(words >> word && word == tr_control_name(j));
  CHECK(words >> word && word == "Commands");
  for (int j = TR_CONTROLS; j < TR_INPUTS; ++j) CHECK(words >> word && word == tr_control_name(j));
  CHECK(!(words >> word));
}
