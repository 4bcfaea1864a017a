// States and controls from a CSV file, columns in any order.
//
// States carry the names of kStateNames, controls th75_rad, lon_in, lat_in, ped_in. Optional: `case`,
// `mast_deg`, the remaining controls as <name>_<unit> (elevator_rad, gust_u_mps; zero when absent), and
// d_<state>, which is ignored.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/records.hpp"
#include "tiltrotor/model/controls.hpp"
#include "tiltrotor/model/state.hpp"

namespace tiltrotor::cli {

struct StateRow {
  std::size_t line;
  std::string name;  // of the column `case`, else the number of the row from 0
  std::optional<double> mast_deg;
  State<double> state;
  Controls<double> controls;
  Row cells;  // of StateFile::columns
};

struct StateFile {
  std::string path;
  std::vector<std::string> columns;  // as in the file without d_*
  std::vector<StateRow> rows;
  bool has_mast;
};

// Throws UsageError "FILE:LINE: ..." for anything that is not a complete, finite table of states. The states
// beyond the first 24 are needed when `options` makes them alive.
StateFile read_state_file(const std::string& path, const Options& options);

}  // namespace tiltrotor::cli
