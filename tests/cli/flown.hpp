// Flights by script, as the program prints them.
#pragma once

#include <cmath>
#include <cstdlib>
#include <string>

#include "cli/csv_text.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"

namespace check {

struct Flown {
  ProgramResult result;
  CsvText rows;
  double operator()(std::size_t row, const char* column) const { return rows.number(row, column); }
  std::size_t count() const { return rows.rows.size(); }
};

inline Flown fly(const std::string& script, const std::string& options) {
  const ScratchFolder folder;
  const ProgramResult result =
      run_tiltrotor("fly --script " + quoted(folder.write("script.txt", script)) + " " + options);
  return {result, CsvText(result.out)};
}

// Number behind "name:" in the summary, the first such line.
inline double summary(const Flown& flown, const std::string& name) {
  const std::string& text = flown.result.err;
  const std::size_t place = text.find(name + ": ");
  if (place == std::string::npos) return std::nan("");
  const std::size_t number = text.find_first_of("-0123456789", place + name.size());
  return std::strtod(text.c_str() + number, nullptr);
}

}  // namespace check
