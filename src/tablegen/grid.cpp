#include "tablegen/grid.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>

#include "tablegen/fault.hpp"
#include "tablegen/units.hpp"
#include "tiltrotor/math/tables/table.hpp"

namespace tablegen {

namespace {

// `unit` as a word of its own: "ft2" in "area (ft2)", but not in "ft2/deg".
bool states(const std::string& comments, const std::string& unit) {
  const auto belongs = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '/'; };
  for (std::size_t at = comments.find(unit); at != std::string::npos; at = comments.find(unit, at + 1)) {
    const std::size_t end = at + unit.size();
    if ((at == 0 || !belongs(comments[at - 1])) && (end >= comments.size() || !belongs(comments[end])))
      return true;
  }
  return false;
}

std::vector<double> read_knots(const Csv& csv) {
  std::vector<double> knot;
  for (const Row& row : csv.rows) {
    const double x = number(csv, row, 0);
    if (!knot.empty() && x == knot.back())
      throw Fault{csv.file, row.line, "knot " + row.cell[0] + " is repeated"};
    if (!knot.empty() && x < knot.back())
      throw Fault{csv.file, row.line, "knots do not increase at " + row.cell[0]};
    knot.push_back(x);
    if (knot.size() > tiltrotor::kMaxKnots)
      throw Fault{csv.file, row.line, "more than " + std::to_string(tiltrotor::kMaxKnots) + " knots"};
  }
  return knot;
}

// Places after the point of a number as it is written, at least 0.
int decimals(const std::string& text) {
  const std::size_t exponent = text.find_first_of("eE");
  const std::size_t point = text.find('.');
  const std::size_t end = std::min(exponent, text.size());
  const int places = point < end ? static_cast<int>(end - point) - 1 : 0;
  return std::max(0, places - (exponent < text.size() ? std::atoi(text.c_str() + exponent + 1) : 0));
}

// The files leave zeros at the end of a number away. A number is taken as printed with as many decimals as most of those
// of its file that have some, or with its own when these are more.
int usual_decimals(const Csv& csv) {
  std::map<int, int> count;
  for (const Row& row : csv.rows)
    for (std::size_t i = 1; i < row.cell.size(); ++i)
      if (const int places = decimals(row.cell[i]); places > 0) ++count[places];
  int usual = 0;
  for (const auto& [places, cells] : count)
    if (usual == 0 || cells >= count[usual]) usual = places;
  return usual;
}

double half_unit(const std::string& text, int usual) {
  return 0.5 * std::pow(10.0, -std::max(decimals(text), usual));
}

Curve read_column(const Csv& csv, const std::vector<double>& knot, std::size_t index, int usual) {
  const bool rule = csv.comments.find("Empty = ") != std::string::npos;
  Curve curve;
  int first_empty_after = 0;  // line
  for (std::size_t i = 0; i < csv.rows.size(); ++i) {
    const Row& row = csv.rows[i];
    if (row.cell[index].empty()) {
      if (!rule)
        throw Fault{csv.file, row.line,
                    "empty cell in column '" + csv.header[index] + "' and no comment \"Empty = ...\""};
      if (!curve.value.empty() && first_empty_after == 0) first_empty_after = row.line;
      continue;
    }
    if (first_empty_after != 0)
      throw Fault{csv.file, first_empty_after, "hole in column '" + csv.header[index] + "'"};
    if (!knot.empty()) curve.knot.push_back(knot[i]);
    curve.value.push_back(number(csv, row, index));
    curve.half.push_back(half_unit(row.cell[index], usual));
  }
  if (curve.value.empty())
    throw Fault{csv.file, csv.header_line, "column '" + csv.header[index] + "' is empty"};
  return curve;
}

}  // namespace

Grid read_grid(const std::string& file) {
  Grid grid{read_csv(file), {}, {}};
  const Csv& csv = grid.csv;
  if (csv.header.size() < 2) throw Fault{file, csv.header_line, "no column beside the knots"};
  // The first column of a table by flap setting holds names, FL1 and so on; it has no knots of its own.
  if (csv.header[0] != "flap") grid.knot = read_knots(csv);
  const int usual = usual_decimals(csv);
  for (std::size_t i = 1; i < csv.header.size(); ++i)
    grid.columns.push_back(read_column(csv, grid.knot, i, usual));
  return grid;
}

Curve Grid::column(const std::string& name, const std::string& unit, const std::string& wanted) const {
  const std::size_t index = csv.column(name);
  if (index == 0) throw Fault{csv.file, csv.header_line, "'" + name + "' is the column of the knots"};
  const Unit* const from = find_unit(unit);
  const Unit* const to = find_unit(wanted);
  if (from == nullptr || to == nullptr || !states(csv.comments, unit))
    throw Fault{csv.file, csv.header_line, "the comments do not state the unit " + unit};
  Curve curve = columns[index - 1];
  for (double& value : curve.value) value = converted(value, *from, *to);
  for (double& half : curve.half) half = converted(half, *from, *to);
  return curve;
}

std::vector<double> Grid::labels(const std::vector<std::string>& from, const std::string& prefix) const {
  std::vector<double> result;
  for (const std::string& name : from) {
    const bool begins = name.compare(0, prefix.size(), prefix) == 0;
    std::string digits = begins ? name.substr(prefix.size()) : "";
    const bool minus = digits.size() > 1 && digits[0] == 'm';
    if (minus) digits.erase(0, 1);
    const bool plain = digits.find_first_not_of("0123456789.") == std::string::npos;
    constexpr std::size_t most_digits = 20;
    if (digits.empty() || digits.size() > most_digits || !plain || digits[0] == '.' ||
        std::count(digits.begin(), digits.end(), '.') > 1)
      throw Fault{csv.file, csv.header_line, "column '" + name + "' is not " + prefix + " and a number"};
    result.push_back(minus ? -std::stod(digits) : std::stod(digits));
    if (result.size() > 1 && !(result[result.size() - 2] < result.back()))
      throw Fault{csv.file, csv.header_line, "columns do not increase at '" + name + "'"};
    if (result.size() > tiltrotor::kMaxKnots) throw Fault{csv.file, csv.header_line, "too many columns"};
  }
  if (result.empty()) throw Fault{csv.file, csv.header_line, "no column begins with '" + prefix + "'"};
  return result;
}

}  // namespace tablegen
