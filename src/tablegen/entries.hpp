// aircraft.csv and choices.csv: named values with units.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tablegen/csv.hpp"

namespace tablegen {

struct Entry {
  std::string text;  // value as written
  double value;
  std::string unit;
};

class Entries {
 public:
  // aircraft.csv: name,value,unit,SI_value,SI_unit,... Each value is converted and compared with its SI
  // value.
  void read_aircraft(const std::string& file);
  // choices.csv: name,value,unit,reason. No choice without a reason.
  void read_choices(const std::string& file);

  const Entry& operator[](const std::string& name) const;
  double in(const std::string& name, const std::string& unit) const;
  bool has(const std::string& name) const { return entries_.count(name) != 0; }
  // Throws the fault at the line of an entry.
  [[noreturn]] void refuse(const std::string& name, const std::string& message) const;

 private:
  struct Position {
    std::string file;
    int line;
  };
  Csv read_named(const std::string& file);
  void add(const Csv& csv, const Row& row, const Entry& entry);
  std::map<std::string, Entry> entries_;
  std::map<std::string, Position> positions_;
  std::vector<Position> ends_;  // last line of every file read: where a missing entry would have to be
};

}  // namespace tablegen
