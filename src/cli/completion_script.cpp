#include "cli/completion_script.hpp"

#include <algorithm>
#include <set>

#include "cli/model_options.hpp"
#include "cli/named_outputs.hpp"
#include "cli/sensitivity_parameters.hpp"
#include "cli/targeted_trim.hpp"
#include "cli/trim_columns.hpp"
#include "cli/units.hpp"
#include "text/csv_line.hpp"
#include "tiltrotor/systems/system_state.hpp"

namespace tiltrotor::cli {

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::string without_parentheses(const std::string& text) {
  std::string out;
  int depth = 0;
  for (const char c : text) {
    depth += c == '(';
    if (depth == 0) out += c;
    depth -= c == ')';
  }
  return out;
}

bool is_word(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

// "a, b or c"; nothing where the text is more than words.
std::vector<std::string> listed_words(const std::string& text) {
  std::vector<std::string> words;
  for (const std::string& part : split(replaced(text, " or ", ","), ',')) {
    const std::string word(csv::trimmed(part));
    if (word.empty()) continue;
    if (!is_word(word)) return {};
    words.push_back(word);
  }
  return words;
}

// What stands for a value that is one of some words.
const std::set<std::string> worded_values = {"KIND", "STATE", "SET", "WHAT", "NAME", "SHELL"};

// Names that options of these commands take beside what their help lists.
std::vector<std::string> named_values(const std::string& command, const std::string& option) {
  std::vector<std::string> names;
  if (option == "--to" && command == "sensitivity") {
    names.emplace_back("all");
    for (const SensitivityParameter& parameter : sensitivity_parameters()) names.emplace_back(parameter.name);
  } else if (option == "--from") {
    for (int j = 0; j < vehicle_input_count; ++j) names.emplace_back(vehicle_input(j).name);
  } else if (option == "--hold" || (option == "--columns" && command == "trim")) {
    names = option == "--hold" ? held_quantities() : trim_columns();
    for (const std::string& output : output_names())
      if (std::find(names.begin(), names.end(), output) == names.end()) names.push_back(output);
  } else if (option == "--outputs" || option == "--columns" || option == "--to") {
    names = output_names();
    if (option == "--to") names.emplace_back("psi");
  }
  return names;
}

// Whether the value is a list.
bool takes_several(const Option& option) {
  const std::string value = option.value;
  return value == "NAMES" || value.find(",..") != std::string::npos;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

// A branch of `case`: what matches, and what is then done.
std::string branch(const std::string& pattern, const std::string& action) {
  return "    " + pattern + ") " + action + " ;;\n";
}

// By what follows an option, whatever the command.
std::string value_branches(const std::vector<Command>& commands) {
  std::set<std::string> files, folders, others;
  std::string words;
  for (const Command& command : commands)
    for (const Option& option : command.options) {
      const std::string value = option.value;
      const std::vector<std::string> choices = words_of_value(command.name, option);
      if (!choices.empty())
        words += branch(std::string("\"") + command.name + " " + option.name + "\"",
                        "choices='" + joined(choices) + "'" + (takes_several(option) ? " several=yes" : "") +
                            (value.rfind("NAME=", 0) == 0 ? " tail='='" : ""));
      if (value.empty() || !choices.empty()) continue;
      (value == "FILE" ? files : value == "DIR" ? folders : others).insert(option.name);
    }
  // --output DIR of one command is --output FILE of the others: files include folders.
  for (const std::string& file : files) folders.erase(file);
  const auto any_of = [](const std::set<std::string>& names) {
    std::string pattern;
    for (const std::string& name : names) pattern += (pattern.empty() ? "*\" " : "|*\" ") + name + "\"";
    return pattern;
  };
  const std::string offer = " -- \"$word\")); return";
  return words + branch(any_of(files), "COMPREPLY=($(compgen -f" + offer) +
         branch(any_of(folders), "COMPREPLY=($(compgen -d" + offer) + branch(any_of(others), "return");
}

std::string switch_branches() {
  std::string text;
  for (const auto& [name, values] : model_option_values())
    text += branch(
        "*\" --option " + name + "\"",
        "choices='" + (values.find("..") == std::string::npos ? replaced(values, "|", " ") : "") + "'");
  return text;
}

}  // namespace

std::vector<std::string> words_of_value(const std::string& command, const Option& option) {
  const std::string value = option.value, name = option.name;
  const std::vector<std::string> named = named_values(command, name);
  if (!named.empty()) return named;
  if (name == "--units") return unit_words();
  if (name == "--option") {
    std::vector<std::string> names;
    for (const auto& [word, values] : model_option_values()) names.push_back(word);
    return names;
  }
  for (const auto& [word, values] : model_option_values())
    if (name == "--" + word) return split(values, '|');
  if (value.find('|') != std::string::npos) return split(value, '|');
  if (worded_values.count(value) == 0) return {};
  std::vector<std::string> words;
  for (const std::string& part : split(without_parentheses(replaced(option.help, "\n", " ")), ';')) {
    const std::size_t colon = part.find(':');
    std::vector<std::string> some = listed_words(part.substr(0, colon));
    if (some.empty() && colon != std::string::npos) some = listed_words(part.substr(colon + 1));
    words.insert(words.end(), some.begin(), some.end());
  }
  return words;
}

std::string bash_completion(const std::vector<Command>& commands) {
  std::vector<std::string> names;
  std::string options;
  for (const Command& command : commands) {
    names.emplace_back(command.name);
    std::vector<std::string> words = {"--help"};
    for (const Option& option : command.options) words.emplace_back(option.name);
    options += branch(command.name, "choices='" + joined(words) + "'");
  }
  return "# Completion of tiltrotor in bash: source it, or store it in a folder of completions.\n"
         "_tiltrotor() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} i=$((COMP_CWORD - 1)) choices='' several='' head='' tail=''\n"
         "  COMPREPLY=()\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    COMPREPLY=($(compgen -W '" +
         joined(names) +
         " help --help --version' -- \"$word\")); return\n"
         "  fi\n"
         "  local command=${COMP_WORDS[1]}\n"
         "  if [ \"$command\" = completion ]; then COMPREPLY=($(compgen -W 'bash zsh' -- \"$word\")); return; fi\n"
         "  if [ \"$command\" = help ]; then COMPREPLY=($(compgen -W '" +
         joined(names) +
         "' -- \"$word\")); return; fi\n"
         "  # bash takes = for a word of its own\n"
         "  if [ \"$word\" = = ]; then word=''; i=$COMP_CWORD; fi\n"
         "  local equals=''\n"
         "  if [ \"${COMP_WORDS[i]}\" = = ]; then equals=yes; i=$((i - 1)); fi\n"
         "  local before=${COMP_WORDS[i]}\n"
         "  if [ -n \"$equals\" ]; then case $before in\n"
         "    --*) ;;\n"
         "    *) before=\"--option $before\" ;;\n"
         "  esac; fi\n"
         "  case \"$command $before\" in\n" +
         switch_branches() + value_branches(commands) +
         "    *) [ -z \"$equals\" ] || return ;;\n"
         "  esac\n"
         "  if [ -z \"$choices\" ]; then case $command in\n" +
         options +
         "  esac; fi\n"
         "  if [ -n \"$several\" ]; then case $word in *,*) head=${word%,*},; word=${word##*,} ;; esac; fi\n"
         "  COMPREPLY=($(compgen -P \"$head\" -S \"$tail\" -W \"$choices\" -- \"$word\"))\n"
         "  # a value follows at once; zsh has no compopt\n"
         "  if [ -n \"$tail\" ]; then compopt -o nospace 2>/dev/null; fi\n"
         "}\n"
         "complete -F _tiltrotor tiltrotor\n";
}

std::string zsh_completion(const std::vector<Command>& commands) {
  return "autoload -U +X compinit && compinit\nautoload -U +X bashcompinit && bashcompinit\n" +
         bash_completion(commands);
}

}  // namespace tiltrotor::cli
