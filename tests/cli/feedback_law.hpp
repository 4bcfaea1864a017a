// Feedback laws for tests: the one that is shipped, its gains, and those that a test writes.
#pragma once

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "cli/csv_text.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"

namespace check {

inline const std::string kFlight = "--mast 90 --speed 100 --grid realtime ";
inline std::string shipped() { return "--feedback " + quoted(source_path("src/examples/lqr.csv")) + " "; }

// Rows of the file for one speed: gain of an input from a reading, zero where the file has none.
struct Gains {
  CsvText file;
  explicit Gains(const std::string& text) : file(text.substr(text.find("mast_deg"))) {}
  double at(const std::string& speed, const std::string& input, const std::string& reading) const {
    for (std::size_t row = 0; row < file.rows.size(); ++row) {
      if (file.text(row, "speed_mps") != speed || file.text(row, "input") != input) continue;
      for (const std::string& column : file.columns)
        if (column == reading) return file.number(row, reading);
    }
    return 0;
  }
};
inline Gains shipped_gains() {
  std::ifstream in(source_path("src/examples/lqr.csv"));
  return Gains(std::string(std::istreambuf_iterator<char>(in), {}));
}

inline std::string law(const ScratchFolder& folder, const std::string& name, const std::string& text) {
  return "--feedback " + quoted(folder.write(name, text)) + " ";
}

}  // namespace check
