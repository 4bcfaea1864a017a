// The C2 tables of the compiled-in aircraft: within print, two derivatives without a jump, no rougher than the C1 ones.
// Expected: the digits of the CSV files, read here; one-sided differences, exact for cubics; symmetry of the print.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include "c2_tables.inc"
#include "check.hpp"
#include "run_program.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/aircraft/c2_aircraft.hpp"

namespace {

using namespace tiltrotor;

// Visits every fitted table with its namesake of the C1 aircraft.
template <class Visit>
void every_pair(Visit&& visit) {
  Aircraft<double> smooth = c2_aircraft_data();
  Aircraft<double> usual = aircraft_data<double>();
  std::map<std::string, const void*> tables;
  c2_tables::visit_print(usual, [&](const char* name, auto& t, const double*) { tables[name] = &t; });
  c2_tables::visit_print(smooth, [&](const char* name, auto& t, const double* half) {
    visit(name, t, *static_cast<const std::decay_t<decltype(t)>*>(tables.at(name)), half);
  });
}

template <int Smooth, int Linear>
int values_of_block(const Table<double, Smooth, Linear>& t) {
  int values = 1;
  for (const Axis<double>& axis : t.smooth) values *= axis.count;
  return values;
}
template <int Smooth, int Linear>
int blocks_of(const Table<double, Smooth, Linear>& t) {
  int blocks = 1;
  for (int a = 0; a < Linear; ++a) blocks *= t.linear[a].count;
  return blocks;
}

// The lines of knots of every block along one axis: visit(count, knot, node of knot 0, numbers from knot to knot).
template <int Smooth, int Linear, class Visit>
void every_line(const Table<double, Smooth, Linear>& t, int axis, Visit&& visit) {
  const int values = values_of_block(t);
  const int step = axis == Smooth - 1 ? 1 : t.smooth[Smooth - 1].count;
  for (int block = 0; block < blocks_of(t); ++block)
    for (int k = 0; k < values; ++k)
      if (k / step % t.smooth[axis].count == 0)
        visit(t.smooth[axis].count, t.smooth[axis].knot, t.node + (block * values + k) * (1 << Smooth),
              step * (1 << Smooth));
}

// Second derivatives at the ends of the cubic between two knots, from values and slopes.
struct Bend {
  double left, right;
};
Bend bend(double h, double f0, double f1, double m0, double m1) {
  const double rise = 6 * (f1 - f0) / h;
  return {(rise - 4 * m0 - 2 * m1) / h, (2 * m0 + 4 * m1 - rise) / h};
}

// Axes that are fitted with two derivatives: all but a second one of Mach numbers.
bool is_smooth_axis(const std::string& name, int axis) {
  for (const char* over_mach : {"rotor.section", "wing.lift_90", "wing.drag_90", "htail.lift_mach",
                                "htail.drag", "fin.side_mach", "fin.drag"})
    if (axis == 1 && name.compare(0, std::string(over_mach).size(), over_mach) == 0) return false;
  return true;
}

// ---- digits as printed, read from the files once more ----

struct Cell {
  double value, half;
};
struct Printed {  // numbers over the knots, by column
  std::map<std::string, std::vector<std::pair<double, Cell>>> column;
};

int places(const std::string& cell) {
  return cell.find('.') == std::string::npos ? 0 : static_cast<int>(cell.size() - cell.find('.') - 1);
}

Printed printed(const std::string& file) {
  std::ifstream in(check::source_path("tables/xv15/" + file + ".csv"));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    rows.emplace_back();
    std::istringstream cells(line + ",");
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  // Most numbers that have decimals show so many; zeros at the end are left away.
  int count[10] = {};
  for (std::size_t r = 1; r < rows.size(); ++r)
    for (std::size_t c = 1; c < rows[r].size(); ++c) ++count[places(rows[r][c])];
  count[0] = 0;
  int usual = 0;
  for (int p = 1; p < 10; ++p)
    if (count[p] > 0 && (usual == 0 || count[p] >= count[usual])) usual = p;
  Printed result;
  for (std::size_t r = 1; r < rows.size(); ++r)
    for (std::size_t c = 1; c < rows[r].size(); ++c)
      if (!rows[r][c].empty())
        result.column[rows[0][c]].push_back(
            {std::stod(rows[r][0]),
             {std::stod(rows[r][c]), 0.5 * std::pow(10.0, -std::max(usual, places(rows[r][c])))}});
  return result;
}

struct Deviations {
  int nodes = 0, moved = 0;
  double largest = 0;  // half units

  void add(double found, const Cell& cell, double unit) {
    const double off = std::fabs(found - cell.value * unit) / (cell.half * unit);
    CHECK_LE(off, 1 + 1e-9);
    largest = std::max(largest, off);
    moved += off > 1e-6 ? 1 : 0;
    ++nodes;
  }
};

template <int Linear>
void check_column(const Table<double, 1, Linear>& t, const GridPoint<double> (&at)[Linear],
                  const std::string& file, const std::string& column, double unit, Deviations& all) {
  const Printed table = printed(file);
  for (const auto& [x, cell] : table.column.at(column)) {
    const double place[1] = {x};
    all.add(lookup(t, Interpolation::c1, at, place), cell, unit);
  }
}
void check_column(const Table<double, 1>& t, const std::string& file, const std::string& column, double unit,
                  Deviations& all) {
  const Printed table = printed(file);
  for (const auto& [x, cell] : table.column.at(column)) all.add(lookup(t, Interpolation::c1, x), cell, unit);
}
// Columns named letter and number.
double label(const std::string& name, double scale) {
  const std::size_t digits = name.find_first_of("0123456789");
  return (name[digits - 1] == 'm' ? -1 : 1) * std::stod(name.substr(digits)) / scale;
}
void check_surface(const Table<double, 2>& t, const std::string& file, double scale, Deviations& all) {
  const Printed table = printed(file);
  for (const auto& [name, column] : table.column)
    for (const auto& [x, cell] : column)
      all.add(lookup(t, Interpolation::c1, x, label(name, scale)), cell, 1);
}
template <int Linear>
void check_surface(const Table<double, 2, Linear>& t, const GridPoint<double> (&at)[Linear],
                   const std::string& file, Deviations& all) {
  const Printed table = printed(file);
  for (const auto& [name, column] : table.column) {
    for (const auto& [x, cell] : column) {
      const double place[2] = {x, label(name, 1)};
      all.add(lookup(t, Interpolation::c1, at, place), cell, 1);
    }
  }
}

}  // namespace

TEST_OF_XV15(lookups_c2_are_within_half_a_unit_of_print) {
  const Aircraft<double>& a = c2_aircraft_data();
  constexpr double foot = 0.3048, degree = 3.14159265358979323846 / 180;
  Deviations all;
  const char* const regions[] = {"region1_inboard", "region2_mid", "region3_outboard", "region4_tip"};
  for (int i = 0; i < kSectionRegions; ++i) {
    const std::string file = std::string("rotor_airfoil/c81_") + regions[i];
    check_surface(a.rotor.section_lift[i], file + "_cl", 100, all);
    check_surface(a.rotor.section_drag[i], file + "_cd", 100, all);
  }
  check_column(a.wing.lift_0[0], "airframe/t4-I_wing_CL_flap0", "bm00", 1, all);
  check_column(a.wing.drag_0[0], "airframe/t4-III_wing_CD_flap0", "bm00", 1, all);
  const double masts[] = {0, 15, 30, 60, 90};
  const char* const downwash[] = {"e_wing_downwash_bm00", "d_wing_downwash_bm15", "c_wing_downwash_bm30",
                                  "b_wing_downwash_bm60", "a_wing_downwash_bm90"};
  const char* const wash[] = {"a_rotor_wake_htail_bm00", "b_rotor_wake_htail_bm15", "c_rotor_wake_htail_bm30",
                              "d_rotor_wake_htail_bm60_90", "d_rotor_wake_htail_bm60_90"};
  for (int m = 0; m < 5; ++m) {
    for (int flap = 0; flap < 4; ++flap) {
      const GridPoint<double> at[2] = {grid_point(a.wing.downwash.linear[0], masts[m]),
                                       grid_point(a.wing.downwash.linear[1], a.wing.flap_deg[flap])};
      check_column(a.wing.downwash, at, std::string("airframe/t4-V_") + downwash[m],
                   "FL" + std::to_string(flap + 1), degree, all);
    }
    const GridPoint<double> at[1] = {grid_point(a.htail.rotor_wash.linear[0], masts[m])};
    check_surface(a.htail.rotor_wash, at, std::string("airframe/t2-I_") + wash[m], all);
  }
  const char* const ratio[] = {"a_htail_q_ratio_bm00", "b_htail_q_ratio_bm15"};
  for (int m = 0; m < 2; ++m) {
    const GridPoint<double> at[1] = {grid_point(a.htail.pressure_ratio.linear[0], masts[m])};
    check_surface(a.htail.pressure_ratio, at, std::string("airframe/t5-V_") + ratio[m], all);
  }
  check_surface(a.htail.lift_elevator, "airframe/t5-I_htail_CL_elevator", 1, all);
  check_surface(a.htail.drag, "airframe/t5-III_htail_CD", 100, all);
  check_surface(a.fin.side_rudder, "airframe/t6-I_vtail_CY_rudder", 1, all);
  check_surface(a.fin.drag, "airframe/t6-III_vtail_CD", 100, all);
  check_surface(a.fin.rotor_sidewash, "airframe/t6-VIII_rotor_sidewash_factor", 1, all);
  const FuselageTables<double>& f = a.fuselage;
  const double square = foot * foot, cube = square * foot;
  check_column(f.lift_alpha, "airframe/t3-I_fuselage_L_alpha", "L_alpha", square, all);
  check_column(f.drag_alpha, "airframe/t3-III_fuselage_D_alpha", "D_alpha", square, all);
  check_column(f.moment_alpha, "airframe/t3-V_fuselage_M_alpha", "M_alpha", cube, all);
  check_column(f.lift_beta, "airframe/t3-II_fuselage_L_beta", "L_beta", square, all);
  check_column(f.side_beta, "airframe/t3-VII_fuselage_Y_beta", "Y_beta", square, all);
  check_column(f.yaw_beta, "airframe/t3-IX_fuselage_N_beta", "N_beta", cube, all);
  check_column(a.pylon.interference, "airframe/t4-XV_pylon_interference_drag", "D_PYINT", square, all);
  check_column(a.tail.control_mach, "airframe/t5-IV_control_mach_factor", "X_K", 1, all);
  NOTE(all.nodes << " printed nodes, " << all.moved << " moved, at most " << all.largest << " half units");
  CHECK(all.nodes > 3000);
  CHECK(all.moved > all.nodes / 3);
}

TEST(lookups_c2_have_no_jump_in_two_derivatives) {
  double largest = 0, of_c1 = 0;
  every_pair([&](const char* name, const auto& smooth, const auto& usual, const double*) {
    constexpr int axes = sizeof(smooth.smooth) / sizeof(smooth.smooth[0]);
    for (int axis = 0; axis < axes; ++axis) {
      if (!is_smooth_axis(name, axis)) continue;
      // Numbers of a node that have no derivative along this axis yet: every one of them is a C2 line.
      for (int number = 0; number < (1 << axes); ++number) {
        if ((number >> axis & 1) != 0) continue;
        const auto jump_over_size = [&](const auto& table) {
          double jump = 0, size = 1e-9;
          every_line(table, axis, [&](int count, const double* knot, const double* node, int stride) {
            double before = 0;
            for (int i = 0; i + 1 < count; ++i, node += stride) {
              const double* const right = node + stride;
              const int slope = number + (1 << axis);
              const Bend b =
                  bend(knot[i + 1] - knot[i], node[number], right[number], node[slope], right[slope]);
              if (i > 0) jump = std::max(jump, std::fabs(b.left - before));
              size = std::max({size, std::fabs(b.left), std::fabs(b.right)});
              before = b.right;
            }
          });
          return jump / size;
        };
        const double found = jump_over_size(smooth);
        if (!CHECK_LE(found, 1e-8)) NOTE(name << ", axis " << axis << ", number " << number);
        largest = std::max(largest, found);
        of_c1 = std::max(of_c1, jump_over_size(usual));
      }
    }
  });
  NOTE("largest jump " << largest << " of the largest second derivative; C1: " << of_c1);
  CHECK(of_c1 > 0.5);
}

// What is looked up is what the nodes say: differences of look-ups on both sides of inner knots.
TEST(lookups_c2_bend_alike_on_both_sides_of_a_knot) {
  const Aircraft<double>& a = c2_aircraft_data();
  for (const Table<double, 1>* t : {&a.fuselage.moment_alpha, &a.wing.lift_0[0], &a.pylon.side_plate}) {
    const Axis<double>& axis = t->smooth[0];
    double size = 0, worst = 0;
    for (int i = 1; i + 1 < axis.count; ++i) {
      const auto f = [&](double from) { return lookup(*t, Interpolation::c1, axis.knot[i] + from); };
      const double e = 0.01 * std::min(axis.knot[i] - axis.knot[i - 1], axis.knot[i + 1] - axis.knot[i]);
      // Of a cubic: 2 f(0) - 5 f(e) + 4 f(2e) - f(3e) = e^2 f''.
      const auto second = [&](double s) { return (2 * f(0) - 5 * f(s) + 4 * f(2 * s) - f(3 * s)) / (e * e); };
      size = std::max(size, std::fabs(second(e)));
      worst = std::max(worst, std::fabs(second(e) - second(-e)));
    }
    CHECK_LE(worst, 1e-6 * size);
  }
}

TEST(lookups_c2_are_no_rougher_than_c1) {
  double ratio_low = 1, ratio_high = 0;
  every_pair([&](const char* name, const auto& smooth, const auto& usual, const double*) {
    double sums[2] = {};
    const auto add = [](double& sum) {
      return [&sum](int count, const double* knot, const double* node, int stride) {
        for (int i = 0; i + 1 < count; ++i, node += stride) {
          const double h = knot[i + 1] - knot[i];
          const Bend b = bend(h, node[0], node[stride], node[1], node[stride + 1]);
          sum += h / 3 * (b.left * b.left + b.left * b.right + b.right * b.right);
        }
      };
    };
    every_line(smooth, 0, add(sums[0]));
    every_line(usual, 0, add(sums[1]));
    if (!CHECK_LE(sums[0], sums[1] * (1 + 1e-9) + 1e-30)) NOTE(name);
    if (sums[1] < 1e-30) return;  // straight but for rounding
    ratio_low = std::min(ratio_low, sums[0] / sums[1]);
    ratio_high = std::max(ratio_high, sums[0] / sums[1]);
  });
  NOTE("roughness " << ratio_low << " to " << ratio_high << " of the C1 curves'");
  CHECK(ratio_low < 1);
}

TEST(lookups_c2_keep_the_symmetry_of_print) {
  const FuselageTables<double>& f = c2_aircraft_data().fuselage;
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> angle(0, 179);
  for (const Table<double, 1>* t : {&f.side_beta, &f.roll_beta, &f.yaw_beta}) {
    CHECK_EQ(lookup(*t, Interpolation::c1, 0.0), 0.0);
    for (int i = 0; i < t->smooth[0].count; ++i) {
      const double* const here = t->node + 2 * i;
      const double* const there = t->node + 2 * (t->smooth[0].count - 1 - i);
      CHECK(here[0] == -there[0] && here[1] == there[1]);
    }
    for (int n = 0; n < 50; ++n) {
      const double x = angle(engine);
      CHECK_NEAR(lookup(*t, Interpolation::c1, x), -lookup(*t, Interpolation::c1, -x), 1e-12);
    }
  }
}

// Sections and airframe have drag at every angle and Mach number of the tables but close to flight backwards.
TEST_OF_XV15(lookups_c2_have_drag) {
  const Aircraft<double>& a = c2_aircraft_data();
  const auto least = [](const auto& t, double mach, double end) {
    double drag = 1;
    for (double x = -end; x <= end; x += 0.25)
      drag = std::min(drag, lookup(t, Interpolation::c1, std::max(x, t.smooth[0].knot[0]), mach));
    return drag;
  };
  for (double mach = 0; mach < 1; mach += 0.02) {
    for (const auto& section : a.rotor.section_drag) CHECK(least(section, mach, 30) > 0.001);
    for (int i = 0; i < a.wing.flap_settings; ++i) CHECK(least(a.wing.drag_90[i], mach, 180) > 0.01);
    CHECK(least(a.htail.drag, mach, 150) > 0.005);
    CHECK(least(a.fin.drag, mach, 150) > 0.005);
  }
}

// The default aircraft is not touched by the other one.
TEST(lookups_c2_tables_are_another_aircraft) {
  CHECK(has_c2_tables(c2_aircraft_data()));
  CHECK(!has_c2_tables(aircraft_data<double>()));
  CHECK_EQ(c2_aircraft_data().mass.gross, aircraft_data<double>().mass.gross);
  CHECK_EQ(c2_aircraft_data().rotor.twist.node[0], aircraft_data<double>().rotor.twist.node[0]);
  CHECK_EQ(c2_aircraft_data().controls.long_cyclic.node[2],
           aircraft_data<double>().controls.long_cyclic.node[2]);
}
