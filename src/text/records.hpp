// Rows of named columns, as CSV, JSON or an aligned table.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "text/sink.hpp"

namespace tiltrotor::text {

enum class Format { table, csv, json };

// A number of the user's: repeated as it was written.
struct Quotation {
  std::string text;
  double value;
};

// A number that the user gave, with all the digits he gave.
Quotation as_given(double value);

// A number that is not finite is an empty cell (null in JSON).
using Cell = std::variant<double, std::string, Quotation>;
using Row = std::vector<Cell>;

// A number in a unit of that size; any other cell as it is.
Cell in_unit(Cell cell, double size);

// A cell of CSV: in quotation marks where it holds a comma, a quotation mark or the end of a line.
std::string csv_cell(const std::string& text);

class Records {
 public:
  // JSON rows end with a member "program" (identity.hpp); CSV has room for rows only.
  // `digits`: significant digits of numbers in CSV; a table shows fewer, JSON always the shortest exact text.
  // Numbers are written without the rounding of `terms` (rounding.hpp), save those of the column `residual`.
  // Without header: CSV whose header stands elsewhere (shards after the first). Nothing is
  // written before the first row or the end.
  Records(Sink& sink, Format format, std::vector<std::string> columns, int digits, double terms,
          bool header = true);

  // Columns are in other units than the rows: sizes of these, one a column, in the units of the rows.
  void divide_by(std::vector<double> sizes) { sizes_ = std::move(sizes); }

  // Lines before the header of CSV or of a table.
  void begin_with(std::string text) { beginning_ = std::move(text); }

  void add(const Row& row);
  // Ends the output and the sink.
  void finish();

 private:
  Row shown(Row row) const;
  void write_header();
  void write_json(const Row& row);
  void write_table();

  Sink& sink_;
  Format format_;
  std::vector<std::string> columns_;
  std::vector<double> sizes_;
  std::string beginning_;
  int digits_;
  double terms_;
  bool header_;
  std::size_t count_ = 0;
  std::vector<std::vector<std::string>> table_;  // the widths of a table are known at its end
};

}  // namespace tiltrotor::text
