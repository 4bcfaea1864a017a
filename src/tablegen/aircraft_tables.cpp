#include "tablegen/aircraft_tables.hpp"

#include "tablegen/composer.hpp"
#include "tablegen/fault.hpp"
#include "tiltrotor/model/aircraft/aircraft.hpp"

namespace tablegen {

// ---- the aircraft, part by part ----

void Composer::rotor() {
  put_single("rotor.twist", "twist_deg", "deg", "rad");
  put_single("rotor.chord_cutout", "chord_cutout_in", "in", "m", "rotor.chord");
  put_single("rotor.chord_text", "chord_text_in", "in", "m", "rotor.chord");
  put_single("rotor.chord_camrad", "chord_camrad_in", "in", "m", "rotor.chord");
  for (int i = 0; i < tiltrotor::kSectionRegions; ++i) {
    const std::string index = "[" + std::to_string(i) + "]";
    const std::string region = "region " + std::to_string(i + 1);
    const std::string lift = files_.file("rotor.section_lift", region);
    const std::string drag = files_.file("rotor.section_drag", region);
    put("rotor.section_lift" + index, lift, from_mach_0(surface(lift, "M", 100)));
    put("rotor.section_drag" + index, drag, from_mach_0(surface(drag, "M", 100)));
  }
  put_single("rotor.side_by_side", "X_SS", "ND", "ND");
  put_single("rotor.sideward", "X_SF", "ND", "ND");
}

void Composer::wing() {
  wing_coefficient("wing.lift");
  wing_coefficient("wing.drag");

  std::vector<double> mast;
  std::vector<Curve> stack;
  const std::vector<Composition::Part> downwash = files_.by_mast("wing.downwash");
  for (const Composition::Part& part : downwash) {
    mast.push_back(part.mast_deg);
    for (const std::string& flap : flap_names_) stack.push_back(curve(part.file, flap, "deg", "rad"));
  }
  put_stack("wing.downwash", downwash.front().file + " and the other mast angles", {mast, flap_deg_}, stack);

  put_by_flap("wing.moment", "ND", "ND");
  put_by_flap("wing.roll_beta", "1/rad", "1/rad");
  put_by_flap("wing.roll_beta_per_lift", "1/rad", "1/rad");
  put_by_flap("wing.zero_lift_drag", "ND", "ND");
  put_by_flap("wing.aileron_roll", "ND", "ND");
  put_by_flap("wing.aileron_yaw_0", "1/deg", "1/rad");
  put_by_flap("wing.aileron_yaw", "ND", "ND");
  aileron_lift_loss();
}

void Composer::aileron_lift_loss() {
  const std::string name = files_.file("wing.aileron_lift_loss");
  const Csv& csv = grid(name).csv;
  for (std::size_t i = 0; i < csv.rows.size(); ++i) {
    const bool known = i < flap_names_.size() && csv.rows[i].cell[0] == flap_names_[i];
    if (!known)
      throw Fault{csv.file, csv.rows[i].line, "flap setting '" + csv.rows[i].cell[0] + "' out of order"};
  }
  if (csv.rows.size() < flap_names_.size())
    throw Fault{csv.file, csv.rows.back().line, "row '" + flap_names_[csv.rows.size()] + "' is missing"};
  const Curve loss = curve(name, "CL_delta_a", "1/deg", "1/rad");
  put("wing.aileron_lift_loss", name, Curve{flap_deg_, loss.value, loss.half});
}

// Lift or drag. The clean wing depends on Mach number at mast 90; a Mach column that is shorter than the
// table keeps its end value. Outside the range of its own column every curve goes on with the extension of
// its flap setting, which goes round the whole circle.
void Composer::wing_coefficient(const std::string& field) {
  const std::string clean = files_.file(field, "clean");
  const std::string flaps = files_.file(field, "flaps");
  const std::string extension = files_.file(field, "extension");
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
  put_single("pylon.interference", "D_PYINT", "ft2", "m2");
  put_single("pylon.side_plate", "K_PLAT", "ND", "ND");

  put_single("fuselage.lift_alpha", "L_alpha", "ft2", "m2");
  put_single("fuselage.drag_alpha", "D_alpha", "ft2", "m2");
  put_single("fuselage.moment_alpha", "M_alpha", "ft3", "m3");
  put_single("fuselage.lift_beta", "L_beta", "ft2", "m2");
  put_single("fuselage.drag_beta", "D_beta", "ft2", "m2");
  put_single("fuselage.moment_beta", "M_beta", "ft3", "m3");
  put_odd("fuselage.side_beta", "Y_beta", "ft2", "m2");
  put_odd("fuselage.roll_beta", "l_beta", "ft3", "m3");
  put_odd("fuselage.yaw_beta", "N_beta", "ft3", "m3");
}

Composer::MastStack Composer::stacked_by_mast(const std::vector<Composition::Part>& parts) {
  MastStack stack;
  for (const Composition::Part& part : parts) {
    check_same_columns(part.file, parts.front().file);
    stack.mast_deg.push_back(part.mast_deg);
    stack.surface.push_back(surface(part.file, "V"));
  }
  return stack;
}

void Composer::horizontal_tail() {
  const std::vector<Composition::Part> wash = files_.by_mast("htail.rotor_wash");
  const MastStack by_file = stacked_by_mast(wash);
  put_stack("htail.rotor_wash", wash.front().file + " and the other mast angles", {by_file.mast_deg},
            by_file.surface);

  const std::string wash_beta = files_.file("htail.rotor_wash_beta");
  const Surface by_mast_angle = surface(wash_beta, "bm");
  put_stack("htail.rotor_wash_beta", wash_beta, {by_mast_angle.y}, by_mast_angle.column);

  const std::string lift = files_.file("htail.lift_elevator");
  put("htail.lift_elevator", lift, surface(lift, "e"));
  below_mach("htail.lift_mach", "htail.lift_elevator", "e00");
  put_mach("htail.drag");
  pressure_ratio();

  put_single("tail.control_mach", "X_K", "ND", "ND");
  put_single("tail.sideslip_loss", "K_beta", "ND", "ND");
}

// A file for each of the first mast angles; above them the ratio does not depend on speed, and one file has a
// column for each mast angle.
void Composer::pressure_ratio() {
  const std::vector<Composition::Part> first = files_.by_mast("htail.pressure_ratio");
  auto [mast, stack] = stacked_by_mast(first);
  const std::string name = files_.file("htail.pressure_ratio", "all speeds");
  const Surface above = surface(name, "bm");
  if (!(mast.back() < above.y.front()))
    throw Fault{grid(name).csv.file, grid(name).csv.header_line, "first mast angle is not above the others"};
  for (std::size_t i = 0; i < above.y.size(); ++i) {
    mast.push_back(above.y[i]);
    const std::vector<double>& speed = stack[0].y;
    stack.push_back(side_by_side(std::vector<Curve>(speed.size(), above.column[i]), speed));
  }
  put_stack("htail.pressure_ratio", first.front().file + " and the other mast angles", {mast}, stack);
}

void Composer::fins() {
  const std::string side = files_.file("fin.side_rudder");
  put("fin.side_rudder", side, surface(side, "r"));
  below_mach("fin.side_mach", "fin.side_rudder", "r00");
  put_mach("fin.drag");

  const std::vector<Composition::Part> sidewash = files_.by_mast_and_flap("fin.sidewash");
  std::vector<double> mast;
  std::vector<Surface> stack;
  for (const Composition::Part& part : sidewash) {
    if (part.setting == 1) mast.push_back(part.mast_deg);
    check_same_columns(part.file, sidewash.front().file);
    stack.push_back(surface(part.file, "b"));
  }
  put_stack("fin.sidewash", sidewash.front().file + " and the others", {mast, flap_deg_}, stack);
  const std::string rotor_sidewash = files_.file("fin.rotor_sidewash");
  put("fin.rotor_sidewash", rotor_sidewash, surface(rotor_sidewash, "b"));
}

// A table that starts at a higher Mach number and takes its low-Mach column from another: that column stands
// at Mach 0 and at the end of the incompressible range, on the knots of both files, shorter columns held.
void Composer::below_mach(const std::string& field, const std::string& low_table,
                          const std::string& low_column) {
  const std::string name = files_.file(field);
  const std::string low_name = files_.file(low_table);
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
  put_single("controls.long_cyclic", "dB1_dXLN", "deg/in", "rad/in");

  // Printed by mast angle, a column for each speed; read by speed, a block for each mast angle.
  const std::string pedal = files_.file("controls.pedal_cyclic");
  const Grid& by_mast_angle = grid(pedal);
  const std::vector<double> speed = by_mast_angle.labels(by_mast_angle.names(), "V");
  std::vector<Curve> stack(by_mast_angle.knot.size(), Curve{speed, {}, {}});
  for (const std::string& name : by_mast_angle.names()) {
    const Curve column = resampled(curve(pedal, name, "deg/in", "rad/in"), by_mast_angle.knot);
    for (std::size_t i = 0; i < stack.size(); ++i) {
      stack[i].value.push_back(column.value[i]);
      stack[i].half.push_back(column.half[i]);
    }
  }
  put_stack("controls.pedal_cyclic", pedal, {by_mast_angle.knot}, stack);

  put_single("controls.lateral_collective", "dtheta0_dXLT", "deg/in", "rad/in");
  put_single("controls.lateral_cyclic_gain", "A1_bm_gain", "ND", "ND");
  put_single("controls.lateral_cyclic", "A1_V", "degrees", "rad");

  put_single("systems.augmentation.pitch", "K_pitch", "in s/rad", "in s/rad");
  put_single("systems.augmentation.roll", "K_roll", "in s/rad", "in s/rad");
  put_single("systems.augmentation.yaw", "K_yaw", "in s/rad", "in s/rad");
  put_single("systems.governor.proportional", "K_proportional", "rad", "rad");
  put_single("systems.governor.integral", "K_integral", "rad/s", "rad/s");
}

namespace {

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

const AxisQuantity* quantity(const std::string& field, std::size_t axis) {
  const std::string name = field.substr(0, field.find('['));
  for (const AxisQuantity& q : kQuantities)
    if (name == q.field && axis == q.axis) return &q;
  return nullptr;
}

// Radial stations and what a mast or flap angle fixes for a run need no width: their arguments never leave
// the grid.
double end_width(const Entries& entries, const std::string& field, std::size_t axis) {
  if (const AxisQuantity* const q = quantity(field, axis)) return entries.in(q->end_width, q->unit);
  return entries.in("smooth_table_end_angle", "deg");
}

}  // namespace

std::vector<double> flap_settings(const Entries& entries) {
  std::vector<double> angles;
  for (int i = 1; i <= tiltrotor::kMostFlapSettings; ++i) {
    const std::string name = "flap_setting_" + std::to_string(i);
    if (i > 2 && !entries.has(name)) break;
    const double angle = entries.in(name, "deg");
    if (!angles.empty() && !(angles.back() < angle)) entries.refuse(name, "flap settings do not increase");
    angles.push_back(angle);
  }
  const std::string beyond = "flap_setting_" + std::to_string(angles.size() + 1);
  if (static_cast<int>(angles.size()) == tiltrotor::kMostFlapSettings && entries.has(beyond))
    entries.refuse(beyond, "there are at most " + std::to_string(angles.size()) + " flap settings");
  return angles;
}

std::vector<TableArray> compose_tables(const std::string& folder, const Entries& entries) {
  Composer composer(folder, entries);
  composer.rotor();
  composer.wing();
  composer.pylon_and_fuselage();
  composer.horizontal_tail();
  composer.fins();
  composer.controls();
  composer.check_the_rest();
  for (TableArray& table : composer.tables) {
    for (std::size_t a = 0; a < table.smooth.size(); ++a)
      table.end_width.push_back(end_width(entries, table.field, a));
    const AxisQuantity* const second = quantity(table.field, 1);
    table.over_mach = second != nullptr && second->end_width == kRatioWidth;
  }
  return std::move(composer.tables);
}

}  // namespace tablegen
