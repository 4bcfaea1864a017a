// The command line program: finds the command, runs it, turns errors into a line on stderr and an exit
// status.

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/help.hpp"
#include "text/nearest.hpp"
#include "text/sink.hpp"

namespace tiltrotor::cli {

namespace {

int print(const std::string& text) {
  Sink sink("-", "");
  sink.write(text);
  sink.finish();
  return exit_success;
}

const Command& find_command(const std::vector<Command>& commands, const std::string& name) {
  const auto place = std::find_if(commands.begin(), commands.end(),
                                  [&](const Command& command) { return command.name == name; });
  if (place != commands.end()) return *place;
  std::vector<std::string> names;
  for (const Command& command : commands) names.emplace_back(command.name);
  std::vector<std::string> near = names;
  near.emplace_back("help");
  throw UsageError(
      (name.empty() ? "a command is needed" : "unknown command " + quoted(name) + did_you_mean(name, near)) +
      "; choose " + one_of(names));
}

bool asks_for_help(const std::string& word) { return word == "--help" || word == "-h"; }

int run(std::vector<std::string> words) {
  const std::vector<Command> commands = all_commands();
  const std::string first = words.empty() ? "" : words.front();
  if (asks_for_help(first) || (first == "help" && words.size() == 1)) return print(general_help(commands));
  if (first == "help") std::rotate(words.begin(), words.begin() + 1, words.end());
  if (first == "--version") words.front() = "version";

  const Command& command = find_command(commands, words.empty() ? "" : words.front());
  words.erase(words.begin());
  const bool names_shell = first == "completion" && !words.empty() && words[0].rfind('-', 0) != 0;
  if (names_shell) words[0].insert(0, "--shell=");
  if (first == "help" || std::any_of(words.begin(), words.end(), asks_for_help))
    return print(command_help(command));
  return command.run(Arguments(command.name, command.options, words));
}

// A message stays one line that can be read, whatever text of the user it repeats.
void complain(const std::string& message) {
  constexpr std::size_t longest_word = 1000;
  std::string line;
  std::size_t word = 0;
  for (const char c : message) {
    word = c == ' ' ? 0 : word + 1;
    if (word == longest_word) line += "...";
    if (word < longest_word) line += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  }
  std::fprintf(stderr, "tiltrotor: %s\n", line.c_str());
}

}  // namespace

}  // namespace tiltrotor::cli

int main(int count, char** arguments) {
  using namespace tiltrotor::cli;
  // A reader that leaves early and a file that may not grow are errors of writing, which clean up, not a
  // silent death.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  clean_up_when_interrupted();
  try {
    return run(std::vector<std::string>(arguments + std::min(count, 1), arguments + count));
  } catch (const UsageError& error) {
    complain(error.what());
    return exit_bad_usage;
  } catch (const ReaderLeft&) {
    return exit_case_failed;
  } catch (const std::exception& error) {
    complain(error.what());
    return exit_case_failed;
  }
}
