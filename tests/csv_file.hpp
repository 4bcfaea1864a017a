// Reads a comma-separated file with one header line, for tests.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "text/csv_line.hpp"

namespace check {

class CsvFile {
 public:
  /// `name`: path inside the source tree. Throws when the file cannot be read or a row has a wrong length.
  explicit CsvFile(const std::string& name) : name_(name) {
    std::ifstream file(std::string(TILTROTOR_SOURCE_DIR "/") + name);
    std::string line;
    if (!std::getline(file, line)) throw std::runtime_error(name + ": cannot be read");
    csv::begin_file(line);
    header_ = cells(line);
    while (std::getline(file, line)) {
      if (line.empty()) continue;
      rows_.push_back(cells(line));
      if (rows_.back().size() != header_.size())
        throw std::runtime_error(name + ": row of wrong length: " + line);
    }
  }

  int rows() const { return static_cast<int>(rows_.size()); }

  const std::string& text(int row, const std::string& column) const {
    return rows_[static_cast<std::size_t>(row)][place(column)];
  }
  double number(int row, const std::string& column) const {
    const std::string& cell = text(row, column);
    char* end = nullptr;
    const double x = std::strtod(cell.c_str(), &end);
    if (cell.empty() || *end != '\0') throw std::runtime_error(name_ + ": not a number: " + cell);
    return x;
  }

 private:
  std::vector<std::string> cells(const std::string& line) const {
    std::vector<std::string> result;
    const char* const fault = csv::split_line(line, result);
    if (fault != nullptr) throw std::runtime_error(name_ + ": " + fault + ": " + line);
    return result;
  }
  std::size_t place(const std::string& column) const {
    for (std::size_t i = 0; i < header_.size(); ++i) {
      if (header_[i] == column) return i;
    }
    throw std::runtime_error(name_ + ": no column " + column);
  }

  std::string name_;
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace check
