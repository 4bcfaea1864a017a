#include "tablegen/csv.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "tablegen/fault.hpp"

namespace tablegen {

namespace {

std::string trimmed(const std::string& text) {
  const char* const blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Cells of one line; a cell in double quotes may hold commas, and a doubled quote stands for itself.
std::vector<std::string> split(const std::string& text, const std::string& file, int line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      cells.back() += c;
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  if (quoted) throw Fault{file, line, "quotation mark is not closed"};
  for (std::string& cell : cells) cell = trimmed(cell);
  return cells;
}

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
    text = trimmed(text);
    if (text.empty()) continue;
    if (text[0] == '#') {
      csv.comments += text + "\n";
      continue;
    }
    std::vector<std::string> cells = split(text, file, line);
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
