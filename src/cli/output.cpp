#include "cli/output.hpp"

#include <algorithm>

#include <utility>

#include "cli/errors.hpp"
#include "text/rounding.hpp"

namespace tiltrotor::cli {

namespace {

Format chosen_format(const Arguments& arguments, const Sink& sink) {
  const bool table = sink.is_terminal() && !arguments.given("--shard");
  return static_cast<Format>(arguments.choice("--format", table ? "table" : "csv", {"table", "csv", "json"}));
}

}  // namespace

Option output_option() { return {"--output", "FILE", "write here instead of to standard output"}; }

Option shard_option() {
  return {"--shard", "K/N", "only part K of N; the CSV of all parts in order is the whole"};
}

OptionList Output::list() {
  return {
      {"--format", "KIND", "table, csv or json (table on a terminal, else csv)"},
      output_option(),
      shard_option(),
  };
}

OptionList Output::list_of_one_piece() {
  OptionList list = Output::list();
  list.erase(std::remove_if(list.begin(), list.end(),
                            [](const Option& option) { return option.name == std::string("--shard"); }),
             list.end());
  return list;
}

Output::Output(const Arguments& arguments)
    : sink_(arguments.text("--output", "-"), arguments.where("--output")),
      format_(chosen_format(arguments, sink_)),
      shard_(parse_shard(arguments.text("--shard", "1/1"), arguments.where("--shard"))) {
  if (shard_.parts > 1 && format_ != Format::csv) {
    throw UsageError(arguments.where("--shard") + ": parts can be joined with --format csv only");
  }
}

Records Output::records(std::vector<std::string> columns, int digits) {
  return Records(sink_, format_, std::move(columns), digits, digits == to_read ? kUsualTerms : 0,
                 shard_.first());
}

}  // namespace tiltrotor::cli
