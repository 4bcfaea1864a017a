// Any words after any command, one a line: matched with the options, read as numbers, sweeps, inputs and
// switches, but not run. Everything that is wrong is a UsageError of one line.
// Expected: the contract: a value or one line.
#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/flight_options.hpp"
#include "cli/help.hpp"
#include "cli/input_text.hpp"
#include "cli/linear_options.hpp"
#include "cli/shard.hpp"
#include "fuzz/target.hpp"

namespace {

using namespace tiltrotor::cli;

const std::vector<Command>& commands() {
  static const std::vector<Command> all = {
      trim_command(),  linearize_command(), modes_command(),  respond_command(),     derivative_command(),
      loads_command(), rotor_command(),     report_command(), conventions_command(), version_command()};
  return all;
}

bool has(const Command& command, const std::string& option) {
  for (const Option& o : command.options)
    if (o.name == option) return true;
  return false;
}

void read(const Command& command, const std::vector<std::string>& words) {
  const Arguments arguments(command.name, command.options, words);
  if (has(command, "--altitude")) {
    const SetupOptions setup(arguments);
    const auto c = setup.configuration(30);
    REQUIRE(c.aircraft != nullptr);
  }
  if (has(command, "--climb")) REQUIRE(!flight_cases(arguments).empty());
  if (has(command, "--reduce")) (void)wants_rigid(arguments);
  if (has(command, "--control-set")) (void)control_set(arguments);
  if (has(command, "--shard") && arguments.given("--shard")) {
    const Shard shard = parse_shard(arguments.text("--shard", ""), arguments.where("--shard"));
    REQUIRE(shard.begin(1000) <= shard.end(1000) && shard.end(1000) <= 1000);
  }
  for (const std::string& text : arguments.texts("--input"))
    REQUIRE(tiltrotor::is_valid(parse_input(text, arguments.where("--input"))));
}

}  // namespace

FUZZ_TARGET(command_line) {
  fuzz::Bytes in(data, size);
  std::vector<std::string> words = split(in.rest(), '\n');
  const std::string name = words.front();
  words.erase(words.begin());
  for (const Command& command : commands()) {
    if (name != command.name) continue;
    try {
      read(command, words);
    } catch (const UsageError& error) {
      const std::string message = error.what();
      REQUIRE(!message.empty() && message.find('\n') == std::string::npos);
    }
  }
}
