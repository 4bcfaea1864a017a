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

/// Of the matrices A along a flight, written every 2 s, and of the roots beside them: rows, trace, its size, sum of the roots.
struct Traces {
  int rows[3] = {};
  double trace[3] = {}, size[3] = {}, sum[3] = {};
};
inline Traces traces(const CsvText& a, const CsvText& modes) {
  const auto place = [](const CsvText& table, std::size_t row) {
    return static_cast<std::size_t>(std::lround(table.number(row, "time_s") / 2));
  };
  Traces t;
  for (std::size_t i = 0; i < a.rows.size(); ++i) {
    const double own = a.number(i, a.text(i, "row"));
    ++t.rows[place(a, i)];
    t.trace[place(a, i)] += own;
    t.size[place(a, i)] += std::fabs(own);
  }
  for (std::size_t i = 0; i < modes.rows.size(); ++i)
    t.sum[place(modes, i)] += modes.number(i, "real") * (modes.number(i, "imag") > 0 ? 2 : 1);
  return t;
}

}  // namespace check
