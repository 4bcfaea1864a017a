// Where tables end: every table of the compiled-in aircraft, every smooth axis,
// both ends. The criteria need no formula: value and slope have no jump, and
// the end value holds from the named width on. The shape between is compared
// with its formula on a table made here.
#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <type_traits>

#include "check.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"
#include "tiltrotor/math/differentiation/dual.hpp"
#include "tiltrotor/math/tables/table_slopes.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace {

using namespace tiltrotor;
using D = Dual<double, 2>;
using C = std::complex<double>;

const Aircraft<double>& aircraft() { return aircraft_data<double>(); }

template <class T>
inline constexpr int kSmoothAxes = 0;
template <int Smooth, int Linear>
inline constexpr int kSmoothAxes<Table<double, Smooth, Linear>> = Smooth;

template <class Visit>
void every_table(Visit&& visit) {
  const Aircraft<double>& a = aircraft();
  for (int i = 0; i < kSectionRegions; ++i) {
    visit("rotor.section_lift", a.rotor.section_lift[i]);
    visit("rotor.section_drag", a.rotor.section_drag[i]);
  }
  visit("rotor.side_by_side", a.rotor.side_by_side);
  visit("rotor.sideward", a.rotor.sideward);
  for (int i = 0; i < a.wing.flap_settings; ++i) {
    visit("wing.lift_0", a.wing.lift_0[i]);
    visit("wing.drag_0", a.wing.drag_0[i]);
    visit("wing.lift_90", a.wing.lift_90[i]);
    visit("wing.drag_90", a.wing.drag_90[i]);
  }
  visit("wing.downwash", a.wing.downwash);
  visit("pylon.side_plate", a.pylon.side_plate);
  const FuselageTables<double>& f = a.fuselage;
  for (const Table<double, 1>* t : {&f.lift_alpha, &f.drag_alpha, &f.moment_alpha, &f.lift_beta, &f.drag_beta,
                                    &f.moment_beta, &f.side_beta, &f.roll_beta, &f.yaw_beta})
    visit("fuselage", *t);
  visit("htail.rotor_wash", a.htail.rotor_wash);
  visit("htail.rotor_wash_beta", a.htail.rotor_wash_beta);
  visit("htail.lift_elevator", a.htail.lift_elevator);
  visit("htail.lift_mach", a.htail.lift_mach);
  visit("htail.drag", a.htail.drag);
  visit("htail.pressure_ratio", a.htail.pressure_ratio);
  visit("fin.side_rudder", a.fin.side_rudder);
  visit("fin.side_mach", a.fin.side_mach);
  visit("fin.drag", a.fin.drag);
  visit("fin.sidewash", a.fin.sidewash);
  visit("fin.rotor_sidewash", a.fin.rotor_sidewash);
  visit("tail.control_mach", a.tail.control_mach);
  visit("tail.sideslip_loss", a.tail.sideslip_loss);
  visit("controls.pedal_cyclic", a.controls.pedal_cyclic);
  visit("controls.lateral_cyclic", a.controls.lateral_cyclic);
}

// Look-up with the linear axes at the knots that `block` counts.
template <class T, int Smooth, int Linear>
T look(const Table<double, Smooth, Linear>& t, Interpolation mode, int block, const T (&x)[Smooth]) {
  if constexpr (Linear == 0) {
    if constexpr (Smooth == 1) return lookup(t, mode, x[0]);
    if constexpr (Smooth == 2) return lookup(t, mode, x[0], x[1]);
  } else {
    GridPoint<double> place[Linear];
    for (int a = 0; a < Linear; ++a) {
      place[a] = grid_point(t.linear[a], t.linear[a].knot[block % t.linear[a].count]);
      block /= t.linear[a].count;
    }
    return lookup(t, mode, place, x);
  }
}
template <int Smooth, int Linear>
int blocks(const Table<double, Smooth, Linear>& t) {
  int count = 1;
  for (int a = 0; a < Linear; ++a) count *= t.linear[a].count;
  return count;
}

// Visits every end of every axis with the other argument at several places;
// `at(x)` looks up there.
template <class Visit>
void every_end(Visit&& visit) {
  std::mt19937 engine(8);
  every_table([&](const char* name, const auto& t) {
    constexpr int kSmooth = kSmoothAxes<std::decay_t<decltype(t)>>;
    for (int axis = 0; axis < kSmooth; ++axis) {
      const Axis<double>& a = t.smooth[axis];
      if (a.count < 2) continue;
      for (int block = 0; block < blocks(t); ++block) {
        for (int n = 0; n < 12; ++n) {
          const bool high = n % 2 == 1;
          double other = 0;
          if (kSmooth == 2) {
            const Axis<double>& b = t.smooth[1 - axis];
            const double margin = n > 8 ? 2 * b.end_width : 0;  // now and then outside as well
            other = std::uniform_real_distribution<double>(b.knot[0] - margin,
                                                           b.knot[b.count - 1] + margin)(engine);
          }
          const auto at = [&, axis, block, other](Interpolation mode, double x) {
            D argument[kSmooth];
            for (int k = 0; k < kSmooth; ++k)
              argument[k] = k == axis ? D::variable(x, 0) : D::variable(other, 1);
            return look(t, mode, block, argument);
          };
          visit(name, a, high ? a.knot[a.count - 1] : a.knot[0], high ? 1.0 : -1.0, at);
        }
      }
    }
  });
}

// The search by the index of an axis, in the arithmetic of R, against the knots one by one.
template <class R>
void check_index(const char* name, const Axis<double>& axis) {
  std::vector<R> knot(axis.knot, axis.knot + axis.count);
  const Axis<R> a{axis.count, knot.data(), axis.bucket, static_cast<R>(axis.per_width)};
  const auto between = [&](int interval, R part) {
    const auto k = static_cast<std::size_t>(interval);
    return knot[k] + part * (knot[k + 1] - knot[k]);
  };
  for (int i = 0; i < a.count; ++i) {
    if (!CHECK_EQ(find_interval(a, knot[static_cast<std::size_t>(i)]), std::min(i, a.count - 2)))
      NOTE(name << " knot " << i);
    if (i == a.count - 1) continue;
    for (const double part : {1e-4, 0.3, 0.5, 0.9999})
      if (!CHECK_EQ(find_interval(a, between(i, static_cast<R>(part))), i))
        NOTE(name << " " << i << " + " << part);
  }
  CHECK_EQ(find_interval(a, std::numeric_limits<R>::quiet_NaN()), 0);
  // In lanes the same.
  Batch<R> x;
  for (int lane = 0; lane < Batch<R>::kLanes; ++lane) x.set(lane, between(lane % (a.count - 1), R(0.6)));
  const BatchIndex<R> found = find_interval(a, x);
  for (int lane = 0; lane < Batch<R>::kLanes; ++lane) CHECK_EQ(found.e[lane], lane % (a.count - 1));
}

}  // namespace

TEST(table_index_finds_the_interval_of_every_axis) {
  int indexed = 0, all = 0;
  every_table([&](const char* name, const auto& t) {
    for (const Axis<double>& axis : t.smooth) {
      if (axis.count < 3) continue;
      ++all;
      if (axis.bucket == nullptr) continue;
      ++indexed;
      check_index<double>(name, axis);
      check_index<float>(name, axis);
    }
  });
  CHECK_LT(0.8 * all, indexed);
  for (const Table<double, 2>& t : aircraft().rotor.section_lift)
    CHECK(t.smooth[0].bucket != nullptr && t.smooth[1].bucket != nullptr);
  NOTE(indexed << " of " << all << " axes");
}

TEST(table_ends_have_neither_jump_nor_kink) {
  int ends = 0, with_slope = 0;
  every_end([&](const char* name, const Axis<double>& axis, double end, double outward, const auto& at) {
    CHECK(axis.end_width > 0);
    const double step = 1e-5 * axis.end_width;
    for (const double place : {end, end + outward * axis.end_width}) {
      const D before = at(Interpolation::c1, place - outward * step);
      const D after = at(Interpolation::c1, place + outward * step);
      const double slope = before.d.get(0);
      const double size = std::max({std::fabs(slope), std::fabs(at(Interpolation::c1, end).d.get(0)),
                                    1e-2 * std::fabs(before.v), 1e-4});  // the last two: its curvature
      const bool smooth = std::fabs(after.v - before.v - 2 * step * outward * slope) <=
                              1e-4 * size * step + 1e-14 * std::fabs(before.v) &&
                          std::fabs(after.d.get(0) - slope) <= 2e-4 * size;
      if (!CHECK(smooth)) NOTE(name << " at " << place);
      if (place == end && std::fabs(slope) > 1e-6) ++with_slope;
    }
    ++ends;
  });
  CHECK(with_slope > 300);  // otherwise the test has seen nothing
  NOTE(ends << " ends, " << with_slope << " of them with a slope");
}

TEST(table_ends_hold_their_value_beyond_the_width) {
  every_end([&](const char* name, const Axis<double>& axis, double end, double outward, const auto& at) {
    for (const Interpolation mode : {Interpolation::c1, Interpolation::linear}) {
      const D held = at(mode, end);
      for (const double factor : {1.0, 1.5, 1e3}) {
        const D beyond = at(mode, end + outward * factor * axis.end_width * (1 + 1e-6));
        if (!CHECK(beyond.v == held.v && beyond.d.get(0) == 0)) NOTE(name << " beyond " << end);
      }
    }
    // The source's own interpolation holds at once.
    const D near = at(Interpolation::linear, end + outward * 0.3 * axis.end_width);
    CHECK(near.v == at(Interpolation::linear, end).v && near.d.get(0) == 0);
  });
}

// The most a table adds beyond its end: 4/27 of slope times width, small
// against the table (choices.csv).
TEST(table_ends_add_little) {
  double worst = 0;
  every_end([&](const char*, const Axis<double>& axis, double end, double outward, const auto& at) {
    const D held = at(Interpolation::c1, end);
    for (double part = 0.05; part < 1; part += 0.05) {
      const D beyond = at(Interpolation::c1, end + outward * part * axis.end_width);
      const double most = 4.0 / 27 * std::fabs(held.d.get(0)) * axis.end_width;
      CHECK_LE(std::fabs(beyond.v - held.v), most * (1 + 1e-9) + 1e-14);
      worst = std::max(worst, std::fabs(beyond.v - held.v));
    }
  });
  NOTE("largest change, in the unit of its table: " << worst);
}

// The angles that have brought this about: 100 kt of the pressure ratio at the
// tail, 20 deg of the surfaces.
TEST_OF_XV15(table_ends_of_speed_and_deflection) {
  const HorizontalTailTables<double>& h = aircraft().htail;
  const GridPoint<double> mast[1] = {{0, 0.0}};
  const auto ratio = [&](double speed) {
    const D x[2] = {D(2.0), D::variable(speed, 0)};
    return lookup(h.pressure_ratio, Interpolation::c1, mast, x);
  };
  CHECK(std::fabs(ratio(100).d.get(0)) > 1e-3);
  CHECK_NEAR(ratio(100 + 1e-9).d.get(0), ratio(100).d.get(0), 1e-9);
  CHECK_EQ(ratio(101).d.get(0), 0.0);
  CHECK_EQ(ratio(140).v, ratio(100).v);
  for (const double limit : {-20.0, 20.0}) {
    const auto tail = [&](double x) {
      return lookup(h.lift_elevator, Interpolation::c1, D(4.0), D::variable(x, 0)).d.get(0);
    };
    const auto fin = [&](double x) {
      return lookup(aircraft().fin.side_rudder, Interpolation::c1, D(4.0), D::variable(x, 0)).d.get(0);
    };
    CHECK(tail(limit) > 0.01);
    CHECK(std::fabs(fin(limit)) > 0.005);
    CHECK_NEAR(tail(limit * (1 + 1e-12)), tail(limit), 1e-8);
    CHECK_NEAR(fin(limit * (1 + 1e-12)), fin(limit), 1e-8);
  }
}

// An axis that goes once around the circle is one function: -180 and 180 deg
// are one place.
TEST(table_ends_meet_around_the_circle) {
  int circles = 0;
  every_table([&](const char* name, const auto& t) {
    const Axis<double>& axis = t.smooth[0];
    if (axis.knot[0] != -180 || axis.knot[axis.count - 1] != 180) return;
    ++circles;
    constexpr int kSmooth = kSmoothAxes<std::decay_t<decltype(t)>>;
    for (int block = 0; block < blocks(t); ++block) {
      for (int n = 0; n < 8; ++n) {
        D left[kSmooth], right[kSmooth];
        left[0] = D::variable(-180, 0);
        right[0] = D::variable(180, 0);
        if constexpr (kSmooth == 2) {
          const Axis<double>& other = t.smooth[1];
          left[1] = right[1] = D(other.knot[0] + n / 7.0 * (other.knot[other.count - 1] - other.knot[0]));
        }
        const D a = look(t, Interpolation::c1, block, left), b = look(t, Interpolation::c1, block, right);
        if (!CHECK(std::fabs(a.v - b.v) < 1e-14 && std::fabs(a.d.get(0) - b.d.get(0)) < 1e-14)) NOTE(name);
        CHECK_NEAR(look(t, Interpolation::linear, block, left).v,
                   look(t, Interpolation::linear, block, right).v, 1e-14);
      }
    }
  });
  CHECK(circles >= 20);
}

// f + m d (1 - d/w)^2 beyond an end of slope m, in one and two directions, with
// exact derivatives.
TEST(table_ends_fade_by_their_formula) {
  const double x[] = {-1, 0, 2}, y[] = {3, 4, 4.5};
  const double width[2] = {0.4, 0.1};
  const Axis<double> axes[2] = {{3, x, nullptr, 0, width[0]}, {3, y, nullptr, 0, width[1]}};
  double node[9 * 4] = {}, scratch[9 * 4];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) node[(i * 3 + j) * 4] = std::sin(1.3 * i + 0.7 * j) + i * j;
  fill_slopes<double, 2>(axes, node, scratch);
  const Table<double, 2> table{{axes[0], axes[1]}, {}, node};
  const auto bump = [](double d, double w) {
    return std::fabs(d) < w ? d * std::pow(1 - std::fabs(d) / w, 2) : 0;
  };
  for (const double d : {0.0, 0.1, 0.25, 0.4, 3.0}) {
    for (const double e : {0.0, 0.02, 0.07, 0.5}) {
      // Corner (2, 4.5): value, slopes and mixed slope of the node; corner (-1,
      // 3): the same with signs.
      const double* high = node + 8 * 4;
      const double* low = node;
      const double g = bump(d, width[0]), h = bump(e, width[1]);
      const D at = lookup(table, Interpolation::c1, D::variable(2 + d, 0), D::variable(4.5 + e, 1));
      CHECK_NEAR(at.v, high[0] + g * high[1] + h * high[2] + g * h * high[3], 1e-14);
      const D under = lookup(table, Interpolation::c1, D::variable(-1 - d, 0), D::variable(3 - e, 1));
      CHECK_NEAR(under.v, low[0] - g * low[1] - h * low[2] + g * h * low[3], 1e-14);
      CHECK_EQ(at.v, lookup(table, Interpolation::c1, 2 + d, 4.5 + e));
      const C along_x = lookup(table, Interpolation::c1, C(2 + d, 1e-30), C(4.5 + e, 0));
      const C along_y = lookup(table, Interpolation::c1, C(-1 - d, 0), C(3 - e, 1e-30));
      if (d != 0.4) CHECK_NEAR(at.d.get(0), along_x.imag() / 1e-30, 1e-12);
      CHECK_NEAR(under.d.get(1), along_y.imag() / 1e-30, 1e-12);
    }
  }
}

// Slopes at the ends of a closed curve: those of the same curve begun at
// another knot.
TEST(table_slopes_of_a_closed_curve) {
  const double knot[] = {-180, -100, -20, 30, 110, 180};
  const double value[] = {0.4, 1, 0.7, -0.2, 0.1, 0.4};
  double slope[6], shifted[6];
  monotone_slopes(6, knot, value, slope, 1, true);
  CHECK_EQ(slope[0], slope[5]);
  const double from_30[] = {30, 110, 180, 260, 340, 390};
  const double values[] = {-0.2, 0.1, 0.4, 1, 0.7, -0.2};
  monotone_slopes(6, from_30, values, shifted, 1, false);
  CHECK_NEAR(slope[0], shifted[2], 1e-15);
  CHECK_NEAR(slope[1], shifted[3], 1e-15);
}
