#include "tablegen/csv.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "tablegen/fault.hpp"
#include "text/csv_line.hpp"

namespace tablegen {

namespace {

void check_header(const Csv& csv) {
  for (auto name = csv.header.begin(); name != csv.header.end(); ++name) {
    if (name->empty()) throw Fault{csv.file, csv.header_line, "column without a name"};
    if (std::find(csv.header.begin(), name, *name) != name)
      throw Fault{csv.file, csv.header_line, "column '" + *name + "' appears twice"};
  }
}

}  // namespace

Csv read_csv(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw Fault{file, 1, "file is missing or cannot be read"};
  Csv csv{file, {}, 0, {}, {}};
  std::string text;
  int line = 0;
  while (std::getline(in, text)) {
    ++line;
    const char* fault = line == 1 ? csv::begin_file(text) : nullptr;
    if (fault != nullptr) throw Fault{file, line, fault};
    text = std::string(csv::trimmed(text));
    if (text.empty()) continue;
    if (text[0] == '#') {
      csv.comments += text + "\n";
      continue;
    }
    std::vector<std::string> cells;
    fault = csv::split_line(text, cells);
    if (fault != nullptr) throw Fault{file, line, fault};
    if (csv.header.empty()) {
      csv.header = std::move(cells);
      csv.header_line = line;
      check_header(csv);
    } else if (cells.size() != csv.header.size()) {
      throw Fault{
          file, line,
          std::to_string(cells.size()) + " cells, the header has " + std::to_string(csv.header.size())};
    } else {
      csv.rows.push_back({line, std::move(cells)});
    }
  }
  if (in.bad()) throw Fault{file, line, "cannot be read to its end"};
  if (csv.rows.empty()) throw Fault{file, std::max(line, 1), "no rows"};
  return csv;
}

std::size_t Csv::column(const std::string& name) const {
  const auto at = std::find(header.begin(), header.end(), name);
  if (at == header.end()) throw Fault{file, header_line, "column '" + name + "' is missing"};
  return static_cast<std::size_t>(at - header.begin());
}

double number(const Csv& csv, const Row& row, std::size_t column) {
  const std::string& text = row.cell[column];
  // strtod also takes "inf", "nan" and hexadecimal: none of these letters is let through.
  const bool plain = !text.empty() && text.find_first_not_of("0123456789+-.eE") == std::string::npos;
  char* end = nullptr;
  const double value = plain ? std::strtod(text.c_str(), &end) : 0;
  if (!plain || *end != '\0' || !std::isfinite(value))
    throw Fault{csv.file, row.line,
                "'" + text + "' in column '" + csv.header[column] + "' is not a finite number"};
  return value;
}

}  // namespace tablegen
