#include "cli/flight_script.hpp"

#include <algorithm>
#include <cmath>

#include "cli/arguments.hpp"
#include "cli/errors.hpp"
#include "cli/line_reader.hpp"
#include "text/csv_line.hpp"
#include "text/nearest.hpp"
#include "text/number.hpp"

namespace tiltrotor::cli {

namespace {

constexpr Range kScriptTimes{0, 3600, "s"};
constexpr std::size_t kMostEvents = 100000;

using Words = std::vector<std::string>;

// Up to a comment.
Words words_of_line(std::string_view line) {
  Words words;
  line = line.substr(0, line.find('#'));
  while (!(line = csv::trimmed(line)).empty()) {
    const std::size_t end = std::min(line.find_first_of(csv::kBlanks), line.size());
    words.emplace_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

Words words_of_name(const std::string& name) { return words_of_line(name); }

// The row whose name begins at the second word.
const ScriptRule& find_rule(const Words& words, const std::string& where) {
  Words firsts, seconds;
  for (const ScriptRule& rule : script_rules()) {
    const Words name = words_of_name(rule.name);
    const bool begins = words[1] == name[0];
    if (begins && (name.size() == 1 || (words.size() > 2 && words[2] == name[1]))) return rule;
    if (begins) seconds.push_back(name[1]);
    if (std::find(firsts.begin(), firsts.end(), name[0]) == firsts.end()) firsts.push_back(name[0]);
  }
  if (seconds.empty())
    throw UsageError(where + ": unknown command " + quoted(words[1]) + did_you_mean(words[1], firsts) +
                     "; give " + one_of(firsts));
  const std::string what =
      words.size() > 2 ? quoted(words[2]) + did_you_mean(words[2], seconds) + " is not" : "give";
  throw UsageError(where + ": " + words[1] + ": " + what + " " + one_of(seconds));
}

// "40", "80kt": of the first unit where none is written.
double read_script_number(const std::string& text, const ScriptArgument& argument, const std::string& where) {
  if (argument.kind == ScriptArgument::Kind::whole)
    return static_cast<double>(
        parse_integer(text, where, static_cast<long>(argument.low), static_cast<long>(argument.high)));
  const double rounding = 1e-9 * std::fmax(std::fabs(argument.low), std::fabs(argument.high));
  const auto within_range = [&](double number, std::size_t unit) {
    const double value = number * argument.units[unit].size;
    if (value < argument.low - rounding || value > argument.high + rounding)
      throw UsageError(where + ": " + quoted(text) + " lies outside " + range_text(argument, unit));
    return std::clamp(value, argument.low, argument.high);
  };
  double number = 0;
  if (read_number(text, number)) return within_range(number, 0);
  std::string units;
  std::vector<std::string> names;
  for (std::size_t unit = 0; unit < argument.units.size(); ++unit) {
    const std::string name = argument.units[unit].name;
    const std::size_t digits = text.size() - std::min(name.size(), text.size());
    if (text.substr(digits) == name && read_number(text.substr(0, digits), number))
      return within_range(number, unit);
    names.push_back(name);
    units += (units.empty() ? "" : " or ") + name;
  }
  const std::string sign = text.substr(text.find_last_of("0123456789.") + 1);  // npos + 1 is 0
  throw UsageError(where + ": " + quoted(text) + " is not a number" +
                   (units.empty() ? "" : ", alone or with " + units + did_you_mean(sign, names)) + "; give " +
                   range_text(argument));
}

// A name counts from the folder of the script.
std::string series_path(const std::string& script, const std::string& name) {
  if (script == "-" || name[0] == '/') return name;
  return script.substr(0, script.rfind('/') + 1) + name;  // npos + 1 is 0
}

class ScriptReader {
 public:
  explicit ScriptReader(const std::string& path) : ScriptReader(path, LineReader(path)) {}
  ScriptReader(const std::string& path, LineReader lines) : path_(path), lines_(std::move(lines)) {
    script_.path = lines_.path();
  }

  FlightScript read() {
    std::string line;
    while (lines_.next(line)) {
      if (lines_.number() == 1 && line.compare(0, 3, "\xef\xbb\xbf") == 0) line.erase(0, 3);
      if (line.find('\0') != std::string::npos || !csv::is_utf8(line))
        throw UsageError(lines_.where() + ": the text is not UTF-8");
      const Words words = words_of_line(line);
      if (!words.empty()) add(words);
    }
    if (script_.events.empty() || script_.events.back().command != ScriptCommand::end)
      throw UsageError(script_.path + ":" + std::to_string(lines_.number()) +
                       ": the script has no `end`; give TIME end, which says how long the flight is");
    return script_;
  }

 private:
  void add(const Words& words) {
    const std::string where = lines_.where();
    if (!script_.events.empty() && script_.events.back().command == ScriptCommand::end)
      throw UsageError(where + ": a command after the `end` in line " +
                       std::to_string(script_.events.back().line));
    if (script_.events.size() == kMostEvents)
      throw UsageError(where + ": more than " + std::to_string(kMostEvents) + " commands");
    ScriptEvent event{};
    event.time = parse_number(words[0], where + ": time", kScriptTimes);
    event.line = lines_.number();
    if (!script_.events.empty() && event.time < script_.events.back().time)
      throw UsageError(where + ": time: " + words[0] + " s lies before the " +
                       number_text(script_.events.back().time) + " s of line " +
                       std::to_string(script_.events.back().line) + "; give " +
                       text::range_text({script_.events.back().time, kScriptTimes.high, "s"}));
    if (words.size() == 1)
      throw UsageError(where + ": no command after the time; `tiltrotor fly --help` lists them");
    const ScriptRule& rule = find_rule(words, where);
    event.command = rule.command;
    event.control = rule.control;
    std::size_t place = 1 + words_of_name(rule.name).size();
    for (const ScriptArgument& argument : rule.arguments) {
      const std::string at = where + ": " + rule.name + " " + argument.name;
      if (place < words.size()) {
        fill(event, argument, words[place++], at);
      } else if (!argument.is_optional) {
        throw UsageError(at + ": is missing; give " + range_text(argument));
      }
    }
    if (place < words.size())
      throw UsageError(where + ": " + quoted(words[place]) + " is one too many; give " + usage_text(rule));
    script_.events.push_back(event);
    if (event.command == ScriptCommand::series) add_series(words[2], event.word == 1, where);
  }

  // A file that is not there is what the line of the script is wrong about.
  void add_series(const std::string& name, bool is_held, const std::string& where) {
    const std::string path = series_path(path_, name), unread = path + ": cannot be read";
    try {
      script_.series.push_back(read_input_series(path, is_held));
    } catch (const UsageError& error) {
      const std::string what = error.what();
      throw UsageError(what.compare(0, unread.size(), unread) == 0 ? where + ": series FILE: " + what : what);
    }
  }

  void fill(ScriptEvent& event, const ScriptArgument& argument, const std::string& text,
            const std::string& where) {
    switch (argument.kind) {
      case ScriptArgument::Kind::number:
      case ScriptArgument::Kind::whole:
        event.number[event.count++] = read_script_number(text, argument, where);
        return;
      case ScriptArgument::Kind::word:
        event.word = place_of(text, argument.words, where);
        return;
      case ScriptArgument::Kind::file:
        event.series = script_.series.size();
        return;
    }
  }

  std::string path_;
  LineReader lines_;
  FlightScript script_;
};

}  // namespace

const ScriptRule& rule_of(const ScriptEvent& event) {
  const std::vector<ScriptRule>& rules = script_rules();
  return *std::find_if(rules.begin(), rules.end(), [&](const ScriptRule& rule) {
    return rule.command == event.command && rule.control == event.control;
  });
}

FlightScript read_flight_script(const std::string& path) { return ScriptReader(path).read(); }
FlightScript read_flight_script_text(const std::string& name, const std::string& text) {
  return ScriptReader(name, LineReader(name, text)).read();
}

}  // namespace tiltrotor::cli
