// The means to put the tables of one aircraft together; what is put together stands in aircraft_tables.cpp.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tablegen/aircraft_tables.hpp"
#include "tablegen/compose.hpp"
#include "tablegen/composition.hpp"

namespace tablegen {

class Composer {
 public:
  Composer(const std::string& folder, const Entries& entries);

  void rotor();
  void wing();
  void pylon_and_fuselage();
  void horizontal_tail();
  void fins();
  void controls();
  // Every file of the folder is read once, and every row of tables.csv belongs to a table.
  void check_the_rest();

  std::vector<TableArray> tables;

 private:
  const Grid& grid(const std::string& name);
  Curve curve(const std::string& name, const std::string& column, const std::string& unit,
              const std::string& to);
  // All columns, named prefix and number, over that number times `scale`.
  Surface surface(const std::string& name, const std::string& prefix, double scale = 1);
  // Files of one table, one for each mast angle, with a column for each speed.
  struct MastStack {
    std::vector<double> mast_deg;
    std::vector<Surface> surface;
  };
  MastStack stacked_by_mast(const std::vector<Composition::Part>& parts);
  // Columns of several files must be the same when the files make one table.
  void check_same_columns(const std::string& name, const std::string& as);

  void put(const std::string& field, const std::string& source, const Curve& c);
  void put(const std::string& field, const std::string& source, const Surface& s);
  // One surface or curve for each place on the linear axes, the last axis running fastest.
  void put_stack(const std::string& field, const std::string& source, std::vector<std::vector<double>> linear,
                 const std::vector<Surface>& stack);
  void put_stack(const std::string& field, const std::string& source, std::vector<std::vector<double>> linear,
                 const std::vector<Curve>& stack);
  // The one column of the one file of a table; of `from`, when several tables come from one file.
  void put_single(const std::string& field, const std::string& column, const std::string& unit,
                  const std::string& to, const std::string& from = "");
  void put_odd(const std::string& field, const std::string& column, const std::string& unit,
               const std::string& to);
  // Rows by mast angle, one column for each flap setting.
  void put_by_flap(const std::string& field, const std::string& unit, const std::string& to);
  void put_mach(const std::string& field);
  void wing_coefficient(const std::string& field);
  void aileron_lift_loss();
  void pressure_ratio();
  void below_mach(const std::string& field, const std::string& low_table, const std::string& low_column);

  std::string folder_;
  double incompressible_mach_;
  std::vector<std::string> flap_names_;
  std::vector<double> flap_deg_;
  Composition files_;
  std::map<std::string, Grid> grids_;
};

}  // namespace tablegen
