// Single table look-ups of the compiled-in aircraft against tests/reference/lookups.csv, which a second,
// independent implementation computed from the same CSV files: this checks the composition of the tables, the
// units and both interpolants. The file holds 12 digits.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "check.hpp"
#include "run_program.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace {

using tiltrotor::Aircraft;
using tiltrotor::grid_point;
using tiltrotor::Interpolation;
using tiltrotor::lookup;
using tiltrotor::Table;

constexpr double kTolerance = 1e-10;
constexpr double kCubicFoot = 0.3048 * 0.3048 * 0.3048;  // m^3; the reference keeps the unit of the source

template <class R>
const Aircraft<R>& aircraft() {
  return tiltrotor::aircraft_data<R>();
}

// Smooth table with linear axes, all of them at their first knot.
template <class R, int Linear>
R at_first_knots(const Table<R, 2, Linear>& table, Interpolation mode, R x, R y) {
  tiltrotor::GridPoint<R> place[Linear];
  for (int a = 0; a < Linear; ++a) place[a] = grid_point(table.linear[a], table.linear[a].knot[0]);
  const R arguments[2] = {x, y};
  return lookup(table, mode, place, arguments);
}

struct Case {
  Interpolation mode;
  std::string table;
  double x, y, value;
};

std::vector<Case> read_cases() {
  std::ifstream in(check::source_path("tests/reference/lookups.csv"));
  std::vector<Case> cases;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    std::string mode, table, x, y, value;
    std::getline(cells, mode, ',');
    std::getline(cells, table, ',');
    std::getline(cells, x, ',');
    std::getline(cells, y, ',');
    std::getline(cells, value, ',');
    cases.push_back({mode == "c1" ? Interpolation::c1 : Interpolation::linear, table, std::stod(x),
                     y.empty() ? 0 : std::stod(y), std::stod(value)});
  }
  return cases;
}

// The table of one name of the reference file, in the unit of the source; sets `known`.
template <class R>
R evaluate(const Case& c, bool& known) {
  const Aircraft<R>& a = aircraft<R>();
  const Interpolation mode = c.mode;
  const R x = static_cast<R>(c.x);
  const R y = static_cast<R>(c.y);
  const std::string& name = c.table;
  known = true;
  const std::string section = "c81_region";
  if (name.compare(0, section.size(), section) == 0) {
    const int region = name[section.size()] - '1';
    const bool lift = name.substr(section.size() + 2) == "cl";
    return lookup(lift ? a.rotor.section_lift[region] : a.rotor.section_drag[region], mode, x, y);
  }
  if (name == "wing_CL_FL3_bm00") return lookup(a.wing.lift_0[2], mode, x);
  if (name == "wing_CD_FL3_bm00") return lookup(a.wing.drag_0[2], mode, x);
  if (name == "wing_CL_FL2_bm90") return lookup(a.wing.lift_90[1], mode, x, R(0));
  if (name == "wing_CL_FL1_bm90") return lookup(a.wing.lift_90[0], mode, x, y);
  if (name == "wing_CD_FL1_bm90") return lookup(a.wing.drag_90[0], mode, x, y);
  if (name == "htail_CL") return lookup(a.htail.lift_elevator, mode, x, y);
  if (name == "htail_CL_mach") return lookup(a.htail.lift_mach, mode, x, y);
  if (name == "htail_CD") return lookup(a.htail.drag, mode, x, y);
  if (name == "fuselage_M_alpha")
    return lookup(a.fuselage.moment_alpha, mode, x) / static_cast<R>(kCubicFoot);
  if (name == "tail_wash_bm00") return at_first_knots(a.htail.rotor_wash, mode, x, y);
  if (name == "tail_q_bm00") return at_first_knots(a.htail.pressure_ratio, mode, x, y);
  if (name == "fin_CY") return lookup(a.fin.side_rudder, mode, x, y);
  if (name == "sidewash_FL1_bm00") return at_first_knots(a.fin.sidewash, mode, x, y);
  if (name == "K_betaR") return lookup(a.fin.rotor_sidewash, mode, x, y);
  known = false;
  return R(0);
}

TEST_OF_XV15(lookups_agree_with_independent_implementation) {
  const std::vector<Case> cases = read_cases();
  CHECK_EQ(cases.size(), std::size_t{238});
  double worst = 0;
  for (const Case& c : cases) {
    bool known = false;
    const double value = evaluate<double>(c, known);
    if (!CHECK(known)) {
      NOTE("no table " << c.table);
      continue;
    }
    if (!CHECK_REL(value, c.value, kTolerance)) NOTE(c.table << " at " << c.x << ", " << c.y);
    if (c.value != 0) worst = std::max(worst, std::abs(value / c.value - 1));
  }
  NOTE(cases.size() << " look-ups, worst relative difference " << worst);
}

TEST_OF_XV15(lookups_in_single_precision) {
  for (const Case& c : read_cases()) {
    bool known = false;
    const float value = evaluate<float>(c, known);
    // Rounding of the argument times the steepest slope of the tables decides, not rounding of the value.
    if (!CHECK_NEAR(value, c.value, 3e-6 * std::max(1.0, std::abs(c.value)))) NOTE(c.table << " at " << c.x);
  }
}

// Values read by eye off the CSV files and converted by hand.
TEST_OF_XV15(aircraft_numbers_in_si) {
  const Aircraft<double>& a = aircraft<double>();
  CHECK_REL(a.mass.gross, 13000 * 0.45359237, 1e-15);
  CHECK_REL(a.mass.inertia.xx, 52795 * 1.3558179483314004, 1e-14);
  CHECK_REL(a.mass.inertia_slope.yy, -11.24 * 1.3558179483314004, 1e-14);
  CHECK_REL(a.mast.length, 4.667 * 0.3048, 1e-15);
  CHECK_REL(a.wing.area, 181 * 0.09290304, 1e-15);
  CHECK_REL(a.rotor.speed_helicopter, 589 * 2 * 3.14159265358979323846 / 60, 1e-15);
  CHECK_REL(a.rotor.hub_spring, 12891.5503904 * 1.3558179483314004, 1e-10);
  CHECK_REL(a.controls.elevator, 4.167 * 3.14159265358979323846 / 180, 1e-15);
  CHECK_REL(a.controls.power_limit, 1160 * 745.69987158227, 1e-14);
  CHECK_EQ(a.controls.long_travel, 4.8);
  CHECK_EQ(a.wing.rotor_wash_1, 3.341e-05);
  CHECK_EQ(a.rotor.blades, 3);
  CHECK_EQ(a.fin.surface.area, 25.25 * 0.09290304);
  CHECK_REL(a.smooth.angle, 0.5 * 3.14159265358979323846 / 180, 1e-15);
}

// The odd halves are written out: beta = 0 is an inner knot with a slope.
TEST(odd_fuselage_tables_have_a_slope_at_zero) {
  const auto& f = aircraft<double>().fuselage;
  for (const auto* table : {&f.side_beta, &f.roll_beta, &f.yaw_beta}) {
    for (const double beta : {0.0, 3.0, 10.0, 77.0, 180.0}) {
      for (const Interpolation mode : {Interpolation::c1, Interpolation::linear})
        CHECK_NEAR(lookup(*table, mode, -beta), -lookup(*table, mode, beta), 1e-14);
    }
    CHECK(std::abs(lookup(*table, Interpolation::c1, 0.01)) > 1e-4);
  }
}

// Table 4-V(c), alpha 8 deg, flap 40/25: 7.7 deg. Table 8a-II, mast 30 deg, 80 kt: 0.9 deg/in.
TEST_OF_XV15(tables_with_linear_axes_hit_printed_cells) {
  const Aircraft<double>& a = aircraft<double>();
  const double degree = 3.14159265358979323846 / 180;
  const auto& downwash = a.wing.downwash;
  const tiltrotor::GridPoint<double> at[2] = {grid_point(downwash.linear[0], 30.0),
                                              grid_point(downwash.linear[1], 40.0)};
  const double alpha[1] = {8.0};
  CHECK_REL(lookup(downwash, Interpolation::c1, at, alpha), 7.7 * degree, 1e-14);
  const tiltrotor::GridPoint<double> mast[1] = {grid_point(a.controls.pedal_cyclic.linear[0], 30.0)};
  const double speed[1] = {80.0};
  CHECK_REL(lookup(a.controls.pedal_cyclic, Interpolation::c1, mast, speed), 0.9 * degree, 1e-14);
  // Sidewash, table 6-VI, flap 40/25, mast 60 deg, alpha -3 deg, sideslip 16 deg: 1.117.
  const tiltrotor::GridPoint<double> sidewash[2] = {grid_point(a.fin.sidewash.linear[0], 60.0),
                                                    grid_point(a.fin.sidewash.linear[1], 40.0)};
  const double angles[2] = {-3.0, 16.0};
  CHECK_REL(lookup(a.fin.sidewash, Interpolation::c1, sidewash, angles), 1.117, 1e-14);
}

}  // namespace
