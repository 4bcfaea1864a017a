// What a state or an input is: its unit, how far it may go, over which distance the model bends in it, and
// to which half of a symmetric flight it belongs. state.hpp and controls.hpp say it of each, once; counts,
// places, names, scales, bounds and the order of linear models follow from there.
#pragma once

#include <limits>

#include "tiltrotor/math/scalar.hpp"

namespace tiltrotor {

// The one enumeration that is not scoped: a side is a place in arrays of two, x.rotor[right].
enum Side { right = 0, left = 1 };
inline constexpr int kNoSide = -1;

enum class VariableKind : unsigned char {
  speed,
  body_rate,
  bank,
  pitch,
  heading,
  gimbal_tilt,
  gimbal_rate,
  mean_inflow,
  cyclic_inflow,
  downwash,
  coning,
  coning_rate,
  position,
  blade_pitch,
  stick,
  pedal,
  surface,
  gust,
  mast_angle,
  mast_rate,
  flap_angle,
  rotor_speed,
  shaft_twist,
  twist_rate,
  power,
  actuator,
  fuel,
  series_actuator,
  washout,
  held_angle,
  held_stick,
  flag,
  gear_extension,
  gust_filter,
  throttle,
  count
};

// Which half of a symmetric flight a variable belongs to: lateral ones change sign in the mirror, those of a
// rotor change sides, so that their means are longitudinal and their differences lateral.
enum class Plane : unsigned char { longitudinal, lateral, rotor };

struct KindFacts {
  VariableKind kind;
  const char* unit;
  double bend;             // distance over which the model bends noticeably: scale of numerical differences
  double bound;            // of a state: beyond it a flight has diverged, since the tables end long before
  bool ignorable = false;  // nothing depends on it: linear models leave it out
};
inline constexpr double kUnbounded = std::numeric_limits<double>::max();
inline constexpr KindFacts kKindFacts[] = {
    {VariableKind::speed, "m/s", 10, 300},
    {VariableKind::body_rate, "rad/s", 1, 20},
    {VariableKind::bank, "rad", 1, 1000},                           // rolls may add up
    {VariableKind::pitch, "rad", 1, 89.9999 * kRadPerDeg<double>},  // Euler angles end at 90
    {VariableKind::heading, "rad", 1, 1e6, true},
    {VariableKind::gimbal_tilt, "rad", 1, 2},
    {VariableKind::gimbal_rate, "rad/s", 10, 200},
    {VariableKind::mean_inflow, "-", 0.1, 2},
    {VariableKind::cyclic_inflow, "-", 0.1, 2},
    {VariableKind::downwash, "rad", 1, 2},
    {VariableKind::coning, "rad", 1, 2},
    {VariableKind::coning_rate, "rad/s", 10, 200},
    {VariableKind::position, "m", 10, 1e9, true},
    {VariableKind::blade_pitch, "rad", 1, kUnbounded},
    {VariableKind::stick, "in", 1, kUnbounded},
    {VariableKind::pedal, "in", 1, kUnbounded},
    {VariableKind::surface, "rad", 1, kUnbounded},
    {VariableKind::gust, "m/s", 10, kUnbounded},
    {VariableKind::mast_angle, "rad", 1, 2},
    {VariableKind::mast_rate, "rad/s", 1, 2},
    {VariableKind::flap_angle, "rad", 1, 2},
    {VariableKind::rotor_speed, "rad/s", 10, 100},
    {VariableKind::shaft_twist, "rad", 0.1, 2},
    {VariableKind::twist_rate, "rad/s", 1, 50},
    {VariableKind::power, "W", 1e5, 1e8},
    {VariableKind::actuator, "rad", 1, 2},
    {VariableKind::fuel, "kg", 100, 1e6, true},
    {VariableKind::series_actuator, "in", 1, 100},
    {VariableKind::washout, "rad/s", 1, 20},
    {VariableKind::held_angle, "rad", 1, 1000, true},
    {VariableKind::held_stick, "in", 1, 100, true},
    {VariableKind::flag, "-", 1, 1, true},
    {VariableKind::gear_extension, "-", 1, 1, true},
    {VariableKind::gust_filter, "-", 1, 1000, true},
    {VariableKind::throttle, "-", 1, kUnbounded},
};

constexpr bool kinds_in_order() {
  for (int k = 0; k < static_cast<int>(VariableKind::count); ++k)
    if (static_cast<int>(kKindFacts[k].kind) != k) return false;
  return sizeof(kKindFacts) / sizeof(kKindFacts[0]) == static_cast<unsigned>(VariableKind::count);
}
static_assert(kinds_in_order(), "one row of kKindFacts per VariableKind, in its order");

struct Variable {
  const char* name = nullptr;
  VariableKind kind = VariableKind::count;
  Plane plane = Plane::longitudinal;
  int side = kNoSide;

  constexpr const KindFacts& facts() const { return kKindFacts[static_cast<int>(kind)]; }
  constexpr const char* unit() const { return facts().unit; }
};

// Number of members that Shape::describe visits.
template <template <class> class Shape>
constexpr int count_variables() {
  Shape<int> shape{};
  int count = 0;
  Shape<int>::describe(shape, [&count](int&, const Variable&) { ++count; });
  return count;
}

// Each member holds its own place in the order of Shape::describe.
template <template <class> class Shape>
constexpr Shape<int> places() {
  Shape<int> shape{};
  int count = 0;
  Shape<int>::describe(shape, [&count](int& place, const Variable&) { place = count++; });
  return shape;
}

template <int Count>
struct VariableTable {
  Variable row[Count];
  int partner[Count];  // place of the same variable of the other side; its own where there is no other
  constexpr const Variable& operator[](int place) const { return row[place]; }
};

template <template <class> class Shape>
constexpr auto variable_table() {
  constexpr int size = count_variables<Shape>();
  VariableTable<size> table{};
  Shape<int> shape{};
  int count = 0;
  Shape<int>::describe(shape, [&](int&, const Variable& variable) { table.row[count++] = variable; });
  for (int i = 0; i < size; ++i) {
    table.partner[i] = i;
    int order = 0;  // among the variables of its side
    for (int j = 0; j < i; ++j) order += table[j].side == table[i].side;
    for (int j = 0; table[i].side != kNoSide && j < size; ++j)
      if (table[j].side == 1 - table[i].side && order-- == 0) table.partner[i] = j;
  }
  return table;
}

// Every row named, known and unlike the others; partners of one kind that point at each other.
template <int Count>
constexpr bool is_complete(const VariableTable<Count>& table) {
  for (int i = 0; i < Count; ++i) {
    const Variable& one = table[i];
    if (one.name == nullptr || one.kind == VariableKind::count) return false;
    const int other = table.partner[i];
    if (table.partner[other] != i || table[other].kind != one.kind) return false;
    if ((one.side == kNoSide) != (other == i)) return false;
    for (int j = 0; j < i; ++j) {
      const char* a = one.name;
      const char* b = table[j].name;
      while (*a != '\0' && *a == *b) ++a, ++b;
      if (*a == *b) return false;
    }
  }
  return true;
}

}  // namespace tiltrotor
