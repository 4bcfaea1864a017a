#include "tablegen/identity.hpp"

#include <algorithm>

#include "tablegen/csv.hpp"
#include "tablegen/fault.hpp"

namespace tablegen {

namespace {

const Row& row_of(const Csv& csv, const std::string& field) {
  const std::size_t column = csv.column("field");
  const auto is_field = [&](const Row& row) { return row.cell[column] == field; };
  const auto row = std::find_if(csv.rows.begin(), csv.rows.end(), is_field);
  if (row == csv.rows.end()) throw Fault{csv.file, csv.rows.back().line, "field '" + field + "' is missing"};
  const auto twice = std::find_if(row + 1, csv.rows.end(), is_field);
  if (twice != csv.rows.end()) throw Fault{csv.file, twice->line, "field '" + field + "' appears twice"};
  return *row;
}

// Printed in headers of files and in JSON: plain printable characters of one line.
std::string text_of(const Csv& csv, const std::string& field) {
  const Row& row = row_of(csv, field);
  const std::string& text = row.cell[csv.column("text")];
  const bool plain = std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
  if (text.empty() || !plain)
    throw Fault{csv.file, row.line, "'" + field + "' must be one line of plain characters"};
  return text;
}

}  // namespace

Identity read_identity(const std::string& file, const std::string& folder) {
  const Csv csv = read_csv(file);
  const Row& row = row_of(csv, "id");
  const double id = number(csv, row, csv.column("text"));
  constexpr double largest = 1e9;
  if (!(id >= 1 && id <= largest) || id != static_cast<int>(id))
    throw Fault{csv.file, row.line, "'id' must be a whole number, 1 or more"};
  return {folder, text_of(csv, "name"), text_of(csv, "description"), static_cast<int>(id)};
}

}  // namespace tablegen
