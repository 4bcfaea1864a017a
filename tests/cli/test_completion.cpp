// What the shell is offered. Expected: the commands, options and values that --help lists.
#include <sstream>
#include <string>
#include <vector>

#include "check.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"

using check::run_program;
using check::run_tiltrotor;

namespace {

// Words that begin lines indented by two blanks, after the line `from` of a help.
std::vector<std::string> listed(const std::string& help, const std::string& beginning) {
  std::vector<std::string> words;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("Switches of the model", 0) == 0) break;
    if (line.rfind("  " + beginning, 0) != 0 || line.size() < 3 || line[2] == ' ') continue;
    words.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return words;
}

// What bash offers for the last of the words.
std::string offered(const std::string& words) {
  std::string array;
  std::istringstream in(words);
  int count = 0;
  for (std::string word; in >> word; ++count) array += " " + check::quoted(word == "EMPTY" ? "" : word);
  const check::ProgramResult result = run_program(
      "bash -c " +
      check::quoted("source <(" + check::built("tiltrotor") + " completion bash); COMP_WORDS=(" + array +
                    "); COMP_CWORD=" + std::to_string(count - 1) + "; _tiltrotor; echo \"${COMPREPLY[*]}\""));
  return result.err + result.out;
}

bool has_bash() { return run_program("command -v bash").exit_status == 0; }

bool has_word(const std::string& text, const std::string& word) {
  return (" " + text.substr(0, text.find('\n')) + " ").find(" " + word + " ") != std::string::npos;
}

}  // namespace

TEST(cli_completion_knows_every_command_and_option) {
  const check::ProgramResult script = run_tiltrotor("completion bash");
  CHECK_EQ(script.exit_status, 0);
  CHECK_EQ(script.err, "");
  const std::vector<std::string> commands = listed(run_tiltrotor("--help").out, "");
  CHECK_LE(std::size_t{17}, commands.size());
  const std::size_t beginning = script.out.find("-W '") + 4;
  const std::string names = script.out.substr(beginning, script.out.find('\'', beginning) - beginning);
  for (const std::string& command : commands) {
    CHECK(has_word(names, command));
    const std::string begin = "\n    " + command + ") choices='";
    const std::size_t place = script.out.find(begin);
    CHECK(place != std::string::npos);
    if (place == std::string::npos) continue;
    const std::size_t from = place + begin.size();
    const std::string options = script.out.substr(from, script.out.find('\'', from) - from);
    for (const std::string& option : listed(run_tiltrotor(command + " --help").out, "--"))
      CHECK(has_word(options, option));
  }
}

TEST(cli_completion_offers_commands_options_and_values) {
  if (!has_bash()) return;
  CHECK_EQ(offered("tiltrotor sens"), "sensitivity\n");
  CHECK_EQ(offered("tiltrotor trim --alt"), "--altitude\n");
  CHECK_EQ(offered("tiltrotor trim --mast 0 --form"), "--format\n");
  CHECK_EQ(offered("tiltrotor trim --format EMPTY"), "table csv json\n");
  CHECK_EQ(offered("tiltrotor trim --format = j"), "json\n");
  CHECK_EQ(offered("tiltrotor linearize --format ma"), "matlab\n");
  CHECK_EQ(offered("tiltrotor modes --show ="), "modes shapes\n");
  CHECK_EQ(offered("tiltrotor trim --grid r"), "realtime\n");
  CHECK_EQ(offered("tiltrotor trim --preset EMPTY"), "reference\n");
  CHECK_EQ(offered("tiltrotor trim --option gov"), "governor=\n");
  CHECK_EQ(offered("tiltrotor trim --option governor ="), "off ideal pi\n");
  CHECK_EQ(offered("tiltrotor qualities --category EMPTY"), "A B C\n");
  CHECK_EQ(offered("tiltrotor trim --units kn"), "knots\n");
  CHECK_EQ(offered("tiltrotor trim --mast EMPTY"), "\n");
  // Names of outputs, columns, inputs and parameters, one after another.
  CHECK_EQ(offered("tiltrotor linearize --outputs load_f"), "load_factor\n");
  CHECK_EQ(offered("tiltrotor qlpv --outputs nz,airsp"), "nz,airspeed\n");
  CHECK_EQ(offered("tiltrotor trim --columns pitch_deg,power_k"), "pitch_deg,power_kw\n");
  CHECK_EQ(offered("tiltrotor trim --columns htail_force_"), "htail_force_x htail_force_y htail_force_z\n");
  CHECK_EQ(offered("tiltrotor fly --columns htail_moment_y,nz,ny"), "htail_moment_y,nz,ny\n");
  CHECK_EQ(offered("tiltrotor trim --hold power_k"), "power_kw=\n");
  CHECK_EQ(offered("tiltrotor trim --hold power_kw ="), "\n");
  CHECK_EQ(offered("tiltrotor trim --free clim"), "climb_deg\n");
  CHECK_EQ(offered("tiltrotor bode --from long_"), "long_stick long_cyclic\n");
  CHECK_EQ(offered("tiltrotor bode --to q,ps"), "q,psi\n");
  CHECK_EQ(offered("tiltrotor sensitivity --to mass,tail_inc"), "mass,tail_incidence\n");
  // Not where one word alone is taken.
  CHECK_EQ(offered("tiltrotor trim --format csv,j"), "\n");
  CHECK_EQ(offered("tiltrotor help lin"), "linearize\n");
  CHECK_EQ(offered("tiltrotor completion EMPTY"), "bash zsh\n");
}

// bash itself says what it was asked for: no blank follows a name whose value does.
TEST(cli_completion_leaves_no_blank_before_a_value) {
  if (!has_bash()) return;
  const auto blank = [](const std::string& words) {
    const std::string before = "compopt() { echo \"$*\"; }; _tiltrotor_blank() { source <(" +
                               check::built("tiltrotor") + " completion bash); COMP_WORDS=(" + words +
                               "); COMP_CWORD=3; _tiltrotor; }; _tiltrotor_blank";
    return run_program("bash -c " + check::quoted(before)).out;
  };
  CHECK_EQ(blank("tiltrotor trim --hold power_k"), "-o nospace\n");
  CHECK_EQ(blank("tiltrotor trim --option gov"), "-o nospace\n");
  CHECK_EQ(blank("tiltrotor trim --free clim"), "");
}

TEST(cli_completion_offers_files) {
  if (!has_bash()) return;
  const check::ScratchFolder folder;
  const std::string file = folder.write("states.csv", "x\n");
  CHECK_EQ(offered("tiltrotor derivative --states " + folder.path("st")), file + "\n");
}

// Runs under zsh where that is installed; the script is the same.
TEST(cli_completion_of_zsh_is_that_of_bash) {
  const std::string zsh = run_tiltrotor("completion zsh").out, bash = run_tiltrotor("completion bash").out;
  CHECK_LT(bash.size(), zsh.size());
  CHECK_EQ(zsh.substr(zsh.size() - bash.size()), bash);
  CHECK(zsh.find("bashcompinit") != std::string::npos);
  CHECK_EQ(run_tiltrotor("completion fish").exit_status, 2);
  CHECK_EQ(run_tiltrotor("completion fish").err,
           "tiltrotor: completion: --shell: 'fish' is not one of bash or zsh\n");
}
