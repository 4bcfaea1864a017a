#include "cli/state_file.hpp"

#include <algorithm>
#include <fstream>

#include "cli/errors.hpp"
#include "cli/flight_options.hpp"
#include "cli/sweep.hpp"
#include "tiltrotor/math/waist.hpp"

namespace tiltrotor::cli {

namespace {

// What a column fills.
struct Target {
  enum Kind { ignored, name, mast, state, control } kind;
  int index;
};

struct ControlColumn {
  const char* name;
  int index;
};
// Names of the reference files for the four inceptors.
constexpr ControlColumn inceptor_columns[] = {
    {"th75_rad", iu_collective}, {"lon_in", iu_long_stick}, {"lat_in", iu_lat_stick}, {"ped_in", iu_pedal}};

std::string increment_column(int control) {
  const std::string unit = kControlNames[control].unit;
  return std::string(kControlNames[control].name) + "_" + (unit == "m/s" ? "mps" : unit);
}

std::optional<Target> find_target(const std::string& column) {
  if (column.compare(0, 2, "d_") == 0) return Target{Target::ignored, 0};
  if (column == "case") return Target{Target::name, 0};
  if (column == "mast_deg") return Target{Target::mast, 0};
  for (int i = 0; i < state_count; ++i) {
    if (column == kStateNames[i].name) return Target{Target::state, i};
  }
  for (const ControlColumn& inceptor : inceptor_columns) {
    if (column == inceptor.name) return Target{Target::control, inceptor.index};
  }
  for (int i = iu_pedal + 1; i < control_count; ++i) {
    if (column == increment_column(i)) return Target{Target::control, i};
  }
  return std::nullopt;
}

// Names of all columns that must be there.
std::vector<std::string> required_columns(const Options& options) {
  const ActiveStates active = active_states(options, true);
  std::vector<std::string> names;
  for (int i = 0; i < state_count; ++i) {
    const bool alive = std::find(active.index, active.index + active.count, i) != active.index + active.count;
    if (i < ix_coning_right || alive) names.emplace_back(kStateNames[i].name);
  }
  for (const ControlColumn& inceptor : inceptor_columns) names.emplace_back(inceptor.name);
  return names;
}

std::string trimmed(const std::string& text) {
  constexpr const char* blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> line_cells(const std::string& line) {
  std::vector<std::string> cells = split(line, ',');
  for (std::string& cell : cells) cell = trimmed(cell);
  return cells;
}

std::vector<Target> read_header(const std::vector<std::string>& columns, const Options& options,
                                const std::string& where) {
  std::vector<Target> targets;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::optional<Target> target = find_target(columns[i]);
    if (!target) {
      throw UsageError(where + ": unknown column '" + columns[i] +
                       "'; `tiltrotor derivative --help` lists the columns");
    }
    if (std::find(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(i), columns[i]) !=
        columns.begin() + static_cast<std::ptrdiff_t>(i)) {
      throw UsageError(where + ": column '" + columns[i] + "' stands there twice");
    }
    targets.push_back(*target);
  }
  std::string missing;
  for (const std::string& name : required_columns(options)) {
    if (std::find(columns.begin(), columns.end(), name) == columns.end()) missing += " " + name;
  }
  if (!missing.empty()) throw UsageError(where + ": missing column" + missing);
  return targets;
}

StateRow read_row(const std::vector<std::string>& cells, const std::vector<std::string>& columns,
                  const std::vector<Target>& targets, const std::string& where) {
  if (cells.size() != columns.size()) {
    throw UsageError(where + ": " + std::to_string(cells.size()) + " cells, but the header names " +
                     std::to_string(columns.size()) + " columns");
  }
  double x[state_count] = {};
  double u[control_count] = {};
  StateRow row{};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string here = where + ": column " + columns[i];
    const Target& target = targets[i];
    if (target.kind == Target::ignored) continue;
    if (target.kind == Target::name) {
      row.name = cells[i];
      row.cells.emplace_back(cells[i]);
      continue;
    }
    const double value =
        target.kind == Target::mast ? parse_number(cells[i], here, kMastRange) : parse_number(cells[i], here);
    row.cells.emplace_back(Quotation{cells[i], value});
    if (target.kind == Target::mast) row.mast_deg = value;
    if (target.kind == Target::state) x[target.index] = value;
    if (target.kind == Target::control) u[target.index] = value;
  }
  unpack(x, row.state);
  unpack(u, row.controls);
  return row;
}

}  // namespace

StateFile read_state_file(const std::string& path, const Options& options) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw UsageError(path + ": cannot be read");
  StateFile file{path, {}, {}, false};
  std::vector<std::string> columns;
  std::vector<Target> targets;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    if (trimmed(line).empty()) continue;
    const std::string where = path + ":" + std::to_string(number);
    const std::vector<std::string> cells = line_cells(line);
    if (columns.empty()) {
      columns = cells;
      targets = read_header(columns, options, where);
      continue;
    }
    StateRow row = read_row(cells, columns, targets, where);
    row.line = number;
    if (row.name.empty()) row.name = std::to_string(file.rows.size());
    file.rows.push_back(row);
  }
  if (in.bad()) throw UsageError(path + ": cannot be read");
  if (columns.empty()) throw UsageError(path + ":1: no header line");
  if (file.rows.empty()) throw UsageError(path + ": no states below the header");
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (targets[i].kind != Target::ignored) file.columns.push_back(columns[i]);
    if (targets[i].kind == Target::mast) file.has_mast = true;
  }
  return file;
}

}  // namespace tiltrotor::cli
