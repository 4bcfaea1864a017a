// tables.csv: which file makes which table of the model, at which mast angle and flap setting.
#pragma once

#include <string>
#include <vector>

#include "tablegen/csv.hpp"

namespace tablegen {

class Composition {
 public:
  struct Part {
    double mast_deg;
    int setting;       // flap setting, from 1; 0: none given
    std::string file;  // below the aircraft's folder, without .csv
  };

  void read(const std::string& file, int flap_settings);

  // The one file of a table, or of a part of it.
  std::string file(const std::string& table, const std::string& part = "");
  // Files of a table by mast angle, which increases; with flap settings each mast angle has one of each.
  std::vector<Part> by_mast(const std::string& table);
  std::vector<Part> by_mast_and_flap(const std::string& table);
  // A row that nobody asked for names no table of the model.
  void check_all_used() const;

 private:
  struct Entry {
    int line;
    std::string table, part;
    bool at_mast;
    Part place;
    bool used = false;
  };
  std::vector<Entry*> rows_of(const std::string& table, const std::string& part, bool at_mast);

  Csv csv_;
  int flap_settings_ = 0;
  std::vector<Entry> entries_;
};

}  // namespace tablegen
