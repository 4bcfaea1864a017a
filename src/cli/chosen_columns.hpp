// --columns: which columns of its rows a command prints, in which order, and beside its own what instruments read, by the
// names that outputs have in linear models.
#pragma once

#include <string>
#include <vector>

#include "cli/arguments.hpp"
#include "text/records.hpp"
#include "tiltrotor/analysis/flight/instruments.hpp"

namespace tiltrotor::cli {

OptionList columns_option();

class ChosenColumns {
 public:
  // `own`: those of the command, printed where nothing is chosen. Throws UsageError for a name that is none.
  ChosenColumns(const Arguments& arguments, const std::vector<std::string>& own);

  const std::vector<std::string>& names() const { return names_; }
  bool have_readings() const { return have_readings_; }
  // From the cells of all own columns and the readings, not a number where there are none.
  Row row(const Row& own, const Instruments<double>& readings) const;

 private:
  std::vector<std::string> names_;
  std::vector<std::size_t> place_;  // among the own columns, then among the readings
  std::vector<double> size_;        // of the unit of its name
  bool have_readings_ = false;
};

// Of a row that has none.
Instruments<double> no_readings();

}  // namespace tiltrotor::cli
