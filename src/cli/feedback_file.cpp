#include "cli/feedback_file.hpp"

#include <algorithm>
#include <tuple>

#include "cli/arguments.hpp"
#include "cli/errors.hpp"
#include "cli/flight_options.hpp"
#include "cli/line_reader.hpp"
#include "text/csv_line.hpp"
#include "text/nearest.hpp"

namespace tiltrotor::cli {

namespace {

constexpr std::size_t most_blocks = 10000;

// All but gusts.
std::vector<std::string> input_names() {
  std::vector<std::string> names;
  for (int j = 0; j < kControlIndex.gust.x; ++j) names.emplace_back(kControlVariables[j].name);
  return names;
}

template <class Names>
int place(const Names& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

}  // namespace

FeedbackFile::FeedbackFile(const std::string& path, const ReadingNames& names) {
  LineReader lines(path);
  std::string line;
  std::vector<std::string> cells;
  std::vector<Row> rows;
  while (lines.next(line)) {
    const char* fault = lines.number() == 1 ? csv::begin_file(line) : nullptr;
    if (fault != nullptr) throw UsageError(lines.where() + ": " + fault);
    const std::string_view text = csv::trimmed(line);
    if (text.empty() || text[0] == '#') continue;
    fault = csv::split_line(line, cells);
    if (fault != nullptr) throw UsageError(lines.where() + ": " + fault);
    if (header_.empty()) {
      read_header(cells, names, lines.where());
    } else {
      rows.push_back(read_row(cells, lines.number(), lines.where()));
    }
  }
  if (header_.empty()) throw UsageError(lines.path() + ":1: no header line");
  if (rows.empty()) throw UsageError(lines.path() + ": no gains below the header");
  make_blocks(std::move(rows), lines.path());
}

void FeedbackFile::read_header(const std::vector<std::string>& cells, const ReadingNames& names,
                               const std::string& where) {
  header_ = cells;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::string& name = cells[k];
    if (std::find(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(k), name) !=
        cells.begin() + static_cast<std::ptrdiff_t>(k))
      throw UsageError(where + ": column " + quoted(name) + " stands there twice");
    if (name == "input" || name == "mast_deg" || name == "speed_mps") {
      (name == "input" ? input_ : name == "mast_deg" ? mast_ : speed_) = static_cast<int>(k);
      continue;
    }
    const int at = place(names.name, name);
    if (at < 0)
      throw UsageError(where + ": column " + quoted(name) + " is no reading of this model" +
                       did_you_mean(name, names.name) + "; choose among " + one_of(names.name) +
                       names.remark);
    law_.reading[law_.readings++] = names.reading[static_cast<std::size_t>(at)];
  }
  if (input_ < 0) throw UsageError(where + ": missing column input; a row begins with the input it is for");
  if (law_.readings == 0)
    throw UsageError(where + ": no column of a reading; choose among " + one_of(names.name) + names.remark);
}

FeedbackFile::Row FeedbackFile::read_row(const std::vector<std::string>& cells, std::size_t line,
                                         const std::string& where) {
  if (cells.size() != header_.size()) {
    throw UsageError(where + ": " + std::to_string(cells.size()) + " cells, but the header names " +
                     std::to_string(header_.size()) + " columns");
  }
  static const std::vector<std::string> inputs = input_names();
  Row row{line, 0, 0, 0, {}};
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const int column = static_cast<int>(k);
    const std::string here = where + ": column " + header_[k];
    if (column == mast_) {
      row.mast_deg = parse_number(cells[k], here, kMastRange);
    } else if (column == speed_) {
      row.speed = parse_number(cells[k], here, kSpeedRange);
    } else if (column != input_) {
      row.gain.push_back(parse_number(cells[k], here));
    } else {
      const int control = place(inputs, cells[k]);
      if (control < 0)
        throw UsageError(where + ": " + quoted(cells[k]) + " is no input" + did_you_mean(cells[k], inputs) +
                         "; choose among " + one_of(inputs));
      int* const end = law_.input + law_.inputs;
      row.input = static_cast<int>(std::find(law_.input, end, control) - law_.input);
      if (row.input == law_.inputs) law_.input[law_.inputs++] = control;
    }
  }
  return row;
}

void FeedbackFile::make_blocks(std::vector<Row> rows, const std::string& path) {
  const auto is_before = [](const Row& a, const Row& b) {
    return std::tie(a.mast_deg, a.speed) < std::tie(b.mast_deg, b.speed);
  };
  std::stable_sort(rows.begin(), rows.end(), is_before);
  for (std::size_t k = 0; k < rows.size();) {
    const Row& first = rows[k];
    const auto refuse = [&](const Row& row, int input, const std::string& what) {
      const std::string mast = mast_ < 0 ? "" : " at mast " + number_text(row.mast_deg) + " deg";
      const std::string speed = speed_ < 0 ? "" : " at " + number_text(row.speed) + " m/s";
      throw UsageError(path + ":" + std::to_string(row.line) + ": input " +
                       kControlVariables[law_.input[input]].name + " " + what + mast + speed);
    };
    if (blocks_.size() == most_blocks)
      refuse(first, first.input, "is one of more than " + std::to_string(most_blocks) + " blocks");
    blocks_.push_back({first.mast_deg, first.speed, {}});
    std::vector<bool> has(static_cast<std::size_t>(law_.inputs));
    for (; k < rows.size() && !is_before(first, rows[k]); ++k) {
      const Row& row = rows[k];
      const auto input = static_cast<std::size_t>(row.input);
      if (has[input]) refuse(row, row.input, "stands there twice");
      has[input] = true;
      for (int r = 0; r < law_.readings; ++r)
        blocks_.back().gain(row.input, r) = row.gain[static_cast<std::size_t>(r)];
    }
    for (int i = 0; i < law_.inputs; ++i)
      if (!has[static_cast<std::size_t>(i)]) refuse(first, i, "has rows elsewhere and none");
  }
  law_.block = blocks_.data();
  law_.blocks = static_cast<int>(blocks_.size());
}

}  // namespace tiltrotor::cli
