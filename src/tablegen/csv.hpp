// CSV files as text: comment lines (#), one header line, rows. Every row knows its line for messages.
#pragma once

#include <string>
#include <vector>

namespace tablegen {

struct Row {
  int line;
  std::vector<std::string> cell;
};

struct Csv {
  std::string file;
  std::string comments;  // all comment lines, one after the other
  int header_line;
  std::vector<std::string> header;
  std::vector<Row> rows;

  // Index of a column; a column that is not there is a fault of the header line.
  std::size_t column(const std::string& name) const;
};

// Every row has as many cells as the header; names in the header are unique; there is at least one row.
Csv read_csv(const std::string& file);

// Finite decimal number of one cell.
double number(const Csv& csv, const Row& row, std::size_t column);

}  // namespace tablegen
