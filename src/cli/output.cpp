#include "cli/output.hpp"

#include <algorithm>

#include <utility>

#include "cli/errors.hpp"
#include "cli/stamp.hpp"
#include "text/rounding.hpp"

namespace tiltrotor::cli {

namespace {

// In the order of Format.
const std::vector<std::string> kFormats = {"table", "csv", "json"};

Format chosen_format(const Arguments& arguments, const Sink& sink) {
  const bool table = sink.is_terminal() && !arguments.given("--shard");
  return static_cast<Format>(arguments.choice("--format", table ? "table" : "csv", kFormats));
}

}  // namespace

Option output_option() { return {"--output", "FILE", "write here instead of to standard output"}; }

Option units_option() {
  return {"--units", "A,B,..",
          "knots, feet, pounds, horsepower: of columns, and of options whose\n"
          "number is without unit (`--speed 80kt` has its own); matrices: SI"};
}

Option shard_option() {
  return {"--shard", "K/N", "only part K of N; the CSV of all parts in order is the whole"};
}

OptionList Output::list() {
  return {
      {"--format", "KIND", "table, csv or json (table on a terminal, else csv)"},
      output_option(),
      units_option(),
      stamp_option(),
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
      shard_(parse_shard(arguments.text("--shard", "1/1"), arguments.where("--shard"))),
      units_(arguments.units()),
      stamp_(stamp_of(arguments, kFormats[static_cast<std::size_t>(format_)])) {
  if (shard_.parts > 1 && format_ != Format::csv) {
    throw UsageError(arguments.where("--shard") + ": parts can be joined with --format csv only");
  }
}

Records Output::records(std::vector<std::string> columns, int digits) {
  std::vector<double> sizes;
  for (std::string& column : columns) {
    const InUnit shown = units_.column(column);
    column = shown.name;
    sizes.push_back(shown.size);
  }
  Records records(sink_, format_, std::move(columns), digits, digits == to_read ? kUsualTerms : 0,
                  shard_.first());
  records.divide_by(std::move(sizes));
  records.begin_with(stamp_);
  return records;
}

}  // namespace tiltrotor::cli
