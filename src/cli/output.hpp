// Options about the output, shared by the commands, and what they lead to.
#pragma once

#include "cli/arguments.hpp"
#include "cli/shard.hpp"
#include "text/records.hpp"

namespace tiltrotor::cli {

class Output {
 public:
  // Significant digits of CSV: enough to plot, with zero where a number is zero but for rounding, or enough
  // to compare two programs.
  static constexpr int to_read = 12;
  static constexpr int to_compare = 15;

  static OptionList list();
  // All but shards: of a flight.
  static OptionList list_of_one_piece();
  explicit Output(const Arguments& arguments);

  // Rows of this run, in the units chosen. With more than one shard only the first writes the header.
  Records records(std::vector<std::string> columns, int digits);
  const Shard& shard() const { return shard_; }

 private:
  Sink sink_;
  Format format_;
  Shard shard_;
  Units units_;
  std::string stamp_;
};

// The option alone, for commands with formats of their own.
Option output_option();
Option units_option();
Option shard_option();

}  // namespace tiltrotor::cli
