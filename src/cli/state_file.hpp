// States and controls from a CSV file, columns in any order.
//
// Columns are those of state_columns.hpp: the states and the four inceptors must be there. Optional: `case`,
// the settings (mast_deg, altitude_m, flap_deg, rotor_rpm, mass_kg, cg_sl_in), the remaining controls (zero
// when absent), d_<state>, and what else trim and respond print; the last two are not read.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/errors.hpp"
#include "cli/line_reader.hpp"
#include "cli/state_columns.hpp"
#include "text/records.hpp"

namespace tiltrotor::cli {

struct StateRow {
  std::size_t line;
  std::string name;  // of the column `case`, else the number of the row from 0
  // Where the file has their columns; SI but for the flap.
  std::optional<double> mast_deg, altitude, flap_deg, rotor_speed, mass, sl_cg;
  State<double> state;
  Controls<double> controls;
  Row cells;  // of StateFile::columns()
};

// Rows are read one at a time: the memory does not grow with the file.
class StateFile {
 public:
  // Reads the whole file once. Throws UsageError "FILE:LINE: ..." for anything that is not a complete table
  // of finite states within the ranges of tr_set_state. The states beyond the first 24 are needed when
  // `options` makes them alive.
  StateFile(const std::string& path, const Options& options);

  const std::string& path() const { return lines_.path(); }
  std::size_t size() const { return size_; }
  const std::vector<std::string>& columns() const { return columns_; }  // as in the file without d_*
  bool has(Target::Kind kind) const;

  // The rows from `begin` to before `end`, in order.
  void each(std::size_t begin, std::size_t end, const std::function<void(const StateRow&)>& visit);

 private:
  bool next_row_line();
  void read_header(const Options& options);
  void read_row(std::size_t number, StateRow& row);

  LineReader lines_;
  std::string line_;
  std::vector<std::string> cells_;
  std::vector<std::string> header_;
  std::vector<Target> targets_;
  std::vector<std::string> columns_;
  std::size_t size_ = 0;
};

}  // namespace tiltrotor::cli
