// The words after a command, matched with the options the command has.
#pragma once

#include <string>
#include <vector>

#include "cli/sweep.hpp"
#include "cli/units.hpp"

namespace tiltrotor::cli {

struct Option {
  const char* name;   // with its dashes: "--mast"
  const char* value;  // what stands for the value in the help, "DEG"; empty for a flag
  const char* help;   // one line, or several divided by '\n'
  bool repeatable = false;
};

using OptionList = std::vector<Option>;

OptionList operator+(OptionList a, const OptionList& b);

// Options with their help, aligned, ready to print.
std::string options_help(const OptionList& options);

// "a, b or c"
std::string one_of(const std::vector<std::string>& choices);

// Place of the word among the choices. Throws UsageError "<where>: ..." when it is none of them.
std::size_t place_of(const std::string& word, const std::vector<std::string>& choices,
                     const std::string& where);

// Accepts `--name value` and `--name=value`, and of the lines of --config those whose options are not given. Every error is a UsageError of one line.
class Arguments {
 public:
  Arguments(const std::string& command, const OptionList& options, const std::vector<std::string>& words);

  bool given(const std::string& name) const;
  // The text of an option, or the default when it is not given.
  std::string text(const std::string& name, const std::string& otherwise) const;
  std::vector<std::string> texts(const std::string& name) const;
  // In the unit of the range, whatever the unit it is given in.
  double number(const std::string& name, double otherwise, const Range& range) const;
  std::vector<double> sweep(const std::string& name, const std::string& otherwise, const Range& range) const;
  // Place of the given word among the choices.
  std::size_t choice(const std::string& name, const std::string& otherwise,
                     const std::vector<std::string>& choices) const;

  // Beginning of a message: "trim: --mast", of an option from a file "trim: FILE:LINE: --mast".
  std::string where(const std::string& name) const;
  const std::string& command() const { return command_; }
  // Command and options, those of a file too, as a shell reads them; without what does not change results.
  std::string line() const;
  // What --units chooses.
  const Units& units() const { return units_; }

 private:
  struct Given {
    std::string name;
    std::string value;
    std::string where;  // in which file; empty on the command line
  };
  // Throws UsageError "<where>: ..." for a name that is none.
  const Option& option_of(const std::string& name, const OptionList& options, const std::string& where) const;
  void take_config(const OptionList& options);

  std::string command_;
  std::vector<Given> given_;
  Units units_;
};

}  // namespace tiltrotor::cli
