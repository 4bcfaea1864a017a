// States and controls from a CSV file, columns in any order.
//
// Columns are those of state_columns.hpp: the states and the four inceptors must be there. Optional: `case`,
// the settings (mast_deg, altitude_m, flap_deg, rotor_rpm, mass_kg, cg_sl_in), the remaining controls (zero
// when absent), d_<state>, and what else trim and respond print; of these it is compared what follows from
// the states (derived_columns.hpp), the rest is not read.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/errors.hpp"
#include "cli/line_reader.hpp"
#include "cli/state_columns.hpp"
#include "text/number.hpp"
#include "text/records.hpp"

namespace tiltrotor::cli {

struct StateRow {
  std::size_t line = 0;
  std::string name;   // of the column `case`, else the number of the row from 0
  std::string model;  // model_text() of who made it; empty where the file does not say
  // What else the column `model` says; nothing where it says nothing at all.
  std::optional<double> isa_offset;  // K
  std::optional<int> engines;
  // Where the file has their columns; SI but for the flap.
  std::optional<double> mast_deg, altitude, flap_deg, rotor_speed, mass, sl_cg;
  State<double> state{};
  Controls<double> controls{};
  Row cells;          // of StateFile::columns()
  std::string fault;  // why the row is no flight; empty where it is one
};

// Rows are read one at a time: the memory does not grow with the file.
class StateFile {
 public:
  // Reads the whole file once. Throws UsageError "FILE:LINE: ..." for anything that is not a complete table
  // of finite states within the ranges of tr_set_state and tr_set_controls. The states beyond the first 24
  // are needed when `options` makes them alive; those that stand still must be zero. A row without any number
  // of state and controls, as trim prints where it finds none, has a fault.
  // `see` is called for every row with "FILE:LINE" meanwhile.
  using See = std::function<void(const StateRow&, const std::string& where)>;
  StateFile(const std::string& path, const Options& options, const See& see = nullptr);

  const std::string& path() const { return lines_.path(); }
  std::size_t size() const { return size_; }
  const std::vector<std::string>& columns() const { return columns_; }    // as in the file without d_*
  const std::vector<Target>& targets() const { return column_targets_; }  // what these fill
  bool has(Target::Kind kind) const;

  // The rows from `begin` to before `end`, in order.
  void each(std::size_t begin, std::size_t end, const std::function<void(StateRow&)>& visit);

 private:
  bool next_row_line();
  void read_header(const Options& options);
  void read_row(std::size_t number, StateRow& row);
  bool holds_state() const;
  void read_model(const std::string& text, StateRow& row) const;
  void require_alive(std::size_t column, double value) const;
  Range range_of(std::size_t column) const;
  std::string cell(const std::string& column) const;  // of this row; empty where there is none

  Options options_;
  LineReader lines_;
  std::string line_;
  std::vector<std::string> cells_;
  std::vector<std::string> header_;
  std::vector<Target> targets_;
  std::vector<std::string> columns_;
  std::vector<Target> column_targets_;
  std::size_t size_ = 0;
};

}  // namespace tiltrotor::cli
