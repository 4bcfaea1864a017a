#include "text/records.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "text/identity.hpp"
#include "text/json.hpp"
#include "text/number.hpp"
#include "text/rounding.hpp"

namespace tiltrotor::text {

namespace {

constexpr int table_digits = 6;

std::string cell_text(const Cell& cell, int digits) {
  if (const std::string* text = std::get_if<std::string>(&cell)) return *text;
  if (const Quotation* quotation = std::get_if<Quotation>(&cell)) return quotation->text;
  const double number = std::get<double>(cell);
  return std::isfinite(number) ? number_text(number, digits) : "";
}

std::string cell_json(const Cell& cell) {
  if (const std::string* text = std::get_if<std::string>(&cell)) return json_text(*text);
  if (const Quotation* quotation = std::get_if<Quotation>(&cell)) return json_number(quotation->value);
  return json_number(std::get<double>(cell));
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) line += (i > 0 ? "," : "") + csv_cell(cells[i]);
  return line + "\n";
}

std::vector<std::string> row_texts(const Row& row, int digits) {
  std::vector<std::string> texts;
  for (const Cell& cell : row) texts.push_back(cell_text(cell, digits));
  return texts;
}

}  // namespace

Quotation as_given(double value) { return {number_text(value), value}; }

Cell in_unit(Cell cell, double size) {
  if (size == 1) return cell;
  if (double* const number = std::get_if<double>(&cell)) *number /= size;
  if (Quotation* const given = std::get_if<Quotation>(&cell); given != nullptr && std::isfinite(given->value))
    *given = as_given(given_as(given->value, size));
  return cell;
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

Records::Records(Sink& sink, Format format, std::vector<std::string> columns, int digits, double terms,
                 bool header)
    : sink_(sink),
      format_(format),
      columns_(std::move(columns)),
      digits_(digits),
      terms_(terms),
      header_(header) {
  if (format_ == Format::table) table_.push_back(columns_);
}

void Records::add(const Row& exact) {
  if (exact.size() != columns_.size())
    throw std::logic_error("a row of " + std::to_string(exact.size()) + " cells under " +
                           std::to_string(columns_.size()) + " columns");
  const Row row = shown(exact);
  write_header();
  if (format_ == Format::csv) sink_.write(csv_line(row_texts(row, digits_)));
  if (format_ == Format::json) write_json(row);
  if (format_ == Format::table) table_.push_back(row_texts(row, table_digits));
  ++count_;
}

void Records::finish() {
  write_header();
  if (format_ == Format::json) sink_.write(count_ == 0 ? "[]\n" : "\n]\n");
  if (format_ == Format::table) write_table();
  sink_.finish();
}

Row Records::shown(Row row) const {
  for (std::size_t i = 0; i < row.size(); ++i) {
    double* const number = std::get_if<double>(&row[i]);
    if (number != nullptr && columns_[i] != "residual") *number = without_rounding(*number, terms_);
    if (!sizes_.empty()) row[i] = in_unit(row[i], sizes_[i]);
  }
  return row;
}

void Records::write_header() {
  if (format_ == Format::csv && header_) sink_.write(beginning_ + csv_line(columns_));
  header_ = false;
}

void Records::write_json(const Row& row) {
  std::vector<JsonMember> members;
  for (std::size_t i = 0; i < row.size(); ++i) members.emplace_back(columns_[i], cell_json(row[i]));
  members.emplace_back("program", program_json());
  sink_.write((count_ == 0 ? "[\n" : ",\n") + json_object(members));
}

void Records::write_table() {
  sink_.write(beginning_);
  std::vector<std::size_t> width(columns_.size(), 0);
  for (const std::vector<std::string>& row : table_) {
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
  }
  for (const std::vector<std::string>& row : table_) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += std::string(i > 0 ? 2 : 0, ' ') + std::string(width[i] - row[i].size(), ' ') + row[i];
    }
    sink_.write(line + "\n");
  }
}

}  // namespace tiltrotor::text
