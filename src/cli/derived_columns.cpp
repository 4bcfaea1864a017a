#include "cli/derived_columns.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "cli/units.hpp"
#include "text/nearest.hpp"
#include "text/number.hpp"
#include "text/rounding.hpp"
#include "tiltrotor/analysis/trim/trim.hpp"
#include "tiltrotor/math/differentiation/preaccumulate.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double radian = kRadPerDeg<double>;

struct Moment {
  const Configuration<double>& c;
  State<double> x;
  Controls<double> u;

  Vec3<double> air() const { return x.velocity - u.gust; }
  BladeControls<double> blades() const { return mix_controls(c, u, air()); }
};
using Now = const Moment&;

double mean(const double (&sides)[2]) { return (sides[right] + sides[left]) / 2; }
double half_difference(const double (&sides)[2]) { return (sides[right] - sides[left]) / 2; }

// Along and across the heading, level with the ground, and up.
Vec3<double> in_level_axes(const Vec3<double>& v, const State<double>& x) {
  const double lateral_plane = v.y * std::sin(x.roll) + v.z * std::cos(x.roll);
  return {v.x * std::cos(x.pitch) + lateral_plane * std::sin(x.pitch),
          v.y * std::cos(x.roll) - v.z * std::sin(x.roll),
          v.x * std::sin(x.pitch) - lateral_plane * std::cos(x.pitch)};
}

double climb_angle(Now m) {
  const Vec3<double> v = in_level_axes(m.air(), m.x);
  return std::atan2(v.z, std::hypot(v.x, v.y));
}

double turn_rate(Now m) {
  return (m.x.rates.y * std::sin(m.x.roll) + m.x.rates.z * std::cos(m.x.roll)) / std::cos(m.x.pitch);
}

struct Column {
  const char* name;
  double (*value)(Now);
};
constexpr Column columns[] = {
    {"speed_mps", [](Now m) { return airspeed(m.x, m.u); }},
    {"forward_speed_mps", [](Now m) { return forward_speed(m.x); }},
    {"climb_rate_mps", [](Now m) { return climb_rate(m.x); }},
    {"climb_deg", [](Now m) { return climb_angle(m) / radian; }},
    {"turn_rate_degps", [](Now m) { return turn_rate(m) / radian; }},
    {"alpha_deg", [](Now m) { return std::atan2(m.air().z, m.air().x) / radian; }},
    {"sideslip_deg", [](Now m) { return std::atan2(m.air().y, std::hypot(m.air().x, m.air().z)) / radian; }},
    {"collective_root_deg", [](Now m) { return (m.u.collective + blade_root_twist(m.c)) / radian; }},
    {"long_cyclic_deg", [](Now m) { return mean(m.blades().long_cyclic) / radian; }},
    {"diff_collective_deg", [](Now m) { return half_difference(m.blades().collective) / radian; }},
    {"diff_long_cyclic_deg", [](Now m) { return half_difference(m.blades().long_cyclic) / radian; }},
    {"elevator_deg", [](Now m) { return m.blades().elevator / radian; }},
    {"aileron_deg", [](Now m) { return m.blades().aileron / radian; }},
    {"rudder_deg", [](Now m) { return m.blades().rudder / radian; }},
};

// With how many digits a row is printed: the most of any of its cells. Rows of few digits are round numbers.
struct Printed {
  int significant = 6;
  int decimals = 0;

  void see(const std::string& cell) {
    int digits = 0;
    int behind_point = 0;
    bool point = false;
    std::size_t i = 0;
    for (; i < cell.size() && cell[i] != 'e' && cell[i] != 'E'; ++i) {
      point = point || cell[i] == '.';
      if (std::isdigit(static_cast<unsigned char>(cell[i])) == 0) continue;
      digits += digits > 0 || cell[i] != '0';
      behind_point += point;
    }
    const int exponent = i < cell.size() ? std::atoi(cell.c_str() + i + 1) : 0;
    significant = std::max(significant, digits);
    decimals = std::max(decimals, behind_point - exponent);
  }
  // How far a number may be from what it was before it was printed.
  double uncertainty(double value) const {
    return std::abs(value) * std::pow(10.0, 1 - significant) + std::pow(10.0, -decimals) +
           kRounding * kUsualTerms;
  }
};

// A cell of the row and what it fills.
struct Given {
  const Quotation& cell;
  Target target;
};

// How far the column may be off, for the digits of every state and control it could depend on.
double uncertainty(const Column& column, const Moment& now, const std::vector<Given>& given,
                   const Printed& printed) {
  double x[state_count], u[control_count];
  flatten(now.x, x);
  flatten(now.u, u);
  const double value = column.value(now);
  double sum = printed.uncertainty(value);
  for (const Given& g : given) {
    double& input = g.target.kind == Target::Kind::state ? x[g.target.index] : u[g.target.index];
    const double before = input;
    input += printed.uncertainty(g.cell.value) * g.target.unit;
    Moment moved = now;
    unflatten(x, moved.x);
    unflatten(u, moved.u);
    sum += std::abs(column.value(moved) - value);
    input = before;
  }
  return sum;
}

}  // namespace

double airspeed(const State<double>& x, const Controls<double>& u) {
  const Vec3<double> v = x.velocity - u.gust;
  return std::sqrt(dot(v, v));
}

double forward_speed(const State<double>& x) { return in_level_axes(x.velocity, x).x; }
double climb_rate(const State<double>& x) { return in_level_axes(x.velocity, x).z; }

std::string contradiction(const StateRow& row, const StateFile& file, const Configuration<double>& c) {
  const Moment now{c, row.state, row.controls};
  std::vector<Given> given;
  Printed printed;
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    const Target& target = file.targets()[i];
    if (target.kind != Target::Kind::state && target.kind != Target::Kind::control) continue;
    given.push_back({std::get<Quotation>(row.cells[i]), target});
    printed.see(given.back().cell.text);
  }
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    const std::string& name = file.columns()[i];
    const double size = file.targets()[i].size;
    const std::string own = size == 1 ? name : in_own_unit(name).name;
    const Column* const column =
        std::find_if(std::begin(columns), std::end(columns), [&](const Column& k) { return own == k.name; });
    if (column == std::end(columns)) continue;
    if (const std::string* const word = std::get_if<std::string>(&row.cells[i]))
      return "column " + name + ": " + quoted(*word) + " is not a number";
    const Quotation* const cell = std::get_if<Quotation>(&row.cells[i]);
    if (cell == nullptr || !std::isfinite(cell->value)) continue;
    const double value = column->value(now) / size;
    const double difference = std::abs(value - cell->value);
    // The second is a few hundred times as much work.
    if (difference <= printed.uncertainty(value) ||
        difference <= uncertainty(*column, now, given, printed) / size)
      continue;
    constexpr int digits = 12;
    return "column " + name + ": " + cell->text + ", but the states and controls of the row give " +
           number_text(without_rounding(value, kUsualTerms), digits) +
           "; it follows from these: change them, or leave the column out";
  }
  return "";
}

}  // namespace tiltrotor::cli
