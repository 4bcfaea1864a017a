#include "cli/state_file.hpp"

#include <algorithm>
#include <limits>

#include "cli/errors.hpp"
#include "cli/flight_options.hpp"
#include "cli/units.hpp"
#include "text/csv_line.hpp"
#include "text/nearest.hpp"
#include "tiltrotor/analysis/flight/response.hpp"
#include "tiltrotor/math/differentiation/preaccumulate.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/variables/control_range.hpp"

namespace tiltrotor::cli {

namespace {

// A header in other units than the model's is told what it lacks in those.
std::string missing_columns(const std::vector<std::string>& header, const Options& options) {
  const auto has = [&](const std::string& name) {
    return std::any_of(header.begin(), header.end(), [&](const std::string& column) {
      return column == name || in_own_unit(column).name == name;
    });
  };
  bool printed = false;
  std::vector<std::vector<std::string>> missing;
  const auto require = [&](const std::vector<std::string>& names) {
    printed = printed || (names.back() != names.front() && has(names.back()));
    if (std::none_of(names.begin(), names.end(), has)) missing.push_back(names);
  };
  for (const int i : needed_states(options)) require(state_columns(i));
  for (int j = 0; j <= kControlIndex.pedal; ++j) require(control_columns(j));
  std::string text;
  for (const std::vector<std::string>& names : missing)
    text += " " + (printed ? names.back() : names.front());
  return text;
}

bool is_motion(const Target& target) {
  return target.kind == Target::Kind::state || target.kind == Target::Kind::control;
}

std::string separator_hint(const std::vector<std::string>& header) {
  if (header.size() > 1) return "";
  if (header[0].find(';') != std::string::npos)
    return "; the cells are to be separated by commas, not by ';'";
  if (header[0].find('\t') != std::string::npos)
    return "; the cells are to be separated by commas, not by tabs";
  return "";
}

}  // namespace

StateFile::StateFile(const std::string& name, const Options& options, const See& see)
    : options_(options), lines_(name) {
  if (!next_row_line()) throw UsageError(path() + ":1: no header line");
  read_header(options);
  StateRow row{};
  while (next_row_line()) {
    read_row(size_++, row);
    if (see) see(row, lines_.where());
  }
  if (size_ == 0) throw UsageError(path() + ": no states below the header");
  for (std::size_t i = 0; i < header_.size(); ++i) {
    if (targets_[i].kind == Target::Kind::rate) continue;
    columns_.push_back(header_[i]);
    column_targets_.push_back(targets_[i]);
  }
}

bool StateFile::has(Target::Kind kind) const {
  return std::any_of(targets_.begin(), targets_.end(), [&](const Target& t) { return t.kind == kind; });
}

void StateFile::each(std::size_t begin, std::size_t end, const std::function<void(StateRow&)>& visit) {
  lines_.rewind();
  next_row_line();
  StateRow row{};
  for (std::size_t number = 0; number < end && next_row_line(); ++number) {
    if (number < begin) continue;
    read_row(number, row);
    visit(row);
  }
}

// Lines without content and comments do not count.
bool StateFile::next_row_line() {
  while (lines_.next(line_)) {
    const char* const fault = lines_.number() == 1 ? csv::begin_file(line_) : nullptr;
    if (fault != nullptr) throw UsageError(lines_.where() + ": " + fault);
    const std::string_view text = csv::trimmed(line_);
    if (!text.empty() && text[0] != '#') return true;
  }
  return false;
}

void StateFile::read_header(const Options& options) {
  const std::string where = lines_.where();
  const char* const fault = csv::split_line(line_, header_);
  if (fault != nullptr) throw UsageError(where + ": " + fault);
  for (std::size_t i = 0; i < header_.size(); ++i) {
    const std::string& name = header_[i];
    if (name.empty()) throw UsageError(where + ": column " + std::to_string(i + 1) + " has no name");
    const std::optional<Target> target = find_target(name);
    if (!target) {
      throw UsageError(where + ": unknown column " + quoted(name) + did_you_mean(name, known_columns()) +
                       separator_hint(header_) + "; `tiltrotor derivative --help` lists the columns");
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (header_[k] == name) throw UsageError(where + ": column '" + name + "' stands there twice");
      const bool same = targets_[k].kind == target->kind && targets_[k].index == target->index;
      if (same && target->kind != Target::Kind::rate && target->kind != Target::Kind::derived)
        throw UsageError(where + ": columns '" + header_[k] + "' and '" + name + "' give the same quantity");
    }
    targets_.push_back(*target);
  }
  const std::string missing = missing_columns(header_, options);
  if (!missing.empty()) throw UsageError(where + ": missing column" + missing);
}

std::string StateFile::cell(const std::string& column) const {
  const auto place = std::find(header_.begin(), header_.end(), column);
  return place == header_.end() ? "" : cells_[static_cast<std::size_t>(place - header_.begin())];
}

// In the unit of the column. A control may be beyond its stop where the row's own column `limits` says so: a
// trim that no pilot could hold.
Range StateFile::range_of(std::size_t column) const {
  const Target& target = targets_[column];
  const auto between = [&](double low, double high) {
    return Range{given_as(low, target.unit) + target.zero, given_as(high, target.unit) + target.zero,
                 target.unit_name};
  };
  const auto setting = [&](const Range& range) {
    return Range{range.low / target.size, range.high / target.size, target.unit_name};
  };
  switch (target.kind) {
    case Target::Kind::mast:
      return setting(kMastRange);
    case Target::Kind::altitude:
      return setting(kAltitudeRange);
    case Target::Kind::flap:
      return setting(kFlapRange);
    case Target::Kind::rotor_speed:
      return setting(kRotorSpeedRange);
    case Target::Kind::mass:
      return setting(kMassRange);
    case Target::Kind::sl_cg:
      return setting(kCgRange);
    case Target::Kind::state: {
      const double bound = state_bound<double>(target.index);
      return between(-bound, bound);
    }
    case Target::Kind::control: {
      const std::vector<std::string> limits = split(cell("limits"), ' ');
      if (std::find(limits.begin(), limits.end(), kControlVariables[target.index].name) != limits.end())
        return between(-kLargestControl<double>, kLargestControl<double>);
      const Bounds<double> range = control_range(aircraft_data<double>(), target.index);
      return between(range.low, range.high);
    }
    default:
      return {-std::numeric_limits<double>::max(), std::numeric_limits<double>::max(), ""};
  }
}

bool StateFile::holds_state() const {
  for (std::size_t i = 0; i < cells_.size(); ++i)
    if (is_motion(targets_[i]) && !cells_[i].empty()) return true;
  return false;
}

// "XV-15 grid=realtime isa_offset=30 engines=1"
void StateFile::read_model(const std::string& text, StateRow& row) const {
  if (text.empty()) return;
  const int all = aircraft_data<double>().controls.engines;
  row.isa_offset = 0;
  row.engines = all;
  for (const std::string& word : split(text, ' ')) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const std::string value = equals < word.size() ? word.substr(equals + 1) : "";
    const std::string where = lines_.where() + ": column " + kModelColumn + ": " + name;
    if (name == kIsaOffsetWord) {
      row.isa_offset = parse_number(value, where, isa_offset_range());
    } else if (name == kEnginesWord) {
      row.engines = static_cast<int>(parse_integer(value, where, 1, all));
    } else {
      row.model += (row.model.empty() ? "" : " ") + word;
    }
  }
}

// A state that stands still under the options is not read.
void StateFile::require_alive(std::size_t column, double value) const {
  const Target& target = targets_[column];
  if (target.kind != Target::Kind::state || value == 0 || is_active(kStateVariables[target.index], options_))
    return;
  throw UsageError(lines_.where() + ": column " + header_[column] + ": " + cells_[column] +
                   ", but with these options the state stands still; give the --option the file was made "
                   "with");
}

void StateFile::read_row(std::size_t number, StateRow& row) {
  const char* const fault = csv::split_line(line_, cells_);
  if (fault != nullptr) throw UsageError(lines_.where() + ": " + fault);
  if (cells_.size() != header_.size()) {
    throw UsageError(lines_.where() + ": " + std::to_string(cells_.size()) + " cells, but the header names " +
                     std::to_string(header_.size()) + " columns");
  }
  double x[state_count] = {};
  double u[control_count] = {};
  row = StateRow{};
  row.line = lines_.number();
  row.name = std::to_string(number);
  const bool has_state = holds_state();
  if (!has_state) {
    const std::string status = cell("status");
    row.fault = "the row holds no state" + (status.empty() ? "" : ": " + quoted(status));
  }
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const std::string& text = cells_[i];
    const Target& target = targets_[i];
    if (target.kind == Target::Kind::rate) continue;
    double value = std::numeric_limits<double>::quiet_NaN();
    const bool is_number = read_number(text, value);
    if (target.kind == Target::Kind::name || target.kind == Target::Kind::model ||
        target.kind == Target::Kind::derived) {
      if (target.kind == Target::Kind::name && !text.empty()) row.name = text;
      if (target.kind == Target::Kind::model) read_model(text, row);
      const bool repeats_number = target.kind == Target::Kind::derived && (is_number || text.empty());
      row.cells.emplace_back(repeats_number ? Cell(Quotation{text, value}) : Cell(text));
      continue;
    }
    const bool may_be_empty = !has_state && is_motion(target);
    const Range range = range_of(i);
    if (!may_be_empty && (!is_number || !(value >= range.low && value <= range.high)))
      parse_number(text, lines_.where() + ": column " + header_[i], range);  // throws
    row.cells.emplace_back(Quotation{text, value});
    if (may_be_empty) continue;
    value = target.read(value);
    require_alive(i, value);
    if (target.kind == Target::Kind::mast) row.mast_deg = value;
    if (target.kind == Target::Kind::altitude) row.altitude = value;
    if (target.kind == Target::Kind::flap) row.flap_deg = value;
    if (target.kind == Target::Kind::rotor_speed) row.rotor_speed = value;
    if (target.kind == Target::Kind::mass) row.mass = value;
    if (target.kind == Target::Kind::sl_cg) row.sl_cg = value;
    if (target.kind == Target::Kind::state) x[target.index] = value;
    if (target.kind == Target::Kind::control) u[target.index] = value;
  }
  unflatten(x, row.state);
  unflatten(u, row.controls);
}

}  // namespace tiltrotor::cli
