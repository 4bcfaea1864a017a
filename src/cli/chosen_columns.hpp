// --columns: which columns of its rows a command prints, in which order, and beside its own what instruments read, load
// factors at stations and loads of components, by the names that outputs have in linear models.
#pragma once

#include <string>
#include <vector>

#include "cli/named_outputs.hpp"
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
  // Those of stations and components.
  const std::vector<AirframeOutput>& airframe() const { return airframe_; }
  // From the cells of all own columns, the readings and, in their order, those of airframe(): not a number where there are
  // none.
  Row row(const Row& own, const Instruments<double>& readings, const std::vector<double>& airframe) const;

 private:
  std::vector<std::string> names_;
  std::vector<std::size_t>
      place_;                 // among the own columns, then among the readings, then those of the airframe
  std::vector<double> size_;  // of the unit of its name
  bool have_readings_ = false;
  std::vector<AirframeOutput> airframe_;
};

// Of a row that has none.
Instruments<double> no_readings();

}  // namespace tiltrotor::cli
