#include "cli/arguments.hpp"

#include <algorithm>

#include "cli/config_file.hpp"
#include "cli/errors.hpp"
#include "text/nearest.hpp"

namespace tiltrotor::cli {

namespace {

const Option* find(const OptionList& options, const std::string& name) {
  const auto place =
      std::find_if(options.begin(), options.end(), [&](const Option& option) { return option.name == name; });
  return place == options.end() ? nullptr : &*place;
}

std::vector<std::string> names_of(const OptionList& options) {
  std::vector<std::string> names = {"--help"};
  for (const Option& option : options) names.emplace_back(option.name);
  return names;
}

std::string choices(const OptionList& options) {
  if (options.empty()) return "the command takes no options";
  std::string text = "options are";
  for (const Option& option : options) text += std::string(" ") + option.name;
  return text;
}

}  // namespace

OptionList operator+(OptionList a, const OptionList& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::string options_help(const OptionList& options) {
  constexpr std::size_t help_column = 26;
  std::string text;
  for (const Option& option : options) {
    std::string line = std::string("  ") + option.name;
    if (*option.value != '\0') line += std::string(" ") + option.value;
    for (const std::string& help : split(option.help, '\n')) {
      if (line.size() + 1 > help_column) {
        text += line + "\n";
        line.clear();
      }
      line.resize(help_column, ' ');
      text += line + help + "\n";
      line.clear();
    }
  }
  return text;
}

std::string one_of(const std::vector<std::string>& choices) {
  std::string text;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (i > 0) text += i + 1 == choices.size() ? " or " : ", ";
    text += choices[i];
  }
  return text;
}

std::size_t place_of(const std::string& word, const std::vector<std::string>& choices,
                     const std::string& where) {
  const auto place = std::find(choices.begin(), choices.end(), word);
  if (place == choices.end())
    throw UsageError(where + ": " + quoted(word) + did_you_mean(word, choices) + " is not one of " +
                     one_of(choices));
  return static_cast<std::size_t>(place - choices.begin());
}

Arguments::Arguments(const std::string& command, const OptionList& options,
                     const std::vector<std::string>& words)
    : command_(command) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    if (name.compare(0, 2, "--") != 0) {
      throw UsageError(command + ": unexpected argument " + quoted(word) +
                       did_you_mean(name, names_of(options)) + "; " + choices(options));
    }
    const Option& option = option_of(name, options, command);
    if (given(name) && !option.repeatable) throw UsageError(where(name) + ": given more than once");
    const bool is_flag = *option.value == '\0';
    if (is_flag && equals != std::string::npos) throw UsageError(where(name) + ": takes no value");
    if (is_flag) {
      given_.push_back({name, "", ""});
    } else if (equals != std::string::npos) {
      given_.push_back({name, word.substr(equals + 1), ""});
    } else if (i + 1 < words.size()) {
      given_.push_back({name, words[++i], ""});
    } else {
      throw UsageError(where(name) + ": a value " + option.value + " must follow");
    }
  }
  if (given("--config")) take_config(options);
  if (given("--units")) units_ = Units(text("--units", ""), where("--units"));
}

const Option& Arguments::option_of(const std::string& name, const OptionList& options,
                                   const std::string& where) const {
  const Option* const option = find(options, name);
  if (option == nullptr)
    throw UsageError(where + ": unknown option " + name + did_you_mean(name, names_of(options)) + "; " +
                     choices(options));
  return *option;
}

void Arguments::take_config(const OptionList& options) {
  const std::vector<Given> here = given_;
  for (const ConfigLine& line : read_config(text("--config", ""))) {
    const std::string in = command_ + ": " + line.where;
    const Option& option = option_of(line.name, options, in);
    if (line.name == "--config") throw UsageError(in + ": --config: a file cannot name another");
    const auto is_it = [&](const Given& g) { return g.name == line.name; };
    if (std::any_of(here.begin(), here.end(), is_it)) continue;
    const std::string where = in + ": " + line.name;
    if (given(line.name) && !option.repeatable) throw UsageError(where + ": given more than once");
    const bool is_flag = *option.value == '\0';
    if (is_flag && line.has_value) throw UsageError(where + ": takes no value");
    if (!is_flag && !line.has_value) throw UsageError(where + ": a value " + option.value + " must follow");
    given_.push_back({line.name, line.value, line.where});
  }
}

std::string Arguments::where(const std::string& name) const {
  const auto place =
      std::find_if(given_.begin(), given_.end(), [&](const Given& g) { return g.name == name; });
  const bool in_file = place != given_.end() && !place->where.empty();
  return command_ + ": " + (in_file ? place->where + ": " : "") + name;
}

std::string Arguments::line() const {
  const auto is_plain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           std::string_view("_-+.,:/=@").find(c) != std::string_view::npos;
  };
  std::string line = command_;
  for (const Given& g : given_) {
    if (g.name == "--config" || g.name == "--output" || g.name == "--shard" || g.name == "--stamp") continue;
    line += " " + g.name;
    if (g.value.empty()) continue;
    std::string word;
    for (const char c : g.value) word += c == '\'' ? "'\\''" : std::string(1, c < ' ' && c >= 0 ? '?' : c);
    const bool plain = std::all_of(g.value.begin(), g.value.end(), is_plain);
    line += plain ? " " + word : " '" + word + "'";
  }
  return line;
}

bool Arguments::given(const std::string& name) const {
  return std::any_of(given_.begin(), given_.end(), [&](const Given& g) { return g.name == name; });
}

std::vector<std::string> Arguments::texts(const std::string& name) const {
  std::vector<std::string> values;
  for (const Given& g : given_) {
    if (g.name == name) values.push_back(g.value);
  }
  return values;
}

std::string Arguments::text(const std::string& name, const std::string& otherwise) const {
  const std::vector<std::string> values = texts(name);
  return values.empty() ? otherwise : values.back();
}

double Arguments::number(const std::string& name, double otherwise, const Range& range) const {
  return given(name) ? units_.number(text(name, ""), where(name), range) : otherwise;
}

std::vector<double> Arguments::sweep(const std::string& name, const std::string& otherwise,
                                     const Range& range) const {
  // What is not given stands in the unit of the range.
  return given(name) ? units_.sweep(text(name, ""), where(name), range)
                     : parse_sweep(otherwise, where(name), range);
}

std::size_t Arguments::choice(const std::string& name, const std::string& otherwise,
                              const std::vector<std::string>& choices) const {
  const std::string word = text(name, otherwise);
  return place_of(word, choices, where(name));
}

}  // namespace tiltrotor::cli
