#include "tablegen/aircraft_tables.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "tablegen/compose.hpp"
#include "tablegen/fault.hpp"
#include "tiltrotor/model/aircraft.hpp"

namespace tablegen {

namespace {

// Lists for people, with words in their cells: read as CSV, not as a grid.
const char* const kLists[] = {"airfoil_stations.csv"};

struct MastFile {
  double mast_deg;
  const char* name;
};

class Composer {
 public:
  Composer(const std::string& folder, const Entries& entries)
      : folder_(folder), incompressible_mach_(entries.in("tail_incompressible_mach", "ND")) {
    for (int i = 1; i <= tiltrotor::kFlapSettings; ++i) {
      flap_names_.push_back("FL" + std::to_string(i));
      flap_deg_.push_back(entries.in("flap_setting_" + std::to_string(i), "deg"));
    }
  }

  void rotor();
  void wing();
  void pylon_and_fuselage();
  void horizontal_tail();
  void fins();
  void controls();
  void check_the_rest();

  std::vector<TableArray> tables;

 private:
  const Grid& grid(const std::string& name);
  Curve curve(const std::string& name, const std::string& column, const std::string& unit,
              const std::string& to);
  // All columns, named prefix and number, over that number times `scale`.
  Surface surface(const std::string& name, const std::string& prefix, double scale = 1);
  // Columns of several files must be the same when the files make one table.
  void check_same_columns(const std::string& name, const std::string& as);

  void put(const std::string& field, const std::string& source, const Curve& c);
  void put(const std::string& field, const std::string& source, const Surface& s);
  // One surface or curve for each place on the linear axes, the last axis running fastest.
  void put_stack(const std::string& field, const std::string& source, std::vector<std::vector<double>> linear,
                 const std::vector<Surface>& stack);
  void put_stack(const std::string& field, const std::string& source, std::vector<std::vector<double>> linear,
                 const std::vector<Curve>& stack);
  void put_single(const std::string& field, const std::string& name, const std::string& column,
                  const std::string& unit, const std::string& to);
  void put_odd(const std::string& field, const std::string& name, const std::string& column,
               const std::string& unit, const std::string& to);
  // Rows by mast angle, one column for each flap setting.
  void put_by_flap(const std::string& field, const std::string& name, const std::string& unit,
                   const std::string& to);
  void wing_coefficient(const std::string& field, const std::string& clean, const std::string& flaps,
                        const std::string& extension);
  void below_mach(const std::string& field, const std::string& name, const std::string& low_name,
                  const std::string& low_column);
  void by_mast(const std::string& field, const std::vector<MastFile>& files, const std::string& prefix);

  std::string folder_;
  double incompressible_mach_;
  std::vector<std::string> flap_names_;
  std::vector<double> flap_deg_;
  std::map<std::string, Grid> grids_;
};

// ---- the aircraft, part by part ----

void Composer::rotor() {
  put_single("rotor.twist", "rotor_airfoil/blade_twist", "twist_deg", "deg", "rad");
  put_single("rotor.chord_cutout", "rotor_airfoil/blade_chord", "chord_cutout_in", "in", "m");
  put_single("rotor.chord_text", "rotor_airfoil/blade_chord", "chord_text_in", "in", "m");
  put_single("rotor.chord_camrad", "rotor_airfoil/blade_chord", "chord_camrad_in", "in", "m");
  const char* const regions[tiltrotor::kSectionRegions] = {"region1_inboard", "region2_mid",
                                                           "region3_outboard", "region4_tip"};
  for (int i = 0; i < tiltrotor::kSectionRegions; ++i) {
    const std::string index = "[" + std::to_string(i) + "]";
    const std::string name = std::string("rotor_airfoil/c81_") + regions[i];
    put("rotor.section_lift" + index, name + "_cl", from_mach_0(surface(name + "_cl", "M", 100)));
    put("rotor.section_drag" + index, name + "_cd", from_mach_0(surface(name + "_cd", "M", 100)));
  }
  put_single("rotor.side_by_side", "airframe/t1-III_side_by_side_factor", "X_SS", "ND", "ND");
  put_single("rotor.sideward", "airframe/t1-II_sideward_flight_factor", "X_SF", "ND", "ND");
}

void Composer::wing() {
  wing_coefficient("wing.lift", "airframe/t4-I_wing_CL_flap0", "airframe/t4-II_wing_CL_flaps",
                   "airframe/t4-II_wing_CL_extension");
  wing_coefficient("wing.drag", "airframe/t4-III_wing_CD_flap0", "airframe/t4-IV_wing_CD_flaps",
                   "airframe/t4-IV_wing_CD_extension");

  const MastFile downwash[] = {{0, "airframe/t4-V_e_wing_downwash_bm00"},
                               {15, "airframe/t4-V_d_wing_downwash_bm15"},
                               {30, "airframe/t4-V_c_wing_downwash_bm30"},
                               {60, "airframe/t4-V_b_wing_downwash_bm60"},
                               {90, "airframe/t4-V_a_wing_downwash_bm90"}};
  std::vector<double> mast;
  std::vector<Curve> stack;
  for (const MastFile& file : downwash) {
    mast.push_back(file.mast_deg);
    for (const std::string& flap : flap_names_) stack.push_back(curve(file.name, flap, "deg", "rad"));
  }
  put_stack("wing.downwash", "airframe/t4-V_a..e", {mast, flap_deg_}, stack);

  put_by_flap("wing.moment", "airframe/t4-VIII_wing_Cm", "ND", "ND");
  put_by_flap("wing.roll_beta", "airframe/t4-VI_wing_Clbeta_CL0", "1/rad", "1/rad");
  put_by_flap("wing.roll_beta_per_lift", "airframe/t4-VII_wing_Clbeta_per_CL", "1/rad", "1/rad");
  put_by_flap("wing.zero_lift_drag", "airframe/t4-X_wing_CD0", "ND", "ND");
  put_by_flap("wing.aileron_roll", "airframe/t4-XI_aileron_roll_factor", "ND", "ND");
  put_by_flap("wing.aileron_yaw_0", "airframe/t4-XIII_aileron_yaw_K0", "1/deg", "1/rad");
  put_by_flap("wing.aileron_yaw", "airframe/t4-XIV_aileron_yaw_K", "ND", "ND");

  const std::string loss = "airframe/t4-XII_aileron_lift_loss";
  const Csv& csv = grid(loss).csv;
  for (std::size_t i = 0; i < csv.rows.size(); ++i) {
    const bool known = i < flap_names_.size() && csv.rows[i].cell[0] == flap_names_[i];
    if (!known)
      throw Fault{csv.file, csv.rows[i].line, "flap setting '" + csv.rows[i].cell[0] + "' out of order"};
  }
  if (csv.rows.size() < flap_names_.size())
    throw Fault{csv.file, csv.rows.back().line, "row '" + flap_names_[csv.rows.size()] + "' is missing"};
  put("wing.aileron_lift_loss", loss, Curve{flap_deg_, curve(loss, "CL_delta_a", "1/deg", "1/rad").value});
}

// Lift or drag. The clean wing depends on Mach number at mast 90; a Mach column that is shorter than the
// table keeps its end value. Outside the range of its own column every curve goes on with the extension of
// its flap setting, which goes round the whole circle.
void Composer::wing_coefficient(const std::string& field, const std::string& clean, const std::string& flaps,
                                const std::string& extension) {
  const std::string mach_prefix = "bm90_M";
  for (std::size_t i = 0; i < flap_names_.size(); ++i) {
    const std::string& flap = flap_names_[i];
    const std::string& main = i == 0 ? clean : flaps;
    const std::string index = "[" + std::to_string(i) + "]";
    const std::string source = main + ", " + extension + " " + flap;
    const Curve beyond = curve(extension, flap, "ND", "ND");
    const Curve mast_0 = curve(main, i == 0 ? "bm00" : flap + "_bm00", "ND", "ND");
    put(field + "_0" + index, source, extended(mast_0, beyond));
    if (i > 0) {
      const Curve mast_90 = extended(curve(main, flap + "_bm90", "ND", "ND"), beyond);
      put(field + "_90" + index, source, side_by_side({mast_90}, {0.0}));
      continue;
    }
    std::vector<std::string> names;
    for (const std::string& name : grid(main).names())
      if (name.compare(0, mach_prefix.size(), mach_prefix) == 0) names.push_back(name);
    std::vector<double> mach = grid(main).labels(names, mach_prefix);
    for (double& m : mach) m /= 100;
    std::vector<Curve> columns;
    for (const std::string& name : names)
      columns.push_back(extended(resampled(curve(main, name, "ND", "ND"), grid(main).knot), beyond));
    put(field + "_90" + index, source, from_mach_0(side_by_side(columns, mach)));
  }
}

void Composer::pylon_and_fuselage() {
  put_single("pylon.interference", "airframe/t4-XV_pylon_interference_drag", "D_PYINT", "ft2", "m2");
  put_single("pylon.side_plate", "airframe/t4-XVI_pylon_lateral_drag", "K_PLAT", "ND", "ND");

  put_single("fuselage.lift_alpha", "airframe/t3-I_fuselage_L_alpha", "L_alpha", "ft2", "m2");
  put_single("fuselage.drag_alpha", "airframe/t3-III_fuselage_D_alpha", "D_alpha", "ft2", "m2");
  put_single("fuselage.moment_alpha", "airframe/t3-V_fuselage_M_alpha", "M_alpha", "ft3", "m3");
  put_single("fuselage.lift_beta", "airframe/t3-II_fuselage_L_beta", "L_beta", "ft2", "m2");
  put_single("fuselage.drag_beta", "airframe/t3-IV_fuselage_D_beta", "D_beta", "ft2", "m2");
  put_single("fuselage.moment_beta", "airframe/t3-VI_fuselage_M_beta", "M_beta", "ft3", "m3");
  put_odd("fuselage.side_beta", "airframe/t3-VII_fuselage_Y_beta", "Y_beta", "ft2", "m2");
  put_odd("fuselage.roll_beta", "airframe/t3-VIII_fuselage_l_beta", "l_beta", "ft3", "m3");
  put_odd("fuselage.yaw_beta", "airframe/t3-IX_fuselage_N_beta", "N_beta", "ft3", "m3");
}

void Composer::horizontal_tail() {
  by_mast("htail.rotor_wash",
          {{0, "airframe/t2-I_a_rotor_wake_htail_bm00"},
           {15, "airframe/t2-I_b_rotor_wake_htail_bm15"},
           {30, "airframe/t2-I_c_rotor_wake_htail_bm30"},
           {60, "airframe/t2-I_d_rotor_wake_htail_bm60_90"},
           {90, "airframe/t2-I_d_rotor_wake_htail_bm60_90"}},
          "V");

  const std::string wash_beta = "airframe/t2-II_sideslip_correction_htail_wake";
  const Surface by_mast_angle = surface(wash_beta, "bm");
  put_stack("htail.rotor_wash_beta", wash_beta, {by_mast_angle.y}, by_mast_angle.column);

  put("htail.lift_elevator", "airframe/t5-I", surface("airframe/t5-I_htail_CL_elevator", "e"));
  below_mach("htail.lift_mach", "airframe/t5-II_htail_CL_mach", "airframe/t5-I_htail_CL_elevator", "e00");
  put("htail.drag", "airframe/t5-III", from_mach_0(surface("airframe/t5-III_htail_CD", "M", 100)));

  // Above the second mast angle the ratio no longer depends on speed: one column for each mast angle.
  const std::string name_0 = "airframe/t5-V_a_htail_q_ratio_bm00";
  const std::string name_15 = "airframe/t5-V_b_htail_q_ratio_bm15";
  check_same_columns(name_15, name_0);
  std::vector<double> mast = {0, 15};
  std::vector<Surface> stack = {surface(name_0, "V"), surface(name_15, "V")};
  const Surface above = surface("airframe/t5-V_c_htail_q_ratio_bm30_90", "bm");
  for (std::size_t i = 0; i < above.y.size(); ++i) {
    mast.push_back(above.y[i]);
    const std::vector<double>& speed = stack[0].y;
    stack.push_back(side_by_side(std::vector<Curve>(speed.size(), above.column[i]), speed));
  }
  put_stack("htail.pressure_ratio", "airframe/t5-V_a..c", {mast}, stack);

  put_single("tail.control_mach", "airframe/t5-IV_control_mach_factor", "X_K", "ND", "ND");
  put_single("tail.sideslip_loss", "airframe/t5-VI_tail_sideslip_factor", "K_beta", "ND", "ND");
}

void Composer::fins() {
  put("fin.side_rudder", "airframe/t6-I", surface("airframe/t6-I_vtail_CY_rudder", "r"));
  below_mach("fin.side_mach", "airframe/t6-II_vtail_CY_mach", "airframe/t6-I_vtail_CY_rudder", "r00");
  put("fin.drag", "airframe/t6-III", from_mach_0(surface("airframe/t6-III_vtail_CD", "M", 100)));

  const MastFile masts[] = {{0, "bm00"}, {30, "bm30"}, {60, "bm60"}, {90, "bm90"}};
  const char* const sidewash[tiltrotor::kFlapSettings] = {"t6-IV_sidewash_FL1_", "t6-V_sidewash_FL2_",
                                                          "t6-VI_sidewash_FL3_", "t6-VII_sidewash_FL4_"};
  std::vector<double> mast;
  std::vector<Surface> stack;
  std::string first;
  for (const MastFile& m : masts) {
    mast.push_back(m.mast_deg);
    for (const char* const flap : sidewash) {
      const std::string name = std::string("airframe/") + flap + m.name;
      if (first.empty()) first = name;
      check_same_columns(name, first);
      stack.push_back(surface(name, "b"));
    }
  }
  put_stack("fin.sidewash", "airframe/t6-IV..VII", {mast, flap_deg_}, stack);
  put("fin.rotor_sidewash", "airframe/t6-VIII", surface("airframe/t6-VIII_rotor_sidewash_factor", "b"));
}

// A table that starts at a higher Mach number and takes its low-Mach column from another: that column stands
// at Mach 0 and at the end of the incompressible range, on the knots of both files, shorter columns held.
void Composer::below_mach(const std::string& field, const std::string& name, const std::string& low_name,
                          const std::string& low_column) {
  Surface high = surface(name, "M", 100);
  if (!(incompressible_mach_ < high.y.front()))
    throw Fault{grid(name).csv.file, grid(name).csv.header_line,
                "first Mach number is not above the incompressible range"};
  const Curve low = curve(low_name, low_column, "ND", "ND");
  std::vector<double> mach = {0.0, incompressible_mach_};
  std::vector<Curve> columns = {low, low};
  mach.insert(mach.end(), high.y.begin(), high.y.end());
  columns.insert(columns.end(), high.column.begin(), high.column.end());
  put(field, name + ", " + low_name + " " + low_column, side_by_side(columns, mach));
}

void Composer::controls() {
  put_single("controls.long_cyclic", "airframe/t8a-I_long_cyclic_per_stick", "dB1_dXLN", "deg/in", "rad/in");

  // Printed by mast angle, a column for each speed; read by speed, a block for each mast angle.
  const std::string pedal = "airframe/t8a-II_diff_long_cyclic_per_pedal";
  const Grid& by_mast_angle = grid(pedal);
  const std::vector<double> speed = by_mast_angle.labels(by_mast_angle.names(), "V");
  std::vector<Curve> stack(by_mast_angle.knot.size(), Curve{speed, {}});
  for (const std::string& name : by_mast_angle.names()) {
    const Curve column = resampled(curve(pedal, name, "deg/in", "rad/in"), by_mast_angle.knot);
    for (std::size_t i = 0; i < stack.size(); ++i) stack[i].value.push_back(column.value[i]);
  }
  put_stack("controls.pedal_cyclic", pedal, {by_mast_angle.knot}, stack);

  put_single("controls.lateral_collective", "airframe/t8a-III_diff_collective_per_lateral_stick",
             "dtheta0_dXLT", "deg/in", "rad/in");
  put_single("controls.lever", "airframe/t8a-IV_collective", "dtheta0_dXCOL", "deg/in", "rad/in");
  put_single("controls.collective_floor", "airframe/t8a-IV_collective", "theta0LL_75R", "deg", "rad");
  put_single("controls.lateral_cyclic_gain", "airframe/t8a-VII_lateral_cyclic_gain_mast", "A1_bm_gain", "ND",
             "ND");
  put_single("controls.lateral_cyclic", "airframe/t8a-VIII_lateral_cyclic_airspeed", "A1_V", "degrees",
             "rad");
}

void Composer::check_the_rest() {
  namespace fs = std::filesystem;
  std::vector<std::string> names;
  for (const char* const part : {"airframe", "rotor_airfoil"}) {
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(folder_) / part))
      if (entry.path().extension() == ".csv")
        names.push_back(std::string(part) + "/" + entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    const auto is_list = [&](const char* list) { return fs::path(name).filename() == list; };
    if (std::any_of(std::begin(kLists), std::end(kLists), is_list)) {
      read_csv((fs::path(folder_) / name).string());
    } else {
      grid(name.substr(0, name.size() - 4));
    }
  }
}

// ---- the means ----

const Grid& Composer::grid(const std::string& name) {
  const auto known = grids_.find(name);
  if (known != grids_.end()) return known->second;
  return grids_.emplace(name, read_grid((std::filesystem::path(folder_) / (name + ".csv")).string()))
      .first->second;
}

Curve Composer::curve(const std::string& name, const std::string& column, const std::string& unit,
                      const std::string& to) {
  return grid(name).column(column, unit, to);
}

Surface Composer::surface(const std::string& name, const std::string& prefix, double scale) {
  const Grid& g = grid(name);
  std::vector<double> y = g.labels(g.names(), prefix);
  for (double& label : y) label /= scale;
  std::vector<Curve> columns;
  for (const std::string& column : g.names()) columns.push_back(g.column(column, "ND", "ND"));
  return side_by_side(columns, y);
}

void Composer::check_same_columns(const std::string& name, const std::string& as) {
  if (grid(name).names() != grid(as).names())
    throw Fault{grid(name).csv.file, grid(name).csv.header_line,
                "columns differ from those of " + grid(as).csv.file};
}

void Composer::put(const std::string& field, const std::string& source, const Curve& c) {
  tables.push_back({field, source, {c.knot}, {}, c.value});
}

void Composer::put(const std::string& field, const std::string& source, const Surface& s) {
  put_stack(field, source, {}, std::vector<Surface>{s});
}

void Composer::put_stack(const std::string& field, const std::string& source,
                         std::vector<std::vector<double>> linear, const std::vector<Surface>& stack) {
  std::vector<double> x;
  for (const Surface& s : stack) x = union_of(x, s.x);
  TableArray table{field, source, {x, stack.front().y}, std::move(linear), {}};
  for (const Surface& s : stack) {
    std::vector<Curve> columns;
    for (const Curve& column : s.column) columns.push_back(resampled(column, x));
    for (std::size_t i = 0; i < x.size(); ++i)
      for (const Curve& column : columns) table.value.push_back(column.value[i]);
  }
  tables.push_back(std::move(table));
}

void Composer::put_stack(const std::string& field, const std::string& source,
                         std::vector<std::vector<double>> linear, const std::vector<Curve>& stack) {
  std::vector<double> x;
  for (const Curve& c : stack) x = union_of(x, c.knot);
  TableArray table{field, source, {x}, std::move(linear), {}};
  for (const Curve& c : stack) {
    const Curve on_x = resampled(c, x);
    table.value.insert(table.value.end(), on_x.value.begin(), on_x.value.end());
  }
  tables.push_back(std::move(table));
}

void Composer::put_single(const std::string& field, const std::string& name, const std::string& column,
                          const std::string& unit, const std::string& to) {
  put(field, name, curve(name, column, unit, to));
}

void Composer::put_odd(const std::string& field, const std::string& name, const std::string& column,
                       const std::string& unit, const std::string& to) {
  const Curve half = curve(name, column, unit, to);
  const Csv& csv = grid(name).csv;
  if (half.knot.front() != 0 || half.value.front() != 0)
    throw Fault{csv.file, csv.rows.front().line, "an odd function must begin with 0 at 0"};
  put(field, name + ", odd half written out", with_odd_half(half));
}

void Composer::put_by_flap(const std::string& field, const std::string& name, const std::string& unit,
                           const std::string& to) {
  std::vector<Curve> stack;
  for (const std::string& flap : flap_names_) stack.push_back(curve(name, flap, unit, to));
  put_stack(field, name, {flap_deg_}, stack);
}

void Composer::by_mast(const std::string& field, const std::vector<MastFile>& files,
                       const std::string& prefix) {
  std::vector<double> mast;
  std::vector<Surface> stack;
  for (const MastFile& file : files) {
    check_same_columns(file.name, files.front().name);
    mast.push_back(file.mast_deg);
    stack.push_back(surface(file.name, prefix));
  }
  put_stack(field, std::string(files.front().name) + " and the other mast angles", {mast}, stack);
}

// What the smooth axes measure: all but these an angle.
struct AxisQuantity {
  const char* field;  // without its index
  std::size_t axis;
  const char* end_width;  // choice, and its unit
  const char* unit;
};
constexpr const char* kRatioWidth = "smooth_table_end_ratio";
constexpr const char* kSpeedWidth = "smooth_table_end_speed";
constexpr AxisQuantity kQuantities[] = {
    {"rotor.section_lift", 1, kRatioWidth, "ND"},    {"rotor.section_drag", 1, kRatioWidth, "ND"},
    {"rotor.side_by_side", 0, kRatioWidth, "ND"},    {"rotor.sideward", 0, kRatioWidth, "ND"},
    {"wing.lift_90", 1, kRatioWidth, "ND"},          {"wing.drag_90", 1, kRatioWidth, "ND"},
    {"htail.lift_mach", 1, kRatioWidth, "ND"},       {"htail.drag", 1, kRatioWidth, "ND"},
    {"fin.side_mach", 1, kRatioWidth, "ND"},         {"fin.drag", 1, kRatioWidth, "ND"},
    {"tail.control_mach", 0, kRatioWidth, "ND"},     {"htail.rotor_wash", 1, kSpeedWidth, "kt"},
    {"htail.pressure_ratio", 1, kSpeedWidth, "kt"},  {"fin.rotor_sidewash", 0, kSpeedWidth, "kt"},
    {"controls.pedal_cyclic", 0, kSpeedWidth, "kt"}, {"controls.lateral_cyclic", 0, kSpeedWidth, "kt"},
};

// Radial stations and what a mast or flap angle fixes for a run need no width: their arguments never leave
// the grid.
double end_width(const Entries& entries, const std::string& field, std::size_t axis) {
  const std::string name = field.substr(0, field.find('['));
  for (const AxisQuantity& q : kQuantities)
    if (name == q.field && axis == q.axis) return entries.in(q.end_width, q.unit);
  return entries.in("smooth_table_end_angle", "deg");
}

}  // namespace

std::vector<TableArray> compose_tables(const std::string& folder, const Entries& entries) {
  Composer composer(folder, entries);
  composer.rotor();
  composer.wing();
  composer.pylon_and_fuselage();
  composer.horizontal_tail();
  composer.fins();
  composer.controls();
  composer.check_the_rest();
  for (TableArray& table : composer.tables)
    for (std::size_t a = 0; a < table.smooth.size(); ++a)
      table.end_width.push_back(end_width(entries, table.field, a));
  return std::move(composer.tables);
}

}  // namespace tablegen
