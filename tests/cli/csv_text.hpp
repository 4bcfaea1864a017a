// CSV as the program prints it, for tests.
#pragma once

#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace check {

inline std::vector<std::string> csv_cells(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

struct CsvText {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  explicit CsvText(const std::string& text) {
    std::istringstream in(text);
    std::string line;
    if (std::getline(in, line)) columns = csv_cells(line);
    while (std::getline(in, line)) rows.push_back(csv_cells(line));
  }

  const std::string& text(std::size_t row, const std::string& column) const {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i] == column) return rows.at(row).at(i);
    }
    throw std::runtime_error("no column " + column);
  }
  double number(std::size_t row, const std::string& column) const {
    const std::string& cell = text(row, column);
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    if (cell.empty() || *end != '\0') throw std::runtime_error(column + " is not a number: '" + cell + "'");
    return value;
  }
};

/// The first line, without its end.
inline std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace check
