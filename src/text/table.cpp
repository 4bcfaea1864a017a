#include "text/table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "text/number.hpp"

namespace tiltrotor::text {

namespace {

constexpr int kDigits = 7;

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

std::vector<std::string> fields(std::string_view line, const std::string& where) {
  std::vector<std::string> result(1);
  bool in_quotes = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && in_quotes && i + 1 < line.size() && line[i + 1] == '"') {
      result.back() += '"';
      ++i;
    } else if (c == '"') {
      in_quotes = !in_quotes;
    } else if (c == ',' && !in_quotes) {
      result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  if (in_quotes) throw std::runtime_error(where + ": a quoted cell does not end");
  return result;
}

}  // namespace

Table::Table(std::vector<std::string> columns) : columns_(std::move(columns)) {}

Table Table::parse(std::string_view text, const std::string& name) {
  Table table({});
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    const std::string where = name + ":" + std::to_string(number);
    if (line.empty()) continue;
    if (line[0] == '#') {
      table.comments_.emplace_back(line.substr(line.find_first_not_of("# ") == std::string_view::npos
                                                   ? line.size()
                                                   : line.find_first_not_of("# ")));
    } else if (table.columns_.empty()) {
      table.columns_ = fields(line, where);
    } else {
      table.rows_.push_back(fields(line, where));
      if (table.rows_.back().size() != table.columns_.size()) {
        throw std::runtime_error(where + ": " + std::to_string(table.rows_.back().size()) + " cells, " +
                                 std::to_string(table.columns_.size()) + " columns");
      }
    }
  }
  return table;
}

void Table::add(const std::vector<Cell>& row) {
  if (row.size() != columns_.size()) throw std::logic_error("row and header differ in length");
  std::vector<std::string> texts;
  for (const Cell& cell : row) {
    if (const double* value = std::get_if<double>(&cell)) {
      texts.push_back(std::isfinite(*value) ? number_text(*value == 0 ? 0.0 : *value, kDigits) : "");
    } else {
      texts.push_back(std::get<std::string>(cell));
    }
  }
  rows_.push_back(std::move(texts));
}

std::string Table::csv() const {
  std::string out;
  for (const std::string& line : comments_) out += "# " + line + "\n";
  const auto put = [&out](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) out += (i ? "," : "") + quoted(cells[i]);
    out += "\n";
  };
  put(columns_);
  for (const auto& row : rows_) put(row);
  return out;
}

std::size_t Table::place(const std::string& column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) throw std::logic_error("no column '" + column + "'");
  return static_cast<std::size_t>(found - columns_.begin());
}

const std::string& Table::text(std::size_t row, const std::string& column) const {
  return rows_[row][place(column)];
}

double Table::number(std::size_t row, const std::string& column) const {
  const std::string& cell = text(row, column);
  if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
  return parse_number(cell, column);
}

std::vector<double> Table::numbers(const std::string& column) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < rows(); ++i) values.push_back(number(i, column));
  return values;
}

template <class Predicate>
Table Table::filtered(Predicate&& keep) const {
  Table result(columns_);
  result.comments_ = comments_;
  for (std::size_t i = 0; i < rows(); ++i) {
    if (keep(i)) result.rows_.push_back(rows_[i]);
  }
  return result;
}

Table Table::where(const std::string& column, const std::string& wanted) const {
  return filtered([&](std::size_t i) { return text(i, column) == wanted; });
}

Table Table::where(const std::string& column, double value) const {
  return filtered([&](std::size_t i) { return std::fabs(number(i, column) - value) <= 1e-9; });
}

std::vector<std::string> Table::different(const std::string& column) const {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < rows(); ++i) {
    if (std::find(result.begin(), result.end(), text(i, column)) == result.end())
      result.push_back(text(i, column));
  }
  return result;
}

}  // namespace tiltrotor::text
