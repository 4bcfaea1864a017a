#include "cli/input_series.hpp"

#include <algorithm>

#include "cli/arguments.hpp"
#include "cli/errors.hpp"
#include "cli/line_reader.hpp"
#include "cli/state_columns.hpp"
#include "text/csv_line.hpp"
#include "text/nearest.hpp"
#include "tiltrotor/math/differentiation/preaccumulate.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/variables/control_range.hpp"
#include "tiltrotor/systems/drive.hpp"
#include "tiltrotor/systems/system_state.hpp"

namespace tiltrotor::cli {

namespace {

constexpr Range kTimeRange{0, 3600, "s"};
constexpr std::size_t kMostRows = 1000000;
const char* const kTime = "time_s";

struct Column {
  std::string name;
  int input;  // -1: the time
  double unit, zero;
  Range range;
};

std::vector<std::string> throttle_names() {
  std::vector<std::string> names;
  for (int i = 1; i <= aircraft_data<double>().controls.engines; ++i)
    names.push_back("throttle_" + std::to_string(i));
  return names;
}

std::vector<std::string> series_columns() {
  std::vector<std::string> names = {kTime};
  for (int j = 0; j < control_count; ++j) names.push_back(control_columns(j).back());
  for (const std::string& throttle : throttle_names()) names.push_back(throttle);
  return names;
}

// As a column of files, or under the name of the model in its unit.
std::optional<Target> find_input(const std::string& name) {
  for (int j = 0; j < control_count; ++j)
    if (name == kControlVariables[j].name)
      return Target{Target::Kind::control, j, 1, 0, kControlVariables[j].unit()};
  return find_target(name);
}

Column find_column(const std::string& name, const std::string& where) {
  if (name == kTime) return {name, -1, 1, 0, kTimeRange};
  const std::vector<std::string> throttles = throttle_names();
  for (std::size_t i = 0; i < throttles.size() && i < 2; ++i)
    if (name == throttles[i] || name == kCommandVariables.row[kCommandIndex.throttle[i]].name)
      return {name, kFirstThrottle + static_cast<int>(i), 1, 0, {0, kMostThrottle<double>, ""}};
  const std::optional<Target> target = find_input(name);
  if (!target || target->kind != Target::Kind::control)
    throw UsageError(where + ": unknown column " + quoted(name) + did_you_mean(name, series_columns()) +
                     "; give " + one_of(series_columns()));
  const Bounds<double> range = control_range(aircraft_data<double>(), target->index);
  const auto shown = [&](double bound) { return given_as(bound, target->unit) + target->zero; };
  return {name,
          target->index,
          target->unit,
          target->zero,
          {shown(range.low), shown(range.high), target->unit_name}};
}

// A line with content, its cells.
bool next_row(LineReader& lines, std::vector<std::string>& cells) {
  std::string line;
  while (lines.next(line)) {
    const char* fault = lines.number() == 1 ? csv::begin_file(line) : nullptr;
    const std::string_view text = csv::trimmed(line);
    if (fault == nullptr && (text.empty() || text[0] == '#')) continue;
    if (fault == nullptr) fault = csv::split_line(line, cells);
    if (fault != nullptr) throw UsageError(lines.where() + ": " + fault);
    return true;
  }
  return false;
}

std::vector<Column> read_header(LineReader& lines) {
  std::vector<std::string> names;
  if (!next_row(lines, names))
    throw UsageError(lines.path() + ":1: no header line; give time_s and the inputs");
  std::vector<Column> columns;
  for (const std::string& name : names) {
    const Column column = find_column(name, lines.where());
    for (const Column& other : columns)
      if (other.input == column.input)
        throw UsageError(lines.where() + ": columns '" + other.name + "' and '" + name +
                         "' give the same quantity");
    columns.push_back(column);
  }
  const auto is_time = [](const Column& c) { return c.input < 0; };
  if (std::none_of(columns.begin(), columns.end(), is_time))
    throw UsageError(lines.where() + ": missing column " + kTime);
  if (columns.size() < 2)
    throw UsageError(lines.where() + ": no column of an input; give " + one_of(series_columns()));
  return columns;
}

}  // namespace

InputSeries read_input_series(const std::string& path, bool is_held) {
  LineReader lines(path);
  const std::vector<Column> columns = read_header(lines);
  const std::size_t width = columns.size();
  InputSeries series;
  series.name = lines.path();
  series.is_held = is_held;
  std::size_t time_place = 0;
  for (std::size_t i = 0; i < width; ++i) {
    if (columns[i].input < 0) time_place = i;
    if (columns[i].input >= 0) series.input.push_back(columns[i].input);
  }
  std::vector<std::string> cells;
  while (next_row(lines, cells)) {
    if (cells.size() != width)
      throw UsageError(lines.where() + ": " + std::to_string(cells.size()) + " cells, but the header names " +
                       std::to_string(width) + " columns");
    if (series.time.size() == kMostRows)
      throw UsageError(lines.where() + ": more than " + std::to_string(kMostRows) + " rows");
    for (std::size_t i = 0; i < width; ++i) {
      const Column& column = columns[i];
      const std::string where = lines.where() + ": column " + column.name;
      if (cells[i].empty()) throw UsageError(where + ": a hole; give " + text::range_text(column.range));
      const double number = parse_number(cells[i], where, column.range);
      if (i == time_place) {
        if (!series.time.empty() && number <= series.time.back())
          throw UsageError(where + ": " + cells[i] + " s does not come after the " +
                           number_text(series.time.back()) + " s of the row above");
        series.time.push_back(number);
      } else {
        series.value.push_back((number - column.zero) * column.unit);
      }
    }
  }
  if (series.time.empty()) throw UsageError(lines.path() + ": no rows below the header");
  return series;
}

double value_at(const InputSeries& series, std::size_t column, double time) {
  const std::size_t width = series.input.size();
  const auto value = [&](std::size_t row) { return series.value[row * width + column]; };
  const auto after = std::upper_bound(series.time.begin(), series.time.end(), time);
  if (after == series.time.begin()) return value(0);
  const std::size_t row = static_cast<std::size_t>(after - series.time.begin()) - 1;
  if (after == series.time.end() || series.is_held) return value(row);
  const double part = (time - series.time[row]) / (series.time[row + 1] - series.time[row]);
  return value(row) + part * (value(row + 1) - value(row));
}

}  // namespace tiltrotor::cli
