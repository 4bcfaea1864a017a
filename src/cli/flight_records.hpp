// Rows of trimmed flights. A condition of which the command line asks for several values has a column in them, so that
// rows can be told apart: the command's own, or one behind those.
#pragma once

#include <string>
#include <vector>

#include "cli/output.hpp"
#include "cli/trimmed_flights.hpp"

namespace tiltrotor::cli {

class SweptColumns {
 public:
  // Of flights with these columns of their own.
  SweptColumns(const Arguments& arguments, const std::vector<SetupOptions>& setups,
               const std::vector<std::string>& own);

  const std::vector<std::string>& names() const { return names_; }
  std::vector<double> values(const TrimmedFlight& flight) const;
  Row cells(const TrimmedFlight& flight) const;

 private:
  std::vector<std::string> names_;
};

// Every name such a column can have, apart from quantities that --hold holds.
std::vector<std::string> swept_names();

class FlightRecords {
 public:
  FlightRecords(const Arguments& arguments, const std::vector<SetupOptions>& setups, Output& output,
                const std::vector<std::string>& own, int digits);

  // `row`: of the command's own columns.
  void add(const TrimmedFlight& flight, const Row& row) { add(complete(flight, row)); }
  // The same in two steps, for rows that wait.
  Row complete(const TrimmedFlight& flight, Row row) const;
  void add(const Row& complete) { records_.add(complete); }
  void finish() { records_.finish(); }

 private:
  SweptColumns swept_;
  Records records_;
};

}  // namespace tiltrotor::cli
