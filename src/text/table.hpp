// A table of the report: what stands in a CSV file, and what every figure is drawn from.
//
// Numbers are rounded to the digits of the file when they enter, so that a figure shows exactly what the file
// holds.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tiltrotor::text {

class Table {
 public:
  using Cell = std::variant<double, std::string>;  // a number that is not finite is an empty cell

  explicit Table(std::vector<std::string> columns);

  // CSV with a header; lines that begin with '#' are comments and are kept. Throws std::runtime_error
  // "<name>:<line>".
  static Table parse(std::string_view text, const std::string& name);

  void add(const std::vector<Cell>& row);
  void comment(const std::string& line) { comments_.push_back(line); }

  std::string csv() const;

  const std::vector<std::string>& columns() const { return columns_; }
  const std::vector<std::string>& comments() const { return comments_; }
  std::size_t rows() const { return rows_.size(); }
  const std::string& text(std::size_t row, const std::string& column) const;
  const std::string& text(std::size_t row, std::size_t column) const { return rows_[row][column]; }
  double number(std::size_t row, const std::string& column) const;  // NaN for an empty cell
  std::vector<double> numbers(const std::string& column) const;

  // Rows in which a column reads so.
  Table where(const std::string& column, const std::string& text) const;
  Table where(const std::string& column, double value) const;  // equal to 1e-9
  // Different texts of a column in order of appearance.
  std::vector<std::string> different(const std::string& column) const;

 private:
  std::size_t place(const std::string& column) const;
  template <class Predicate>
  Table filtered(Predicate&& keep) const;

  std::vector<std::string> columns_;
  std::vector<std::string> comments_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace tiltrotor::text
