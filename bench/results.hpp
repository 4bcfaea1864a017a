// Results of a benchmark: printed, and kept in build/bench/results.csv as name,value,unit.
#pragma once

#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "harness.hpp"

namespace bench {

// Writes beside the file and moves the complete text to its place.
inline void write_whole(const std::string& path, const std::string& text) {
  const std::string part = path + ".part";
  std::ofstream out(part, std::ios::binary);
  out << text;
  out.close();
  if (!out || std::rename(part.c_str(), path.c_str()) != 0) throw std::runtime_error("cannot write " + path);
}

inline std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

class Results {
 public:
  // `directory` exists.
  explicit Results(std::string directory) : directory_(std::move(directory)) {}

  void add(const std::string& name, double value, const std::string& unit) {
    rows_.emplace_back(name, number(value) + "," + unit);
    std::printf("  %-44s %12s %s\n", name.c_str(), number(value).c_str(), unit.c_str());
  }
  // The median, with the quartiles beside it on paper.
  void add(const std::string& name, const Spread& value, const std::string& unit, double factor = 1) {
    rows_.emplace_back(name, number(factor * value.median) + "," + unit);
    std::printf("  %-44s %12s %-4s (%s .. %s)\n", name.c_str(), number(factor * value.median).c_str(),
                unit.c_str(), number(factor * value.low).c_str(), number(factor * value.high).c_str());
    std::fflush(stdout);
  }

  // A table of its own.
  void write(const std::string& file, const std::string& text) const {
    write_whole(directory_ + "/" + file, text);
  }

  // Merges with what other benchmarks have left: rows of the same name are replaced in place, others are
  // appended.
  void save() const {
    const std::string path = directory_ + "/results.csv";
    std::vector<std::pair<std::string, std::string>> all;
    std::ifstream in(path);
    std::string line;
    std::getline(in, line);  // the header
    while (std::getline(in, line)) {
      const std::size_t comma = line.find(',');
      if (comma != std::string::npos) all.emplace_back(line.substr(0, comma), line.substr(comma + 1));
    }
    for (const auto& row : rows_) {
      bool found = false;
      for (auto& old : all) {
        if (old.first != row.first) continue;
        old.second = row.second;
        found = true;
      }
      if (!found) all.push_back(row);
    }
    std::ostringstream text;
    text << "name,value,unit\n";
    for (const auto& row : all) text << row.first << ',' << row.second << '\n';
    write_whole(path, text.str());
  }

 private:
  std::string directory_;
  std::vector<std::pair<std::string, std::string>> rows_;
};

}  // namespace bench
